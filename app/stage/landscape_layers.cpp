#include "app/stage/landscape_layers.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "app/stage/landscape_map.h"
#include "app/stage/landscape_words.h"
#include "app/stage/stage_layers.h"
#include "core/conventions.h"

namespace ghostforce {
namespace {

Landscape landscape_shown(const LandscapeView& view) {
  if (view.has_every_motor) return landscape_without_ghost(view.settings);
  return landscape_of(view.settings, view.dial);
}

std::string_view side_of(double share, const StageLanguage::Map& words) {
  return share > 0.0 ? words.too_much : words.too_little;
}

class LandscapePainter {
 public:
  LandscapePainter(const LandscapeView& view, Marks& marks)
      : view_(view),
        said_(view.language.map),
        layout_(landscape_layout(view)),
        landscape_(landscape_shown(view)),
        point_(landscape_point(view.settings)),
        share_(ghost_share(landscape_, point_)),
        range_(ghost_share_range(landscape_)),
        words_(view, layout_, marks),
        marks_(marks) {}

  void compose() {
    const std::vector<DrawnContour> contours = drawn_contours(landscape_, layout_);
    add_map(view_, layout_, landscape_, marks_);
    add_contours(view_, layout_, contours, marks_);
    add_frame();
    add_axes();
    add_colour_scale(view_, layout_, !is_no_share(range_.least), words_, marks_);
    add_ring();
    add_contour_labels(view_, layout_, contours, words_);
    add_verdict();
    if (view_.has_every_motor) {
      add_words_of_every_motor();
    } else {
      add_dial();
    }
  }

 private:
  double em(double count) const noexcept { return count * layout_.em; }
  Vector<2> world(const Vector<2>& screen) const noexcept { return to_world(view_.camera, screen); }
  Colour naive_letters() const { return view_.theme.strategy_text[index_of(StrategyId::naive)]; }
  Colour anisotropic_letters() const { return view_.theme.strategy_text[index_of(StrategyId::anisotropic)]; }

  void add_disc(Role role, const Vector<2>& screen, double radius, Colour fill, Colour rim, double rim_width) {
    marks_.push_back({role, std::nullopt, Marker{world(screen), Shape::disc, radius, fill, rim, rim_width}});
  }
  void add_box(Role role, const ScreenBox& box, double radius, Colour fill, Colour rim, double rim_width) {
    marks_.push_back({role, std::nullopt, Box{world(box.least), box.extent(), radius, fill, rim, rim_width}});
  }

  void add_frame() {
    add_box(Role::scale, layout_.map, 0.0, view_.theme.background.with_alpha(0), view_.theme.text, em(0.09));
  }

  void add_axes() {
    const TextStyle drawn = words_.style(1.0);
    for (int degrees = 0; degrees <= 90; degrees += 15) {
      const Vector<2> at = ring_at(layout_, {degrees * radians_per_degree, shown_kappas.least});
      words_.put(Role::scale, fmt::format("{}°", degrees), drawn, view_.theme.faint_text,
                 at + Vector<2>(0.0, em(beside_map)), {0.5, 0.0});
    }
    for (const int kappa : {1, 2, 5, 10, 20, 50, 100}) {
      const Vector<2> at = ring_at(layout_, {0.0, static_cast<double>(kappa)});
      words_.put(Role::scale, fmt::format("{}", kappa), drawn, view_.theme.faint_text,
                 at - Vector<2>(em(beside_map), 0.0), {1.0, 0.5});
    }
    const double left = layout_.column.most.x + em(0.5);
    const double right = layout_.size.x - em(0.5);
    words_.put_lines(Role::scale, line_breaks_of(said_.stiffness_axis), view_.theme.text,
                     {left, layout_.axis_title_top}, right - left);
    words_.put_lines(
        Role::scale, line_breaks_of(said_.angle_axis), view_.theme.text,
        {0.5 * (layout_.map.least.x + layout_.map.most.x), layout_.map.most.y + em(beside_map + line_height + 0.1)},
        layout_.map.extent().x, 0.5);
  }

  void add_ring() {
    const Vector<2> at = ring_at(layout_, point_);
    const double radius = layout_.ring_radius;
    const Colour none = view_.theme.background.with_alpha(0);
    add_disc(Role::handle, at, radius, none, view_.theme.background, em(0.34));
    add_disc(Role::handle, at, radius, none, view_.theme.accent, em(0.17));
    const double reach = radius + em(0.2);
    words_.take({at - Vector<2>(reach), at + Vector<2>(reach)});

    const std::string text = filled(is_on_map(point_) ? said_.you_are_here : said_.off_the_map, share_words(share_));
    const ScreenBox inside = layout_.map.grown(-em(0.15));
    const TextStyle drawn = words_.fitted(text, words_.style(1.0, true), inside.extent().x);
    const Vector<2> extent = words_.extent(text, drawn);
    // Beside it as one reads, else on the other side, else below or above, moved as far as the map asks for.
    const double away = reach + em(0.1);
    const std::array<Vector<2>, 4> corners{
        at + Vector<2>(away, -0.5 * extent.y), at + Vector<2>(-away - extent.x, -0.5 * extent.y),
        at + Vector<2>(-0.5 * extent.x, away), at + Vector<2>(-0.5 * extent.x, -away - extent.y)};
    for (const Vector<2>& asked : corners) {
      const Vector<2> corner = glm::max(glm::min(asked, inside.most - extent), inside.least);
      if (!words_.is_free({corner, corner + extent})) continue;
      words_.put(Role::handle, text, drawn, view_.theme.accent, corner);
      return;
    }
  }

  // Title, number and what the number is.
  void add_verdict() {
    const ScreenBox& column = layout_.column;
    const double room = column.extent().x;
    const std::string title(said_.title);
    words_.put(Role::sentence, title, words_.fitted(title, words_.style(1.25, true), room), view_.theme.text,
               column.least);
    const std::string number = share_words(share_);
    const bool is_none = is_no_share(share_);
    const Colour colour = is_none ? view_.theme.text : share_ > 0.0 ? naive_letters() : view_.theme.shortfall;
    constexpr double number_ems = 2.67;
    // Smaller ones keep the same middle.
    words_.put(Role::number, number, words_.fitted(number, words_.style(number_ems, true), room), colour,
               column.least + Vector<2>(0.0, em(1.8 + 0.5 * number_ems * line_height)), {0.0, 0.5});
    const std::string_view which = side_of(share_, said_);
    const LineBreaks ways = line_breaks_of(is_none ? said_.no_ghost : filled(said_.verdict, which, which));
    words_.put_lines(Role::sentence, ways, view_.theme.faint_text, column.least + Vector<2>(0.0, em(5.05)), room);
    const LineBreaks hint = line_breaks_of(said_.drag_ring);
    words_.put_lines(Role::hint, hint, view_.theme.faint_text,
                     {column.least.x, column.most.y - words_.height_of_lines(hint, room)}, room);
  }

  // What turning the dial all the way would do to what is too much now; empty: nothing that is worth it.
  LineBreaks promise() const {
    const double now = range_.greatest;
    const double then = ghost_share_range(landscape_of(view_.settings, 1.0)).greatest;
    constexpr double all_the_way = 0.99;
    if (landscape_.dial > all_the_way || is_no_share(now)) return {};
    if (is_no_share(then)) return line_breaks_of(said_.slide_to_cure);
    constexpr double seen = 0.8;  // of the deepest red: more than that looks like no change
    if (then < seen * now) return line_breaks_of(said_.slide_for_less);
    return {};
  }

  void add_words_of_every_motor() {
    const LineBreaks ways = line_breaks_of(said_.two_motors);
    words_.put_lines(Role::hint, ways, view_.theme.text, {layout_.column.least.x, layout_.dial.least.y},
                     layout_.column.extent().x);
  }

  void add_dial() {
    const Vector<2> knob = knob_at(layout_, landscape_.dial);
    const double half = em(0.2);
    const Colour none = view_.theme.background.with_alpha(0);
    const Colour track = view_.theme.panel_border;
    add_box(Role::button, layout_.dial.grown(half), half, track, none, 0.0);
    add_box(Role::button, ScreenBox{layout_.dial.least, knob}.grown(half), half,
            view_.theme.strategy[index_of(StrategyId::anisotropic)], none, 0.0);
    add_disc(Role::button, knob, layout_.knob_radius, view_.theme.background, view_.theme.text, em(0.17));
    const double left = layout_.column.least.x;
    const double right = layout_.dial.most.x + em(0.8);
    const double below = layout_.dial.least.y + em(0.95);
    const TextStyle bold = words_.style(1.0, true);
    words_.put(Role::button, std::string(said_.naive), bold, naive_letters(), {left, below}, {}, StrategyId::naive);
    // A ratio that a person has chosen is optimal for nobody.
    words_.put(Role::button, std::string(landscape_.chosen_ratio ? said_.chosen_ratio : said_.optimal), bold,
               anisotropic_letters(), {right, below}, {1.0, 0.0}, StrategyId::anisotropic);
    if (const LineBreaks ways = promise(); !ways.empty()) {
      const double room = layout_.column.most.x - left;
      words_.put_lines(Role::hint, ways, view_.theme.faint_text,
                       {left, layout_.dial.least.y - em(0.95) - words_.height_of_lines(ways, room)}, room);
    }
  }

  const LandscapeView& view_;
  const StageLanguage::Map& said_;
  LandscapeLayout layout_;
  Landscape landscape_;
  LandscapePoint point_;
  double share_;
  NumberRange range_;
  LandscapeWords words_;
  Marks& marks_;
};

}  // namespace

std::string landscape_sentence(const LandscapeView& view) {
  const double share = ghost_share(landscape_shown(view), landscape_point(view.settings));
  const StageLanguage::Map& words = view.language.map;
  if (is_no_share(share)) return std::string(words.sentence_without_ghost);
  return filled(words.sentence, share_words(share), side_of(share, words));
}

void add_landscape(const LandscapeView& view, Marks& marks) {
  LandscapePainter(view, marks).compose();
}

// --- As a mode of the stage ---

namespace {

void add_map(const StageLayer& layer) {
  if (maps_workspace(layer.content)) return add_workspace(layer);
  const LandscapeRoom room{layer.layout.header_box(), layer.layout.bottom};
  add_landscape(stage_landscape(layer.content, layer.canvas.camera, room), layer.canvas.marks);
}

// The map of walls and hands has its verdict in place of one.
std::string map_sentence(const StageContent& content) {
  return maps_workspace(content) ? workspace_sentence(content) : "";
}

}  // namespace

LandscapeView stage_landscape(const StageContent& content, const Camera& camera, const LandscapeRoom& room) {
  return {.settings = content.settings,
          .dial = content.landscape_dial,
          .has_every_motor = content.moment.weights[index_of(StrategyId::full)] == 1.0,
          .language = content.language,
          .theme = content.theme,
          .camera = camera,
          .scale = content.scale,
          .measure = content.measure,
          .room = room};
}

const StageModeLayers landscape_layers{StageMode::landscape, add_map, map_sentence};

}  // namespace ghostforce
