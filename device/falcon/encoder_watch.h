// EncoderWatch: whether the encoders still count while a force stands. A hand that rests lets them say the same for as
// long as it likes, so silence proves nothing. Where an encoder has said the same for a while, it is asked: with a force
// that grows along the way of its leg until it moves. All are frozen if none moves, and this one is if the others have
// come far without it. Where friction holds a handle, another leg may be the first to move, but not far alone.
//
// A plain value, fed with each reading; never allocates or throws; any one thread. N; times in ns.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/conventions.h"

namespace ghostforce {

class EncoderWatch {
 public:
  static constexpr double least_force = 0.3;           // that stands; a weaker one is not watched [N]
  static constexpr double silence_s = 0.025;           // before an encoder is asked
  static constexpr double answer_s = 0.060;            // in which it has to answer
  static constexpr double greatest_force = 2.4;        // of the question, at the end of that time [N]
  static constexpr double longest_question_s = 0.150;  // while other legs move a little
  static constexpr double far_counts = 20.0;
  static constexpr int least_replies = 8;  // without so many nobody has been asked

  // `encoders`: leg by leg [counts]; `has_reply`: they are new; `force`: that stands, without the question [N].
  void update(const Vector<3>& encoders, bool has_reply, double force, std::int64_t now_ns) noexcept {
    for (std::size_t leg = 0; leg < since_ns_.size(); ++leg) {
      const auto axis = static_cast<glm::length_t>(leg);
      if (force >= least_force && encoders[axis] == encoders_[axis]) continue;
      since_ns_[leg] = now_ns;
      if (leg == asked_) end_question(now_ns);
    }
    encoders_ = encoders;
    if (ended_ns_ != 0) {
      if (force_at(now_ns) != 0.0) return;
      asked_ = nobody;
      ended_ns_ = 0;
      return;
    }
    if (asked_ == nobody) return ask(now_ns);
    replies_ += has_reply ? 1 : 0;
    if (replies_ < least_replies) return;
    const double asked_s = seconds(now_ns - asked_ns_);
    const double all_silent_s = std::min(asked_s, seconds(now_ns - std::ranges::max(since_ns_)));
    const Vector<3> moved = glm::abs(encoders - encoders_asked_);
    const bool is_alone = asked_s >= answer_s && std::max({moved.x, moved.y, moved.z}) >= far_counts;
    is_frozen_ |= all_silent_s >= answer_s || is_alone;
    if (asked_s < longest_question_s) return;
    since_ns_[asked_] = now_ns;
    end_question(now_ns);
  }

  // No force stands.
  void reset() noexcept { *this = {}; }

  bool is_frozen() const noexcept { return is_frozen_; }
  bool is_asking() const noexcept { return asked_ != nobody; }
  std::size_t asked_leg() const noexcept { return asked_; }

  // The question's force along that leg's way [N].
  double force_at(std::int64_t now_ns) const noexcept {
    if (!is_asking()) return 0.0;
    if (ended_ns_ == 0) return grown(now_ns - asked_ns_);
    // A short one is followed by the same the other way round, so that the handle is left without momentum.
    const std::int64_t lasted_ns = ended_ns_ - asked_ns_;
    return seconds(lasted_ns) < 0.5 * answer_s ? -grown(std::max(std::int64_t{0}, ended_ns_ + lasted_ns - now_ns))
                                               : 0.0;
  }

 private:
  static constexpr std::size_t nobody = 3;

  static double seconds(std::int64_t ns) noexcept { return static_cast<double>(ns) * 1e-9; }

  // Gently at first: most hands answer soon.
  static double grown(std::int64_t ns) noexcept {
    const double share = std::min(1.0, seconds(ns) / answer_s);
    return greatest_force * share * share;
  }

  void ask(std::int64_t now_ns) noexcept {
    const auto longest = static_cast<std::size_t>(std::ranges::min_element(since_ns_) - since_ns_.begin());
    if (seconds(now_ns - since_ns_[longest]) < silence_s) return;
    asked_ = longest;
    asked_ns_ = now_ns;
    encoders_asked_ = encoders_;
    replies_ = 0;
  }

  void end_question(std::int64_t now_ns) noexcept {
    if (ended_ns_ == 0) ended_ns_ = now_ns;
  }

  Vector<3> encoders_{0.0};
  Vector<3> encoders_asked_{0.0};           // when the question began
  std::array<std::int64_t, 3> since_ns_{};  // when each last said something else, or no force stood
  std::size_t asked_ = nobody;
  std::int64_t asked_ns_ = 0;
  std::int64_t ended_ns_ = 0;  // 0: the question is open
  int replies_ = 0;
  bool is_frozen_ = false;
};

}  // namespace ghostforce
