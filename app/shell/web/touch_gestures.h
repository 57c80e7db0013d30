// Fingers on the canvas as what ImGui knows: one is the left button of a mouse; two are the right one, which moves the
// view, at the place between them, and the wheel, which zooms there. Since two fingers never land at once, the first
// one presses only when it has moved, has stayed for a moment, or is lifted again.
#pragma once

#include <optional>
#include <span>
#include <utility>

#include "core/conventions.h"

namespace ghostforce {

class TouchGestures {
 public:
  static constexpr double longest_wait_s = 0.1;
  static constexpr double first_move = 4.0;  // [CSS pixels]

  // All fingers that are down, where they are [CSS pixels, y down].
  void follow(std::span<const Vector<2>> fingers, double now_s);
  // Between those, often.
  void advance(double now_s);
  // Two fingers have moved the view since the last call, and have been lifted.
  bool take_end_of_two() noexcept { return std::exchange(two_have_ended_, false); }

 private:
  struct Landing {
    Vector<2> place;
    double time_s;
  };
  void press(std::optional<int> button);
  void press_one(const Vector<2>& place);

  std::optional<int> pressed_;      // of the mouse's buttons
  std::optional<Landing> landing_;  // of a finger that does not press yet
  bool two_have_ended_ = false;
  bool waits_for_lift_ = false;  // after two fingers, one that is left means nothing
  double distance_ = 0.0;        // between two
};

}  // namespace ghostforce
