// A port to a simulated board that is listened to: what is written, and how things really are behind it every 50 µs.
// For tests. The board itself sees no difference.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "device/virtual_haply/virtual_port.h"

namespace ghostforce {

class WatchedPort final : public SerialPort {
 public:
  struct Packet {
    std::int64_t time_ns = 0;
    std::vector<std::uint8_t> bytes;
  };

  explicit WatchedPort(const VirtualPort::Options& options) : board_(options) {}

  bool waits_to_open() const noexcept override { return false; }
  LinkFault open() noexcept override {
    ++opens;
    return board_.open();
  }
  void close() noexcept override { board_.close(); }
  LinkFault fault() const noexcept override { return board_.fault(); }
  std::string_view serial() const noexcept override { return board_.serial(); }
  bool is_guarded() const noexcept override { return is_with_guard; }
  void set_may_push(bool may_push) noexcept override {
    told_may_push = may_push;
    board_.set_may_push(may_push);
  }
  std::int64_t now_ns() const noexcept override { return board_.now_ns(); }

  bool write(std::span<const std::uint8_t> packet) noexcept override {
    if (takes_nothing || !board_.write(packet)) return false;
    if (on_write) on_write(packet);
    if (keeps_packets) packets.push_back({now_ns(), {packet.begin(), packet.end()}});
    return true;
  }
  std::size_t read(std::span<std::uint8_t> into) noexcept override { return board_.read(into); }
  void discard_input() noexcept override { board_.discard_input(); }
  void write_at_once(std::span<const std::uint8_t> packet) noexcept override {
    at_once.push_back({now_ns(), {packet.begin(), packet.end()}});
    board_.write_at_once(packet);
    if (on_at_once) on_at_once();
  }

  // In steps, where somebody looks on. Who waits is woken no sooner for it: a step ends early only if there is news.
  void wait_until(std::int64_t deadline_ns) noexcept override {
    if (!on_step) return board_.wait_until(deadline_ns);
    for (;;) {
      // Off the grid of whatever happens.
      const std::int64_t step_end_ns = now_ns() + 49'000 + static_cast<std::int64_t>(++steps_ * 7'919 % 997);
      board_.wait_until(std::min(deadline_ns, step_end_ns));
      on_step();
      if (now_ns() >= deadline_ns || now_ns() < step_end_ns) return;
    }
  }

  VirtualPort& board() noexcept { return board_; }
  const VirtualPort& board() const noexcept { return board_; }

  std::function<void()> on_step;
  std::function<void(std::span<const std::uint8_t>)> on_write;
  std::function<void()> on_at_once;
  bool keeps_packets = false;
  std::vector<Packet> packets;
  std::vector<Packet> at_once;
  bool takes_nothing = false;
  bool is_with_guard = true;
  bool told_may_push = false;
  int opens = 0;

 private:
  VirtualPort board_;
  std::uint64_t steps_ = 0;
};

// An exchange's torque at a port, 0 or 1.
inline float torque_in(std::span<const std::uint8_t> exchange, std::size_t port) {
  std::uint32_t bits = 0;
  for (std::size_t i = 4; i-- > 0;) bits = bits << 8U | exchange[2 + 4 * port + i];
  return std::bit_cast<float>(bits);
}

inline bool is_exchange(std::span<const std::uint8_t> packet) {
  return packet.size() == 10 && packet[0] == 2;
}

}  // namespace ghostforce
