// Frame: 16 bytes between host and Falcon at run time, both ways. '<', three 16-bit numbers of four nibbles each (least
// significant first, each + 'A'), two bytes of bits (+ 'A'), '>'. The device answers each frame with exactly one;
// ReplyMatcher tells to which frame an answer belongs. Plain values; any one thread; never allocate or throw.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace ghostforce {

inline constexpr std::size_t frame_size = 16;
using FrameBytes = std::array<std::uint8_t, frame_size>;

// Host → Falcon.
struct CommandFrame {
  // The first byte of bits.
  static constexpr std::uint8_t homing = 0x01;
  static constexpr std::uint8_t green = 0x02;
  static constexpr std::uint8_t blue = 0x04;
  static constexpr std::uint8_t red = 0x08;

  std::array<std::int16_t, 3> motors{};  // positive pulls the arm in [counts]
  std::uint8_t info = 0;                 // homing and lights

  friend bool operator==(const CommandFrame&, const CommandFrame&) = default;
};

// Falcon → host.
struct ReplyFrame {
  // The first byte of bits.
  static constexpr std::uint8_t button_right = 0x01;
  static constexpr std::uint8_t button_forward = 0x02;
  static constexpr std::uint8_t button_centre = 0x04;
  static constexpr std::uint8_t button_left = 0x08;
  static constexpr std::uint8_t homed = 0x70;  // all three motors; 0x10, 0x20, 0x40 one by one

  std::array<std::int16_t, 3> encoders{};  // grow as the arms swing outwards [counts]
  std::uint8_t status = 0;                 // buttons and homed motors

  friend bool operator==(const ReplyFrame&, const ReplyFrame&) = default;
};

FrameBytes encode(const CommandFrame& frame) noexcept;
// Motors and lights off, twice: a frame that was cut short before would swallow the beginning of the first one.
std::array<std::uint8_t, 2 * frame_size> stop_frames() noexcept;
FrameBytes encode(const ReplyFrame& frame) noexcept;

// Takes frames of one kind out of a stream of bytes, whatever lies between them: a frame begins with '<', has '>' 15
// bytes later and numbers in between; a byte that begins none is passed over and counted. No byte inside a frame can
// look like its ends, so a wrong place to begin is never taken for a right one.
template <typename Frame>
class FrameReader {
 public:
  // Returns the newest frame that these bytes complete, if any.
  std::optional<Frame> take(std::span<const std::uint8_t> bytes) noexcept;

  // Forgets the beginning of a frame that is not complete.
  void reset() noexcept { held_ = 0; }

  std::uint64_t frames() const noexcept { return frames_; }
  std::uint64_t discarded_bytes() const noexcept { return discarded_bytes_; }

 private:
  FrameBytes bytes_{};
  std::size_t held_ = 0;
  std::uint64_t frames_ = 0;
  std::uint64_t discarded_bytes_ = 0;
};

extern template class FrameReader<CommandFrame>;
extern template class FrameReader<ReplyFrame>;

// Which command a reply belongs to. A reply carries no number: when one is lost, the next could be taken for it, and a
// late one for a fresh one. So replies are matched with commands in their order, and a command that is given up keeps
// its place: its reply may still come. A reply that is late then never looks younger than it is; after a loss it looks
// one exchange older. Once replies are fresh again, a pause shows whether the one that was given up comes after all.
// Times in ns on one clock; never waits.
class ReplyMatcher {
 public:
  // Commands that may be asked again without an answer to any of them.
  static constexpr std::size_t most_given_up = 3;
  // A command is given up after this. Two of them fit into the 20 ms after which motors go off.
  static constexpr std::int64_t patience_ns = 6'000'000;
  // Of the pause, and how fresh a reply must be to begin it: together less than those 20 ms.
  static constexpr std::int64_t pause_ns = 12'000'000;
  static constexpr std::int64_t fresh_ns = 5'000'000;

  void reset() noexcept { *this = {}; }

  // The newest command has no reply yet.
  bool is_waiting() const noexcept { return unanswered_ > given_up_; }

  // Nothing is waited for, neither a reply nor the end of the pause.
  bool may_send(std::int64_t now_ns) noexcept {
    if (is_waiting() || now_ns < pause_until_ns_) return false;
    if (pause_until_ns_ != 0) reset();
    return true;
  }

  // The newest command has waited long enough, and asking again leaves no doubt that could not be resolved.
  bool may_ask_again(std::int64_t now_ns) const noexcept {
    return is_waiting() && given_up_ < most_given_up && now_ns - sent_ns_[unanswered_ - 1] >= patience_ns;
  }

  // A command goes out. One that is still waited for is given up.
  void sent(std::int64_t now_ns) noexcept {
    if (unanswered_ == sent_ns_.size()) reset();
    given_up_ = unanswered_;
    sent_ns_[unanswered_++] = now_ns;
    pause_until_ns_ = 0;
  }

  // A reply has come; when the command that it belongs to was sent. Nothing: nobody has asked for it.
  std::optional<std::int64_t> replied(std::int64_t now_ns) noexcept {
    if (unanswered_ == 0) return {};
    const std::int64_t asked_ns = sent_ns_[0];
    for (std::size_t i = 1; i < unanswered_; ++i) sent_ns_[i - 1] = sent_ns_[i];
    --unanswered_;
    if (given_up_ > unanswered_) given_up_ = unanswered_;
    const bool is_in_doubt = given_up_ > 0 && !is_waiting();
    pause_until_ns_ = is_in_doubt && now_ns - asked_ns < fresh_ns ? now_ns + pause_ns : 0;
    return asked_ns;
  }

 private:
  std::array<std::int64_t, most_given_up + 1> sent_ns_{};  // of the commands without a reply, the oldest first
  std::size_t unanswered_ = 0;
  std::size_t given_up_ = 0;         // the older ones of these
  std::int64_t pause_until_ns_ = 0;  // 0: there is none
};

}  // namespace ghostforce
