// SettledSentence: which sentences are worth being spoken: those that have stood for a moment. What changes all the
// time, as words with running numbers in them do, is never spoken. Any one thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ghostforce {

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

}  // namespace ghostforce
