// ForceLimiter: the last thing that a force passes on its way to a motor. Whatever comes in, what goes out is a number,
// no longer than the limit, and changes no faster than allowed. A plain value, [N] and [s]; never allocates or throws;
// any one thread.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/conventions.h"

namespace ghostforce {

// A desktop device pushes with a few newtons; nobody may ask it for more than this [N].
inline constexpr double force_ceiling = 8.0;

class ForceLimiter {
 public:
  static constexpr double slew = 500.0;          // [N/s]
  static constexpr double cross_fade_s = 0.150;  // from one force law to another
  // A tick that came later than this does not earn a larger step [s].
  static constexpr double longest_step_s = 0.002;

  struct Result {
    Vector<2> force{0.0};        // for the motors [N]
    bool was_finite = true;      // what was wanted was a number
    bool was_saturated = false;  // the limit has shortened it
  };

  // From now on the wanted force comes from another law, another strategy or other gains: what goes out leads over from
  // one to the other.
  void cross_fade() noexcept {
    from_ = wanted_;
    fade_s_ = 0.0;
  }

  // Nothing goes out, and the next force starts from nothing.
  void reset() noexcept { *this = {}; }

  // In this order: finite, cross-fade, `added`, `gain` (0 … 1: of ramp and fade), `probe`, slew, length, finite. `added`
  // is no law of its own, and nothing leads over to it: tones that measure the hand [N]. `probe` is what the device
  // checks itself with: it has its own envelope, and comes on top of a force that the limit has shortened [N]. `limit`
  // may change at any time: a lower one is reached as fast as a force may change. `elapsed_s`: since the call before.
  Result pass(const Vector<2>& wanted, double gain, double limit, double elapsed_s,
              const Vector<2>& added = Vector<2>(0.0), const Vector<2>& probe = Vector<2>(0.0)) noexcept {
    Result result;
    result.was_finite = is_finite(wanted) && is_finite(added) && is_finite(probe) && std::isfinite(gain);
    if (!result.was_finite) {
      reset();
      return result;
    }
    const double step_s = elapsed_s > 0.0 ? std::min(elapsed_s, longest_step_s) : 0.0;  // NaN: nothing has passed
    limit = limit > 0.0 ? std::min(limit, force_ceiling) : 0.0;
    // A limit that comes down may turn a force while it shortens it: each of the two gets half of the way.
    const double longest_change = slew * step_s * (limit < limit_ ? 0.5 : 1.0);
    limit_ = std::max(limit, limit_ - longest_change);

    // Where the new law wants nothing, as in free space, nothing of the old one is left over.
    fade_s_ = wanted == Vector<2>(0.0) ? cross_fade_s : std::min(fade_s_ + step_s, cross_fade_s);
    wanted_ = glm::mix(from_, wanted, fade_s_ / cross_fade_s);
    Vector<2> force = (wanted_ + added) * std::clamp(gain, 0.0, 1.0);
    // Far too long a vector has a length that no number holds.
    force = within_reason(force);
    result.was_saturated = glm::length(force) > limit_;
    if (probe != Vector<2>(0.0)) force = shortened(force, limit_) + within_reason(probe);

    force = sent_ + shortened(force - sent_, longest_change);
    // The length and not each axis: to shorten one axis alone would turn the force, which is a ghost force of its own.
    force = shortened(force, limit_);
    sent_ = is_finite(force) ? force : Vector<2>(0.0);
    result.force = sent_;
    return result;
  }

  // What went out last [N].
  const Vector<2>& sent() const noexcept { return sent_; }

 private:
  static constexpr double farthest = 1e6;

  static bool is_finite(const Vector<2>& v) noexcept { return std::isfinite(v.x) && std::isfinite(v.y); }

  static Vector<2> within_reason(const Vector<2>& v) noexcept {
    return glm::clamp(v, Vector<2>(-farthest), Vector<2>(farthest));
  }

  static Vector<2> shortened(const Vector<2>& v, double longest) noexcept {
    const double length = glm::length(v);
    return length > longest ? v * (longest / length) : v;
  }

  Vector<2> from_{0.0};
  Vector<2> wanted_{0.0};
  Vector<2> sent_{0.0};
  double fade_s_ = cross_fade_s;
  double limit_ = 0.0;  // in use
};

}  // namespace ghostforce
