// Chart: curves and points over two axes, as a value, and its picture. For the figures, and for what the plots in the
// window save. Pure, any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/picture/marks.h"
#include "app/picture/panes.h"
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

}  // namespace ghostforce
