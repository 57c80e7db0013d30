#include "app/state/scene_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "core/general_tick.h"
#include "core/scene.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

ScenePart nth_after(ScenePart first, std::size_t i) noexcept {
  return static_cast<ScenePart>(static_cast<std::size_t>(first) + i);
}

void add_device_parts(const Settings& settings, const Vector<2>& handle, std::vector<PlacedPart>& parts) {
  const GeneralSettings& general = settings.general;
  switch (general.mechanism) {
    case MechanismKind::axes:
      break;
    case MechanismKind::arm: {
      parts.push_back({ScenePart::left_base, general.arm.base, true});
      const LinkagePose pose = nearest_pose(general.arm, handle);
      const std::size_t elbow = general.arm.motor == TwoLinkArm::Motor::base ? 1 : 0;
      parts.push_back({ScenePart::elbow, pose.joints[elbow], true, true});
      break;
    }
    case MechanismKind::pantograph:
      for (std::size_t i = 0; i < 2; ++i) {
        parts.push_back({nth_after(ScenePart::left_base, i), general.pantograph.bases[i], true});
      }
      break;
    case MechanismKind::strings:
      for (std::size_t i = 0; i < general.strings.count; ++i) {
        parts.push_back({nth_after(ScenePart::first_anchor, i), general.strings.anchors[i], false});
      }
      break;
  }
}

void add_wall_parts(const Settings& settings, double wall_reach, std::vector<PlacedPart>& parts) {
  const GeneralSettings& general = settings.general;
  if (general.constraint == ConstraintKind::circle) {
    parts.push_back({ScenePart::circle_middle, general.circle_center, false});
    parts.push_back({ScenePart::circle_edge, general.circle_center + Vector<2>(0.0, general.circle_radius), false});
  } else if (general.constraint == ConstraintKind::corner) {
    const Outline edge = outline(constraint_of(settings), wall_reach);
    parts.push_back({ScenePart::corner, settings.wall_point, false});
    for (std::size_t i = 0; i < 2; ++i)
      parts.push_back({nth_after(ScenePart::first_wall, i), edge.points[2 * i], false});
  }
}

// The wall turns about the corner with its edge through there, and keeps its side. Where both would enclose too little
// or too much, it stays.
void turn_wall(std::size_t which, const Vector<2>& to, Settings& settings) noexcept {
  std::array<double, 2>& angles = settings.general.corner_normal_angles;
  const Vector<2> along = to - settings.wall_point;
  if (glm::length(along) == 0.0) return;
  const Vector<2> across(-along.y, along.x);
  const Vector<2> normal = glm::dot(across, direction_at(angles[which])) < 0.0 ? -across : across;
  const double before = std::exchange(angles[which], std::atan2(normal.y, normal.x));
  if (find_corner_problem(settings.general)) angles[which] = before;
}

}  // namespace

std::vector<PlacedPart> scene_parts(const Settings& settings, const Vector<2>& handle, double wall_reach) {
  std::vector<PlacedPart> parts;
  add_device_parts(settings, handle, parts);
  add_wall_parts(settings, wall_reach, parts);
  return parts;
}

Settings with_part_at(Settings settings, ScenePart part, const Vector<2>& to, const Vector<2>& goal) noexcept {
  constexpr NumberRange radii{0.001, 1.0};  // [m]
  const Vector<2> place = nearest_in_scene(to);
  GeneralSettings& general = settings.general;
  const auto within_reach = [&](double longest) {
    const double least_room = 0.95 * longest;
    const double distance = glm::distance(place, goal);
    return distance <= least_room ? place : goal + (place - goal) * (least_room / distance);
  };
  const std::size_t number = static_cast<std::size_t>(part);
  switch (part) {
    case ScenePart::left_base:
    case ScenePart::right_base:
      if (general.mechanism == MechanismKind::pantograph) {
        FiveBar moved = general.pantograph;
        moved.bases[number - static_cast<std::size_t>(ScenePart::left_base)] =
            within_reach(moved.proximal + moved.distal);
        if (has_elbows_outward(moved, goal)) general.pantograph = moved;
      } else if (general.mechanism == MechanismKind::arm && part == ScenePart::left_base) {
        general.arm.base = within_reach(general.arm.links[0] + general.arm.links[1]);
      }
      break;
    case ScenePart::first_anchor:
    case ScenePart::second_anchor:
    case ScenePart::third_anchor:
    case ScenePart::fourth_anchor:
      general.strings.anchors[number - static_cast<std::size_t>(ScenePart::first_anchor)] = place;
      break;
    case ScenePart::corner:
      settings.wall_point = place;
      break;
    case ScenePart::first_wall:
    case ScenePart::second_wall:
      turn_wall(number - static_cast<std::size_t>(ScenePart::first_wall), place, settings);
      break;
    case ScenePart::circle_middle:
      general.circle_center = place;
      break;
    case ScenePart::circle_edge:
      general.circle_radius = radii.nearest_to(glm::distance(place, general.circle_center));
      break;
    case ScenePart::elbow:
      break;
  }
  return settings;
}

}  // namespace ghostforce
