// What the stage says as lines of text, for screen readers and loggers: the sentence first, since that is what one
// listens to, then the numbers as they stand on the stage. Columns are separated by tabs; what cannot be known, or is
// hidden, is "-". The minus sign is ASCII's, which programs read. Any one thread.
#pragma once

#include <optional>
#include <string>

#include "app/stage/stage.h"

namespace ghostforce {

// The names of the columns, beginning with '#', with units. With its end of line.
std::string printed_header();

// `time_s`: of the moment that is shown, in the model's time. With its end of line.
std::string printed_line(const StageReading& reading, double time_s);

// When there is a line to print: at most so many times a second, and only when something else than the time is new.
class PrintedValues {
 public:
  static constexpr double least_hz = 0.1;
  static constexpr double greatest_hz = 60.0;

  explicit PrintedValues(double hz) : period_s_(1.0 / hz), since_s_(period_s_) {}

  // Time goes on. True: it is time to poll().
  bool advance(double interval_s) noexcept;

  // The line to print; empty: nothing is new.
  std::optional<std::string> poll(const StageReading& reading, double time_s);

 private:
  double period_s_;
  double since_s_;       // the last line
  std::string printed_;  // it, without its time
};

}  // namespace ghostforce
