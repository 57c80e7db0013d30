// Speech: sentences for speech-dispatcher, the speech service of Linux desktops, by its own tool spd-say, which also
// starts the service where it does not run yet. The tool lives as long as its sentence is spoken. Nothing here waits.
// UI thread.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ghostforce {

// Which sentences are worth being spoken: those that have stood for a moment. What changes all the time, as words with
// running numbers in them do, is never spoken.
class SettledSentence {
 public:
  static constexpr double settles_in_s = 0.6;

  // `interval_s`: since the last call. The sentence, once, when it has stood for so long and is not the one before.
  std::optional<std::string> take(std::string_view sentence, double interval_s);

 private:
  std::string seen_;
  std::string taken_;
  double stands_s_ = 0.0;
};

class Speech {
 public:
  static constexpr double speaks_within_s = 60.0;  // a sentence; the service may have to start first

  Speech() = default;
  ~Speech() { end(); }
  Speech(const Speech&) = delete;
  Speech& operator=(const Speech&) = delete;

  // In place of what is being said. `language` as in "en", "es". Returns why nothing can be spoken, and what to do;
  // empty: it has begun.
  std::string say(std::string_view words, std::string_view language);

  // Often: buries the tools that have ended. Returns the same of a sentence that has failed meanwhile, once.
  std::string update(double interval_s);

  // What is being said ends, as far as the service listens.
  void end();

 private:
  // Whether a sentence was being spoken. Its tool is killed, so that a service that hangs gathers none.
  bool silence();
  // 0, or the number of an error.
  int start(const std::vector<std::string>& words, pid_t& child);

  std::vector<pid_t> children_;  // that have not been buried
  pid_t speaking_ = 0;           // the one of them with the sentence that is being spoken; 0: there is none
  double speaks_since_s_ = 0.0;
};

}  // namespace ghostforce
