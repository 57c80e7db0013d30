// Walls that are not straight, and devices that are more than one line: drawn from what core tells of any of them.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "app/stage/stage_layers.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

constexpr double quiet_spacing = 22.0;  // as beside a straight wall
constexpr double ruler_distance = 34.0;

void add_edge(const StageLayer& layer, const std::vector<Vector<2>>& corners, double width, Colour colour) {
  StageCanvas& canvas = layer.canvas;
  canvas.curve(Role::wall, corners, canvas.width(width), colour);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    canvas.labels.keep_clear(corners[i - 1], corners[i], 0.5 * canvas.width(width), Clearance::if_possible);
  }
}

// `whole_pieces`: all round.
std::vector<Vector<2>> circle_points(const Vector<2>& middle, double radius, double from, double to,
                                     double whole_pieces = 240.0) {
  const double turns = std::abs(to - from) / (2.0 * std::numbers::pi);
  const int pieces = std::max(2, static_cast<int>(std::ceil(turns * whole_pieces)));
  std::vector<Vector<2>> points;
  for (int i = 0; i <= pieces; ++i) points.push_back(middle + radius * direction_at(from + (to - from) * i / pieces));
  return points;
}

// Both walls, the ones that act stronger than the others.
void add_corner(const StageLayer& layer, const CornerWall& corner) {
  const auto& [content, layout, canvas] = layer;
  const StageMoment& moment = content.moment;
  for (const Vector<2>& normal : corner.normals) add_half_plane(layer, {corner.point, normal});
  const Outline edge = outline(corner, reach_of(canvas.camera, corner.point));
  const unsigned acting = acting_walls(content.settings, moment.proxy, moment.in_contact);
  const Theme& theme = content.theme;
  const auto add = [&](std::size_t i) {
    const bool acts = (acting >> i & 1U) != 0;
    add_edge(layer, {canvas.at(edge.points[1]), canvas.at(edge.points[2 * i])}, acts ? 9.0 : 5.0,
             acts || acting == 0 ? theme.wall_edge : mix(theme.wall, theme.wall_edge, 0.55));
  };
  // What acts lies over what does not.
  const std::size_t last = acting == 2U ? 1 : 0;
  add(1 - last);
  add(last);
}

void add_round_wall(const StageLayer& layer, const RoundWall& wall) {
  const auto& [content, layout, canvas] = layer;
  const Theme& theme = content.theme;
  const double whole = 2.0 * std::numbers::pi;
  const Vector<2> middle = canvas.at(wall.center);
  const double radius = wall.radius * canvas.camera.points_per_metre;
  if (wall.is_free_inside) canvas.box(Role::wall, {Vector<2>(0.0), layout.size}, 0.0, theme.wall, theme.wall, 0.0);
  canvas.marks.push_back(
      {Role::wall,
       {},
       Area{circle_points(wall.center, wall.radius, 0.0, whole), wall.is_free_inside ? theme.background : theme.wall}});
  const Colour quiet = mix(theme.wall, theme.wall_edge, 0.07);
  constexpr int most_rings = 8;
  for (int i = 1; i <= most_rings; ++i) {
    const double away = i * canvas.points(quiet_spacing);
    const double ring = wall.is_free_inside ? radius + away : radius - away;
    if (ring <= 0.0) break;
    canvas.curve(Role::hatching, circle_points(middle, ring, 0.0, whole, 96.0), canvas.points(2.5), quiet);
  }
  add_edge(layer, circle_points(middle, radius, 0.0, whole), 5.0, theme.wall_edge);
}

// --- The device ---

struct DeviceColours {
  Colour link;
  Colour strong;
  Colour paper;
};

DeviceColours device_colours(const Theme& theme) {
  return {mix(theme.wall, theme.wall_edge, 0.5), mix(theme.wall_edge, theme.background, 0.08), theme.background};
}

// A slack string hangs through, in dashes.
void add_slack_string(StageCanvas& canvas, const Vector<2>& from, const Vector<2>& to, Colour colour) {
  constexpr double sag = 0.12;  // of the length
  const double length = glm::distance(from, to);
  const int pieces = 2 * std::max(3, static_cast<int>(length / canvas.points(16.0) / 2.0)) + 1;
  const auto place = [&](int i) {
    const double along = static_cast<double>(i) / pieces;
    return glm::mix(from, to, along) + Vector<2>(0.0, 4.0 * sag * length * along * (1.0 - along));
  };
  for (int i = 0; i < pieces; i += 2) canvas.line(Role::linkage, place(i), place(i + 1), canvas.width(2.5), colour);
}

bool has_device(const StageContent& content) {
  return content.linkage || content.settings.general.mechanism != MechanismKind::axes;
}

LinkagePose device_pose(const StageContent& content) {
  return content.linkage ? *content.linkage : nearest_pose(mechanism_of(content.settings), content.moment.handle);
}

// `size`: of what does not depend on the view.
void add_strings(const StageLayer& layer, const LinkagePose& pose, double size, const auto& at) {
  const auto& [content, layout, canvas] = layer;
  const StageMoment& moment = content.moment;
  const DeviceColours colours = device_colours(content.theme);
  const Efforts efforts = efforts_of(content.settings, moment.handle, moment.wall_share + moment.ghost_force);
  constexpr double thinnest = 2.5;
  constexpr double thickest = 7.0;  // more than at the reference force
  for (std::size_t i = 0; i < pose.motor_count; ++i) {
    const Vector<2> anchor = at(pose.joints[i]);
    const Vector<2> handle = at(moment.handle);
    if (efforts[i] < least_tension) {
      add_slack_string(canvas, anchor, handle, colours.link);
    } else {
      const double share = std::min(1.0, efforts[i] / content.reference_force);
      canvas.line(Role::linkage, anchor, handle, canvas.width(size * glm::mix(thinnest, thickest, share)),
                  colours.strong);
    }
    canvas.labels.keep_clear(anchor, handle, canvas.width(2.0), Clearance::if_possible);
    canvas.disc(Role::joint, anchor, canvas.points(13.0 * size), colours.strong, colours.paper, canvas.width(3.0));
    canvas.labels.keep_clear(anchor, anchor, canvas.points(14.0));
  }
}

// Of both joints that may have a motor the first one has it. With every motor, so has the other.
void add_links(const StageLayer& layer, const LinkagePose& pose, double size, const auto& at) {
  const auto& [content, layout, canvas] = layer;
  const DeviceColours colours = device_colours(content.theme);
  const double fullness = content.moment.weights[index_of(StrategyId::full)];
  for (std::size_t i = 0; i < pose.link_count; ++i) {
    const Vector<2> from = at(pose.joints[pose.links[i].from]);
    const Vector<2> to = at(pose.joints[pose.links[i].to]);
    canvas.line(Role::linkage, from, to, canvas.points(9.0 * size), colours.link);
    canvas.labels.keep_clear(from, to, canvas.points(5.0), Clearance::if_possible);
  }
  constexpr std::size_t motor_joints = 2;
  for (std::size_t i = 0; i + 1 < pose.joint_count; ++i) {
    const Vector<2> joint = at(pose.joints[i]);
    const bool may_have_motor = i < motor_joints;
    const double motor = i == 0 ? 1.0 : may_have_motor ? fullness : 0.0;
    const double radius = canvas.points(size * (may_have_motor ? 15.0 : 7.0));
    canvas.disc(Role::joint, joint, radius, colours.paper, may_have_motor ? colours.strong : colours.link,
                canvas.width(size * (may_have_motor ? 4.0 : 3.0)));
    if (motor > 0.0) {
      const Colour fill = mix(colours.paper, colours.strong, motor);
      canvas.disc(Role::joint, joint, canvas.points(9.0 * size), fill, fill, 0.0);
    }
    canvas.labels.keep_clear(joint, joint, radius + canvas.points(2.0));
  }
}

void add_device(const StageLayer& layer, const LinkagePose& pose, double size, const auto& at) {
  pose.links[0].is_string ? add_strings(layer, pose, size, at) : add_links(layer, pose, size, at);
}

// How far the hand yields to a force, whichever way it comes from.
void add_hand_ellipse(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const GeneralSettings& general = content.settings.general;
  if (!general.k_u_second) return;
  const double k_u = content.settings.stiffnesses.k_u;
  const double usual = std::sqrt(k_u * *general.k_u_second);
  constexpr NumberRange shown{0.4, 2.5};
  const double first = canvas.points(62.0) * shown.nearest_to(usual / k_u);
  const double second = canvas.points(62.0) * shown.nearest_to(usual / *general.k_u_second);
  const Vector<2> along = to_screen_direction(direction_at(general.k_u_first_angle));
  const Vector<2> across{-along.y, along.x};
  const Vector<2> middle = canvas.at(content.moment.goal);
  std::vector<Vector<2>> corners;
  for (const Vector<2>& point : circle_points(Vector<2>(0.0), 1.0, 0.0, 2.0 * std::numbers::pi)) {
    corners.push_back(middle + along * (first * point.x) + across * (second * point.y));
  }
  canvas.curve(Role::hand, corners, canvas.width(2.0), content.theme.faint_text);
}

}  // namespace

void add_shaped_wall(const StageLayer& layer) {
  const Constraint constraint = constraint_of(layer.content.settings);
  if (const auto* const corner = std::get_if<CornerWall>(&constraint)) add_corner(layer, *corner);
  if (const auto* const wall = std::get_if<RoundWall>(&constraint)) add_round_wall(layer, *wall);
}

namespace {

// On the circle's edge, as far from the contact as it can be seen, or where it is held; empty: nowhere.
std::optional<Vector<2>> grip_of_circle(const StageLayer& layer, const ScreenBox& room) {
  const auto& [content, layout, canvas] = layer;
  const GeneralSettings& general = content.settings.general;
  const auto at_angle = [&](double angle) {
    return general.circle_center + general.circle_radius * direction_at(angle);
  };
  if (content.held_end && content.held_end->grip == StageGrip::part && content.hovered_part == ScenePart::circle_edge) {
    const Vector<2> way = to_world(canvas.camera, content.held_end->pointer) - general.circle_center;
    return at_angle(std::atan2(way.y, way.x));
  }
  constexpr double step = std::numbers::pi / 36.0;
  std::optional<Vector<2>> farthest;
  double most = 0.0;
  for (double angle = 0.0; angle < 2.0 * std::numbers::pi; angle += step) {
    const Vector<2> place = at_angle(angle);
    const Vector<2> shown = canvas.at(place);
    const double apart = glm::distance(place, content.moment.expected_contact);
    if (!is_in_sight(layout, shown) || !contains(room, shown) || apart <= most) continue;
    most = apart;
    farthest = place;
  }
  return farthest;
}

// Of a real device, the joints with motors: a press chooses the one that pushes alone.
std::vector<PlacedPart> placed_parts(const StageContent& content, double farthest) {
  if (!content.linkage) return scene_parts(content.settings, content.moment.handle, farthest);
  return {{ScenePart::left_base, content.linkage->joints[0], true, true},
          {ScenePart::right_base, content.linkage->joints[1], true, true}};
}

}  // namespace

std::vector<StagePart> stage_parts(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  // Of a wall as far from its corner as it can be seen.
  constexpr double from_edges = 40.0;
  const ScreenBox room = layout.scene().grown(-canvas.points(from_edges));
  const double farthest = 0.3 * glm::length(layout.size) / canvas.camera.points_per_metre;
  std::vector<StagePart> parts;
  for (PlacedPart part : placed_parts(content, farthest)) {
    const bool is_turned = part.part == ScenePart::first_wall || part.part == ScenePart::second_wall;
    for (double share = 0.9; is_turned && share > 0.3 && !contains(room, canvas.at(part.at)); share -= 0.1) {
      const Vector<2> way = part.at - content.settings.wall_point;
      part.at = content.settings.wall_point + way * (share * farthest / glm::length(way));
    }
    if (part.part == ScenePart::circle_edge) part.at = grip_of_circle(layer, room).value_or(part.at);
    const Vector<2> place = canvas.at(part.at);
    if (is_in_sight(layout, place)) {
      parts.push_back({part, place, canvas.camera.points_per_metre});
    } else if (canvas.inset && !is_of_wall(part.part)) {
      parts.push_back({part, canvas.inset->at(part.at), canvas.inset->points_per_metre});
    }
  }
  return parts;
}

namespace {

void add_hot_ring(const StageLayer& layer, const Vector<2>& at, double radius) {
  StageCanvas& canvas = layer.canvas;
  const Theme& theme = layer.content.theme;
  canvas.disc(Role::joint, at, canvas.points(radius), theme.background.with_alpha(0), theme.accent, canvas.width(3.0));
}

}  // namespace

void add_part_grips(const StageLayer& layer) {
  const StageContent& content = layer.content;
  if (!content.may_move_parts) return;
  for (const StagePart& part : stage_parts(layer)) {
    const bool is_hot = content.hovered_part == part.placed.part;
    if (is_of_wall(part.placed.part)) add_knob(layer, part.place, is_hot);
    if (!is_of_wall(part.placed.part) && is_hot) add_hot_ring(layer, part.place, 19.0);
  }
}

std::optional<ScreenBox> place_of_device(const StageLayout& layout) {
  constexpr Vector<2> extent{200.0, 150.0};
  constexpr double least_height = 90.0;
  constexpr double apart = 14.0;
  if (!layout.numbers) return std::nullopt;
  ScreenBox place{layout.numbers->least, layout.numbers->least + extent * layout.unit};
  if (layout.is_upright) {
    // The scene lies below the numbers.
    place.most.x = layout.size.x - layout.margin;
    place.least.x = std::max(layout.numbers->most.x + apart * layout.unit, place.most.x - extent.x * layout.unit);
  } else {
    const auto tools = layout.tools_box();
    const auto motors = layout.motors_box();
    place.most.y = (motors ? motors->least.y : layout.bottom) - apart * layout.unit;
    place.least.y = std::max((tools ? tools->most.y : layout.numbers->most.y) + apart * layout.unit,
                             place.most.y - extent.y * layout.unit);
  }
  const Vector<2> found = place.extent();
  if (std::min(found.x, found.y) < least_height * layout.unit) return std::nullopt;
  return place;
}

void add_edge_in(const StageLayer& layer, const DeviceInset& part, Role role, double width, Colour colour) {
  const auto& [content, layout, canvas] = layer;
  const Outline edge = outline(constraint_of(content.settings), reach_of(canvas.camera, content.settings.wall_point));
  for (std::size_t i = 0; i + 1 < edge.count + (edge.is_closed ? 1 : 0); ++i) {
    ScreenPiece piece{part.at(edge.points[i]), part.at(edge.points[(i + 1) % edge.count]), 0.0};
    if (clip(part.box, piece)) canvas.line(role, piece.from, piece.to, canvas.width(width), colour);
  }
}

void add_device_inset(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  if (!has_device(content) || content.is_bare) return;
  const LinkagePose pose = device_pose(content);
  const std::span<const Vector<2>> joints(pose.joints.data(), pose.joint_count);
  const auto is_seen = [&](const Vector<2>& joint) { return is_in_sight(layout, canvas.at(joint)); };
  if (std::ranges::all_of(joints, is_seen)) return;
  const auto box = place_of_device(layout);
  if (!box) return;
  ScreenBox world{joints[0], joints[0]};
  for (const Vector<2>& joint : joints) world.include(joint);
  const double title = layout.letters.about.height;
  const Vector<2> room = box->extent() - Vector<2>(canvas.points(52.0), canvas.points(40.0) + title);
  const Vector<2> scale = room / glm::max(world.extent(), Vector<2>(1e-6));
  const double points_per_metre = std::min(scale.x, scale.y);
  const Vector<2> below_title(0.0, 0.5 * title / points_per_metre);
  canvas.inset = DeviceInset{*box, 0.5 * (world.least + world.most) + below_title, points_per_metre};
  const Theme& theme = content.theme;
  canvas.box(Role::linkage, *box, canvas.points(10.0), theme.background, theme.panel_border, canvas.width(2.0));
  canvas.labels.keep_clear(box->grown(canvas.points(4.0)));
  DeviceInset within_rim = *canvas.inset;
  within_rim.box = box->grown(-canvas.points(4.0));
  add_edge_in(layer, within_rim, Role::linkage, 2.0, mix(theme.wall, theme.wall_edge, 0.6));
  add_device(layer, pose, 0.55, [&](const Vector<2>& place) { return canvas.inset->at(place); });
  const Colour own = stage_colour(content.moment, theme.strategy);
  canvas.disc(Role::linkage, canvas.inset->at(content.moment.handle), canvas.points(6.0), own, own, 0.0);
  canvas.text(Role::linkage, box->least + Vector<2>(canvas.points(8.0), canvas.points(4.0)),
              std::string(content.language.labels.whole_device), layout.letters.about, theme.faint_text);
  for (const StagePart& part : content.may_move_parts ? stage_parts(layer) : std::vector<StagePart>()) {
    const bool is_hot = content.hovered_part == part.placed.part && contains(*box, part.place);
    if (is_hot) add_hot_ring(layer, part.place, 12.0);
  }
}

void add_mechanism(const StageLayer& layer) {
  add_hand_ellipse(layer);
  if (!has_device(layer.content)) return;
  const LinkagePose pose = device_pose(layer.content);
  add_device(layer, pose, 1.0, [&](const Vector<2>& place) { return layer.canvas.at(place); });
}

void add_pulls(const StageLayer& layer, const MotorReach& motors) {
  const auto& [content, layout, canvas] = layer;
  if (motors.count < 2) return;
  std::array<double, most_motors> angles{};
  for (std::size_t i = 0; i < motors.count; ++i) angles[i] = std::atan2(motors.directions[i].y, motors.directions[i].x);
  std::sort(angles.begin(), angles.begin() + motors.count);
  // What lies opposite the widest gap between two of them; all round, where that is less than a half turn.
  const double whole = 2.0 * std::numbers::pi;
  double widest = whole - (angles[motors.count - 1] - angles[0]);
  double from = angles[0];
  for (std::size_t i = 1; i < motors.count; ++i) {
    if (angles[i] - angles[i - 1] <= widest) continue;
    widest = angles[i] - angles[i - 1];
    from = angles[i];
  }
  const double reach = canvas.points(190.0) / canvas.camera.points_per_metre;
  const Vector<2>& handle = content.moment.handle;
  const bool is_cone = widest > std::numbers::pi;
  std::vector<Vector<2>> corners = circle_points(handle, reach, from, from + (is_cone ? whole - widest : whole));
  if (is_cone) corners.push_back(handle);
  const double strength = 1.0 - content.moment.weights[index_of(StrategyId::full)];
  const auto alpha = static_cast<std::uint8_t>(std::lround(40.0 * strength));
  canvas.marks.push_back({Role::reach, {}, Area{std::move(corners), content.theme.wall_edge.with_alpha(alpha)}});
}

SlideRuler round_ruler(const StageLayer& layer, const Vector<2>& from, const Vector<2>& out) {
  const auto& [content, layout, canvas] = layer;
  const StageMoment& moment = content.moment;
  const Vector<2>& center = content.settings.general.circle_center;
  const auto angle_of = [&](const Vector<2>& place) { return std::atan2(place.y - center.y, place.x - center.x); };
  const double begin = angle_of(moment.expected_contact);
  const double turn = std::remainder(angle_of(moment.expected_contact + moment.slide) - begin, 2.0 * std::numbers::pi);
  const double distance = canvas.points(ruler_distance) / canvas.camera.points_per_metre;
  const bool is_inside = content.settings.general.circle_is_free_inside;
  const double radius = content.settings.general.circle_radius + (is_inside ? -distance : distance);
  SlideRuler ruler{from, from, out};
  for (const Vector<2>& place : circle_points(center, radius, begin, begin + turn))
    ruler.arc.push_back(canvas.at(place));
  ruler.to = ruler.arc.back();
  ruler.out_at_end = to_screen_direction(wall_near(content.settings, moment.expected_contact + moment.slide).normal);
  return ruler;
}

}  // namespace ghostforce
