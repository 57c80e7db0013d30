#include "app/tools/figures/scene_pane.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "app/paint/vector/vector_painter.h"
#include "app/picture/layers.h"
#include "app/picture/screen_box.h"
#include "app/picture/trail_history.h"
#include "core/conventions.h"

namespace ghostforce {
namespace {

// [points]
constexpr double room_at_sides = 30.0;  // round the scene, for letters
constexpr double room_for_scale = 36.0;
constexpr double scale_above_edge = 14.0;
constexpr double dial_reach = 20.0;  // of each of its arrows
constexpr double subscript_drop = 7.0;
constexpr Vector<2> aside{0.0, 17.0};  // arrows, below what they are of

// In the world [m].
ScreenBox extent_of(const ScenePicture& picture) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ScreenBox box{Vector<2>(infinity), Vector<2>(-infinity)};
  for (const Trail& trail : picture.trails) {
    for (const Vector<2>& point : trail.points) box.include(point);
  }
  for (const FigurePoint& point : picture.points) box.include(point.at);
  return box;
}

// The motor axis' dial is as high as the axis is steep.
double dial_above_edge(const Settings& settings) {
  constexpr double clear = 6.0;  // half an arrow head, and a little
  const double rise = dial_reach * std::abs(direction_at(settings.actuated_angle).y);
  return std::max(scale_above_edge, rise + clear);
}

class Drawing {
 public:
  Drawing(const ScenePicture& picture, Pane& pane) : picture_(picture), pane_(pane), size_(pane.camera.size) {}

  void draw() {
    add_scene();
    for (const Trail& trail : picture_.trails) add_trail(trail);
    for (const MotorForceArrow& arrow : picture_.arrows) add_arrow(arrow);
    for (const FigurePoint& point : picture_.points) add_point(point);
    if (picture_.has_scale) add_scale();
    for (const FigurePoint& point : picture_.points) place_name(on_screen(point.at), point.radius + 3.0, point);
  }

 private:
  Vector<2> on_screen(const Vector<2>& world) const { return to_screen(pane_.camera, world); }
  Vector<2> in_world(const Vector<2>& screen) const { return to_world(pane_.camera, screen); }
  static Vector<2> on_screen_direction(const Vector<2>& force) {
    return to_screen_direction(force) * points_per_newton_on_paper;
  }

  // Wall and hatching as in the window.
  void add_scene() {
    const Snapshot snapshot;
    const History history;
    const MeasureText measure = measure_vector_text;
    add_wall({.settings = picture_.settings,
              .snapshot = snapshot,
              .history = history,
              .theme = paper(),
              .camera = pane_.camera,
              .options = {},
              .scale = 1.0,
              .points_per_newton = points_per_newton_on_paper,
              .measure = measure},
             pane_.marks);
    std::erase_if(pane_.marks, [](const Mark& mark) { return mark.role == Role::grid; });
    for (const Mark& mark : pane_.marks) {
      const auto* edge = std::get_if<Line>(&mark.form);
      if (mark.role == Role::wall && edge != nullptr) lines_.push_back({on_screen(edge->from), on_screen(edge->to)});
    }
    frame();
  }

  void frame() {
    const std::array<Vector<2>, 5> corners{
        {{0.5, 0.5}, {size_.x - 0.5, 0.5}, {size_.x - 0.5, size_.y - 0.5}, {0.5, size_.y - 0.5}, {0.5, 0.5}}};
    for (std::size_t i = 1; i < corners.size(); ++i) line(Role::grid, corners[i - 1], corners[i], 1.0, rgb(0xB8B8B8));
  }

  void line(Role role, const Vector<2>& from, const Vector<2>& to, double width, Colour colour,
            LinePattern pattern = solid_line) {
    pane_.marks.push_back({role, std::nullopt, Line{in_world(from), in_world(to), width, colour, pattern}});
  }

  void words(const Vector<2>& upper_left, std::string text, const TextStyle& style, Colour colour) {
    const Vector<2> extent = measure_on_paper(text, style);
    taken_.push_back({upper_left, upper_left + extent});
    pane_.marks.push_back(
        {Role::legend, std::nullopt,
         Label{in_world(upper_left), Vector<2>(0.0), std::move(text), style, colour, paper().background}});
  }

  void add_trail(const Trail& trail) {
    double along = 0.0;
    for (std::size_t i = 1; i < trail.points.size(); ++i) {
      const Vector<2>& from = trail.points[i - 1];
      const Vector<2>& to = trail.points[i];
      if (from == to) continue;
      pane_.marks.push_back(
          {Role::trail, std::nullopt, Line{from, to, trail.width, trail.colour, trail.pattern, along}});
      along += glm::distance(from, to);
      lines_.push_back({on_screen(from), on_screen(to)});
    }
  }

  void add_arrow(const MotorForceArrow& arrow) {
    const Vector<2> tail = on_screen(arrow.tail) + aside;
    const Vector<2> tip = tail + on_screen_direction(arrow.force);
    pane_.marks.push_back(
        {Role::force, std::nullopt,
         Arrow{in_world(tail), in_world(tip), 4.0, arrow.is_hollow ? paper().background : arrow.colour, arrow.colour,
               arrow.is_hollow ? 1.4 : 0.0}});
    lines_.push_back({tail, tip});
    // Its words stand at the blunt end.
    const Vector<2> extent = measure_on_paper(arrow.name, small_text);
    const double side = arrow.force.x < 0.0 ? 7.0 : -7.0 - extent.x;
    words(tail + Vector<2>(side, -0.55 * extent.y), arrow.name, small_text, arrow.letters);
  }

  void add_point(const FigurePoint& point) {
    pane_.marks.push_back(
        {Role::device, std::nullopt, Marker{point.at, point.shape, point.radius, point.fill, point.rim, 1.6}});
    const Vector<2> at = on_screen(point.at);
    if (point.has_cross) {
      const double arm = point.radius + 4.0;
      line(Role::goal, at - Vector<2>(arm, 0.0), at + Vector<2>(arm, 0.0), 1.5, point.rim);
      line(Role::goal, at - Vector<2>(0.0, arm), at + Vector<2>(0.0, arm), 1.5, point.rim);
    }
    const double reach = point.radius + 3.0;
    spots_.push_back({at - Vector<2>(reach), at + Vector<2>(reach)});
  }

  // A round length, and which way the motor pushes.
  void add_scale() {
    double metres = 0.001;
    for (const double step : {0.002, 0.005, 0.01, 0.02, 0.05, 0.1}) {
      if (step * pane_.camera.points_per_metre <= 80.0) metres = step;
    }
    const double length = metres * pane_.camera.points_per_metre;
    const Vector<2> from{12.0, size_.y - scale_above_edge};
    const Vector<2> to = from + Vector<2>(length, 0.0);
    // Hatching steps back behind them.
    const std::string name = fmt::format("{:g} mm", metres * mm_per_m);
    const std::string motor = "actuated";
    const double name_width = measure_on_paper(name, small_text).x;
    const double height = small_text.height;
    const Vector<2> dial{to.x + name_width + 46.0, size_.y - dial_above_edge(picture_.settings)};
    const Vector<2> motor_words = dial + Vector<2>(28.0, -0.55 * height);
    const double right = motor_words.x + measure_on_paper(motor, small_text).x;
    const Colour backdrop = paper().background.with_alpha(225);
    if (dial.y == from.y) {
      line(Role::scale, from, {right, from.y}, 22.0, backdrop);
    } else {
      line(Role::scale, from, to + Vector<2>(7.0 + name_width, 0.0), 22.0, backdrop);
      line(Role::scale, dial, {right, dial.y}, 22.0, backdrop);
    }
    const double reach_up = std::max(11.0, size_.y - dial.y);
    taken_.push_back({{0.0, dial.y - reach_up}, {right + 11.0, size_.y}});
    line(Role::scale, from, to, 1.8, paper().text);
    for (const Vector<2>& end : {from, to}) {
      line(Role::scale, end - Vector<2>(0.0, 4.0), end + Vector<2>(0.0, 4.0), 1.8, paper().text);
    }
    words(to + Vector<2>(7.0, -0.55 * height), name, small_text, paper().text);
    const Vector<2> reach = to_screen_direction(direction_at(picture_.settings.actuated_angle)) * dial_reach;
    for (const double sign : {-1.0, 1.0}) {
      pane_.marks.push_back(
          {Role::motor_axis, std::nullopt,
           Arrow{in_world(dial), in_world(dial + sign * reach), 2.6, paper().text, paper().text, 0.0}});
    }
    words(motor_words, motor, small_text, paper().text);
  }

  // Beside its point, where least is covered.
  void place_name(const Vector<2>& at, double gap, const FigurePoint& point) {
    if (point.name.empty()) return;
    Vector<2> extent = measure_on_paper(point.name, point.style);
    const double name_width = extent.x;
    if (!point.subscript.empty()) {
      extent += Vector<2>(measure_on_paper(point.subscript, small_text).x + 1.0, 0.0);
    }
    const Vector<2> room = size_ - extent - Vector<2>(3.0);
    Vector<2> best(0.0);
    double least = std::numeric_limits<double>::infinity();
    constexpr int directions = 16;
    for (const double reach : {0.0, 5.0, 12.0, 22.0, 36.0}) {
      for (int i = 0; i < directions; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / directions;
        const Vector<2> side{std::cos(angle), -std::sin(angle)};
        // Letters fill less than their line is high.
        const Vector<2> half{0.5 * extent.x, 0.36 * extent.y};
        const Vector<2> middle = at + side * (gap + reach) + side * half;
        const Vector<2> corner = middle - 0.5 * extent;
        const bool leaves = corner.x < 3.0 || corner.y < 3.0 || corner.x > room.x || corner.y > room.y;
        const double cost = overlap_cost({corner + Vector<2>(0.0, 0.1 * extent.y), corner + extent}) + 2.5 * reach +
                            ambiguity(middle, point) + (leaves ? 1e5 : 0.0);
        if (cost < least) {
          least = cost;
          best = corner;
        }
      }
    }
    const Colour colour = letter_colour(point);
    const double small = small_text.height;
    words(best, point.name, point.style, colour);
    if (!point.subscript.empty()) {
      const double drop = extent.y - small + 0.2 * subscript_drop;
      words(best + Vector<2>(name_width + 0.5, drop), point.subscript, small_text, colour);
    }
  }

  // Whether a name in this place could be another point's: it should be nearer to its own by far.
  double ambiguity(const Vector<2>& middle, const FigurePoint& own) const {
    const auto way_to = [&](const FigurePoint& point) {
      return std::max(1.0, glm::distance(middle, on_screen(point.at)) - point.radius);
    };
    constexpr double clearly = 1.8;
    double cost = 0.0;
    for (const FigurePoint& other : picture_.points) {
      if (&other != &own) cost += 60.0 * std::max(0.0, clearly - way_to(other) / way_to(own));
    }
    return cost;
  }

  // The strategies' own letters where the point has a strategy's colour.
  static Colour letter_colour(const FigurePoint& point) {
    for (std::size_t i = 0; i < strategy_count; ++i) {
      if (point.fill == paper().strategy[i] || point.rim == paper().strategy[i]) return paper().strategy_text[i];
    }
    return paper().text;
  }

  double overlap_cost(const ScreenBox& box) const {
    double cost = 0.0;
    for (const ScreenBox& other : taken_) cost += 60.0 * std::sqrt(overlap(box.grown(2.0), other));
    for (const ScreenBox& other : spots_) cost += 12.0 * std::sqrt(overlap(box, other));
    for (ScreenPiece piece : lines_) {
      if (clip(box.grown(1.5), piece)) cost += 2.0 + 1.5 * glm::distance(piece.from, piece.to);
    }
    return cost;
  }

  const ScenePicture& picture_;
  Pane& pane_;
  const Vector<2> size_;
  std::vector<ScreenBox> taken_;  // by words
  std::vector<ScreenBox> spots_;
  std::vector<ScreenPiece> lines_;
};

}  // namespace

Frame frame_for(std::span<const ScenePicture> pictures, const Vector<2>& size) {
  Frame frame{std::numeric_limits<double>::infinity(), {}};
  const bool has_arrows =
      std::ranges::any_of(pictures, [](const ScenePicture& picture) { return !picture.arrows.empty(); });
  double dial = scale_above_edge;
  for (const ScenePicture& picture : pictures) dial = std::max(dial, dial_above_edge(picture.settings));
  const double below = room_for_scale + 2.0 * (dial - scale_above_edge) + (has_arrows ? aside.y : 0.0);
  const Vector<2> room = size - Vector<2>(2.0 * room_at_sides, room_at_sides + below);
  for (const ScenePicture& picture : pictures) {
    const ScreenBox box = extent_of(picture);
    constexpr double least_extent = 0.005;  // a hand that stands still [m]
    const Vector<2> extent = glm::max(box.extent(), Vector<2>(least_extent));
    frame.points_per_metre = std::min({frame.points_per_metre, room.x / extent.x, room.y / extent.y});
    frame.centers.push_back(0.5 * (box.least + box.most));
  }
  // More room is wanted below than above.
  for (Vector<2>& center : frame.centers) center.y -= 0.5 * (below - room_at_sides) / frame.points_per_metre;
  return frame;
}

Pane scene_pane(const ScenePicture& picture, const Place& place, const Vector<2>& center, double points_per_metre) {
  Pane pane{place.corner, Camera{center, points_per_metre, place.size}, picture.settings.active, {}};
  Drawing(picture, pane).draw();
  return pane;
}

FigurePoint goal_point(const Vector<2>& at, std::string name, std::string subscript) {
  return {.at = at,
          .fill = paper().goal,
          .rim = paper().goal_rim,
          .radius = 6.5,
          .name = std::move(name),
          .subscript = std::move(subscript),
          .has_cross = true};
}

FigurePoint device_point(StrategyId id, const Vector<2>& at, std::string name, std::string subscript) {
  return {.at = at,
          .shape = strategy_style(id).shape,
          .fill = paper().strategy[index_of(id)],
          .rim = paper().background,
          .radius = 7.0,
          .name = std::move(name),
          .subscript = std::move(subscript)};
}

Trail device_trail(StrategyId id, std::vector<Vector<2>> points) {
  // One over the other they are all to be seen: the widest is at the bottom.
  constexpr PerStrategy<double> widths = std::to_array({3.6, 2.4, 2.0});
  return {.points = std::move(points),
          .colour = paper().strategy[index_of(id)],
          .pattern = strategy_style(id).pattern,
          .width = widths[index_of(id)]};
}

}  // namespace ghostforce
