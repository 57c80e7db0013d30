// hAPI: the packets between a host and a board that drives a Haply 2DIY, as the published firmwares read and write them
// (docs/haply.md). No frame, no checksum, no number, no query: a packet is known by its length alone. Numbers are IEEE
// 754 binary32, little-endian. Pure values, any thread, never allocate or throw. N·m; degrees, as the board has them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace ghostforce::hapi {

// The address that this program gives a board. Never 0, which unused slots of a board have, nor 0, 1, 2, which a board
// that is out of step would read as commands.
inline constexpr std::uint8_t address = 5;

// What 100 % duty of a motor means in every firmware. A motor may give more or less [N·m].
inline constexpr double greatest_torque = 0.123;

// Two motors and two encoders, in order of the board's ports, which are 1 and 2 on every device that is known.
inline constexpr std::size_t motor_count = 2;
template <typename Value>
using PerPort = std::array<Value, motor_count>;

struct SetUp {
  PerPort<std::uint8_t> motor_directions{};    // 0 clockwise, 1 counter-clockwise
  PerPort<std::uint8_t> encoder_directions{};  // likewise
  PerPort<float> offsets_deg{};                // what the encoders tell where they are now: set up is the homing
  PerPort<float> counts_per_turn{};

  friend bool operator==(const SetUp&, const SetUp&) = default;
};

using SetUpPacket = std::array<std::uint8_t, 26>;
using ExchangePacket = std::array<std::uint8_t, 10>;
inline constexpr std::size_t reply_size = 9;

SetUpPacket encode(const SetUp& set_up) noexcept;
bool is_set_up(std::span<const std::uint8_t> packet) noexcept;
// Torques by port [N·m]. One that is not finite is sent as zero, one beyond the greatest as that. Others are the nearest
// number that holds no set up, to within 0.13 mN·m, which is a step of an M0's duty.
ExchangePacket exchange(const PerPort<double>& torques) noexcept;
inline ExchangePacket zero_exchange() noexcept {
  return exchange({0.0, 0.0});
}

// The encoders' angles by port, of a reply of this size to this address [degrees]. Empty: it is none, or an angle is not
// finite.
std::optional<PerPort<double>> decode_reply(std::span<const std::uint8_t> bytes) noexcept;

}  // namespace ghostforce::hapi
