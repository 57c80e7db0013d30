// ReadingAloud: what the stage says, for those who do not look at it: printed as lines, and spoken while the session
// has that switched on. UI thread.
#pragma once

#include <memory>
#include <optional>

#include "app/base/newest_line_writer.h"
#include "app/shell/application.h"
#include "app/tools/speech/printed_values.h"
#include "app/tools/speech/speech.h"

namespace ghostforce {

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
