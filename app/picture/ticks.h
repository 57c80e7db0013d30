// Ticks: where an axis has its marks, and what stands there: 1, 2 or 5 times a power of ten, as many as have room.
// Pure, any thread.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace ghostforce {

struct Tick {
  double value;
  std::string words;
};

struct Ticks {
  double least;              // of the axis
  double greatest;           // more than least
  std::vector<Tick> named;   // ascending
  std::vector<double> fine;  // further lines of a logarithmic axis, without words
};

struct TickRequest {
  double least;  // least ≤ greatest; positive where the axis is logarithmic
  double greatest;
  bool is_logarithmic;
  bool rounds_out;  // the axis may grow to whole ticks
  double length;    // of the axis [points]
  double gap;       // between the words of neighbours, at least [points]
  // How much room words take along the axis [points].
  const std::function<double(std::string_view)>& extent;
};

// The densest row of ticks whose words do not touch. Words have no exponent unless the axis goes beyond 99999 or is
// finer than 0.0001, and a real minus sign. Where not even two have room, one is named, or none.
Ticks choose_ticks(const TickRequest& request);

// 0 … 1 between the ends of an axis; beyond them outside of that. NaN for what a logarithmic axis cannot show.
double place_on_axis(double value, double least, double greatest, bool is_logarithmic) noexcept;

}  // namespace ghostforce
