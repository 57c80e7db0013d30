// PromptChip: the far end of an emulated cable that answers each of the Falcon's frames at once, with the arms always
// in the same place: without a latency timer, a serial line or an arm. What is left is the way there and back.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "device/falcon/frame.h"
#include "device/virtual_falcon/arm.h"
#include "tests/emulation/emulated_chip.h"

namespace ghostforce {

class PromptChip final : public EmulatedChip {
 public:
  PromptChip() noexcept {
    ReplyFrame frame{.encoders = {}, .status = ReplyFrame::homed};
    const SimulatedArm arm({});
    std::ranges::transform(arm.encoders(), frame.encoders.begin(), [](int n) { return static_cast<std::int16_t>(n); });
    reply_ = encode(frame);
  }

  void power_up(std::int64_t /*now_ns*/) override {}
  void control(const VendorRequest& /*request*/, std::int64_t /*now_ns*/) override {}
  std::size_t room() const override { return packet_size; }
  void receive(std::span<const std::uint8_t> bytes, std::int64_t /*now_ns*/) override {
    if (commands_.take(bytes)) is_asked_ = true;
  }
  std::size_t take_packet(std::span<std::uint8_t, packet_size> into, std::int64_t /*now_ns*/) override {
    if (!is_asked_) return 0;
    is_asked_ = false;
    into[0] = 0x01;
    into[1] = 0x60;
    std::ranges::copy(reply_, into.begin() + 2);
    return 2 + reply_.size();
  }
  std::int64_t next_due_ns() const override { return is_asked_ ? 0 : std::numeric_limits<std::int64_t>::max(); }

 private:
  FrameReader<CommandFrame> commands_;
  FrameBytes reply_{};
  bool is_asked_ = false;
};

}  // namespace ghostforce
