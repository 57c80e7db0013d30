#include "core/equilibrium.h"

namespace ghostforce {
namespace {

template <glm::length_t D>
Equilibrium<D> equilibrium_from_proxy(const Wall<D>& wall, double k_u, const Vector<D>& goal, const Vector<D>& proxy,
                                      const Vector<D>& force) noexcept {
  return {goal, proxy, goal + force / k_u, projection(wall, proxy), force, true};
}

template <glm::length_t D>
Equilibrium<D> in_free_space(const Wall<D>& wall, const Vector<D>& goal) noexcept {
  return {goal, goal, goal, projection(wall, goal), Vector<D>(0.0), false};
}

}  // namespace

template <glm::length_t D>
Equilibrium<D> equilibrium_with_ratio(const Wall<D>& wall, const Actuation<D>& actuation,
                                      const Stiffnesses& stiffnesses, double tracking_ratio,
                                      const Vector<D>& goal) noexcept {
  const double d = depth(wall, goal);
  if (!(d > 0.0)) return in_free_space(wall, goal);
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

template <glm::length_t D>
Equilibrium<D> equilibrium_fully_actuated(const Wall<D>& wall, const Stiffnesses& stiffnesses,
                                          const Vector<D>& goal) noexcept {
  const double d = depth(wall, goal);
  if (!(d > 0.0)) return in_free_space(wall, goal);
  const double kappa = stiffnesses.k_r / stiffnesses.k_u;
  const double softness = stiffnesses.k_t / stiffnesses.k_c;
  return equilibrium_from_proxy(wall, stiffnesses.k_u, goal,
                                goal + wall.normal * (d / (1.0 + softness / (1.0 + kappa))),
                                wall.normal * (stiffnesses.k_r * d / (1.0 + kappa + softness)));
}

template <glm::length_t D>
Equilibrium<D> equilibrium_naive(const Wall<D>& wall, const Actuation<D>& actuation, const Stiffnesses& stiffnesses,
                                 const Vector<D>& goal) noexcept {
  const double d = depth(wall, goal);
  if (!(d > 0.0)) return in_free_space(wall, goal);
  const double kappa = stiffnesses.k_r / stiffnesses.k_u;
  const Vector<D> actuated_normal = actuation.actuated * wall.normal;
  const double alpha = glm::dot(wall.normal, actuated_normal);
  const double scale = d / (1.0 + kappa * alpha + stiffnesses.k_t / stiffnesses.k_c);
  return equilibrium_from_proxy(wall, stiffnesses.k_u, goal, goal + scale * (wall.normal + kappa * actuated_normal),
                                (stiffnesses.k_r * scale) * actuated_normal);
}

template <glm::length_t D>
Equilibrium<D> equilibrium_anisotropic(const Wall<D>& wall, const Actuation<D>& actuation,
                                       const Stiffnesses& stiffnesses, const Vector<D>& goal) noexcept {
  const double d = depth(wall, goal);
  if (!(d > 0.0)) return in_free_space(wall, goal);
  const double k_tn = stiffnesses.k_t / optimal_tracking_ratio(stiffnesses.k_r, stiffnesses.k_u);
  const double softness = 1.0 + k_tn / stiffnesses.k_c;
  const double force = stiffnesses.k_u * d / ((1.0 + stiffnesses.k_u / stiffnesses.k_r) * softness);
  return equilibrium_from_proxy(wall, stiffnesses.k_u, goal, goal + wall.normal * (d / softness),
                                force * (actuation.actuated * wall.normal));
}

template <glm::length_t D>
Equilibrium<D> equilibrium_of(const Strategy& strategy, const Wall<D>& wall, const Actuation<D>& actuation,
                              const Stiffnesses& stiffnesses, const Vector<D>& goal) noexcept {
  return strategy.has_every_motor
             ? equilibrium_fully_actuated(wall, stiffnesses, goal)
             : equilibrium_with_ratio(wall, actuation, stiffnesses, strategy.tracking_ratio(stiffnesses), goal);
}

#define GHOSTFORCE_INSTANTIATE(D)                                                                                     \
  template Equilibrium<D> equilibrium_with_ratio<D>(const Wall<D>&, const Actuation<D>&, const Stiffnesses&, double,  \
                                                    const Vector<D>&) noexcept;                                       \
  template Equilibrium<D> equilibrium_fully_actuated<D>(const Wall<D>&, const Stiffnesses&,                           \
                                                        const Vector<D>&) noexcept;                                   \
  template Equilibrium<D> equilibrium_naive<D>(const Wall<D>&, const Actuation<D>&, const Stiffnesses&,               \
                                               const Vector<D>&) noexcept;                                            \
  template Equilibrium<D> equilibrium_anisotropic<D>(const Wall<D>&, const Actuation<D>&, const Stiffnesses&,         \
                                                     const Vector<D>&) noexcept;                                      \
  template Equilibrium<D> equilibrium_of<D>(const Strategy&, const Wall<D>&, const Actuation<D>&, const Stiffnesses&, \
                                            const Vector<D>&) noexcept
GHOSTFORCE_INSTANTIATE(2);
GHOSTFORCE_INSTANTIATE(3);
GHOSTFORCE_INSTANTIATE(4);
#undef GHOSTFORCE_INSTANTIATE

}  // namespace ghostforce
