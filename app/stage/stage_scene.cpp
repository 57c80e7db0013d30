// Everything of the stage that is a thing: wall, rail, springs, hand, handle, force, ruler.
#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/stage/stage_layers.h"
#include "app/stage/stage_scene.h"
#include "app/state/stage_view.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

constexpr Colour skin = rgb(0xF3C9A5);
constexpr Colour skin_rim = rgb(0x6B4A31);

Vector<2> normal_on_screen(const StageContent& content, const Vector<2>& place) {
  return to_screen_direction(wall_near(content.settings, place).normal);
}

Vector<2> motor_on_screen(const StageContent& content) {
  return to_screen_direction(rail_direction(content.settings, content.moment.handle));
}

// Half the rail's length to either side of the handle [points of the design].
constexpr double short_rail = 72.0;
constexpr double long_rail = 340.0;
constexpr double beyond_hand = 130.0;
constexpr double chevron = 11.0;

double fullness_of(const StageMoment& moment) {
  return moment.weights[index_of(StrategyId::full)];
}

// How much of a line from `middle` there is before it comes to the box. All of it, if it begins there.
double reach_outside(const Vector<2>& middle, const Vector<2>& to, const std::optional<ScreenBox>& box) {
  ScreenPiece piece{middle, to, 0.0};
  const bool meets = box && !contains(*box, middle) && clip(*box, piece);
  return glm::distance(middle, meets ? piece.from : to);
}

// The numbers, and what is below them. Whoever takes hold of something must see it.
std::optional<ScreenBox> beside_column(const StageLayout& layout, double distance) {
  std::optional<ScreenBox> column = layout.numbers;
  if (const auto tools = layout.tools_box()) {
    if (!column) column = tools;
    column->include(tools->least);
    column->include(tools->most);
  }
  return column ? std::optional(column->grown(distance * layout.unit)) : std::nullopt;
}

std::array<Vector<2>, 2> rail_ends(const Settings& settings, const StageMoment& moment, const Camera& camera,
                                   const StageLayout& layout, const std::optional<HeldEnd>& held) {
  constexpr double to_edges = 24.0;
  constexpr double beside_handle = 50.0;  // at least, or a knob would lie on it; beyond the scene if it must
  const double unit = layout.unit;
  const Vector<2> along = to_screen_direction(rail_direction(settings, moment.handle));
  const Vector<2> middle = to_screen(camera, moment.handle);
  const double to_hand = glm::dot(to_screen(camera, moment.goal) - middle, along);
  // One motor's rail can be seen beyond the hand, too.
  const auto end = [&](double side) {
    const double of_one_motor = std::max(long_rail * unit, side * to_hand + beyond_hand * unit);
    const Vector<2> direction = side * along;
    const bool is_turned = held && held->grip == StageGrip::motor;
    const double to_pointer = is_turned ? glm::dot(held->pointer - middle, direction) : 0.0;
    // The end that is held comes to the pointer, and beside the handle where that is at the pointer.
    const double reach = is_turned && to_pointer > -beside_handle * unit
                             ? to_pointer
                             : glm::mix(of_one_motor, short_rail * unit, fullness_of(moment));
    ScreenPiece piece{middle, middle + direction * reach, 0.0};
    // A handle that is dragged below the buttons takes its rail along.
    const ScreenBox seen = contains(layout.scene(), middle) ? layout.scene() : ScreenBox{Vector<2>(0.0), layout.size};
    const bool is_seen = clip(seen.grown(-to_edges * unit), piece);
    const double shown = is_seen ? reach_outside(middle, piece.to, beside_column(layout, to_edges)) : 0.0;
    return middle + direction * std::max(shown, beside_handle * unit);
  };
  return {end(-1.0), end(1.0)};
}

void add_chevron(const StageCanvas& canvas_in, const Vector<2>& tip, const Vector<2>& direction, Colour colour) {
  StageCanvas canvas = canvas_in;
  const Vector<2> across{-direction.y, direction.x};
  const Vector<2> back = tip - direction * canvas.points(chevron);
  canvas.curve(Role::motor_axis, {back + across * canvas.points(chevron), tip, back - across * canvas.points(chevron)},
               canvas.width(4.0), colour);
  canvas.labels.keep_clear(back, back, canvas.points(chevron) + canvas.width(2.0), Clearance::if_possible);
}

}  // namespace

Colour stage_colour(const StageMoment& moment, const PerStrategy<Colour>& colours) {
  Colour mixed = colours[0];
  double sum = moment.weights[0];
  for (std::size_t i = 1; i < strategy_count; ++i) {
    if (moment.weights[i] <= 0.0) continue;
    sum += moment.weights[i];
    mixed = mix(mixed, colours[i], moment.weights[i] / sum);
  }
  return mixed;
}

void add_knob(const StageLayer& layer, const Vector<2>& place, bool is_hot) {
  const auto& [content, layout, canvas] = layer;
  canvas.disc(Role::handle, place, canvas.points(is_hot ? 11.0 : 8.0), content.theme.background,
              is_hot ? content.theme.accent : content.theme.wall_edge, canvas.width(3.0));
  canvas.labels.keep_clear(place, place, canvas.points(12.0));
}

namespace {

void add_knobs(const StageLayer& layer, const std::array<Vector<2>, 2>& places, StageGrip grip) {
  for (const Vector<2>& place : places) add_knob(layer, place, layer.content.hovered_grip == grip);
}

}  // namespace

namespace {

// It ends before Fit and Reset, as the rail does, and goes on behind them.
void add_wall_edge(const StageLayer& layer, const Vector<2>& from, const Vector<2>& to) {
  const auto& [content, layout, canvas] = layer;
  const auto add = [&](const Vector<2>& begin, const Vector<2>& end) {
    canvas.line(Role::wall, begin, end, canvas.width(5.0), content.theme.wall_edge);
  };
  constexpr double apart = 10.0;
  const auto tools = layout.tools_box();
  ScreenPiece behind{from, to, 0.0};
  if (!tools || !clip(tools->grown(canvas.points(apart)), behind)) return add(from, to);
  add(from, behind.from);
  add(behind.to, to);
}

}  // namespace

StageEdge add_half_plane(const StageLayer& layer, const Wall<2>& wall) {
  const auto& [content, layout, canvas] = layer;
  const Theme& theme = content.theme;
  canvas.marks.push_back({Role::wall, {}, HalfPlane{wall.point, wall.normal, theme.wall}});
  // Quiet lines beside the edge, as many as reach the farthest corner.
  const Vector<2> normal = to_screen_direction(wall.normal);
  const Vector<2> along{-normal.y, normal.x};
  const Vector<2> middle = 0.5 * layout.size;
  const double reach = 0.5 * glm::length(layout.size);
  const Vector<2> edge = middle - normal * glm::dot(middle - canvas.at(wall.point), normal);
  const double spacing = canvas.points(22.0);
  const Colour quiet = mix(theme.wall, theme.wall_edge, 0.07);
  const double to_middle = glm::dot(edge - middle, normal);
  const double first = std::max(1.0, std::ceil((to_middle - reach) / spacing));
  for (double i = first; to_middle - i * spacing > -reach; i += 1.0) {
    const Vector<2> foot = edge - normal * (i * spacing);
    canvas.line(Role::hatching, foot - along * reach, foot + along * reach, canvas.points(2.5), quiet);
  }
  return {edge - along * reach, edge + along * reach};
}

void add_wall_grips(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  if (!content.may_turn_wall) return;
  if (const auto grips = stage_grips(content.settings, content.moment, canvas.camera, layout, content.held_end).wall) {
    add_knobs(layer, *grips, StageGrip::wall);
  }
}

void add_stage_wall(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  if (content.settings.general.constraint != ConstraintKind::plane) return add_shaped_wall(layer);
  const auto [from, to] = add_half_plane(layer, wall_of(content.settings));
  add_wall_edge(layer, from, to);
  canvas.labels.keep_clear(from, to, canvas.width(2.5), Clearance::if_possible);
  add_wall_grips(layer);
}

void add_rail(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const MotorReach motors = motor_reach(content.settings, content.moment.handle);
  if (motors.only_pulls) add_pulls(layer, motors);
  if (motors.only_pulls || motors.count == 0) return;
  const Theme& theme = content.theme;
  const double fullness = fullness_of(content.moment);
  const Colour rail = mix(theme.wall, theme.wall_edge, 0.14);
  const bool is_hot = content.hovered_grip == StageGrip::motor;
  const Colour ends = is_hot ? theme.accent : mix(theme.wall, theme.wall_edge, 0.5);
  const auto add = [&](const std::array<Vector<2>, 2>& piece) {
    if (glm::distance(piece[0], piece[1]) < canvas.points(1.0)) return;
    const Vector<2> along = glm::normalize(piece[1] - piece[0]);
    canvas.line(Role::motor_axis, piece[0], piece[1], canvas.points(12.0), rail);
    add_chevron(canvas, piece[0] - along * canvas.points(14.0), -along, ends);
    add_chevron(canvas, piece[1] + along * canvas.points(14.0), along, ends);
    canvas.labels.keep_clear(piece[0] - along * canvas.points(14.0), piece[1] + along * canvas.points(14.0),
                             canvas.points(7.0), Clearance::if_possible);
  };
  add(rail_ends(content.settings, content.moment, canvas.camera, layout, content.held_end));
  if (fullness <= 0.0) return;
  const Vector<2> across = to_screen_direction(motors.missing) * canvas.points(short_rail * fullness);
  const Vector<2> middle = canvas.at(content.moment.handle);
  add({middle - across, middle + across});
}

void add_rail_grips(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  if (!content.may_turn_motor) return;
  add_knobs(layer, rail_ends(content.settings, content.moment, canvas.camera, layout, content.held_end),
            StageGrip::motor);
}

void add_expectations(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const Theme& theme = content.theme;
  const StageMoment& moment = content.moment;
  const Vector<2> foot = canvas.at(moment.expected_contact);
  if (moment.has_target) {
    canvas.ring(Role::target, foot, canvas.points(target_radius), canvas.width(3.0), theme.text);
    canvas.disc(Role::target, foot, canvas.points(4.0), theme.text, theme.text, 0.0);
  }
  if (!moment.in_contact) return;
  const Vector<2> goal = canvas.at(moment.goal);
  canvas.line(Role::expected_contact, goal, foot, canvas.width(2.0), theme.faint_text, {2.0, 6.0, 2.0, 6.0});
  canvas.labels.keep_clear(goal, foot, canvas.width(1.0), Clearance::if_possible);
  // Under the handle there is nothing to see of it.
  const Vector<2> rest = canvas.at(moment.expected_rest);
  const double apart = glm::distance(rest, canvas.at(moment.handle));
  if (content.hides.rest || moment.is_measured || apart < canvas.points(2.0)) return;
  const double strength = std::min(1.0, apart / canvas.points(20.0));
  canvas.ring(Role::expected_rest, rest, canvas.points(handle_radius), canvas.width(2.5),
              faded(theme.faint_text, strength));
  canvas.labels.keep_clear(rest, rest, canvas.points(handle_radius));
}

void add_springs(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const Theme& theme = content.theme;
  const StageMoment& moment = content.moment;
  const Vector<2> handle = canvas.at(moment.handle);
  canvas.coil(Role::tracking_link, handle, canvas.at(moment.proxy), 6, canvas.width(3.5),
              stage_colour(moment, theme.strategy));
  canvas.coil(Role::hand_spring, handle, canvas.at(moment.goal), 9, canvas.width(3.0), theme.text);
}

void add_stage_hand(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const Theme& theme = content.theme;
  const StageMoment& moment = content.moment;
  const Vector<2> goal = canvas.at(moment.goal);
  // The arm lies where the hand pulls to; a hand that does not pull yet, into the wall.
  const Vector<2> pull = goal - canvas.at(moment.handle) - normal_on_screen(content, moment.goal) * canvas.points(25.0);
  const double length = glm::length(pull);
  const Vector<2> arm = length > 0.0 ? pull / length : -normal_on_screen(content, moment.goal);
  const Vector<2> across{-arm.y, arm.x};
  const double strength = moment.is_measured ? 0.5 : 1.0;  // of an inferred hand
  const double rim = canvas.width(2.0);
  const auto place = [&](double along_arm, double across_arm) {
    return goal + arm * canvas.points(along_arm) + across * canvas.points(across_arm);
  };
  struct Limb {
    Vector<2> from;
    Vector<2> to;
    double thickness;
  };
  const auto add = [&](std::initializer_list<Limb> limbs) {
    // All rims first, so that what belongs together has one outline.
    for (const bool is_rim : {true, false}) {
      for (const Limb& limb : limbs) {
        const double thickness = canvas.points(limb.thickness) + (is_rim ? rim : -rim);
        canvas.line(Role::hand, place(limb.from.x, limb.from.y), place(limb.to.x, limb.to.y), thickness,
                    mix(theme.wall, is_rim ? skin_rim : skin, strength));
      }
    }
  };
  add({{{36.0, -9.0}, {70.0, -9.0}, 26.0}, {{36.0, 9.0}, {70.0, 9.0}, 26.0}, {{36.0, 0.0}, {70.0, 0.0}, 26.0}});
  for (const double finger : {-18.0, -6.0, 6.0, 18.0}) add({{{0.0, finger}, {24.0, finger}, 12.5}});
  add({{{14.0, 24.0}, {42.0, 15.0}, 13.0}});
  canvas.disc(Role::goal, goal, canvas.points(9.0), theme.goal, theme.goal_rim, canvas.width(2.5));
  canvas.labels.keep_clear(place(8.0, 0.0), place(62.0, 0.0), canvas.points(30.0));
}

namespace {

constexpr double same_line = 0.999;  // cosine between two forces that are drawn as one arrow

}  // namespace

std::optional<ForceArrow> force_arrow(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const StageMoment& moment = content.moment;
  const double share = glm::length(moment.wall_share);
  const double ghost = signed_ghost_force(moment);
  const double longest = std::max(std::abs(share), std::abs(share + ghost));
  if (!(longest > 0.0)) return std::nullopt;
  const double per_newton = arrow_points_per_newton(content.reference_force, longest) * canvas.camera.points_per_metre *
                            content.shown.width / stage_view_width;
  if (longest * per_newton < canvas.points(3.0)) return std::nullopt;
  const Vector<2> world = share > 0.0 ? moment.wall_share / share : glm::normalize(moment.ghost_force);
  Vector<2> direction = to_screen_direction(world);
  // The loop may not have seen yet that the motor has been turned.
  const MotorReach motors = motor_reach(content.settings, moment.handle);
  if (motors.only_pulls && std::abs(ghost) * per_newton >= canvas.points(1.0)) {
    const Vector<2> excess = to_screen_direction(glm::normalize(moment.ghost_force));
    if (std::abs(glm::dot(excess, direction)) < same_line) {
      return ForceArrow{canvas.at(moment.handle), direction, share * per_newton, std::abs(ghost) * per_newton, excess};
    }
  }
  if (fullness_of(moment) == 0.0 && motors.is_one_line()) {
    const Vector<2> rail = motor_on_screen(content);
    direction = glm::dot(rail, direction) < 0.0 ? -rail : rail;
  }
  return ForceArrow{canvas.at(moment.handle), direction, share * per_newton, ghost * per_newton, direction};
}

void add_stage_force(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const auto found = force_arrow(layer);
  if (!found) return;
  const ForceArrow& arrow = *found;
  const Theme& theme = content.theme;
  const Colour dark = mix(theme.wall_edge, theme.background, 0.08);
  const Colour red = theme.strategy[index_of(StrategyId::naive)];
  const double body = canvas.points(arrow_width);
  const double rim = canvas.width(2.5);
  const double head = 2.185 * body;     // its length, as painters draw it
  const double with_head = head / 0.8;  // the shortest arrow whose head has its full size
  const auto add = [&](Role role, const Vector<2>& from, const Vector<2>& to, Colour fill, Colour edge, bool has_head,
                       bool is_hatched) {
    canvas.marks.push_back({role,
                            {},
                            Arrow{to_world(canvas.camera, from), to_world(canvas.camera, to), body, fill, edge, rim,
                                  Vector<2>(0.0), has_head, is_hatched}});
  };
  const Vector<2> tip = arrow.tip();
  if (arrow.turns()) {
    if (arrow.share >= canvas.points(1.0))
      add(Role::wall_share, arrow.start, arrow.share_end(), dark, dark, true, false);
    add(Role::ghost_force, arrow.share_end(), tip, theme.background, red, true, true);
  } else if (arrow.ghost >= 0.0) {
    // One head for both: of the wall's colour without a ghost, and more and more the ghost's as that grows.
    const double length = std::min(std::max(arrow.ghost, with_head), arrow.share + arrow.ghost);
    const double ghostly = std::clamp(arrow.ghost / with_head, 0.0, 1.0);
    // The bar ends where the head begins, which is narrower at its tip.
    const double bar = std::min(arrow.share, arrow.share + arrow.ghost - head * std::min(1.0, length / with_head));
    if (bar > 0.0) add(Role::wall_share, arrow.start, arrow.start + arrow.direction * bar, dark, dark, false, false);
    add(ghostly > 0.0 ? Role::ghost_force : Role::wall_share, tip - arrow.direction * length, tip,
        mix(dark, theme.background, ghostly), mix(dark, red, ghostly), true, ghostly > 0.0);
  } else {
    // Too little: it folds back over the share.
    add(Role::wall_share, arrow.start, arrow.share_end(), dark, dark, true, false);
    if (-arrow.ghost >= canvas.points(1.0))
      add(Role::ghost_force, arrow.share_end(), tip, theme.background, red, true, true);
  }
  canvas.labels.keep_clear(arrow.start, arrow.share_end(), body);
  canvas.labels.keep_clear(arrow.start, tip, body);
  const Vector<2> to_head = arrow.ghost_direction * std::copysign(body, arrow.ghost);
  canvas.labels.keep_clear(tip - to_head, tip, 1.3 * body);
}

std::optional<SlideRuler> slide_ruler(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const StageMoment& moment = content.moment;
  if ((moment.is_measured && !moment.has_target) || !moment.in_contact || !moment.has_rest) return std::nullopt;
  const Vector<2> out = normal_on_screen(content, moment.expected_contact);
  const Vector<2> from = canvas.at(moment.expected_contact) + out * canvas.points(34.0);
  const Vector<2> to = from + to_screen_direction(moment.slide) * canvas.camera.points_per_metre;
  if (glm::distance(from, to) < canvas.points(1.0)) return std::nullopt;
  if (content.settings.general.constraint == ConstraintKind::circle) return round_ruler(layer, from, out);
  return SlideRuler{from, to, out};
}

void add_slide(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const auto ruler = slide_ruler(layer);
  if (!ruler) return;
  const double strength = std::min(1.0, glm::distance(ruler->from, ruler->to) / canvas.points(14.0));
  const Colour colour = faded(stage_colour(content.moment, content.theme.strategy), strength);
  const Vector<2> tick = ruler->out * canvas.points(9.0);
  if (ruler->arc.empty()) {
    canvas.line(Role::proxy_drift, ruler->from, ruler->to, canvas.width(3.0), colour);
  } else {
    canvas.curve(Role::proxy_drift, ruler->arc, canvas.width(3.0), colour);
  }
  const Vector<2> last_tick = ruler->arc.empty() ? tick : ruler->out_at_end * canvas.points(9.0);
  canvas.line(Role::proxy_drift, ruler->from - tick, ruler->from + tick, canvas.width(3.0), colour);
  canvas.line(Role::proxy_drift, ruler->to - last_tick, ruler->to + last_tick, canvas.width(3.0), colour);
  canvas.labels.keep_clear(ruler->from, ruler->to, canvas.points(10.0));
}

double shape_reach(const StageMoment& moment, double radius) {
  constexpr std::array reach{1.0, 1.3, 1.57};  // of disc, diamond and triangle, as the painters draw them
  double most = 0.0;
  for (const Strategy& entry : strategy_catalog()) {
    const auto shape = static_cast<std::size_t>(strategy_style(entry.id).shape);
    if (moment.weights[index_of(entry.id)] > 0.0) most = std::max(most, reach[shape]);
  }
  return most * radius;
}

void add_handle(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const Theme& theme = content.theme;
  const StageMoment& moment = content.moment;
  const auto add = [&](Role role, const Vector<2>& at, double radius, bool is_filled) {
    for (const Strategy& entry : strategy_catalog()) {
      const double weight = moment.weights[index_of(entry.id)];
      if (weight <= 0.0) continue;
      const Colour own = faded(theme.strategy[index_of(entry.id)], weight);
      const Colour paper = faded(theme.background, weight);
      canvas.marks.push_back({role, entry.id,
                              Marker{at, strategy_style(entry.id).shape, canvas.points(radius), is_filled ? own : paper,
                                     is_filled ? paper : own, canvas.width(4.0)}});
    }
    canvas.labels.keep_clear(canvas.at(at), canvas.at(at),
                             shape_reach(moment, canvas.points(radius)) + canvas.width(2.0));
  };
  if (moment.in_contact) {
    add(Role::proxy, moment.proxy, 11.0, false);
    const Vector<2> foot = canvas.at(moment.expected_contact);
    canvas.disc(Role::expected_contact, foot, canvas.points(5.5), theme.text, theme.text, 0.0);
    canvas.labels.keep_clear(foot, foot, canvas.points(6.0));
  }
  add(Role::device, moment.handle, handle_radius, true);
}

StageGrips stage_grips(const Settings& settings, const StageMoment& moment, const Camera& camera,
                       const StageLayout& layout, const std::optional<HeldEnd>& held) {
  StageGrips grips{rail_ends(settings, moment, camera, layout, held), {}};
  // The wall's edge, cut to the scene.
  const Vector<2> at = to_screen(camera, settings.wall_point);
  const Vector<2> normal = to_screen_direction(direction_at(settings.wall_normal_angle));
  const Vector<2> along{-normal.y, normal.x};
  const double reach = glm::distance(at, 0.5 * camera.size) + glm::length(camera.size);
  ScreenPiece edge{at - along * reach, at + along * reach, 0.0};
  constexpr double to_edges = 26.0;
  constexpr double shortest = 120.0;  // of an edge that can be turned by its ends
  if (!clip(layout.scene().grown(-to_edges * layout.unit), edge)) return grips;
  std::array<Vector<2>, 2> ends{edge.from, edge.to};
  const Vector<2> middle = 0.5 * (edge.from + edge.to);
  const auto near_column = beside_column(layout, to_edges);
  const auto column = beside_column(layout, 0.0);
  for (Vector<2>& end : ends) {
    const Vector<2> way = end - middle;
    const bool is_near = near_column && contains(*near_column, end);
    if (is_near) end = middle + glm::normalize(way) * reach_outside(middle, end, near_column);
  }
  const auto is_covered = [&](const Vector<2>& end) { return column && contains(*column, end); };
  const bool is_long = glm::distance(ends[0], ends[1]) > shortest * layout.unit;
  if (!is_long || std::ranges::any_of(ends, is_covered)) return grips;
  for (Vector<2>& end : ends) {
    const Vector<2> way = end - middle;
    const double of_held = held && held->grip == StageGrip::wall ? glm::dot(held->pointer - middle, way) : 0.0;
    if (of_held > 0.0) end = middle + way * std::min(1.0, of_held / glm::dot(way, way));
  }
  grips.wall = ends;
  return grips;
}

}  // namespace ghostforce
