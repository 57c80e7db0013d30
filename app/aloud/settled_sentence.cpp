#include "app/aloud/settled_sentence.h"

namespace ghostforce {

std::optional<std::string> SettledSentence::take(std::string_view sentence, double interval_s) {
  if (sentence != seen_) {
    seen_ = sentence;
    stands_s_ = 0.0;
    return std::nullopt;
  }
  stands_s_ += interval_s;
  if (stands_s_ < settles_in_s || seen_ == taken_) return std::nullopt;
  taken_ = seen_;
  return taken_;
}

}  // namespace ghostforce
