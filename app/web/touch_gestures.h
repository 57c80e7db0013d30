// Fingers on the canvas as what ImGui knows: one is the left button of a mouse; two are the right one, which moves the
// view, at the place between them, and the wheel, which zooms there. A second finger ends what the first one held.
#pragma once

#include <optional>
#include <span>

#include "core/conventions.h"

namespace ghostforce {

class TouchGestures {
 public:
  // All fingers that are down, where they are [CSS pixels, y down].
  void follow(std::span<const Vector<2>> fingers);

 private:
  void hold(std::optional<int> button);

  std::optional<int> held_;      // of the mouse's buttons
  bool waits_for_lift_ = false;  // after two fingers, one that is left means nothing
  double distance_ = 0.0;        // between two
};

}  // namespace ghostforce
