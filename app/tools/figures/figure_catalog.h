// The one list of figures: the paper's, and some that it does not have. A new figure is one file beside this one, a
// line or two in figures.h and one row in figure_catalog.cpp. Immutable, any thread.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/tools/figures/figure.h"

namespace ghostforce {

struct FigureEntry {
  std::string_view name;      // of its files, and on the command line
  std::string_view sentence;  // what it shows, for --help
  Figure (*make)(const FigureRequest& request);
  bool takes_hand = false;  // a recorded one
};

std::span<const FigureEntry> figure_catalog() noexcept;

// A figure as files: the picture as PNG in two densities, as SVG and as PDF, and the numbers that it was drawn from as
// CSV. The same figure gives the same bytes. One thread at a time.
//
// What a figure's name is followed by, in the names of its files.
inline constexpr std::array<std::string_view, 5> figure_file_endings{".png", "@2x.png", ".svg", ".pdf", ".csv"};

struct NamedFile {
  std::string name;
  std::string content;
};

// Throws Failure: file_trouble where the font cannot be read; interrupted.
std::vector<NamedFile> figure_files(std::string_view name, const Figure& figure);

}  // namespace ghostforce
