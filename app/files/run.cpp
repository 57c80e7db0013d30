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

Failure damaged_line(const RunFacts& run, std::size_t line, std::string_view what) {
  return {ExitCode::wrong_call, fmt::format("{}: line {}: {}. Mend the line, or cut the file before it:\n"
                                            "head -n {} RUN.csv > shorter.csv",
                                            run.name, line, what, line - 1)};
}

Failure too_long(const RunFacts& run, const RunTick& tick) {
  return {ExitCode::wrong_call,
          fmt::format("{}: line {}: with t_s = {} there the run is longer than {:.0f} ticks, which is the most. If "
                      "that time is wrong, mend the line; if the run is simply that long, cut it before there:\n"
                      "head -n {} RUN.csv > shorter.csv",
                      run.name, tick.line, tick.time_s, most_ticks, tick.line - 1)};
}

}  // namespace ghostforce
