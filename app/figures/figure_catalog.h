// The one list of figures: the paper's, and some that it does not have. A new figure is one file beside this one, a
// line or two in figures.h and one row in figure_catalog.cpp. Immutable, any thread.
#pragma once

#include <span>
#include <string_view>

#include "app/figures/figure.h"

namespace ghostforce {

struct FigureEntry {
  std::string_view name;      // of its files, and on the command line
  std::string_view sentence;  // what it shows, for --help
  Figure (*make)(const FigureRequest& request);
  bool takes_hand = false;  // a recorded one
};

std::span<const FigureEntry> figure_catalog() noexcept;

}  // namespace ghostforce
