// Where the planes of a constraint let the proxy go, and what the motors that exist make of their push: one small
// problem for both, solved by its active sets. Pure values and functions, never allocate or throw, any thread.
//
//     least over λ ≥ 0, u ∈ U of ½|Nᵀλ|² in C_r + ½|τ A u − Nᵀλ|² in C_u + τ λ·g(q_h) + τ |λ|²/(2 k_c)
//     f_c = Nᵀλ
//     q_p = q_h + [C_r f_c + C_u (f_c − τ A u)]/τ
//     f_r = A u
//
// Which planes act and which motors are at a limit is tried in one order, smaller sets first and then by number, so that
// the same numbers come out wherever it is computed.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "core/actuation_matrix.h"
#include "core/compliance.h"
#include "core/constraint.h"
#include "core/contact_status.h"
#include "core/conventions.h"

namespace ghostforce {

// --- Planes ----------------------------------------------------------------------------------------------------------

// Planes by their number: bit i for plane i.
using PlaneSet = unsigned;

// In the order in which they are tried; without the empty one.
inline constexpr std::array<PlaneSet, 3> plane_sets{1, 2, 3};

// A plane that the proxy pierces by less is not pierced [m].
inline constexpr double negligible_distance = 1e-12;

using PlaneNumbers = std::array<double, most_planes>;

// The multipliers with which just these planes act: λ_i ≥ 0 and g_i + Σ n_iᵀ W n_j λ_j + λ_i/k_c = 0 for those of
// `set`, and g_i + Σ n_iᵀ W n_j λ_j ≥ 0 for the others. `gaps`: g without any push [m]. `response`: W, how the proxy
// moves per force of the planes [m/N]. False: there are none. Without `checks` only the equations count.
template <glm::length_t D>
bool find_multipliers(const Planes<D>& planes, const PlaneNumbers& gaps, const Matrix<D>& response, double softness,
                      PlaneSet set, PlaneNumbers& multipliers, Vector<D>& contact_force, bool checks = true) noexcept {
  const auto is_sound = [checks](double multiplier) {
    return std::isfinite(multiplier) && !(checks && multiplier < 0.0);
  };
  if (set == 3) {
    // Not symmetric where the rest of naïve rendering is asked for.
    const Vector<D>& first = planes.walls[0].normal;
    const Vector<D>& second = planes.walls[1].normal;
    const Vector<D> moved_by_first = response * first;
    const Vector<D> moved_by_second = response * second;
    const double a = glm::dot(first, moved_by_first) + softness;
    const double b = glm::dot(first, moved_by_second);
    const double c = glm::dot(second, moved_by_first);
    const double d = glm::dot(second, moved_by_second) + softness;
    const double determinant = a * d - b * c;
    multipliers[0] = (gaps[1] * b - gaps[0] * d) / determinant;
    multipliers[1] = (gaps[0] * c - gaps[1] * a) / determinant;
    if (!is_sound(multipliers[0]) || !is_sound(multipliers[1])) return false;
    contact_force = multipliers[0] * first + multipliers[1] * second;
    return true;
  }
  const std::size_t acting = set == 1 ? 0 : 1;
  const Vector<D>& normal = planes.walls[acting].normal;
  const Vector<D> moved = response * normal;
  const double multiplier = -gaps[acting] / (glm::dot(normal, moved) + softness);
  if (!is_sound(multiplier)) return false;
  multipliers[acting] = multiplier;
  multipliers[1 - acting] = 0.0;
  contact_force = normal * multiplier;
  if (planes.count == 1 || !checks) return true;
  const std::size_t other = 1 - acting;
  return gaps[other] + multiplier * glm::dot(planes.walls[other].normal, moved) >= -negligible_distance;
}

// --- Motors ----------------------------------------------------------------------------------------------------------

// Which motors are free, and which are at their greatest effort; the others are at their least.
struct MotorState {
  MotorSet free;
  MotorSet greatest;
};

namespace motor_state_tables {

constexpr std::size_t power_of_three(std::size_t exponent) noexcept {
  return exponent == 0 ? 1 : 3 * power_of_three(exponent - 1);
}

template <std::size_t count>
constexpr auto make_motor_states() noexcept {
  std::array<MotorState, power_of_three(count)> states{};
  std::size_t next = 0;
  for (int free_count = 0; free_count <= static_cast<int>(count); ++free_count) {
    for (MotorSet free = 0; free < (1U << count); ++free) {
      if (std::popcount(free) != free_count) continue;
      for (MotorSet greatest = 0; greatest < (1U << count); ++greatest) {
        if ((free & greatest) == 0) states[next++] = {free, greatest};
      }
    }
  }
  return states;
}

template <std::size_t count>
inline constexpr auto table = make_motor_states<count>();

}  // namespace motor_state_tables

// All states that as many motors can be in, in the order in which they are tried.
inline std::span<const MotorState> motor_states(std::size_t count) noexcept {
  switch (count) {
    case 0:
      return motor_state_tables::table<0>;
    case 1:
      return motor_state_tables::table<1>;
    case 2:
      return motor_state_tables::table<2>;
    case 3:
      return motor_state_tables::table<3>;
    default:
      return motor_state_tables::table<4>;
  }
}

// That of motors without limits: all are free. One state.
inline std::span<const MotorState> free_motors(std::size_t count) noexcept {
  return motor_states(count).last(1);
}

// Those that motors with these limits can be in, and some more.
template <glm::length_t D>
std::span<const MotorState> motor_states_of(const ActuationMatrix<D>& actuation) noexcept {
  return actuation.is_limited() ? motor_states(actuation.count) : free_motors(actuation.count);
}

template <glm::length_t D>
bool is_possible(const ActuationMatrix<D>& actuation, const MotorState& state) noexcept {
  for (std::size_t i = 0; i < actuation.count; ++i) {
    if ((state.free >> i & 1U) != 0) continue;
    const bool is_greatest = (state.greatest >> i & 1U) != 0;
    if (!std::isfinite(is_greatest ? actuation.greatest[i] : actuation.least[i])) return false;
    if (is_greatest && actuation.greatest[i] == actuation.least[i]) return false;
  }
  return true;
}

// What motors in a state make of the force f that was meant for all: Φ = Π f + (I − Π) f_b, where Π is that of the free
// ones, and f_b the force of those at a limit.
template <glm::length_t D>
struct NearestForce {
  ActuatedProjection<D> projection;
  Efforts at_limits{};         // of the motors that are not free
  Vector<D> limit_force{0.0};  // f_b [N]

  Vector<D> operator()(const Vector<D>& force) const noexcept {
    return limit_force + projection.projector * (force - limit_force);
  }
};

// False: motors cannot be in this state, or another one does the same with fewer free motors.
template <glm::length_t D>
bool find_nearest_force(const ActuationMatrix<D>& actuation, const Matrix<D>& user_compliance, const MotorState& state,
                        NearestForce<D>& nearest) noexcept {
  const bool is_all_free = state.free == all_motors(actuation.count);
  if (!is_all_free && !is_possible(actuation, state)) return false;
  nearest.projection = actuated_projection(actuation, state.free, user_compliance);
  if (is_all_free && !actuation.is_limited()) return true;
  if (nearest.projection.rank < static_cast<std::size_t>(std::popcount(state.free))) return false;
  nearest.limit_force = Vector<D>(0.0);
  for (std::size_t i = 0; i < actuation.count; ++i) {
    const bool is_greatest = (state.greatest >> i & 1U) != 0;
    const bool is_free = (state.free >> i & 1U) != 0;
    nearest.at_limits[i] = is_free ? 0.0 : is_greatest ? actuation.greatest[i] : actuation.least[i];
    nearest.limit_force += actuation.columns[i] * nearest.at_limits[i];
  }
  return true;
}

// The efforts that make the nearest force to f, and whether motors really are in that state then: free ones within
// their limits, and those at a limit held there.
template <glm::length_t D>
bool find_efforts(const ActuationMatrix<D>& actuation, const Matrix<D>& user_compliance, const MotorState& state,
                  const NearestForce<D>& nearest, const Vector<D>& force, Efforts& efforts) noexcept {
  // Rounding is no reason to refuse a state: where two of them meet, both give the same force.
  constexpr double negligible = 1e-12;
  const bool is_limited = actuation.is_limited();
  const Vector<D> beyond_limits = force - nearest.limit_force;
  for (std::size_t i = 0; i < actuation.count; ++i) {
    efforts[i] = nearest.at_limits[i] + glm::dot(nearest.projection.efforts[i], beyond_limits);
  }
  if (!is_limited) return true;
  const Vector<D> missing = user_compliance * (force - nearest(force));  // where the missing force sends the hand
  const double moved = std::sqrt(std::max(0.0, glm::dot(force, user_compliance * force)));
  for (std::size_t i = 0; i < actuation.count; ++i) {
    const Vector<D>& column = actuation.columns[i];
    if ((state.free >> i & 1U) != 0) {
      const double slack = negligible * (1.0 + std::abs(efforts[i]));
      if (!(efforts[i] >= actuation.least[i] - slack && efforts[i] <= actuation.greatest[i] + slack)) return false;
      efforts[i] = within_limits(actuation, i, efforts[i]);
    } else {
      const double more = glm::dot(column, missing);  // > 0: more effort would come nearer
      const double slack = negligible * moved * std::sqrt(glm::dot(column, user_compliance * column));
      if ((state.greatest >> i & 1U) != 0 ? more < -slack : more > slack) return false;
    }
  }
  return true;
}

// Of all efforts that make the same force as these, the smallest: where motors are more than they need to be, the force
// does not tell what each of them does. Within the limits; as they are where the force is the motors' only one.
template <glm::length_t D>
void make_least(const ActuationMatrix<D>& actuation, Efforts& efforts) noexcept {
  if (actuation.count == 2) {  // in the usual case, two that are not in one line
    const Vector<D>& one = actuation.columns[0];
    const Vector<D>& other = actuation.columns[1];
    const double squares = glm::dot(one, one) * glm::dot(other, other);
    const double product = glm::dot(one, other);
    if (squares - product * product > 1e-6 * squares) return;
  }
  const ActuatedProjection<D> all = actuated_projection(actuation, all_motors(actuation.count), Matrix<D>(1.0));
  if (all.rank == actuation.count) return;
  const Vector<D> force = force_of_efforts(actuation, efforts);
  // On the free motors u = Aᵀ y, the least that makes what those at a limit leave; Aᵀ y of the others lies beyond their
  // limits.
  constexpr double negligible = 1e-12;
  for (const MotorState& state : motor_states_of(actuation)) {
    if (!is_possible(actuation, state)) continue;
    ActuationMatrix<D> transposed{};  // A Aᵀ of the free motors as columns, so that its projection inverts it
    Matrix<D> square(0.0);
    Vector<D> left = force;
    for (std::size_t i = 0; i < actuation.count; ++i) {
      const double limit = (state.greatest >> i & 1U) != 0 ? actuation.greatest[i] : actuation.least[i];
      if ((state.free >> i & 1U) != 0) {
        square += glm::outerProduct(actuation.columns[i], actuation.columns[i]);
      } else {
        left -= actuation.columns[i] * limit;
      }
    }
    for (glm::length_t i = 0; i < D; ++i) add_motor(transposed, square[i], square[i]);
    const ActuatedProjection<D> inverse = actuated_projection(transposed, all_motors(D), Matrix<D>(1.0));
    Vector<D> y(0.0);
    for (int refined = 0; refined < 2; ++refined) {
      const Vector<D> missing = left - square * y;
      for (glm::length_t i = 0; i < D; ++i) y[i] += glm::dot(inverse.efforts[static_cast<std::size_t>(i)], missing);
    }
    if (glm::length(square * y - left) > negligible * (negligible + glm::length(force))) continue;
    Efforts least{};
    bool is_least = true;
    for (std::size_t i = 0; i < actuation.count && is_least; ++i) {
      const double wanted = glm::dot(actuation.columns[i], y);
      const double slack = negligible * (negligible + std::abs(wanted));
      const bool is_free = (state.free >> i & 1U) != 0;
      const bool is_greatest = (state.greatest >> i & 1U) != 0;
      is_least = is_free
                     ? wanted >= actuation.least[i] - slack && wanted <= actuation.greatest[i] + slack
                     : (is_greatest ? wanted >= actuation.greatest[i] - slack : wanted <= actuation.least[i] + slack);
      least[i] = is_free       ? within_limits(actuation, i, wanted)
                 : is_greatest ? actuation.greatest[i]
                               : actuation.least[i];
    }
    if (!is_least) continue;
    efforts = least;
    return;
  }
}

// u° ∈ U: A u° is the nearest to that force that the motors can make.
template <glm::length_t D>
Efforts nearest_efforts(const ActuationMatrix<D>& actuation, const Matrix<D>& user_compliance,
                        const Vector<D>& force) noexcept {
  Efforts efforts{};
  NearestForce<D> nearest;
  for (const MotorState& state : motor_states_of(actuation)) {
    if (!find_nearest_force(actuation, user_compliance, state, nearest)) continue;
    if (find_efforts(actuation, user_compliance, state, nearest, force, efforts)) break;
  }
  if (actuation.count > 1) make_least(actuation, efforts);
  return efforts;
}

// --- Both ------------------------------------------------------------------------------------------------------------

template <glm::length_t D>
struct Contact {
  Vector<D> proxy;               // q_p [m]
  Vector<D> contact_force{0.0};  // f_c [N]
  Vector<D> force{0.0};          // f_r [N]
  PlaneNumbers multipliers{};    // λ [N]
  Efforts efforts{};             // u
  std::uint8_t active = 0;       // the planes that act, bit i for plane i
  ContactStatus status = ContactStatus::free;
};

// There is none with the handle at q. One object is returned on every way, so that none is copied.
template <glm::length_t D>
void refuse(const Vector<D>& q, Contact<D>& contact) noexcept {
  contact = {.proxy = q, .status = ContactStatus::no_solution};
}

// How far each plane is from q. False: none is pierced.
template <glm::length_t D>
bool measure_gaps(const Planes<D>& planes, const Vector<D>& q, PlaneNumbers& gaps) noexcept {
  bool is_pierced = false;
  for (std::size_t i = 0; i < planes.count; ++i) {
    gaps[i] = signed_distance(planes.walls[i], q);
    is_pierced |= gaps[i] < 0.0;
  }
  return is_pierced;
}

// With the proxy held by the planes as a device with every motor would track it: of the fully actuated strategy, and of
// naïve rendering, before the motors.
template <glm::length_t D>
Contact<D> solve_isotropic_contact(const Vector<D>& q, const Planes<D>& planes,
                                   const Compliances<D>& compliances) noexcept {
  Contact<D> contact{q};
  PlaneNumbers gaps;
  if (!measure_gaps(planes, q, gaps)) return contact;
  contact.status = ContactStatus::contact;
  for (const PlaneSet set : plane_sets) {
    if (set >= (1U << planes.count)) continue;
    if (!find_multipliers(planes, gaps, compliances.tracking, compliances.constraint, set, contact.multipliers,
                          contact.contact_force)) {
      continue;
    }
    contact.active = static_cast<std::uint8_t>(set);
    contact.proxy = q + compliances.tracking * contact.contact_force;
    return contact;
  }
  refuse(q, contact);
  return contact;
}

// Full actuation: every axis a motor. The efforts are what the motors that exist contribute to it; without `actuation`
// there are none.
template <glm::length_t D>
Contact<D> solve_full_contact(const Vector<D>& q, const Planes<D>& planes, const ActuationMatrix<D>& actuation,
                              const Compliances<D>& compliances) noexcept {
  Contact<D> contact = solve_isotropic_contact(q, planes, compliances);
  contact.force = compliances.force_share * contact.contact_force;
  for (std::size_t i = 0; i < actuation.count; ++i) {
    contact.efforts[i] = glm::dot(actuation.commands[i], contact.force);
  }
  return contact;
}

// Motors in a state, as the cure has them, and how the proxy is tracked then.
template <glm::length_t D>
struct TrackedState {
  MotorState state;
  NearestForce<D> nearest;
  Matrix<D> tracking;    // C_t [m/N]
  Vector<D> shift{0.0};  // of the proxy: motors at a limit push whether or not a plane does [m]
};

// False: motors cannot be in this state, or another one does the same with fewer free motors.
template <glm::length_t D>
bool find_tracked_state(const ActuationMatrix<D>& actuation, const Compliances<D>& compliances, double share,
                        const MotorState& state, TrackedState<D>& tracked) noexcept {
  if (!find_nearest_force(actuation, compliances.user, state, tracked.nearest)) return false;
  const Matrix<D>& projector = tracked.nearest.projection.projector;
  tracked.state = state;
  tracked.tracking = tracking_compliance(compliances, projector, share);
  const Vector<D>& limit_force = tracked.nearest.limit_force;
  tracked.shift = share * (compliances.user * (projector * limit_force - limit_force));
  return true;
}

// The efforts for the force that was meant for all motors: `share` of the way from what naïve rendering commands to the
// nearest. False: motors are not in this state then.
template <glm::length_t D>
bool find_shared_efforts(const ActuationMatrix<D>& actuation, const Compliances<D>& compliances, double share,
                         const TrackedState<D>& tracked, const Vector<D>& meant, Efforts& efforts) noexcept {
  if (!find_efforts(actuation, compliances.user, tracked.state, tracked.nearest, meant, efforts)) return false;
  if (actuation.count > 1) make_least(actuation, efforts);
  if (share == 1.0) return true;
  for (std::size_t i = 0; i < actuation.count; ++i) {
    const double commanded = within_limits(actuation, i, glm::dot(actuation.commands[i], meant));
    efforts[i] = within_limits(actuation, i, commanded + share * (efforts[i] - commanded));
  }
  return true;
}

// Whether that is the state of the motors with the handle at q, whose `gaps` are measured; `contact` is what follows.
template <glm::length_t D>
bool solve_in_state(const Vector<D>& q, const Planes<D>& planes, const PlaneNumbers& gaps,
                    const ActuationMatrix<D>& actuation, const Compliances<D>& compliances, double share,
                    const TrackedState<D>& tracked, Contact<D>& contact) noexcept {
  PlaneNumbers shifted;
  for (std::size_t i = 0; i < planes.count; ++i) {
    shifted[i] = gaps[i] + glm::dot(planes.walls[i].normal, tracked.shift);
  }
  for (const PlaneSet set : plane_sets) {
    if (set >= (1U << planes.count)) continue;
    if (!find_multipliers(planes, shifted, tracked.tracking, compliances.constraint, set, contact.multipliers,
                          contact.contact_force)) {
      continue;
    }
    const Vector<D> meant = compliances.force_share * contact.contact_force;
    if (!find_shared_efforts(actuation, compliances, share, tracked, meant, contact.efforts)) continue;
    contact.active = static_cast<std::uint8_t>(set);
    contact.proxy = q + tracked.tracking * contact.contact_force + tracked.shift;
    contact.force = force_of_efforts(actuation, contact.efforts);
    return true;
  }
  return false;
}

// Naïve rendering: full actuation's proxy and commands, without the motors that are missing.
template <glm::length_t D>
Contact<D> solve_naive_contact(const Vector<D>& q, const Planes<D>& planes, const ActuationMatrix<D>& actuation,
                               const Compliances<D>& compliances) noexcept {
  Contact<D> contact = solve_isotropic_contact(q, planes, compliances);
  if (contact.status != ContactStatus::contact) return contact;
  contact.efforts = commanded_efforts(actuation, compliances.force_share * contact.contact_force);
  contact.force = force_of_efforts(actuation, contact.efforts);
  return contact;
}

// `share`: s. 0 is naïve rendering, 1 the cure. Between them the proxy's compliance and the efforts change evenly; beyond
// 1 the efforts stay in U.
template <glm::length_t D>
Contact<D> solve_contact(const Vector<D>& q, const Planes<D>& planes, const ActuationMatrix<D>& actuation,
                         const Compliances<D>& compliances, double share) noexcept {
  if (share == 0.0) return solve_naive_contact(q, planes, actuation, compliances);
  Contact<D> contact{q};
  PlaneNumbers gaps;
  if (!measure_gaps(planes, q, gaps)) return contact;
  contact.status = ContactStatus::contact;
  TrackedState<D> tracked;
  for (const MotorState& state : motor_states_of(actuation)) {
    if (find_tracked_state(actuation, compliances, share, state, tracked) &&
        solve_in_state(q, planes, gaps, actuation, compliances, share, tracked, contact)) {
      return contact;
    }
  }
  refuse(q, contact);
  return contact;
}

}  // namespace ghostforce
