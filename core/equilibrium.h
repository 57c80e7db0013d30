// Where everything comes to rest under a goal that is held still, by closed form. Pure, never allocates or throws.
#pragma once

#include "core/actuation.h"
#include "core/stiffness.h"
#include "core/strategy.h"
#include "core/wall.h"

namespace ghostforce {

template <glm::length_t D>
struct Equilibrium {
  Vector<D> goal;     // q_u [m]
  Vector<D> proxy;    // q_p [m]
  Vector<D> device;   // q_h [m]
  Vector<D> contact;  // q_c, (3) [m]
  Vector<D> force;    // f_r, (5) [N]
  bool in_contact;    // the goal is inside the wall; if not, device = proxy = goal and there is no force
};

// In contact, with (7) and (3).
template <glm::length_t D>
Equilibrium<D> equilibrium_from_proxy(const Wall<D>& wall, double k_u, const Vector<D>& goal, const Vector<D>& proxy,
                                      const Vector<D>& force) noexcept {
  return {goal, proxy, goal + force / k_u, projection(wall, proxy), force, true};
}

template <glm::length_t D>
Equilibrium<D> equilibrium_in_free_space(const Wall<D>& wall, const Vector<D>& goal) noexcept {
  return {goal, goal, goal, projection(wall, goal), Vector<D>(0.0), false};
}

// With κ = k_r/k_u, S = ((1+κ) nᵀP_A n + ρ nᵀP_N n)/k_t and δ = d/(1 + k_c S):
//     q_p = q_u + (k_c δ/k_t) ((1+κ) P_A n + ρ P_N n)
//     f_r = (k_r k_c δ/k_t) P_A n
//     q_h = q_u + f_r/k_u     (7)
// One family for any ratio ρ and any k_c (hard: k_c δ → d/S). ρ = 1 is naïve rendering, (12) to (15); ρ = ρ* the
// anisotropic one, (18) to (20).
template <glm::length_t D>
Equilibrium<D> equilibrium_with_ratio(const Wall<D>& wall, const Actuation<D>& actuation,
                                      const Stiffnesses& stiffnesses, double tracking_ratio,
                                      const Vector<D>& goal) noexcept {
  const double d = depth(wall, goal);
  if (!(d > 0.0)) return equilibrium_in_free_space(wall, goal);
  const double kappa = stiffnesses.k_r / stiffnesses.k_u;
  const Vector<D> actuated_normal = actuation.actuated * wall.normal;
  const Vector<D> unactuated_normal = actuation.unactuated * wall.normal;
  const Vector<D> proxy_direction = (1.0 + kappa) * actuated_normal + tracking_ratio * unactuated_normal;
  const double S = glm::dot(wall.normal, proxy_direction) / stiffnesses.k_t;
  const double constraint_force = d / (1.0 / stiffnesses.k_c + S);  // k_c δ [N]
  return equilibrium_from_proxy(wall, stiffnesses.k_u, goal,
                                goal + (constraint_force / stiffnesses.k_t) * proxy_direction,
                                (stiffnesses.k_r * constraint_force / stiffnesses.k_t) * actuated_normal);
}

// (9)   q_p = q_u + d n / (1 + k_t / (k_c (1+κ)))
// (10)  q_h = q_u + f_r/k_u
// (11)  f_r = k_r d n / (1 + κ + k_t/k_c)
template <glm::length_t D>
Equilibrium<D> equilibrium_fully_actuated(const Wall<D>& wall, const Stiffnesses& stiffnesses,
                                          const Vector<D>& goal) noexcept {
  const double d = depth(wall, goal);
  if (!(d > 0.0)) return equilibrium_in_free_space(wall, goal);
  const double kappa = stiffnesses.k_r / stiffnesses.k_u;
  const double softness = stiffnesses.k_t / stiffnesses.k_c;
  return equilibrium_from_proxy(wall, stiffnesses.k_u, goal,
                                goal + wall.normal * (d / (1.0 + softness / (1.0 + kappa))),
                                wall.normal * (stiffnesses.k_r * d / (1.0 + kappa + softness)));
}

// (12)  α = nᵀP_A n
// (13)  q_p = q_u + d (n + κ P_A n) / (1 + κα + k_t/k_c)
// (14)  q_h = q_u + f_r/k_u
// (15)  f_r = k_r d P_A n / (1 + κα + k_t/k_c)
template <glm::length_t D>
Equilibrium<D> equilibrium_naive(const Wall<D>& wall, const Actuation<D>& actuation, const Stiffnesses& stiffnesses,
                                 const Vector<D>& goal) noexcept {
  const double d = depth(wall, goal);
  if (!(d > 0.0)) return equilibrium_in_free_space(wall, goal);
  const double kappa = stiffnesses.k_r / stiffnesses.k_u;
  const Vector<D> actuated_normal = actuation.actuated * wall.normal;
  const double alpha = glm::dot(wall.normal, actuated_normal);
  const double scale = d / (1.0 + kappa * alpha + stiffnesses.k_t / stiffnesses.k_c);
  return equilibrium_from_proxy(wall, stiffnesses.k_u, goal, goal + scale * (wall.normal + kappa * actuated_normal),
                                (stiffnesses.k_r * scale) * actuated_normal);
}

// With ρ = ρ*, (17), of the true k_u, hence k_tn = k_t/(1+κ):
// (18)  q_p = q_u + d n / (1 + k_tn/k_c)
// (19)  q_h = q_u + f_r/k_u
// (20)  f_r = k_u d P_A n / ((1 + k_u/k_r) (1 + k_tn/k_c))
template <glm::length_t D>
Equilibrium<D> equilibrium_anisotropic(const Wall<D>& wall, const Actuation<D>& actuation,
                                       const Stiffnesses& stiffnesses, const Vector<D>& goal) noexcept {
  const double d = depth(wall, goal);
  if (!(d > 0.0)) return equilibrium_in_free_space(wall, goal);
  const double k_tn = stiffnesses.k_t / optimal_tracking_ratio(stiffnesses.k_r, stiffnesses.k_u);
  const double softness = 1.0 + k_tn / stiffnesses.k_c;
  const double force = stiffnesses.k_u * d / ((1.0 + stiffnesses.k_u / stiffnesses.k_r) * softness);
  return equilibrium_from_proxy(wall, stiffnesses.k_u, goal, goal + wall.normal * (d / softness),
                                force * (actuation.actuated * wall.normal));
}

// What a strategy of the catalog comes to rest at, with the ratio that it runs with (so that a wrong belief shows).
template <glm::length_t D>
Equilibrium<D> equilibrium_of(const Strategy& strategy, const Wall<D>& wall, const Actuation<D>& actuation,
                              const Stiffnesses& stiffnesses, const Vector<D>& goal) noexcept {
  return strategy.has_every_motor
             ? equilibrium_fully_actuated(wall, stiffnesses, goal)
             : equilibrium_with_ratio(wall, actuation, stiffnesses, strategy.tracking_ratio(stiffnesses), goal);
}

}  // namespace ghostforce
