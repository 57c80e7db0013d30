// Chart: curves and points over two axes, as a value, where everything of it stands, and its picture. For the figures,
// and for what the plots in the window save. Pure, any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/marks.h"
#include "app/picture/panes.h"
#include "app/picture/screen_box.h"
#include "app/picture/theme.h"
#include "app/picture/view.h"

namespace ghostforce {

struct Axis {
  std::string title;  // with its unit: "wall angle [°]"
  bool is_logarithmic = false;
  std::optional<Vector<2>> range{};  // least and greatest; empty: what the series need, rounded to whole ticks
};

struct Series {
  std::string name;  // in the legend; empty: not there
  Colour colour;
  std::vector<Vector<2>> points;  // in the axes' units; a NaN leaves a gap
  bool has_line = true;
  LinePattern pattern = solid_line;
  double width = 2.0;            // [points]
  std::optional<Shape> shape{};  // at each point; empty: none
  bool is_hollow = false;        // those shapes
};

// A line across the chart with a word: an optimum, a cursor.
struct Reference {
  double at;
  bool is_vertical;
  std::string word;
};

struct Chart {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Series> series;
  std::vector<Reference> references{};
};

// The chart as marks in a pane of its own, so that the painters that draw scenes draw charts too: in its camera one
// metre is one point, y up. `corner` and `size` in points, `scale` as for scenes.
Pane chart_pane(const Chart& chart, const Vector<2>& corner, const Vector<2>& size, const Theme& theme, double scale,
                const MeasureText& measure);

// Of a series' shapes, in points before scale and thickness.
inline constexpr double chart_marker_radius = 4.4;
// Of a line in a legend, in the same points.
inline constexpr double chart_sample_length = 44.0;

// Where everything of a chart stands in its pane: titles, axes with their ticks, what of its series is to be seen, a
// legend that covers no curve, words beside their references. In points of the pane, y down; chart_layout.cpp finds it
// out, and chart.cpp draws it.
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
