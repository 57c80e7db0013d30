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

// With κ = k_r/k_u, S = ((1+κ) nᵀP_A n + ρ nᵀP_N n)/k_t and δ = d/(1 + k_c S):
//     q_p = q_u + (k_c δ/k_t) ((1+κ) P_A n + ρ P_N n)
//     f_r = (k_r k_c δ/k_t) P_A n
//     q_h = q_u + f_r/k_u     (7)
// One family for any ratio ρ and any k_c (hard: k_c δ → d/S). ρ = 1 is naïve rendering, (12) to (15); ρ = ρ* the
// anisotropic one, (18) to (20).
template <glm::length_t D>
Equilibrium<D> equilibrium_with_ratio(const Wall<D>& wall, const Actuation<D>& actuation,
                                      const Stiffnesses& stiffnesses, double tracking_ratio,
                                      const Vector<D>& goal) noexcept;

// (9)   q_p = q_u + d n / (1 + k_t / (k_c (1+κ)))
// (10)  q_h = q_u + f_r/k_u
// (11)  f_r = k_r d n / (1 + κ + k_t/k_c)
template <glm::length_t D>
Equilibrium<D> equilibrium_fully_actuated(const Wall<D>& wall, const Stiffnesses& stiffnesses,
                                          const Vector<D>& goal) noexcept;

// (12)  α = nᵀP_A n
// (13)  q_p = q_u + d (n + κ P_A n) / (1 + κα + k_t/k_c)
// (14)  q_h = q_u + f_r/k_u
// (15)  f_r = k_r d P_A n / (1 + κα + k_t/k_c)
template <glm::length_t D>
Equilibrium<D> equilibrium_naive(const Wall<D>& wall, const Actuation<D>& actuation, const Stiffnesses& stiffnesses,
                                 const Vector<D>& goal) noexcept;

// With ρ = ρ*, (17), of the true k_u, hence k_tn = k_t/(1+κ):
// (18)  q_p = q_u + d n / (1 + k_tn/k_c)
// (19)  q_h = q_u + f_r/k_u
// (20)  f_r = k_u d P_A n / ((1 + k_u/k_r) (1 + k_tn/k_c))
template <glm::length_t D>
Equilibrium<D> equilibrium_anisotropic(const Wall<D>& wall, const Actuation<D>& actuation,
                                       const Stiffnesses& stiffnesses, const Vector<D>& goal) noexcept;

// What a strategy of the catalog comes to rest at, with the ratio that it runs with (so that a wrong belief shows).
template <glm::length_t D>
Equilibrium<D> equilibrium_of(const Strategy& strategy, const Wall<D>& wall, const Actuation<D>& actuation,
                              const Stiffnesses& stiffnesses, const Vector<D>& goal) noexcept;

}  // namespace ghostforce
