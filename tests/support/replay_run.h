// A whole run driven once more. For tests.
#pragma once

#include <functional>

#include "app/files/run.h"
#include "app/runs/replay.h"

namespace ghostforce {

// The run must tell its scene.
inline ReplayReport replay(const Run& run, const std::function<void(const ReplayedTick&)>& on_tick) {
  Replay replay(on_tick);
  for (const RunTick& tick : run.ticks) replay.take(run, tick);
  return replay.report();
}

}  // namespace ghostforce
