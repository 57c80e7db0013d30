#include "device/falcon/frame.h"

#include <algorithm>

namespace ghostforce {
namespace {

constexpr std::uint8_t head = '<';
constexpr std::uint8_t tail = '>';
constexpr std::uint8_t zero = 'A';
constexpr std::size_t info_byte = 13;
// Of the info byte: four buttons and three motors.
constexpr std::uint8_t greatest_info = zero + 0x7F;

FrameBytes encode(const std::array<std::int16_t, 3>& numbers, std::uint8_t info) noexcept {
  FrameBytes bytes;
  bytes.fill(zero);
  bytes.front() = head;
  bytes.back() = tail;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto number = static_cast<std::uint16_t>(numbers[i]);
    for (std::size_t nibble = 0; nibble < 4; ++nibble) {
      bytes[1 + 4 * i + nibble] = static_cast<std::uint8_t>(zero + ((number >> (4 * nibble)) & 0xF));
    }
  }
  bytes[info_byte] = static_cast<std::uint8_t>(zero + info);
  return bytes;
}

std::array<std::int16_t, 3> numbers_in(const FrameBytes& bytes) noexcept {
  std::array<std::int16_t, 3> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    unsigned number = 0;
    for (std::size_t nibble = 0; nibble < 4; ++nibble) {
      number |= static_cast<unsigned>(bytes[1 + 4 * i + nibble] - zero) << (4 * nibble);
    }
    numbers[i] = static_cast<std::int16_t>(static_cast<std::uint16_t>(number));
  }
  return numbers;
}

// Whether a frame may have this byte there. What byte 14 means nobody knows; it is no end of a frame.
bool fits(std::size_t place, std::uint8_t byte) noexcept {
  if (place == 0) return byte == head;
  if (place == frame_size - 1) return byte == tail;
  if (place < info_byte) return byte >= zero && byte < zero + 16;
  return byte >= zero && (place != info_byte || byte <= greatest_info);
}

}  // namespace

FrameBytes encode(const CommandFrame& frame) noexcept {
  return encode(frame.motors, frame.info);
}

std::array<std::uint8_t, 2 * frame_size> stop_frames() noexcept {
  const FrameBytes frame = encode(CommandFrame{});
  std::array<std::uint8_t, 2 * frame_size> frames{};
  std::ranges::copy(frame, frames.begin());
  std::ranges::copy(frame, frames.begin() + frame_size);
  return frames;
}

FrameBytes encode(const ReplyFrame& frame) noexcept {
  return encode(frame.encoders, frame.status);
}

template <typename Frame>
std::optional<Frame> FrameReader<Frame>::take(std::span<const std::uint8_t> bytes) noexcept {
  std::optional<Frame> newest;
  for (const std::uint8_t byte : bytes) {
    if (!fits(held_, byte)) {
      discarded_bytes_ += held_;
      held_ = 0;
      if (byte != head) {
        ++discarded_bytes_;
        continue;
      }
    }
    bytes_[held_++] = byte;
    if (held_ < frame_size) continue;
    held_ = 0;
    ++frames_;
    newest = Frame{numbers_in(bytes_), static_cast<std::uint8_t>(bytes_[info_byte] - zero)};
  }
  return newest;
}

template class FrameReader<CommandFrame>;
template class FrameReader<ReplyFrame>;

}  // namespace ghostforce
