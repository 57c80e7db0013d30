#include "app/files/run.h"

#include <fmt/format.h>

namespace ghostforce {

bool RunLength::takes(std::int64_t tick, double rate) noexcept {
  if (rate_ == 0.0 || (rate == rate_ && tick <= last_)) {  // its beginning, or a reset
    begin_ = tick;
    before_ = 0;
  } else if (rate != rate_) {
    before_ += last_ - begin_ + 1;
    begin_ = tick;
  }
  rate_ = rate;
  last_ = tick;
  return static_cast<double>(before_ + (tick - begin_)) <= most_ticks;
}

ReadError too_long(const RunFacts& run, const RunTick& tick) {
  return {ReadError::Kind::wrong,
          {{.file = run.name,
            .line = tick.line,
            .column = 1,
            .what = fmt::format("with t_s = {} here, the run is longer than {:.0f} ticks, which is the limit",
                                tick.time_s, most_ticks),
            .remedy = fmt::format("if that time is wrong, correct the line; if the run really is that long, cut it "
                                  "before this line:\nhead -n {} RUN.csv > shorter.csv",
                                  tick.line - 1)}}};
}

}  // namespace ghostforce
