// Where everything of a chart stands in its pane: titles, axes with their ticks, what of its series is to be seen, a
// legend that covers no curve, words beside their references. In points of the pane, y down; chart.cpp draws it.
// Pure, any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/chart.h"
#include "app/picture/screen_box.h"
#include "app/picture/view.h"

namespace ghostforce {

// Of a series' shapes, in points before scale and thickness.
inline constexpr double chart_marker_radius = 4.4;

struct ChartLayout {
  struct Words {
    Vector<2> upper_left;
    std::string text;
  };
  struct AxisTick {
    ScreenPiece line;  // outside the plot
    Words words;
  };
  struct GridLine {
    enum class Kind : std::uint8_t { fine, named, zero };
    Kind kind;
    ScreenPiece piece;
  };
  struct VisibleSeries {  // what of it lies within the plot
    std::vector<ScreenPiece> line;
    std::vector<Vector<2>> shapes;
  };
  struct LegendEntry {
    std::size_t series;
    ScreenPiece sample;  // of its line
    Words name;
  };

  ScreenBox plot;
  std::vector<Words> title, x_title, y_title;  // line by line
  std::vector<AxisTick> x_ticks, y_ticks;
  std::vector<GridLine> grid;
  std::vector<VisibleSeries> series;  // as many as the chart has
  std::vector<LegendEntry> legend;
  std::vector<ScreenPiece> references;  // those within the plot
  std::vector<Words> reference_words;
};

// `size` is the pane's, `unit` what sizes are multiplied by for scale and thickness. Empty where the pane is too small
// to show anything.
std::optional<ChartLayout> lay_out(const Chart& chart, const Vector<2>& size, double unit, const MeasureText& measure);

}  // namespace ghostforce
