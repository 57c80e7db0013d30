#include "app/state/stage_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/state/stage_moment.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

constexpr double least_width = 0.03;                               // of a view [m]
constexpr double greatest_scale = stage_view_width / least_width;  // [points/m]
constexpr double usual_arrow = 235.0;
constexpr double longest_arrow = 300.0;

// How far things reach from their middle, with their rims.
constexpr double handle_reach = 31.0;
constexpr double rails_reach = 90.0;  // of two motors
constexpr double proxy_reach = 20.0;
constexpr double arm_length = 70.0;
constexpr double arm_reach = 23.0;
constexpr double arrow_reach = 19.0;
constexpr double ruler_distance = 34.0;  // from the wall
constexpr double ruler_reach = 12.0;

}  // namespace

double arrow_points_per_newton(double reference_force, double greatest) noexcept {
  return std::min(usual_arrow / reference_force, longest_arrow / greatest);
}

std::vector<StageStroke> stage_strokes(const Settings& settings, const Vector<2>& goal, double reference_force) {
  std::vector<StageStroke> strokes;
  const Vector<2> out = to_screen_direction(wall_near(settings, goal).normal);
  for (const Strategy& strategy : strategy_catalog()) {
    Settings each = settings;
    each.active = strategy.id;
    const StageMoment moment = stage_moment_at_rest(each, goal);
    strokes.push_back({{moment.handle}, {goal}, handle_reach});
    if (strategy.has_every_motor) strokes.push_back({{moment.handle}, {moment.handle}, rails_reach});
    // The arm lies between these two, depending on how far away it is seen.
    const double pull = glm::distance(goal, moment.handle);
    const Vector<2> away = pull > 0.0 ? to_screen_direction(goal - moment.handle) / pull : -out;
    for (const Vector<2>& arm : {away, -out}) strokes.push_back({{goal}, {goal, arm * arm_length}, arm_reach});
    // So that the wall is seen, too.
    strokes.push_back({{moment.expected_contact}, {moment.expected_contact}, ruler_reach});
    if (!moment.in_contact) continue;
    strokes.push_back({{moment.handle}, {moment.proxy}, proxy_reach});
    strokes.push_back({{moment.expected_rest}, {moment.expected_rest}, proxy_reach});
    const Vector<2> ruler = out * ruler_distance;
    strokes.push_back({{moment.expected_contact}, {moment.expected_contact, ruler}, ruler_reach});
    strokes.push_back({{moment.expected_contact, ruler}, {moment.expected_contact + moment.slide, ruler}, ruler_reach});
    const double share = glm::length(moment.wall_share);
    const double whole = share + signed_ghost_force(moment);
    const Vector<2> force = share > 0.0 ? moment.wall_share / share : moment.ghost_force;
    if (const double length = glm::length(force); length > 0.0) {
      const double points = arrow_points_per_newton(reference_force, std::max(share, std::abs(whole)));
      const Vector<2> along = to_screen_direction(force) * (points / length);
      strokes.push_back({{moment.handle, along * std::min(0.0, whole)},
                         {moment.handle, along * std::max(share, whole)},
                         arrow_reach});
    }
  }
  return strokes;
}

namespace {

// Base, elbows and anchors. Where the contact would be tiny beside them, the way to them as far as it is not.
void add_device(const Settings& settings, std::span<const Vector<2>> goals, std::vector<FitPoint>& points) {
  constexpr double most_shrunk = 0.36;
  constexpr double reach = 24.0;  // of a joint
  if (settings.general.mechanism == MechanismKind::axes) return;
  const double closest = fitting_scale(points, stage_view_room, greatest_scale);
  const Vector<2> middle = fitting_center(points, closest);
  std::vector<Vector<2>> joints;
  for (const Vector<2>& goal : goals) {
    const LinkagePose pose = nearest_pose(mechanism_of(settings), goal);
    joints.insert(joints.end(), pose.joints.begin(), pose.joints.begin() + pose.joint_count - 1);
  }
  for (double share = 1.0; !joints.empty() && share > 0.0; share -= 0.1) {
    std::vector<FitPoint> all = points;
    for (const Vector<2>& joint : joints) {
      for (const double offset : {-reach, reach}) all.push_back({glm::mix(middle, joint, share), Vector<2>(offset)});
    }
    if (fitting_scale(all, stage_view_room, greatest_scale) < most_shrunk * closest) continue;
    points = std::move(all);
    return;
  }
}

}  // namespace

StageStroke guess_stroke(const Vector<2>& guess) noexcept {
  constexpr double ring_reach = 40.0;
  return {{guess}, {guess}, ring_reach};
}

SceneView stage_view_of(const Settings& settings, std::span<const Vector<2>> goals, double reference_force,
                        const std::optional<Vector<2>>& guess) {
  std::vector<FitPoint> points;
  const auto add = [&points](const StageStroke& stroke) {
    for (const FitPoint& end : {stroke.from, stroke.to}) {
      for (const double reach : {-stroke.radius, stroke.radius}) {
        points.push_back({end.world, end.offset + Vector<2>(reach)});
      }
    }
  };
  for (const Vector<2>& goal : goals) {
    for (const StageStroke& stroke : stage_strokes(settings, goal, reference_force)) add(stroke);
  }
  if (guess) add(guess_stroke(*guess));
  add_device(settings, goals, points);
  const double scale = fitting_scale(points, stage_view_room, greatest_scale);
  return within_scene_limits({.center = fitting_center(points, scale), .width = stage_view_width / scale});
}

SceneView stage_view_of(const Settings& settings, const Vector<2>& goal) {
  return stage_view_of(settings, std::span(&goal, 1), reference_force_of(settings, goal));
}

SceneView stage_view_of(const LinkagePose& pose) {
  std::vector<FitPoint> points;
  for (std::size_t i = 0; i < pose.joint_count; ++i) points.push_back({pose.joints[i], Vector<2>(0.0)});
  const double scale = 0.8 * fitting_scale(points, stage_view_room, greatest_scale);
  return within_scene_limits({.center = fitting_center(points, scale), .width = stage_view_width / scale});
}

SceneView workspace_view(const Settings& settings) {
  const GeneralSettings& general = settings.general;
  const bool is_arm = general.mechanism == MechanismKind::arm;
  const std::array<Vector<2>, 2> bases =
      is_arm ? std::array{general.arm.base, general.arm.base} : general.pantograph.bases;
  const double reach =
      is_arm ? general.arm.links[0] + general.arm.links[1] : general.pantograph.proximal + general.pantograph.distal;
  std::vector<FitPoint> points;
  for (const Vector<2>& base : bases) {
    for (const double side : {-1.0, 1.0}) points.push_back({base + Vector<2>(side * reach), Vector<2>(0.0)});
  }
  const double scale = fitting_scale(points, stage_view_room, greatest_scale);
  return within_scene_limits({.center = fitting_center(points, scale), .width = stage_view_width / scale});
}

double reference_force_of(const Settings& settings, const Vector<2>& goal) {
  constexpr double least = 0.1;  // [N]
  const auto naive = rest_of(StrategyId::naive, settings, goal);
  const auto shown = naive ? naive : rest_of(StrategyId::full, settings, goal);
  return shown ? std::max(least, glm::length(shown->at.force)) : least;
}

}  // namespace ghostforce
