// RecordingChip: a serial chip with nothing behind it. It remembers all that it is told, says back what it hears, or
// sends the packets that a test wants, and speaks up once per latency period when there is nothing to say. Any thread.
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "tests/emulation/emulated_chip.h"

namespace ghostforce {

class RecordingChip final : public EmulatedChip {
 public:
  static constexpr std::uint8_t idle_status[2] = {0x01, 0x60};

  explicit RecordingChip(std::int64_t latency_ns = 16'000'000) : latency_ns_(latency_ns) {}

  void set_echo(bool on) {
    const std::lock_guard lock(mutex_);
    echo_ = on;
  }

  // As if the wire behind the chip stood still: the host has to wait with what it sends.
  void set_stuck(bool on) {
    const std::lock_guard lock(mutex_);
    is_stuck_ = on;
  }

  // A whole packet, status bytes included. Goes out as soon as the host asks after anything at all happens.
  void queue(std::vector<std::uint8_t> packet) {
    const std::lock_guard lock(mutex_);
    packets_.push_back(std::move(packet));
  }

  std::vector<VendorRequest> requests() const {
    const std::lock_guard lock(mutex_);
    return requests_;
  }

  std::vector<std::uint8_t> received() const {
    const std::lock_guard lock(mutex_);
    return received_;
  }

  // Whether so many bytes have come by then.
  bool wait_for_bytes(std::size_t count, std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, patience, [&] { return received_.size() >= count; });
  }

  int power_ups() const {
    const std::lock_guard lock(mutex_);
    return power_ups_;
  }

  void power_up(std::int64_t /*now_ns*/) override {
    const std::lock_guard lock(mutex_);
    ++power_ups_;
  }

  void control(const VendorRequest& request, std::int64_t /*now_ns*/) override {
    const std::lock_guard lock(mutex_);
    requests_.push_back(request);
  }

  std::size_t room() const override {
    const std::lock_guard lock(mutex_);
    return is_stuck_ ? 0 : 4096;
  }

  void receive(std::span<const std::uint8_t> bytes, std::int64_t /*now_ns*/) override {
    const std::lock_guard lock(mutex_);
    received_.insert(received_.end(), bytes.begin(), bytes.end());
    changed_.notify_all();
    while (echo_ && !bytes.empty()) {
      const auto piece = bytes.first(std::min<std::size_t>(bytes.size(), packet_size - 2));
      bytes = bytes.subspan(piece.size());
      std::vector<std::uint8_t> packet(idle_status, idle_status + 2);
      packet.insert(packet.end(), piece.begin(), piece.end());
      packets_.push_back(std::move(packet));
    }
  }

  std::size_t take_packet(std::span<std::uint8_t, packet_size> into, std::int64_t now_ns) override {
    const std::lock_guard lock(mutex_);
    if (packets_.empty()) {
      if (now_ns < next_status_ns_) return 0;
      packets_.emplace_back(idle_status, idle_status + 2);
    }
    next_status_ns_ = now_ns + latency_ns_;
    const std::vector<std::uint8_t> packet = std::move(packets_.front());
    packets_.pop_front();
    std::copy(packet.begin(), packet.end(), into.begin());
    return packet.size();
  }

  std::int64_t next_due_ns() const override {
    const std::lock_guard lock(mutex_);
    return packets_.empty() ? next_status_ns_ : 0;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  const std::int64_t latency_ns_;
  std::int64_t next_status_ns_ = 0;
  bool echo_ = true;
  bool is_stuck_ = false;
  int power_ups_ = 0;
  std::deque<std::vector<std::uint8_t>> packets_;
  std::vector<VendorRequest> requests_;
  std::vector<std::uint8_t> received_;
};

}  // namespace ghostforce
