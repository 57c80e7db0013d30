// Sheet: a figure's paper. Panes are put on it row by row below a title; a legend, a caption and the provenance close
// it. White, in the light theme's colours, for print. Pure, any thread.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/picture/chart.h"
#include "app/picture/theme.h"
#include "app/tools/figures/figure.h"

namespace ghostforce {

// Letters as they are painted by Cairo.
Vector<2> measure_on_paper(std::string_view text, const TextStyle& style);

// One thing that the legend names.
struct LegendEntry {
  std::string name;
  Colour colour;
  bool has_line = false;
  LinePattern pattern = solid_line;
  std::optional<Shape> shape{};
  bool is_hollow = false;
};
// Colour, shape, line and letter of each strategy.
std::vector<LegendEntry> strategy_legend();

// What a pane of a row needs to know.
struct Place {
  Vector<2> corner;
  Vector<2> size;
};

Pane chart_on(const Place& place, const Chart& chart);

class Sheet {
 public:
  // `width` of the paper [points].
  Sheet(std::string title, double width);

  // `count` places side by side, equally wide; their corners and sizes, for make() of each.
  void add_row(double height, std::size_t count, const std::function<Pane(const Place&, std::size_t number)>& make);
  // A line above the places of the next row, one title each.
  void add_titles(std::span<const std::string> titles);
  void add_legend(const std::vector<LegendEntry>& entries);

  // Of the places of add_row().
  Vector<2> place_size(double height, std::size_t count) const;

  // Adds caption and provenance, and hands over the whole.
  Figure finish(const std::string& caption, const std::string& provenance, CsvTable data);

 private:
  void add_words(const std::string& text, const TextStyle& style, Colour colour);

  Figure figure_;
  double bottom_;  // of what is there [points]
};

}  // namespace ghostforce
