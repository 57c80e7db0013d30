// How long a run is in ticks, those without a row included: what is made of a run plays all of them. The rule for a
// scene's duration (most_ticks) holds for it too, or one damaged time would be work without end. Pure, any thread.
#pragma once

#include <cstdint>

#include "app/console/failure.h"
#include "app/files/run_reader.h"

namespace ghostforce {

// Counts from where the run began, or was reset last.
class RunLength {
 public:
  // The next tick of the file: its k, and the rate there. False: with it the run is longer than may be.
  bool takes(std::int64_t tick, double rate) noexcept;

 private:
  std::int64_t begin_ = 0;   // k where the stretch with the same rate begins
  std::int64_t last_ = 0;    // k
  std::int64_t before_ = 0;  // ticks before that stretch
  double rate_ = 0.0;        // 0: no tick yet
};

// What to say of the first tick that is too far off.
Failure too_long(const RunFacts& run, const RunTick& tick);

}  // namespace ghostforce
