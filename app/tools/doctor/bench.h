// FalconBench: exchanges single frames with a Falcon that has firmware and is homed, once a millisecond, as raw
// numbers: for measurements, which can rely neither on the calibration nor on finding a position. It borrows the
// driver's link while the driver rests. One thread; never allocates or throws.
//
// Motors are off unless the newest command says otherwise: whatever goes wrong ends with a frame of zeros.
#pragma once

#include <cstdint>
#include <optional>

#include "device/falcon/falcon.h"
#include "device/falcon/falcon_link.h"
#include "device/falcon/frame.h"

namespace ghostforce {

class FalconBench {
 public:
  static constexpr double period_s = 0.001;
  static constexpr double longest_exchange_s = Falcon::stop_s;

  // Throws away what is still on its way to the driver.
  explicit FalconBench(FalconLink& link) noexcept;
  ~FalconBench() { stop(); }
  FalconBench(const FalconBench&) = delete;
  FalconBench& operator=(const FalconBench&) = delete;

  // One command, its reply, and the rest of the period. Empty: no reply within longest_exchange_s, or the link is gone;
  // zeros have been sent then. Also where the motors were left alone for longer: this process did not run meanwhile.
  std::optional<ReplyFrame> exchange(const CommandFrame& command) noexcept;

  // Zeros until three replies have come: the device has heard it. False: it does not answer.
  bool stop() noexcept;

  // Says nothing to the device for a moment; the motors stay as they are. False: this process did not run, and it
  // became much longer; zeros have been sent then.
  bool be_silent(double seconds) noexcept;

  // A force went out, and no zero has been answered since.
  bool may_still_push() const noexcept { return may_push_; }

  double last_exchange_s() const noexcept { return last_exchange_s_; }
  double now_s() const noexcept { return static_cast<double>(link_.now_ns()) * 1e-9; }
  LinkFault fault() const noexcept { return link_.fault(); }

 private:
  void wait_until(std::int64_t deadline_ns) noexcept;
  std::optional<ReplyFrame> ask(const CommandFrame& command) noexcept;
  void forget_replies() noexcept;
  bool recover() noexcept;

  FalconLink& link_;
  FrameReader<ReplyFrame> reader_;
  std::int64_t next_ns_;
  std::int64_t watched_ns_ = 0;  // up to when the motors were not left alone
  bool may_push_ = false;
  double last_exchange_s_ = 0.0;
};

}  // namespace ghostforce
