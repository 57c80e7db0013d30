// StageMeasuring: what the stage shows of measuring the hand. Values, read only; any thread. SI units.
#pragma once

#include <optional>
#include <string>

#include "core/hand_estimator.h"

namespace ghostforce {

struct StageMeasuring {
  bool is_running = false;
  double filled = 0.0;  // of its ring, 0 to 1
  // While it runs, what it waits for; afterwards, why nobody knows.
  HandUnknown why = HandUnknown::none;
  std::optional<HandEstimate> result{};  // known
  std::optional<HandEstimate> before{};  // the one that was known before
  bool is_believed = false;              // the result is what the renderer believes in now
  // Of a lesson that wants another grip: the nearest stiffness that would do [N/m].
  std::optional<double> asked{};

  // It was tried, or is, and there is something to say about it instead of a number.
  bool has_trouble() const noexcept { return why != HandUnknown::none; }
};

// The words of its button, of which there are several: letters are as large with all of them.
struct StageMeasuringButton {
  std::string words;
  std::string longest;
};

}  // namespace ghostforce
