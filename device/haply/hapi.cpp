#include "device/haply/hapi.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "device/haply/serial_port.h"

namespace ghostforce {

void SerialPort::stop_at_once() noexcept {
  write_at_once(hapi::zero_exchange());
}

namespace hapi {
namespace {

constexpr std::uint8_t set_up_command = 1;
constexpr std::uint8_t exchange_command = 2;
constexpr std::uint8_t both_ports = 0b11;

// The bytes of a packet, one after another.
template <std::size_t Size>
class Writer {
 public:
  void put(std::uint8_t byte) noexcept { bytes_[next_++] = byte; }
  void put(float number) noexcept {
    const auto bits = std::bit_cast<std::uint32_t>(number);
    for (unsigned shift = 0; shift < 32; shift += 8) put(static_cast<std::uint8_t>(bits >> shift));
  }
  const std::array<std::uint8_t, Size>& bytes() const noexcept { return bytes_; }

 private:
  std::array<std::uint8_t, Size> bytes_{};
  std::size_t next_ = 0;
};

// The nearest number in which no byte reads as a set up, and neither of the last two as any command: what is left of a
// packet that was torn on its way is read as commands, and a set up would swallow the zeros that follow. It is off by less
// than 0.02 mN·m, and in 0.2 % of the range, just above 0.0315 N·m, by 0.13. Zero stays what it is.
float without_commands(float number) noexcept {
  auto bits = std::bit_cast<std::uint32_t>(number);
  if (number == 0.0F) return number;
  constexpr std::uint32_t last_command = 2;
  if ((bits >> 16U & 0xFFU) == set_up_command) {
    const std::uint32_t high = bits & 0xFF000000U;
    const float above = std::bit_cast<float>(high | 0x00020303U);
    const float below = std::bit_cast<float>(high | 0x0000FFFFU);
    return std::abs(above - number) < std::abs(below - number) ? above : below;
  }
  if ((bits >> 8U & 0xFFU) <= last_command) bits = (bits & 0xFFFF00FFU) | 0x00000300U;
  if ((bits & 0xFFU) <= last_command) bits = (bits & 0xFFFFFF00U) | 0x00000003U;
  return std::bit_cast<float>(bits);
}

float float_at(std::span<const std::uint8_t> bytes) noexcept {
  std::uint32_t bits = 0;
  for (std::size_t i = 4; i-- > 0;) bits = bits << 8U | bytes[i];
  return std::bit_cast<float>(bits);
}

}  // namespace

SetUpPacket encode(const SetUp& set_up) noexcept {
  Writer<SetUpPacket{}.size()> packet;
  packet.put(set_up_command);
  packet.put(address);
  for (const auto& directions : {set_up.motor_directions, set_up.encoder_directions}) {
    packet.put(both_ports);
    for (const std::uint8_t direction : directions) packet.put(direction);
  }
  packet.put(std::uint8_t{0});  // analogue inputs
  packet.put(std::uint8_t{0});  // PWM outputs
  for (std::size_t port = 0; port < motor_count; ++port) {
    packet.put(set_up.offsets_deg[port]);
    packet.put(set_up.counts_per_turn[port]);
  }
  return packet.bytes();
}

bool is_set_up(std::span<const std::uint8_t> packet) noexcept {
  return packet.size() == SetUpPacket().size() && packet.front() == encode({}).front();
}

ExchangePacket exchange(const PerPort<double>& torques) noexcept {
  Writer<ExchangePacket{}.size()> packet;
  packet.put(exchange_command);
  packet.put(address);
  for (const double torque : torques) {
    const double sent = std::isfinite(torque) ? std::clamp(torque, -greatest_torque, greatest_torque) : 0.0;
    packet.put(without_commands(static_cast<float>(sent)));
  }
  return packet.bytes();
}

std::optional<PerPort<double>> decode_reply(std::span<const std::uint8_t> bytes) noexcept {
  if (bytes.size() != reply_size || bytes[0] != address) return std::nullopt;
  PerPort<double> angles{};
  for (std::size_t port = 0; port < motor_count; ++port) {
    angles[port] = float_at(bytes.subspan(1 + 4 * port, 4));
    if (!std::isfinite(angles[port])) return std::nullopt;
  }
  return angles;
}

}  // namespace hapi
}  // namespace ghostforce
