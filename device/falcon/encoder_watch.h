// EncoderWatch: whether the encoders still count while a force stands. A hand that rests lets them say the same for as
// long as it likes, so silence proves nothing. Where an encoder has said the same for a while, it asks: a force that
// grows along the way of its leg, against the one that stands, until the encoder moves. If it does not, it is frozen.
//
// A plain value, fed with each reading; never allocates or throws; any one thread. N; times in ns.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/conventions.h"

namespace ghostforce {

class EncoderWatch {
 public:
  static constexpr double least_force = 0.3;  // what stands; a smaller one may stand for ever [N]
  static constexpr double silence_s = 0.030;  // before it asks
  static constexpr double answer_s = 0.048;   // to wait for at most
  static constexpr double growth = 20.0;      // of the question [N/s]
  // Without so many replies nobody has been asked.
  static constexpr int least_replies = 8;

  // `encoders`: leg by leg [counts]; `has_reply`: they are new; `force`: that stands, without the question [N].
  void update(const Vector<3>& encoders, bool has_reply, double force, std::int64_t now_ns) noexcept {
    const bool stands = force >= least_force;
    for (std::size_t leg = 0; leg < since_ns_.size(); ++leg) {
      const auto axis = static_cast<glm::length_t>(leg);
      if (stands && encoders[axis] == encoders_[axis]) continue;
      since_ns_[leg] = now_ns;
      if (leg == asked_) asked_ = nobody;
    }
    encoders_ = encoders;
    if (asked_ != nobody) {
      replies_ += has_reply ? 1 : 0;
      is_frozen_ |= seconds(now_ns - asked_ns_) >= answer_s && replies_ >= least_replies;
      return;
    }
    const auto longest = static_cast<std::size_t>(std::ranges::min_element(since_ns_) - since_ns_.begin());
    if (seconds(now_ns - since_ns_[longest]) < silence_s) return;
    asked_ = longest;
    asked_ns_ = now_ns;
    replies_ = 0;
  }

  // No force stands.
  void reset() noexcept { *this = {}; }

  bool is_frozen() const noexcept { return is_frozen_; }
  bool is_asking() const noexcept { return asked_ != nobody; }
  std::size_t asked_leg() const noexcept { return asked_; }
  // The question's force along that leg's way, without its sign [N].
  double force_at(std::int64_t now_ns) const noexcept { return is_asking() ? growth * seconds(now_ns - asked_ns_) : 0.0; }

 private:
  static constexpr std::size_t nobody = 3;

  static double seconds(std::int64_t ns) noexcept { return static_cast<double>(ns) * 1e-9; }

  Vector<3> encoders_{0.0};
  std::array<std::int64_t, 3> since_ns_{};  // when each last said something else, or no force stood
  std::size_t asked_ = nobody;
  std::int64_t asked_ns_ = 0;
  int replies_ = 0;
  bool is_frozen_ = false;
};

}  // namespace ghostforce
