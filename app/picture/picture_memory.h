// PictureMemory: where words, legend and scale bars of the workbench's picture before stood, so that they stand still
// while something is dragged. As it is made: there was none. A value, one thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "app/picture/label_placer.h"
#include "core/strategy.h"

namespace ghostforce {

// What stands in one of a few places.
struct CornerMemory {
  std::optional<std::size_t> place{};
  double strength = 0.0;      // 0: not to be seen, 1: all there
  double waited_s = 0.0;      // for a place, or for a better one
  std::uint64_t picture = 0;  // its number: the same where nothing moves
  bool is_best = true;        // of that picture, as far as anybody has looked

  bool is_moving() const noexcept { return !is_best || waited_s > 0.0 || (place && strength < 1.0); }
};

struct PaneMemory {
  LabelMemory labels{};
  CornerMemory legend{};
  CornerMemory scales{};

  bool is_moving() const noexcept { return labels.is_moving() || legend.is_moving() || scales.is_moving(); }
};

using PictureMemory = std::array<PaneMemory, strategy_count>;  // as many panes as there can be

}  // namespace ghostforce
