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

}  // namespace ghostforce
