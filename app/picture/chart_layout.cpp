#include "app/picture/chart.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>

#include "app/picture/ticks.h"

namespace ghostforce {
namespace {

// Sizes in points before scale and thickness.
constexpr double margin = 8.0;               // to the edge of the pane
constexpr double line_step = 1.25;           // from line to line of words, in their heights
constexpr double tick_length = 4.0;          // outside the plot
constexpr double word_gap = 4.0;             // between a tick and its words
constexpr double title_gap = 3.0;            // between those and the axis' title
constexpr double padding = 6.0;              // round the legend's entries
constexpr double clearance = 6.0;            // between legend and curves
constexpr double least_plot = 24.0;          // a smaller one shows nothing
constexpr double least_plot_beside = 220.0;  // what a legend at the right must leave,
constexpr double least_share_beside = 0.6;   // and as a share of the width

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Range {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();

  void add(double value, bool is_logarithmic) {
    if (!std::isfinite(value) || (is_logarithmic && value <= 0.0)) return;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
};

Range range_of(const Chart& chart, glm::length_t component) {
  const Axis& axis = component == 0 ? chart.x : chart.y;
  if (axis.range && axis.range->x < axis.range->y && (!axis.is_logarithmic || axis.range->x > 0.0)) {
    return {axis.range->x, axis.range->y};
  }
  Range range;
  for (const Series& series : chart.series) {
    for (const Vector<2>& point : series.points) {
      if (std::isfinite(point[1 - component])) range.add(point[component], axis.is_logarithmic);
    }
  }
  for (const Reference& reference : chart.references) {
    if (reference.is_vertical == (component == 0)) range.add(reference.at, axis.is_logarithmic);
  }
  if (range.least > range.greatest) return {axis.is_logarithmic ? 1.0 : 0.0, axis.is_logarithmic ? 10.0 : 1.0};
  return range;
}

// Finds the places in turn: titles, then the axes between them, the legend in what the curves leave, references last.
class Arrangement {
 public:
  Arrangement(const Chart& chart, const Vector<2>& size, double unit, const MeasureText& measure)
      : chart_(chart), unit_(unit), measure_(measure), size_(size) {
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
      if (chart.series[i].name.empty()) continue;
      std::string name =
          shortened(chart.series[i].name, size.x - 2.0 * points(margin + padding) - name_left(), small_text);
      const double width = name_left() + width_of(name);
      named_.push_back({i, std::move(name), width, {}});
    }
  }

  std::optional<ChartLayout> make() {
    for (const Legend where : {Legend::inside, Legend::right, Legend::below}) {
      divide(where);
      if (named_.empty() || find_place_for_legend(where)) break;
    }
    if (!(plot_.extent().x >= points(least_plot) && plot_.extent().y >= points(least_plot))) return {};
    ChartLayout layout;
    layout.plot = plot_;
    place_grid(layout);
    place_references(layout);
    place_ticks(layout);
    place_titles(layout);
    place_legend(layout);
    layout.series = std::move(series_);
    return layout;
  }

 private:
  enum class Legend : std::uint8_t { inside, right, below };
  struct Entry {  // of the legend
    std::size_t series;
    std::string name;
    double width;
    Vector<2> upper_left;
  };

  double points(double size) const { return size * unit_; }
  double height_of(const TextStyle& style) const { return points(style.height); }
  Vector<2> extent_of(std::string_view words, const TextStyle& style) const {
    return measure_(words, {height_of(style), style.is_bold});
  }
  double width_of(std::string_view words, const TextStyle& style = small_text) const {
    return extent_of(words, style).x;
  }

  // ---- Words --------------------------------------------------------------------------------------------------------

  // Broken where there is a blank, in two lines at most; what has no room in them is cut.
  std::vector<std::string> broken(std::string_view text, double room, const TextStyle& style) const {
    std::string first;
    while (!text.empty()) {
      const std::size_t end = std::min(text.find(' ', 1), text.size());
      const std::string joined = first + std::string(text.substr(0, end));
      if (!first.empty() && width_of(joined, style) > room) break;
      first = joined;
      text.remove_prefix(end);
    }
    std::vector<std::string> lines;
    if (!first.empty()) lines.push_back(shortened(first, room, style));
    if (!text.empty()) lines.push_back(shortened(std::string(text.substr(1)), room, style));
    return lines;
  }

  std::string shortened(std::string text, double room, const TextStyle& style) const {
    if (width_of(text, style) <= room) return text;
    const auto is_within_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
    while (!text.empty() && width_of(text + "…", style) > room) {
      while (text.size() > 1 && is_within_letter(text.back())) text.pop_back();
      text.pop_back();
    }
    return text + "…";
  }

  // ---- The pane divided ---------------------------------------------------------------------------------------------

  // Titles, plot and axes, if the legend is there.
  void divide(Legend where) {
    const double room = size_.x - 2.0 * points(margin);
    const double small = line_step * height_of(small_text);
    title_ = broken(chart_.title, room, normal_text);
    y_title_ = broken(chart_.y.title, room, small_text);
    x_title_ = broken(chart_.x.title, room, small_text);

    plot_.least.y = points(margin) + static_cast<double>(title_.size()) * line_step * height_of(normal_text) +
                    static_cast<double>(y_title_.size()) * small + points(word_gap) + 0.5 * height_of(small_text);
    plot_.most.y = size_.y - points(margin) - static_cast<double>(x_title_.size()) * small - height_of(small_text) -
                   points(tick_length + word_gap + title_gap);
    if (where == Legend::below) {
      flow_legend(Vector<2>(points(margin), 0.0), room);
      plot_.most.y -= legend_.extent().y + points(word_gap);
    }

    const Range y = range_of(chart_, 1);
    const std::function<double(std::string_view)> line_height = [&](std::string_view) { return height_of(small_text); };
    y_ticks_ = choose_ticks({y.least, y.greatest, chart_.y.is_logarithmic, !chart_.y.range, plot_.extent().y,
                             1.1 * height_of(small_text), line_height});
    double widest = 0.0;
    for (const Tick& tick : y_ticks_.named) widest = std::max(widest, width_of(tick.words));
    plot_.least.x = points(margin) + widest + points(word_gap + tick_length);

    const Range x = range_of(chart_, 0);
    const std::function<double(std::string_view)> width = [&](std::string_view words) { return width_of(words); };
    plot_.most.x = size_.x - points(2.0 * margin);
    if (where == Legend::right) plot_.most.x -= column_extent().x + points(clearance);
    // The words of the last tick may reach beyond the axis.
    for (int pass = 0; pass < 2; ++pass) {
      x_ticks_ = choose_ticks({x.least, x.greatest, chart_.x.is_logarithmic, !chart_.x.range, plot_.extent().x,
                               1.6 * height_of(small_text), width});
      if (x_ticks_.named.empty()) break;
      const Tick& last = x_ticks_.named.back();
      const double end = on_screen({last.value, y_ticks_.least}).x + 0.5 * width_of(last.words);
      const double beyond = end - (where == Legend::right ? plot_.most.x + points(margin) : size_.x - points(margin));
      if (beyond <= 0.0) break;
      plot_.most.x -= beyond;
    }
    trace();
  }

  Vector<2> on_screen(const Vector<2>& point) const {
    // Far outside of the picture it does not matter how far.
    constexpr double farthest = 1e6;
    const double x = place_on_axis(point.x, x_ticks_.least, x_ticks_.greatest, chart_.x.is_logarithmic);
    const double y = place_on_axis(point.y, y_ticks_.least, y_ticks_.greatest, chart_.y.is_logarithmic);
    if (std::isnan(x) || std::isnan(y)) return Vector<2>(nan);
    return {std::clamp(plot_.least.x + x * plot_.extent().x, -farthest, farthest),
            std::clamp(plot_.most.y - y * plot_.extent().y, -farthest, farthest)};
  }

  // What of the series is to be seen.
  void trace() {
    series_.assign(chart_.series.size(), {});
    const ScreenBox within = plot_.grown(1e-6);  // a point on the edge is inside, whatever rounding says
    for (std::size_t i = 0; i < chart_.series.size(); ++i) {
      const Series& series = chart_.series[i];
      Vector<2> before(nan);
      double along = 0.0;
      for (const Vector<2>& point : series.points) {
        const Vector<2> at = on_screen(point);
        if (!std::isnan(at.x) && !std::isnan(before.x)) {
          ScreenPiece piece{before, at, along};
          along += glm::distance(before, at);
          if (series.has_line && clip(within, piece)) series_[i].line.push_back(piece);
        } else {
          along = 0.0;
        }
        if (series.shape && contains(within, at)) series_[i].shapes.push_back(at);
        before = at;
      }
    }
  }

  // How much of the box curves, points and words cover; 0 is free.
  double overlap_cost(const ScreenBox& box) const {
    double cost = 0.0;
    for (std::size_t i = 0; i < chart_.series.size(); ++i) {
      for (ScreenPiece piece : series_[i].line) {
        if (clip(box.grown(0.5 * points(chart_.series[i].width)), piece))
          cost += 1.0 + glm::distance(piece.from, piece.to);
      }
      for (const Vector<2>& at : series_[i].shapes) {
        if (contains(box.grown(points(chart_marker_radius)), at)) cost += points(2.0 * chart_marker_radius);
      }
    }
    constexpr double weight_of_words = 100.0;  // words over a line can still be read, words over words cannot
    for (const ScreenBox& words : words_) cost += weight_of_words * overlap(box, words);
    return cost;
  }

  // ---- Legend -------------------------------------------------------------------------------------------------------

  double row_height() const { return 1.3 * height_of(small_text); }
  double name_left() const { return points(chart_sample_length + 7.0); }

  Vector<2> column_extent() const {
    Vector<2> extent(0.0);
    for (const Entry& entry : named_) extent = {std::max(extent.x, entry.width), extent.y + row_height()};
    return extent + Vector<2>(2.0 * points(padding));
  }

  // Entries in a column.
  void stack_legend(const Vector<2>& corner) {
    legend_ = {corner, corner + column_extent()};
    Vector<2> at = corner + Vector<2>(points(padding));
    for (Entry& entry : named_) {
      entry.upper_left = at;
      at.y += row_height();
    }
  }

  // Entries in rows, as many side by side as have room.
  void flow_legend(const Vector<2>& corner, double room) {
    Vector<2> at = corner;
    for (Entry& entry : named_) {
      if (at.x > corner.x && at.x + entry.width > corner.x + room) at = {corner.x, at.y + row_height()};
      entry.upper_left = at;
      at.x += entry.width + points(18.0);
    }
    legend_ = {corner, {corner.x + room, at.y + row_height()}};
  }

  bool find_place_for_legend(Legend where) {
    switch (where) {
      case Legend::inside:
        return find_free_corner();
      case Legend::right:
        stack_legend({size_.x - points(margin) - column_extent().x, plot_.least.y - points(padding)});
        return plot_.extent().x >= std::max(points(least_plot_beside), least_share_beside * size_.x) &&
               legend_.most.y <= size_.y;
      case Legend::below:
        flow_legend({points(margin), size_.y - points(margin) - legend_.extent().y}, size_.x - 2.0 * points(margin));
        return true;
    }
    return true;
  }

  bool find_free_corner() {
    const Vector<2> extent = column_extent();
    const Vector<2> room = plot_.extent() - extent - Vector<2>(2.0 * points(clearance));
    if (room.x < 0.0 || room.y < 0.0) return false;
    words_.clear();
    for (std::size_t i = 0; i < chart_.references.size(); ++i) words_.push_back(place_reference_words(i));
    for (const double x : {1.0, 0.0, 0.5}) {
      for (const double y : {0.0, 1.0}) {
        const Vector<2> corner = plot_.least + Vector<2>(points(clearance)) + room * Vector<2>(x, y);
        const ScreenBox box{corner, corner + extent};
        if (overlap_cost(box) > 0.0 || is_crossed_by_reference(box)) continue;
        stack_legend(corner);
        return true;
      }
    }
    return false;
  }

  bool is_crossed_by_reference(const ScreenBox& box) const {
    return std::ranges::any_of(chart_.references, [&](const Reference& reference) {
      ScreenPiece piece = line_of(reference);
      return !std::isnan(piece.from.x) && clip(box, piece);
    });
  }

  void place_legend(ChartLayout& layout) const {
    for (const auto& [series, name, width, at] : named_) {
      const Vector<2> middle = at + Vector<2>(0.0, 0.5 * row_height());
      layout.legend.push_back({series,
                               {middle, middle + Vector<2>(points(chart_sample_length), 0.0)},
                               {at + Vector<2>(name_left(), 0.5 * (row_height() - height_of(small_text))), name}});
    }
  }

  // ---- References ---------------------------------------------------------------------------------------------------

  // All across the plot; NaN where it lies outside.
  ScreenPiece line_of(const Reference& reference) const {
    const Vector<2> at = on_screen(reference.is_vertical ? Vector<2>(reference.at, y_ticks_.least)
                                                         : Vector<2>(x_ticks_.least, reference.at));
    if (!contains(plot_.grown(1e-6), at)) return {Vector<2>(nan), Vector<2>(nan)};
    if (reference.is_vertical) return {{at.x, plot_.most.y}, {at.x, plot_.least.y}};
    return {{plot_.least.x, at.y}, {plot_.most.x, at.y}};
  }

  // Beside the line, where least is covered; an empty box where the line is not to be seen.
  ScreenBox place_reference_words(std::size_t i) const {
    const Reference& reference = chart_.references[i];
    const ScreenPiece piece = line_of(reference);
    if (std::isnan(piece.from.x) || reference.word.empty()) return {};
    const Vector<2> extent = extent_of(reference.word, small_text);
    const double gap = points(word_gap);
    const Vector<2> room = glm::max(plot_.extent() - extent - Vector<2>(2.0 * gap), Vector<2>(0.0));
    ScreenBox best;
    double least = std::numeric_limits<double>::infinity();
    for (const double share : {0.0, 1.0, 0.07, 0.14, 0.21, 0.93, 0.86, 0.5, 0.3, 0.4, 0.6, 0.7}) {
      for (const bool is_behind : {true, false}) {
        Vector<2> corner = plot_.least + Vector<2>(gap) + room * (reference.is_vertical ? share : 1.0 - share);
        const glm::length_t across = reference.is_vertical ? 0 : 1;
        // Behind a vertical line is right of it, of a horizontal one above it.
        const bool is_after = reference.is_vertical == is_behind;
        corner[across] = piece.from[across] + (is_after ? gap : -gap - extent[across]);
        const ScreenBox box{corner, corner + extent};
        const bool leaves = !contains(plot_.grown(1e-6), box.least) || !contains(plot_.grown(1e-6), box.most);
        const double cost = overlap_cost(box.grown(points(1.5))) + (leaves ? 1e6 : 0.0);
        if (cost < least) {
          least = cost;
          best = box;
        }
      }
    }
    // Wider than the plot: at least within the pane.
    const Vector<2> corner = glm::max(glm::min(best.least, size_ - extent), Vector<2>(0.0));
    return {corner, corner + extent};
  }

  void place_references(ChartLayout& layout) {
    words_.clear();
    if (!named_.empty()) words_.push_back(legend_);
    for (std::size_t i = 0; i < chart_.references.size(); ++i) {
      const Reference& reference = chart_.references[i];
      const ScreenPiece piece = line_of(reference);
      if (!std::isnan(piece.from.x)) layout.references.push_back(piece);
      const ScreenBox box = place_reference_words(i);
      words_.push_back(box);
      if (box.extent().x > 0.0) layout.reference_words.push_back({box.least, reference.word});
    }
  }

  // ---- Axes ---------------------------------------------------------------------------------------------------------

  void place_grid(ChartLayout& layout) const {
    using Kind = ChartLayout::GridLine::Kind;
    const auto place = [&](double value, bool is_vertical, Kind kind) {
      const ScreenPiece piece = line_of({value, is_vertical, {}});
      if (!std::isnan(piece.from.x)) layout.grid.push_back({kind, piece});
    };
    for (const bool is_vertical : {true, false}) {
      const Ticks& ticks = is_vertical ? x_ticks_ : y_ticks_;
      const bool is_logarithmic = is_vertical ? chart_.x.is_logarithmic : chart_.y.is_logarithmic;
      for (const double value : ticks.fine) place(value, is_vertical, Kind::fine);
      for (const Tick& tick : ticks.named) place(tick.value, is_vertical, Kind::named);
      if (!is_logarithmic && ticks.least < 0.0 && ticks.greatest > 0.0) place(0.0, is_vertical, Kind::zero);
    }
  }

  void place_ticks(ChartLayout& layout) const {
    for (const Tick& tick : x_ticks_.named) {
      const Vector<2> at = on_screen({tick.value, y_ticks_.least});
      const Vector<2> end = at + Vector<2>(0.0, points(tick_length));
      const Vector<2> corner = end + Vector<2>(-0.5 * width_of(tick.words), points(word_gap));
      layout.x_ticks.push_back({{at, end}, {corner, tick.words}});
    }
    for (const Tick& tick : y_ticks_.named) {
      const Vector<2> at = on_screen({x_ticks_.least, tick.value});
      const Vector<2> end = at - Vector<2>(points(tick_length), 0.0);
      const Vector<2> corner = end - Vector<2>(points(word_gap) + width_of(tick.words), 0.5 * height_of(small_text));
      layout.y_ticks.push_back({{at, end}, {corner, tick.words}});
    }
  }

  void place_titles(ChartLayout& layout) const {
    Vector<2> at(points(margin));
    for (const std::string& line : title_) {
      layout.title.push_back({at, line});
      at.y += line_step * height_of(normal_text);
    }
    for (const std::string& line : y_title_) {
      layout.y_title.push_back({at, line});
      at.y += line_step * height_of(small_text);
    }
    at.y = plot_.most.y + points(tick_length + word_gap + title_gap) + height_of(small_text);
    for (const std::string& line : x_title_) {
      const double width = width_of(line);
      const double middle = 0.5 * (plot_.least.x + plot_.most.x) - 0.5 * width;
      at.x = std::clamp(middle, points(margin), std::max(points(margin), size_.x - points(margin) - width));
      layout.x_title.push_back({at, line});
      at.y += line_step * height_of(small_text);
    }
  }

  const Chart& chart_;
  const double unit_;  // of the sizes above [points]
  const MeasureText& measure_;
  const Vector<2> size_;

  std::vector<std::string> title_, x_title_, y_title_;
  ScreenBox plot_;
  Ticks x_ticks_{0.0, 1.0, {}, {}}, y_ticks_{0.0, 1.0, {}, {}};
  std::vector<ChartLayout::VisibleSeries> series_;
  std::vector<ScreenBox> words_;  // of references, and the legend
  ScreenBox legend_;
  std::vector<Entry> named_;
};

}  // namespace

std::optional<ChartLayout> lay_out(const Chart& chart, const Vector<2>& size, double unit, const MeasureText& measure) {
  return Arrangement(chart, size, unit, measure).make();
}

}  // namespace ghostforce
