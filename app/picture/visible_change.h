// Whether two ticks look the same in a picture. Pure.
#pragma once

#include "core/snapshot.h"

namespace ghostforce {

// What is less than this nobody sees.
struct LeastVisible {
  double step = 0.0;   // of a place [m]
  double force = 0.0;  // [N]
};

// Against what was seen, not against the tick before: what creeps is noticed in the end.
bool differs_visibly(const Snapshot& seen, const Snapshot& now, const LeastVisible& least) noexcept;

}  // namespace ghostforce
