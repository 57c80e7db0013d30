#include "app/stage/ribbon_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/stage/stage_layers.h"

namespace ghostforce {
namespace {

constexpr std::size_t ghost_quantity = 1;  // of the quantity catalog
constexpr double points_per_bucket = 1.0;
// Heights [points]. A smaller change is none; and what changes by less within a bucket is drawn as the middle of it.
constexpr double flat = 0.25;
constexpr double stair = 3.0;
// Smaller ghost forces would be magnified to what nobody can feel [N].
constexpr double smallest_top = 0.5;

// A letter's em, a thirtieth of the picture's height: to be read from the last row. Less where the picture is upright.
double em_of(const Ribbon& ribbon) noexcept {
  return std::min(ribbon.camera.size.y / 30.0, ribbon.camera.size.x / 24.0);
}

// A line of letters is a sixth higher than their em. As it is drawn.
TextStyle style_of(const Ribbon& ribbon, bool is_bold) noexcept {
  return {1.17 * em_of(ribbon), is_bold};
}

Vector<2> extent_of(const Ribbon& ribbon, std::string_view words, bool is_bold = false) {
  return ribbon.measure(words, style_of(ribbon, is_bold));
}

// What its words stand on.
struct Rows {
  double line;  // height of one
  ScreenBox band;
  std::optional<double> title;  // upper edges
  std::optional<double> axis;
};

Rows rows_of(const Ribbon& ribbon) {
  const double gap = 0.25 * em_of(ribbon);
  const double line = extent_of(ribbon, "0").y;
  const double height = ribbon.box.extent().y;
  const RibbonAxis axis = ribbon_axis(ribbon);
  Rows rows{line, {{axis.left, ribbon.box.least.y + gap}, {axis.right, ribbon.box.most.y - gap}}, {}, {}};
  if (height >= 2.0 * line + 3.0 * gap) {
    rows.axis = ribbon.box.most.y - gap - line;
    rows.band.most.y = *rows.axis - gap;
  }
  if (height >= 3.2 * line + 4.0 * gap) {
    rows.title = ribbon.box.least.y + gap;
    rows.band.least.y = *rows.title + line + gap;
  }
  return rows;
}

// 1, 2 or 5 times a power of ten, at least that.
double round_up(double value) noexcept {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= value) return step * power;
  }
  return 10.0 * power;
}

// What is flat becomes one piece.
void add_point(const Vector<2>& point, std::vector<Vector<2>>& points) {
  const std::size_t count = points.size();
  if (count == 0 || std::abs(point.y - points.back().y) >= flat) {
    points.push_back(point);
  } else if (count > 1 && points[count - 2].y == points.back().y) {
    points.back().x = point.x;
  } else {
    points.emplace_back(point.x, points.back().y);
  }
}

// A moment in words; milliseconds where tenths of a second would hide a tick.
std::string words_of_age(double age_s, const StageLanguage::Ribbon& words) {
  if (age_s <= 0.0) return std::string(words.now);
  return age_s < 1.0 ? filled(words.milliseconds_ago, fmt::format("{:.0f}", std::max(1.0, 1000.0 * age_s)))
                     : filled(words.seconds_ago, fmt::format("{:.1f}", age_s));
}

class RibbonPen {
 public:
  RibbonPen(const Ribbon& ribbon, Marks& marks) : ribbon_(ribbon), marks_(marks), em_(em_of(ribbon)) {}

  void line(Role role, const Vector<2>& from, const Vector<2>& to, double ems, Colour colour) {
    marks_.push_back({role, std::nullopt, Line{world(from), world(to), ems * em_, colour}});
  }

  // Words whose middle is at `x`, or as near as the box lets them; left out where other words are. The earlier, the
  // more important.
  void words(double x, double top, std::string text, Colour colour, bool is_bold = false) {
    aligned_words(x, 0.5, top, std::move(text), colour, is_bold);
  }

  // Words of which that share is left of `x`. Returns how wide they are.
  double aligned_words(double x, double share, double top, std::string text, Colour colour, bool is_bold = false) {
    const Vector<2> extent = extent_of(ribbon_, text, is_bold);
    put({x - share * extent.x, top}, extent, std::move(text), colour, is_bold);
    return extent.x;
  }
  // The same at a place, measured already.
  void put(const Vector<2>& wanted, const Vector<2>& extent, std::string text, Colour colour, bool is_bold) {
    const double least = ribbon_.box.least.x + margin();
    const double most = ribbon_.box.most.x - margin() - extent.x;
    if (most < least) return;
    const Vector<2> corner{std::clamp(wanted.x, least, most), wanted.y};
    const ScreenBox room = ScreenBox{corner, corner + extent};
    const ScreenBox apart{room.least - Vector<2>(0.6 * em_, 0.0), room.most + Vector<2>(0.6 * em_, 0.0)};
    if (std::ranges::any_of(taken_, [&](const ScreenBox& other) { return overlap(apart, other) > 0.0; })) return;
    taken_.push_back(room);
    const TextStyle drawn = style_of(ribbon_, is_bold);
    marks_.push_back({Role::scale, std::nullopt,
                      Label{world(corner), Vector<2>(0.0), std::move(text), drawn, colour, ribbon_.theme.panel}});
  }

  void ground() {
    marks_.push_back({Role::scale, std::nullopt,
                      Box{world(ribbon_.box.least), ribbon_.box.extent(), 0.3 * em_, ribbon_.theme.panel,
                          ribbon_.theme.panel_border, 0.06 * em_}});
  }

  void curve(StrategyId id, const std::vector<PlotBucket>& buckets, const RibbonAxis& axis, const ScreenBox& band,
             double top) {
    const std::size_t i = index_of(id);
    const LinePattern& pattern = strategy_style(id).pattern;
    // Dashes hold on to their times: else they would crawl as time goes on.
    const double period = std::accumulate(pattern.begin(), pattern.end(), 0.0);
    const double points_per_second = (axis.right - axis.left) / MomentHistory::span_s;
    const double began_s = axis.end_s - MomentHistory::span_s;  // of the axis
    const double began_at = axis.left - (period > 0.0 ? std::fmod(began_s * points_per_second, period) + period : 0.0);
    const auto piece = [&](const Vector<2>& from, const Vector<2>& to) {
      const double start = (from.x - began_at) / ribbon_.camera.points_per_metre;
      marks_.push_back(
          {Role::ghost_force, id, Line{world(from), world(to), 0.1 * em_, ribbon_.theme.strategy[i], pattern, start}});
    };
    std::vector<Vector<2>> points;  // up to a gap
    const auto end_piece = [&] {
      for (std::size_t k = 1; k < points.size(); ++k) piece(points[k - 1], points[k]);
      points.clear();
    };
    for (const PlotBucket& bucket : buckets) {
      if (std::isnan(bucket.least[ghost_quantity][i])) {  // nobody knew it
        end_piece();
        continue;
      }
      const double x = axis.x_at(0.5 * (bucket.from_s + bucket.to_s));
      const auto y = [&](double force) { return band.most.y - std::clamp(force / top, 0.0, 1.0) * band.extent().y; };
      double first = y(bucket.least[ghost_quantity][i]);
      double second = y(bucket.greatest[ghost_quantity][i]);
      // A stroke from the end that is nearer to where the curve is; a row of short ones would look like stairs.
      if (std::abs(second - first) < stair) first = second = 0.5 * (first + second);
      if (!points.empty() && std::abs(second - points.back().y) < std::abs(first - points.back().y)) {
        std::swap(first, second);
      }
      add_point({x, first}, points);
      if (second != first) points.emplace_back(x, second);
    }
    end_piece();
  }

  // A line across the band and something to take hold of.
  void cursor(double x, const ScreenBox& band, Colour colour) {
    line(Role::handle, {x, band.least.y}, {x, band.most.y}, 0.1, colour);
    marks_.push_back(
        {Role::handle, std::nullopt,
         Marker{world({x, band.least.y}), Shape::disc, 0.32 * em_, colour, ribbon_.theme.panel, 0.1 * em_}});
  }

  double margin() const noexcept { return 0.25 * em_; }

 private:
  Vector<2> world(const Vector<2>& point) const noexcept { return to_world(ribbon_.camera, point); }

  const Ribbon& ribbon_;
  Marks& marks_;
  double em_;
  std::vector<ScreenBox> taken_;  // by words
};

// The greatest ghost force in sight; empty: nobody knows any.
std::optional<double> greatest_ghost(const std::vector<PlotBucket>& buckets) {
  double greatest = 0.0;
  bool is_known = buckets.empty();
  for (const PlotBucket& bucket : buckets) {
    for (const double force : bucket.greatest[ghost_quantity]) {
      is_known = is_known || !std::isnan(force);
      greatest = std::fmax(greatest, force);
    }
  }
  return is_known ? std::optional(greatest) : std::nullopt;
}

// Between the times that are named [s]; as many as have room.
double step_of_times(const Ribbon& ribbon, const RibbonAxis& axis) {
  const double widest = extent_of(ribbon, filled(ribbon.language.ribbon.seconds_ago, 60)).x + 1.2 * em_of(ribbon);
  constexpr std::array steps{10.0, 20.0, 30.0};
  for (const double step : steps) {
    if (step * (axis.right - axis.left) / MomentHistory::span_s >= widest) return step;
  }
  return MomentHistory::span_s;
}

// Where the motion began less than a minute ago there is nothing before it, and who does not know why would miss it.
void add_beginning(const Ribbon& ribbon, const RibbonAxis& axis, const ScreenBox& band, RibbonPen& pen) {
  const std::optional<ShownMoment> oldest = ribbon.moments.oldest();
  if (!oldest || oldest->snapshot.tick > 1) return;
  const double x = axis.x_at(oldest->snapshot.time_s);
  const double right = x - 0.4 * em_of(ribbon);
  const StageLanguage::Ribbon& words = ribbon.language.ribbon;
  for (const std::string_view each : {words.begins, words.begins_shortly}) {
    const Vector<2> extent = extent_of(ribbon, each);
    if (right - extent.x < band.least.x) continue;
    const double top = 0.5 * (band.least.y + band.most.y - extent.y);
    pen.put({right - extent.x, top}, extent, std::string(each), ribbon.theme.faint_text, false);
    break;
  }
  pen.line(Role::scale, {x, band.least.y}, {x, band.most.y}, 0.06, ribbon.theme.faint_text);
}

}  // namespace

double RibbonAxis::x_at(double time_s) const noexcept {
  const double share = (time_s - end_s) / MomentHistory::span_s + 1.0;
  return left + std::clamp(share, 0.0, 1.0) * (right - left);
}

std::optional<double> RibbonAxis::time_at(double x) const noexcept {
  if (!(x < right)) return std::nullopt;
  return std::max(oldest_s, end_s - MomentHistory::span_s * std::min(1.0, (right - x) / (right - left)));
}

RibbonAxis ribbon_axis(const Ribbon& ribbon) noexcept {
  const double room = std::min(0.7 * em_of(ribbon), 0.25 * ribbon.box.extent().x);
  const std::optional<ShownMoment> oldest = ribbon.moments.oldest();
  const double end_s = ribbon.moments.changed_s();
  return {ribbon.box.least.x + room, ribbon.box.most.x - room, end_s, oldest ? oldest->snapshot.time_s : end_s};
}

double ribbon_height(const Ribbon& ribbon) {
  return 2.0 * extent_of(ribbon, "0").y + 3.0 * em_of(ribbon);
}

void add_ribbon(const Ribbon& ribbon, Marks& marks) {
  const Theme& theme = ribbon.theme;
  const StageLanguage::Ribbon& words = ribbon.language.ribbon;
  const RibbonAxis axis = ribbon_axis(ribbon);
  const Rows rows = rows_of(ribbon);
  const ScreenBox& band = rows.band;
  RibbonPen pen(ribbon, marks);
  pen.ground();

  const double step_s = step_of_times(ribbon, axis);
  for (double age_s = step_s; age_s <= MomentHistory::span_s; age_s += step_s) {
    const double x = axis.x_at(axis.end_s - age_s);
    pen.line(Role::scale, {x, band.least.y}, {x, band.most.y}, 0.05, theme.panel_border);
  }
  pen.line(Role::scale, {band.least.x, band.most.y}, band.most, 0.06, theme.faint_text);

  const auto most = static_cast<std::size_t>(std::max(64.0, band.extent().x / points_per_bucket));
  const std::vector<PlotBucket> buckets =
      ribbon.moments.plots().between(axis.end_s - MomentHistory::span_s, axis.end_s, most);
  const std::optional<double> greatest = greatest_ghost(buckets);
  const double top = round_up(std::max(smallest_top, greatest.value_or(0.0)));
  const std::optional<ShownMoment> newest = ribbon.moments.newest();
  const StrategyId active = newest ? newest->settings.active : StrategyId::naive;
  for (const Strategy& each : strategy_catalog()) {
    if (each.id != active) pen.curve(each.id, buckets, axis, band, top);
  }
  pen.curve(active, buckets, axis, band, top);

  add_beginning(ribbon, axis, band, pen);
  const double now_x = axis.x_at(axis.end_s);
  const bool is_past = ribbon.looks_back_to_s && *ribbon.looks_back_to_s < axis.end_s;
  if (is_past) pen.line(Role::scale, {now_x, band.least.y}, {now_x, band.most.y}, 0.1, theme.text);
  const double cursor_x = is_past ? axis.x_at(*ribbon.looks_back_to_s) : now_x;
  pen.cursor(cursor_x, band, is_past ? theme.accent : theme.text);

  if (rows.axis) {
    if (is_past) {
      const double age_s = std::min(axis.end_s - *ribbon.looks_back_to_s, MomentHistory::span_s);
      pen.words(cursor_x, *rows.axis, words_of_age(age_s, words), theme.accent, true);
    }
    pen.words(now_x, *rows.axis, std::string(words.now), theme.text, !is_past);
    for (double age_s = MomentHistory::span_s; age_s > 0.0; age_s -= step_s) {
      pen.words(axis.x_at(axis.end_s - age_s), *rows.axis, filled(words.seconds_ago, fmt::format("{:.0f}", age_s)),
                theme.faint_text);
    }
  }
  if (rows.title) {
    // The longer words where they have room.
    for (const std::string_view title : {words.title, words.short_title}) {
      const std::string text = greatest ? filled(title, fmt::format("{:g}", top)) : std::string(words.title_unknown);
      pen.aligned_words(axis.left, 0.0, *rows.title, text, theme.faint_text);
    }
    // Whose line is whose.
    double right = axis.right;
    for (const Strategy& each : std::views::reverse(strategy_catalog())) {
      const std::size_t i = index_of(each.id);
      const std::string name(ribbon.language.strategy_buttons[i].name);
      right -= pen.aligned_words(right, 1.0, *rows.title, name, theme.strategy_text[i], true) + em_of(ribbon);
    }
  }
}

// --- As a mode of the stage: the scene as it was, and the ribbon below it ---

namespace {

void add_last_minute(const StageLayer& layer) {
  add_whole_scene(layer);
  if (const auto ribbon = stage_ribbon(layer)) add_ribbon(*ribbon, layer.canvas.marks);
}

std::string ribbon_sentence(const StageContent& content) {
  if (content.looks_back_to_s) return {};
  return std::string(content.language.sentences.drag_along_ribbon);
}

}  // namespace

std::optional<Ribbon> stage_ribbon(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  if (content.moments == nullptr || !layout.ribbon) return std::nullopt;
  return Ribbon{.moments = *content.moments,
                .looks_back_to_s = content.looks_back_to_s,
                .language = content.language,
                .theme = content.theme,
                .measure = content.measure,
                .camera = canvas.camera,
                .box = *layout.ribbon};
}

const StageModeLayers ribbon_layers{StageMode::ribbon, add_last_minute, ribbon_sentence};

}  // namespace ghostforce
