#include "app/shell/frame_pacer.h"

#include <utility>

namespace ghostforce {

void LateTicks::note(std::uint64_t counted, bool is_opening, double interval_s) {
  clock_s_ += interval_s;
  while (!bursts_.empty() && clock_s_ - bursts_.front().at_s >= lately_s_) {
    lately_ -= bursts_.front().ticks;
    bursts_.pop_front();
  }
  const std::uint64_t before = std::exchange(counted_, counted);
  const std::uint64_t ticks = counted < before ? counted : counted - before;
  // What ends the opening may have been late itself.
  const bool was_opening = std::exchange(is_opening_, is_opening);
  if (ticks == 0 || is_opening || was_opening) return;
  all_ += ticks;
  lately_ += ticks;
  bursts_.push_back({clock_s_, ticks});
}

}  // namespace ghostforce
