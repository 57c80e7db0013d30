// The contact of a scene in which nothing depends on the place: straight walls, and motors without limits that never turn.
// Worked out once for a change of a setting, by contact_solver.h. Pure values and functions, never allocate or throw, any
// thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/contact_solver.h"

namespace ghostforce {

// What a strategy renders where planes and motors stay as they are and no motor has a limit: while a set of planes acts,
// all is linear in their gaps.
template <glm::length_t D>
struct FixedContact {
  struct PerGap {               // of one plane [1/m]
    PlaneNumbers conditions{};  // λ of each plane that acts, and how far each other one is from the proxy
    Vector<D> proxy{0.0};       // q_p − q_h
    Vector<D> force{0.0};       // f_r
    Efforts efforts{};          // u
  };
  // Entry by entry plane_sets. A set that cannot act has no numbers: they meet no condition.
  std::array<std::array<PerGap, most_planes>, plane_sets.size()> sets;
  Planes<D> planes;
  std::size_t motor_count = 0;
};

template <glm::length_t D>
FixedContact<D> fixed_contact(const Planes<D>& planes, const ActuationMatrix<D>& actuation,
                              const Compliances<D>& compliances, bool has_every_motor, double share) noexcept {
  FixedContact<D> fixed;
  fixed.planes = planes;
  fixed.motor_count = actuation.count;
  if (has_every_motor) share = 0.0;
  TrackedState<D> tracked;
  find_tracked_state(actuation, compliances, share, free_motors(actuation.count).front(), tracked);
  for (std::size_t s = 0; s < plane_sets.size(); ++s) {
    for (std::size_t k = 0; k < planes.count; ++k) {
      typename FixedContact<D>::PerGap& per_gap = fixed.sets[s][k];
      PlaneNumbers gaps{};
      gaps[k] = 1.0;
      PlaneNumbers multipliers;
      Vector<D> push;
      if (plane_sets[s] >= (1U << planes.count) ||
          !find_multipliers(planes, gaps, tracked.tracking, compliances.constraint, plane_sets[s], multipliers, push,
                            false)) {
        per_gap.conditions.fill(std::numeric_limits<double>::quiet_NaN());
        continue;
      }
      const Vector<D> meant = compliances.force_share * push;
      find_shared_efforts(actuation, compliances, share, tracked, meant, per_gap.efforts);
      per_gap.force = has_every_motor ? meant : force_of_efforts(actuation, per_gap.efforts);
      per_gap.proxy = tracked.tracking * push;
      for (std::size_t i = 0; i < planes.count; ++i) {
        const bool acts = (plane_sets[s] >> i & 1U) != 0;
        per_gap.conditions[i] = acts ? multipliers[i] : gaps[i] + glm::dot(planes.walls[i].normal, per_gap.proxy);
      }
    }
  }
  return fixed;
}

// With the handle at q.
template <glm::length_t D>
Contact<D> solve_fixed_contact(const FixedContact<D>& fixed, const Vector<D>& q) noexcept {
  Contact<D> contact{q};
  PlaneNumbers gaps;
  const std::size_t count = fixed.planes.count;
  if (!measure_gaps(fixed.planes, q, gaps)) return contact;
  contact.status = ContactStatus::contact;
  for (std::size_t s = 0; s < plane_sets.size(); ++s) {
    const auto& per_gap = fixed.sets[s];
    bool is_met = true;
    contact.contact_force = Vector<D>(0.0);
    for (std::size_t i = 0; i < count; ++i) {
      double condition = 0.0;
      for (std::size_t k = 0; k < count; ++k) condition += gaps[k] * per_gap[k].conditions[i];
      const bool acts = (plane_sets[s] >> i & 1U) != 0;
      is_met &= condition >= (acts ? 0.0 : -negligible_distance);
      contact.multipliers[i] = acts ? condition : 0.0;
      contact.contact_force += contact.multipliers[i] * fixed.planes.walls[i].normal;
    }
    if (!is_met) continue;
    contact.active = static_cast<std::uint8_t>(plane_sets[s]);
    for (std::size_t k = 0; k < count; ++k) {
      contact.proxy += gaps[k] * per_gap[k].proxy;
      contact.force += gaps[k] * per_gap[k].force;
      for (std::size_t i = 0; i < fixed.motor_count; ++i) contact.efforts[i] += gaps[k] * per_gap[k].efforts[i];
    }
    return contact;
  }
  refuse(q, contact);
  return contact;
}

}  // namespace ghostforce
