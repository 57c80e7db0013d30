#include "core/scene_shape.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace ghostforce {

Wall<2> wall_near(const Settings& settings, const Vector<2>& place) noexcept {
  if (settings.general.constraint == ConstraintKind::plane) return wall_of(settings);
  const Planes<2> planes = linearised(constraint_of(settings), place);
  Wall<2> nearest = planes.walls[0];
  for (std::size_t i = 1; i < planes.count; ++i) {
    if (signed_distance(planes.walls[i], place) < signed_distance(nearest, place)) nearest = planes.walls[i];
  }
  return nearest;
}

Vector<2> foot_on_edge(const Settings& settings, const Vector<2>& place) noexcept {
  if (settings.general.constraint == ConstraintKind::plane) return projection(wall_of(settings), place);
  return projection(constraint_of(settings), place);
}

std::uint8_t acting_walls(const Settings& settings, const Vector<2>& proxy, bool in_contact) noexcept {
  constexpr double rounding = 1e-9;  // of a hard wall [m]
  std::uint8_t acting = 0;
  if (!in_contact) return acting;
  const Planes<2> planes = linearised(constraint_of(settings), proxy);
  for (std::size_t i = 0; i < planes.count; ++i) {
    if (signed_distance(planes.walls[i], proxy) < rounding) acting = static_cast<std::uint8_t>(acting | 1U << i);
  }
  return acting;
}

Settings with_other_motor(Settings settings) noexcept {
  TwoLinkArm::Motor& arm = settings.general.arm.motor;
  FiveBar::Motor& pantograph = settings.general.pantograph.motor;
  if (settings.general.mechanism == MechanismKind::arm) {
    arm = arm == TwoLinkArm::Motor::base ? TwoLinkArm::Motor::elbow : TwoLinkArm::Motor::base;
  } else if (settings.general.mechanism == MechanismKind::pantograph) {
    pantograph = pantograph == FiveBar::Motor::left ? FiveBar::Motor::right : FiveBar::Motor::left;
  }
  return settings;
}

MotorReach motor_reach(const Settings& settings, const Vector<2>& handle) noexcept {
  MotorReach reach;
  if (settings.general.mechanism == MechanismKind::axes) {
    const Vector<2> along = direction_at(settings.actuated_angle);
    reach.directions[0] = along;
    reach.count = 1;
    reach.missing = {along.y, -along.x};
    return reach;
  }
  const Mechanism mechanism = mechanism_of(settings);
  const std::optional<ActuationMatrix<2>> actuation = actuation_at(mechanism, handle);
  if (!actuation) return reach;
  reach.count = actuation->count;
  reach.only_pulls = has_strings(settings);
  for (std::size_t i = 0; i < actuation->count; ++i) reach.directions[i] = glm::normalize(actuation->columns[i]);
  if (!has_joints(settings)) return reach;
  const auto missing = actuation_at(mechanism_of(with_other_motor(settings)), handle);
  if (missing) reach.missing = glm::normalize(missing->columns[0]);
  return reach;
}

Vector<2> rail_direction(const Settings& settings, const Vector<2>& handle) noexcept {
  const MotorReach reach = motor_reach(settings, handle);
  return reach.count == 0 ? Vector<2>(1.0, 0.0) : reach.directions[0];
}

Settings flattened(const Settings& settings, const Vector<2>& goal) noexcept {
  if (!is_general(settings)) return settings;
  const Wall<2> wall = wall_near(settings, goal);
  const Vector<2> rail = rail_direction(settings, goal);
  Settings flat = settings;
  flat.general = {};
  flat.wall_point = wall.point;
  flat.wall_normal_angle = std::atan2(wall.normal.y, wall.normal.x);
  flat.actuated_angle = std::atan2(rail.y, rail.x);
  return flat;
}

Vector<2> motor_share(const Settings& settings, const Vector<2>& handle, const Vector<2>& force) noexcept {
  if (!is_general(settings)) return actuation_of(settings).actuated * force;
  const GeneralScene scene = general_scene_of(settings);
  const std::optional<ActuationMatrix<2>> actuation = actuation_at(scene.mechanism, handle);
  if (!actuation) return force;
  return force_of_efforts(*actuation, nearest_efforts(*actuation, scene.user_compliance, force));
}

Efforts efforts_of(const Settings& settings, const Vector<2>& handle, const Vector<2>& force) noexcept {
  const GeneralScene scene = general_scene_of(settings);
  const std::optional<ActuationMatrix<2>> actuation = actuation_at(scene.mechanism, handle);
  return actuation ? nearest_efforts(*actuation, scene.user_compliance, force) : Efforts{};
}

std::size_t slack_strings(const Settings& settings, const Efforts& efforts) noexcept {
  if (!has_strings(settings)) return 0;
  const auto end = efforts.begin() + settings.general.strings.count;
  return static_cast<std::size_t>(
      std::count_if(efforts.begin(), end, [](double effort) { return effort < least_tension; }));
}

std::optional<PredictedEquilibrium> rest_of(StrategyId id, const Settings& settings, const Vector<2>& goal) noexcept {
  if (!is_general(settings)) return predicted_equilibria(settings, goal)[index_of(id)];
  const GeneralScene scene = general_scene_of(settings);
  const auto rest = general_equilibrium_of(id, scene, goal);
  if (!rest) return std::nullopt;
  if (!rest->at.in_contact || scene.strategies[index_of(id)].has_every_motor) return PredictedEquilibrium{rest->at};
  const auto full = general_equilibrium_of(StrategyId::full, scene, goal);
  if (!full) return std::nullopt;
  const PredictedGeneralEquilibrium predicted = with_cost(scene, id, *rest, *full);
  return PredictedEquilibrium{rest->at, predicted.ghost_force, predicted.slide};
}

std::optional<Equilibrium<2>> rest_without_ghost(const Settings& settings, const Vector<2>& goal) noexcept {
  if (!is_general(settings)) {
    const Stiffnesses& stiffnesses = settings.stiffnesses;
    return equilibrium_with_ratio(wall_of(settings), actuation_of(settings), stiffnesses,
                                  optimal_tracking_ratio(stiffnesses.k_r, stiffnesses.k_u), goal);
  }
  Settings cured = settings;
  cured.stiffnesses.believed_k_u.reset();
  cured.general.compliance_share = 1.0;
  const auto rest = general_equilibrium_of(StrategyId::anisotropic, general_scene_of(cured), goal);
  return rest ? std::optional(rest->at) : std::nullopt;
}

}  // namespace ghostforce
