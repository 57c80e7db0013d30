// EncoderWatch: whether the encoders still count while a force stands. A hand that rests lets them say the same for as
// long as it likes, so silence proves nothing. Where none of them has changed for a while, they are asked: the force
// dips, gently at first, and comes back, and ends as soon as one of them counts. If none does all the while, they are
// frozen: by chance a hand would have to let go and press again with the force, to within friction.
//
// A plain value, fed with each reading; never allocates or throws; any one thread. N; times in ns.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/conventions.h"

namespace ghostforce {

class EncoderWatch {
 public:
  static constexpr double least_force = 0.3;     // that stands; a weaker one is not watched [N]
  static constexpr double silence_s = 0.025;     // before they are asked
  static constexpr double answer_s = 0.060;      // in which one of them has to answer
  static constexpr double greatest_force = 3.0;  // of the question [N]
  // Fewer replies without an answer prove nothing: after that time the question is put again, until they are enough.
  static constexpr int least_replies = 25;

  // `encoders`: as they came [counts]; `has_reply`: they are new; `force`: that stands, without the question [N].
  void update(const Vector<3>& encoders, bool has_reply, double force, std::int64_t now_ns) noexcept {
    if (force < least_force || encoders != encoders_) {
      encoders_ = encoders;
      changed_ns_ = now_ns;
      if (asked_ns_ != 0 && ended_ns_ == 0) ended_ns_ = now_ns;
    }
    if (ended_ns_ != 0) {
      if (force_at(now_ns) == 0.0) asked_ns_ = ended_ns_ = 0;
      return;
    }
    if (asked_ns_ == 0) {
      if (seconds(now_ns - changed_ns_) < silence_s) return;
      asked_ns_ = now_ns;
      replies_ = 0;
    }
    replies_ += has_reply ? 1 : 0;
    if (seconds(now_ns - asked_ns_) < answer_s) return;
    if (replies_ < least_replies) {
      asked_ns_ = now_ns;
      return;
    }
    is_frozen_ = true;
    changed_ns_ = now_ns;
    asked_ns_ = 0;
  }

  // No force stands.
  void reset() noexcept { *this = {}; }

  bool is_frozen() const noexcept { return is_frozen_; }
  bool is_asking() const noexcept { return asked_ns_ != 0; }

  // The question, along the force that stands; negative: against it, so that a limit of force lets it through [N].
  double force_at(std::int64_t now_ns) const noexcept {
    if (asked_ns_ == 0) return 0.0;
    if (ended_ns_ == 0) return dip(now_ns - asked_ns_);
    // After an early answer: the same the other way round, back to nothing, so that the handle is left without momentum.
    if (seconds(ended_ns_ - asked_ns_) > 0.5 * answer_s) return 0.0;
    const std::int64_t left_ns = ended_ns_ + (ended_ns_ - asked_ns_) - now_ns;
    return left_ns > 0 ? -dip(left_ns) : 0.0;
  }

 private:
  static double seconds(std::int64_t ns) noexcept { return static_cast<double>(ns) * 1e-9; }

  // Gently at first: most hands answer soon.
  static double dip(std::int64_t ns) noexcept {
    const double share = std::clamp(seconds(ns) / answer_s, 0.0, 1.0);
    return -greatest_force * 256.0 / 27.0 * share * share * share * (1.0 - share);
  }

  Vector<3> encoders_{0.0};
  std::int64_t changed_ns_ = 0;  // one of them, or no force stood
  std::int64_t asked_ns_ = 0;    // 0: they are not asked
  std::int64_t ended_ns_ = 0;    // 0: the question is open
  int replies_ = 0;
  bool is_frozen_ = false;
};

}  // namespace ghostforce
