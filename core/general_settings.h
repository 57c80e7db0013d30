// What a scene of the second format says beyond one wall, one direction with a motor and a hand that is as stiff all
// round: other constraints, other mechanisms, the hand's ellipse. A plain value, trivially copyable, part of Settings.
// The parameters of all kinds stand side by side, so that each has a place that a key of a file can name.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/conventions.h"
#include "core/mechanism.h"

namespace ghostforce {

enum class ConstraintKind : std::uint8_t { plane, corner, circle };
enum class MechanismKind : std::uint8_t { axes, arm, pantograph, strings };

struct GeneralSettings {
  ConstraintKind constraint =
      ConstraintKind::plane;                     // plane: Settings has its point and its normal, a corner its point
  std::array<double, 2> corner_normal_angles{};  // counter-clockwise from +x [rad]
  Vector<2> circle_center{0.0};                  // [m]
  double circle_radius = 0.05;                   // [m]
  bool circle_is_free_inside = true;

  MechanismKind mechanism = MechanismKind::axes;  // axes: Settings has the direction
  TwoLinkArm arm;
  FiveBar pantograph;
  Strings strings;

  std::optional<double> k_u_second;  // the hand's stiffness across the direction in which it is k_u [N/m]; empty: k_u
  double k_u_first_angle = 0.0;      // that direction, counter-clockwise from +x [rad]
  double compliance_share = 1.0;     // s of the cure [1]: 0 is naïve rendering

  friend bool operator==(const GeneralSettings&, const GeneralSettings&) = default;
};

// Whether the scene needs the general loop (general_tick.h). Any other one is the paper's, and runs through tick.h.
inline bool is_general(const GeneralSettings& general) noexcept {
  return general.constraint != ConstraintKind::plane || general.mechanism != MechanismKind::axes ||
         general.k_u_second.has_value() || general.compliance_share != 1.0;
}

}  // namespace ghostforce
