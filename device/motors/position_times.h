// PositionTimes: when a device told its handle's position, and for how long what it tells has been none. A plain value;
// never allocates or throws; any one thread. Times in ns on one clock.
#pragma once

#include <cstdint>

namespace ghostforce {

class PositionTimes {
 public:
  // The encoders must tell a position again within this time: sooner than an old one ends the force anyway.
  static constexpr std::int64_t longest_lost_ns = 10'000'000;

  // None is known, and none is missed.
  void reset() noexcept { asked_ns_ = lost_ns_ = 0; }

  // `asked_ns`: when the device was asked, for it has not looked at its encoders before; `heard_ns`: when it answered.
  void found(std::int64_t asked_ns, std::int64_t heard_ns) noexcept {
    asked_ns_ = asked_ns;
    heard_ns_ = heard_ns;
    lost_ns_ = 0;
  }
  // The device has answered, and what it tells is no position. Whether that has been so for too long.
  bool not_found(std::int64_t now_ns) noexcept {
    if (lost_ns_ != 0) return now_ns - lost_ns_ >= longest_lost_ns;
    lost_ns_ = now_ns;
    return false;
  }

  // Of the newest position; 0 before the first.
  std::int64_t asked_ns() const noexcept { return asked_ns_; }
  // After a loss the time above may be that of an earlier command.
  std::int64_t heard_ns() const noexcept { return heard_ns_; }

 private:
  std::int64_t asked_ns_ = 0;
  std::int64_t heard_ns_ = 0;
  std::int64_t lost_ns_ = 0;  // since when none could be found; 0: it is known
};

}  // namespace ghostforce
