// ReadingAloud: what the stage says, for those who do not look at it: printed as lines, and spoken while the session
// has that switched on. UI thread.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/base/newest_line_writer.h"
#include "app/cli/speech.h"
#include "app/shell/application.h"
#include "app/stage/stage.h"

namespace ghostforce {

// The first of the lines that are printed for screen readers and loggers: the names of the columns, beginning with '#',
// with units. Each line has its end of line.
std::string printed_header();

// What the stage says as lines of text: the sentence first, since that is what one listens to, then the numbers as they
// stand on the stage. Columns are separated by tabs; what cannot be known, or is hidden, is "-". The minus sign is
// ASCII's, which programs read. A line at most so many times a second, and only when something else than the time is
// new.
class PrintedValues {
 public:
  static constexpr double least_hz = 0.1;
  static constexpr double greatest_hz = 60.0;

  explicit PrintedValues(double hz) : period_s_(1.0 / hz), since_s_(period_s_) {}

  // Time goes on. True: it is time to poll().
  bool advance(double interval_s) noexcept;

  // The line to print; empty: nothing is new. `time_s`: of the moment that is shown, in the model's time. `is_past`: who
  // looks back wants to hear of each moment.
  std::optional<std::string> poll(const StageReading& reading, double time_s, bool is_past = false);

 private:
  double period_s_;
  double since_s_;       // the last line
  std::string printed_;  // it, without its time but where somebody looks back
};

class ReadingAloud {
 public:
  // Prints so many times a second at most; empty: nothing is printed. `descriptor`: where to.
  ReadingAloud(std::optional<double> printed_hz, int descriptor);

  // After each update() of the application, which is told of what goes wrong. Speech that does not work is left alone
  // until it has been switched off and on again.
  void follow(Application& application, double interval_s);

  // Gives the last line a second to be written. Nothing is printed after it.
  void finish_printing();

  // errno of what has ended the printing; EPIPE: nobody reads it any more. 0: nothing has.
  int output_problem() const noexcept { return output_problem_; }

 private:
  void print(Application& application, double interval_s);
  void speak(Application& application, double interval_s);

  std::optional<PrintedValues> printed_;
  std::unique_ptr<NewestLineWriter> writer_;
  int output_problem_ = 0;
  Speech speech_;
  SettledSentence settled_;
  double since_sentence_s_ = 0.0;
};

}  // namespace ghostforce
