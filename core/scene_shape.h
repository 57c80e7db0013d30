// What a picture asks of a scene's constraint and of its device, whatever kind they are of. Of the paper's scenes the
// answers are those of wall_of() and of the actuated angle, to the bit. Pure, any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/general_equilibrium.h"
#include "core/prediction.h"
#include "core/settings.h"

namespace ghostforce {

// --- The constraint ---

// The wall that a place is deepest in, or that is nearest to it. A round wall is its tangent there.
Wall<2> wall_near(const Settings& settings, const Vector<2>& place) noexcept;

// The nearest point of the edge [m].
Vector<2> foot_on_edge(const Settings& settings, const Vector<2>& place) noexcept;

// Positive in the wall [m].
inline double depth_in_wall(const Settings& settings, const Vector<2>& place) noexcept {
  return depth(wall_near(settings, place), place);
}

// The walls that hold a proxy there, bit i for wall i.
std::uint8_t acting_walls(const Settings& settings, const Vector<2>& proxy, bool in_contact) noexcept;

// --- The device ---

// The paper's scene that this one is like under that goal: its wall there, and its motor along its line there.
Settings flattened(const Settings& settings, const Vector<2>& goal) noexcept;

// What its motors can do to a handle at one place.
struct MotorReach {
  std::array<Vector<2>, most_motors> directions{};  // in which each pushes, of unit length
  std::size_t count = 0;                            // 0: the handle cannot be there
  bool only_pulls = false;                          // else each pushes the other way, too
  Vector<2> missing{0.0};                           // the direction of the motor that is not there; strings: none

  bool is_one_line() const noexcept { return count == 1 && !only_pulls; }
};
MotorReach motor_reach(const Settings& settings, const Vector<2>& handle) noexcept;

// Of the rail through a handle there. Where there is none: along x.
Vector<2> rail_direction(const Settings& settings, const Vector<2>& handle) noexcept;

// What of a force the motors can make at a handle there, as near as they come to it in the hand's measure [N].
Vector<2> motor_share(const Settings& settings, const Vector<2>& handle, const Vector<2>& force) noexcept;

// The efforts that make this force, one per motor [N or N·m].
Efforts efforts_of(const Settings& settings, const Vector<2>& handle, const Vector<2>& force) noexcept;

// Whether efforts are torques, and the scene has a motor at one of several joints.
inline bool has_joints(const Settings& settings) noexcept {
  const MechanismKind kind = settings.general.mechanism;
  return kind == MechanismKind::arm || kind == MechanismKind::pantograph;
}

inline bool has_strings(const Settings& settings) noexcept {
  return settings.general.mechanism == MechanismKind::strings;
}

// The same scene with its motor at the other joint; without joints the same.
Settings with_other_motor(Settings settings) noexcept;

// Strings that push nothing and could not: each has less than this [N].
inline constexpr double least_tension = 0.005;

// How many of its strings are slack under these efforts; without strings none.
std::size_t slack_strings(const Settings& settings, const Efforts& efforts) noexcept;

// --- Where it rests ---

// Empty: nowhere.
std::optional<PredictedEquilibrium> rest_of(StrategyId id, const Settings& settings, const Vector<2>& goal) noexcept;

// With one motor and without a ghost force, whatever the renderer believes and the person has chosen.
std::optional<Equilibrium<2>> rest_without_ghost(const Settings& settings, const Vector<2>& goal) noexcept;

}  // namespace ghostforce
