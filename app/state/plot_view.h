// PlotView: what of the plots a person looks at. Part of the session.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace ghostforce {

enum class PlotTab : std::uint8_t { time, wall_angle, ratio, hand };

// In proposed file names.
constexpr std::string_view plot_tab_name(PlotTab tab) noexcept {
  constexpr std::array<std::string_view, 4> names{"over-time", "over-wall-angle", "over-ratio", "hand-over-time"};
  return names[static_cast<std::size_t>(tab)];
}

// What it shows has a time axis, and can be looked back at.
constexpr bool is_over_time(PlotTab tab) noexcept {
  return tab == PlotTab::time || tab == PlotTab::hand;
}

struct PlotView {
  // What fits into the plots' memory at 1 kHz [s].
  static constexpr double longest_span_s = 65.0;
  static constexpr double shortest_span_s = 0.02;

  bool is_open = false;
  PlotTab tab = PlotTab::time;
  bool follows = true;  // the newest tick is at the right edge
  double from_s = 0.0;  // the times in sight; model time
  double to_s = 4.0;
  std::optional<double> cursor_s{};  // the time under the pointer

  double span_s() const noexcept { return to_s - from_s; }
  // Keeps the right edge.
  void set_span(double span_s) noexcept { from_s = to_s - span_s; }
};

}  // namespace ghostforce
