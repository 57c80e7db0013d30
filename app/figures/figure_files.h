// A figure as files: the picture as PNG in two densities, as SVG and as PDF, and the numbers that it was drawn from as
// CSV. The same figure gives the same bytes. One thread at a time.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "app/figures/figure.h"

namespace ghostforce {

// What a figure's name is followed by, in the names of its files.
inline constexpr std::array<std::string_view, 5> figure_file_endings{".png", "@2x.png", ".svg", ".pdf", ".csv"};

struct NamedFile {
  std::string name;
  std::string content;
};

// Throws Failure: file_trouble where the font cannot be read; interrupted.
std::vector<NamedFile> figure_files(std::string_view name, const Figure& figure);

}  // namespace ghostforce
