// VirtualPort: the SerialPort to a simulated board, in memory. Behind it are board, arms and hand (haply_bench.h),
// which live on whenever a function of the port is asked for what has happened up to now. For tests and rehearsals: the
// driver above does everything that it does with a real device.
//
// The clock is CLOCK_MONOTONIC, or one that only wait_until() moves: from event to event, without waiting, the same way
// every time; for tests, and where no thread may wait. Nothing is allocated after the constructor. Threads as
// serial_port.h says; besides, one thread may inject faults, one may lead the hand, and any may have it hold the zero
// pose, at any time. Times in ns.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/fixed_queue.h"
#include "device/haply/serial_port.h"
#include "device/virtual_haply/haply_bench.h"

namespace ghostforce {

class VirtualPort final : public SerialPort {
 public:
  enum class Clock : std::uint8_t {
    monotonic,  // that of everybody
    stepped,    // begins at 1 s; wait_until() moves it
  };

  struct Options {
    Clock clock = Clock::monotonic;
    HaplyBench::Options device{};
  };

  // From the host to the board, for one packet.
  static constexpr std::int64_t transfer_ns = 60'000;
  static constexpr std::size_t most_bytes = 64;  // of a packet

  static constexpr std::string_view serial_number = "VIRTUALHAPLY1";

  explicit VirtualPort(const Options& options) noexcept;
  ~VirtualPort() override { close(); }

  bool waits_to_open() const noexcept override { return false; }
  LinkFault open() noexcept override;
  // What has been written before still goes out.
  void close() noexcept override;
  LinkFault fault() const noexcept override { return fault_; }
  std::string_view serial() const noexcept override { return was_open_ ? serial_number : std::string_view{}; }

  // A few packets may be under way. After write_at_once() only an exchange with zeros goes out.
  bool write(std::span<const std::uint8_t> packet) noexcept override;
  std::size_t read(std::span<std::uint8_t> into) noexcept override;
  void discard_input() noexcept override;

  // The guard of a real device is a process. This one ends a force of the simulated device as that would, if whoever
  // drives the port has not waited for it for too long: by zeros for the address that was written last.
  void set_may_push(bool may_push) noexcept override { may_push_ = may_push; }

  std::int64_t now_ns() const noexcept override;
  // Without an open port there is nothing to wait for but the deadline, and that is what it waits for.
  void wait_until(std::int64_t deadline_ns) noexcept override;
  // The first one counts; a program that needs a second one has ended.
  void write_at_once(std::span<const std::uint8_t> packet) noexcept override;

  // From another thread, one for each.
  void inject(const InjectedHaplyFault& wrong) noexcept { bench_.inject(wrong); }
  void lead_hand(const HaplyHandPlan& plan) noexcept { bench_.lead_hand(plan); }
  // Any thread.
  void hold_zero_pose(bool holds) noexcept { bench_.hold_zero_pose(holds); }

  // How things really are behind the cable, also after write_at_once(). Same thread as the port's, or nobody drives it.
  HaplyTruth truth() const noexcept;
  std::array<double, 2> duties() const noexcept { return truth().duties; }  // by arm
  Vector<2> angles() const noexcept { return bench_.arms().angles(); }
  Vector<2> handle() const noexcept { return bench_.arms().handle(); }
  Vector<2> force() const noexcept { return truth().force; }  // the motors', at the handle [N]
  const HaplyBench& bench() const noexcept { return bench_; }

 private:
  struct Packet {
    std::int64_t arrival_ns = 0;
    std::array<std::uint8_t, most_bytes> bytes{};
    std::size_t size = 0;
  };

  // Of the packet of write_at_once().
  enum class AtOnce : std::uint8_t { nothing, being_written, ready, gone };
  static_assert(std::atomic<AtOnce>::is_always_lock_free, "a signal handler writes it");

  bool is_live() const noexcept { return is_open_ && fault_ == LinkFault::none; }
  bool live_until(std::int64_t now_ns) noexcept;
  bool obey_injected_fault() noexcept;
  bool exchange_until(std::int64_t at_ns) noexcept;
  bool take_in(std::int64_t now_ns) noexcept;
  void guard_motors() noexcept;
  std::int64_t next_event_ns() const noexcept;

  Clock clock_;
  std::int64_t stepped_ns_ = 1'000'000'000;
  std::int64_t lived_ns_;  // the grid on which the guard looks
  HaplyBench bench_;
  LinkFault link_fault_;  // asked for
  bool has_vanished_ = false;

  std::atomic<bool> is_open_ = false;
  bool was_open_ = false;
  LinkFault fault_ = LinkFault::absent;

  FixedQueue<Packet, 8> outgoing_;
  FixedQueue<std::uint8_t, 4096> incoming_;
  std::uint8_t last_address_ = 0;

  bool may_push_ = false;
  std::int64_t beat_ns_ = 0;  // when somebody last waited

  std::atomic<AtOnce> at_once_ = AtOnce::nothing;
  Packet packet_at_once_;  // whole when ready
};

}  // namespace ghostforce
