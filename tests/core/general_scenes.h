// The five general scenes that are shipped, as settings: for tests that need no file.
#pragma once

#include <numbers>

#include "core/settings.h"

namespace ghostforce {

inline Settings common_general_settings() {
  Settings settings;
  settings.mass = 0.1;
  settings.damping = 5.0;
  settings.rate = 1000.0;
  settings.stiffnesses.k_u = 200.0;
  settings.stiffnesses.k_r = 600.0;
  settings.stiffnesses.k_t = 600.0;
  settings.stiffnesses.k_c = 1e5;
  return settings;
}

inline Settings arm_settings() {
  Settings settings = common_general_settings();
  settings.wall_normal_angle = 135.0 / degrees_per_radian;
  settings.general.mechanism = MechanismKind::arm;
  settings.general.arm = {{-0.150, -0.150}, {0.160, 0.160}, TwoLinkArm::Elbow::left, TwoLinkArm::Motor::base};
  return settings;
}

inline Settings pantograph_settings() {
  Settings settings = common_general_settings();
  settings.wall_normal_angle = 100.0 / degrees_per_radian;
  settings.general.mechanism = MechanismKind::pantograph;
  settings.general.pantograph = {
      {Vector<2>(-0.035, -0.170), Vector<2>(0.035, -0.170)}, 0.110, 0.140, FiveBar::Motor::left};
  return settings;
}

inline Settings string_settings() {
  Settings settings = common_general_settings();
  settings.wall_normal_angle = 100.0 / degrees_per_radian;
  settings.general.mechanism = MechanismKind::strings;
  settings.general.strings.anchors = {Vector<2>(-0.200, 0.060), Vector<2>(-0.060, -0.200)};
  settings.general.strings.count = 2;
  return settings;
}

inline Settings corner_settings() {
  Settings settings = common_general_settings();
  settings.actuated_angle = 20.0 / degrees_per_radian;
  settings.general.constraint = ConstraintKind::corner;
  settings.general.corner_normal_angles = {130.0 / degrees_per_radian, 40.0 / degrees_per_radian};
  return settings;
}

inline Settings curve_settings() {
  Settings settings = common_general_settings();
  settings.general.constraint = ConstraintKind::circle;
  settings.general.circle_radius = 0.035;
  return settings;
}

// An arm whose handle is near the inner edge of its reach, under a goal there: with every motor it rests, with the cure's
// one motor nothing balances.
inline constexpr Vector<2> goal_near_edge{0.049815239, -0.011922822};
inline Settings with_arm_near_edge(Settings settings) {
  settings.wall_normal_angle = 153.339 / degrees_per_radian;
  settings.general.arm = {
      {0.227949921, 0.146630707}, {0.990, 0.762879}, TwoLinkArm::Elbow::left, TwoLinkArm::Motor::base};
  settings.stiffnesses.k_u = 90.526;
  settings.stiffnesses.k_r = 3930.59;
  settings.stiffnesses.k_t = 3593.31;
  settings.stiffnesses.k_c = 1756.5;
  settings.general.k_u_second = 42.647;
  settings.general.k_u_first_angle = 0.54 / degrees_per_radian;
  return settings;
}

}  // namespace ghostforce
