// VirtualLink: the FalconLink to a simulated Falcon. Behind it are the far end of the cable (falcon_dsp.h), an arm and
// a hand on it, which live on whenever a function of the link is asked for what has happened up to now. For tests and
// rehearsals: the driver above does everything that it does with a real device.
//
// The clock is CLOCK_MONOTONIC, or one that only wait_until() moves: from event to event, without waiting, the same way
// every time; for tests, and where no thread may wait (Servo::step_to). Nothing is allocated after the constructor.
// Threads as falcon_link.h says; besides, one thread may send injected faults and one may lead the hand at any time.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/latest_value.h"
#include "device/falcon/falcon_link.h"
#include "device/virtual_falcon/arm.h"
#include "device/virtual_falcon/falcon_dsp.h"
#include "device/virtual_falcon/hand.h"
#include "device/virtual_falcon/injected_fault.h"

namespace ghostforce {

class VirtualLink final : public FalconLink {
 public:
  enum class Clock : std::uint8_t {
    monotonic,  // that of everybody
    stepped,    // begins at 1 s; wait_until() moves it
  };

  struct Options {
    Clock clock = Clock::monotonic;
    FalconDsp::Options device{};
    SimulatedArm::Options arm{};
    HandPlan hand{};
    InjectedFault injected_fault{};
  };

  // The arm and the hand move in steps of this, on a grid of the clock.
  static constexpr std::int64_t step_ns = 100'000;
  // From the host to the chip: what USB takes for one transfer.
  static constexpr std::int64_t transfer_ns = 60'000;

  static constexpr std::string_view serial_number = "VIRTUAL1";

  explicit VirtualLink(const Options& options) noexcept;
  ~VirtualLink() override { close(); }

  bool waits_to_open() const noexcept override { return false; }
  LinkFault open() noexcept override;
  void close() noexcept override;
  LinkFault fault() const noexcept override { return fault_; }
  std::string_view serial() const noexcept override { return was_open_ ? serial_number : std::string_view{}; }

  bool request(const VendorRequest& request) noexcept override;
  RequestOutcome request_outcome() const noexcept override { return RequestOutcome::done; }
  bool write(std::span<const std::uint8_t> bytes) noexcept override;
  bool is_sending() const noexcept override { return sending_ != Sending::nothing; }

  void stop(std::span<const std::uint8_t> bytes) noexcept override;
  bool owes_stop() const noexcept override { return owes_stop_; }

  // The guard of a real device is a process. This one ends a force of the simulated device as that would, if whoever
  // drives the link has not waited for it for too long.
  void set_may_push(bool may_push) noexcept override { may_push_ = may_push; }

  std::size_t read(std::span<std::uint8_t> into) noexcept override;
  std::uint8_t modem_status() const noexcept override { return modem_status_; }
  LinkCounters counters() const noexcept override { return counters_; }

  std::int64_t now_ns() const noexcept override;
  // Without an open link there is nothing to wait for but the deadline, and that is what it waits for.
  void wait_until(std::int64_t deadline_ns) noexcept override;
  void send_at_once(std::span<const std::uint8_t> bytes) noexcept override;

  // From another thread, one for each.
  void inject(const InjectedFault& wrong) noexcept { injected_faults_.publish(wrong); }
  void lead_hand(const HandPlan& plan) noexcept { hand_.follow(plan); }

  // See SimulatedHand. Same thread as the link's.
  void shake_hand(const Vector<3>& way, std::optional<double> stiffness) noexcept { hand_.shake(way, stiffness); }

  // How things really are behind the cable: for those who compare it with what the driver makes of it. Same thread as
  // the link's, or nobody drives it.
  const FalconDsp& device() const noexcept { return dsp_; }
  const SimulatedArm& arm() const noexcept { return arm_; }
  const SimulatedHand& hand() const noexcept { return hand_; }
  // What the motors are driven with, also after send_at_once().
  MotorNumbers motors() const noexcept;

 private:
  enum class Sending : std::uint8_t { nothing, request, bytes };

  bool is_live() const noexcept { return is_open_ && fault_ == LinkFault::none; }
  bool live_until(std::int64_t now_ns) noexcept;
  bool obey_injected_fault() noexcept;
  bool exchange_until(std::int64_t at_ns) noexcept;
  bool deliver(std::int64_t at_ns) noexcept;
  bool take_packet(std::int64_t at_ns) noexcept;
  void settle_stop() noexcept;
  void step_to(std::int64_t at_ns) noexcept;
  void guard_motors() noexcept;
  std::int64_t next_event_ns() const noexcept;

  Clock clock_;
  std::int64_t stepped_ns_ = 1'000'000'000;
  std::int64_t lived_ns_;  // up to where arm and hand have come

  LatestValue<InjectedFault> injected_faults_;
  LinkFault link_fault_;  // asked for
  FalconDsp dsp_;
  SimulatedArm arm_;
  SimulatedHand hand_;

  std::atomic<bool> is_open_ = false;
  bool was_open_ = false;
  LinkFault fault_ = LinkFault::absent;
  LinkCounters counters_;
  std::uint8_t modem_status_ = 0;

  Sending sending_ = Sending::nothing;
  std::int64_t delivery_ns_ = 0;
  VendorRequest request_;
  std::array<std::uint8_t, FalconDsp::packet_size> outgoing_{};
  std::size_t outgoing_size_ = 0;
  bool owes_stop_ = false;  // it is what is going out, or will when there is a link
  FixedQueue<std::uint8_t, 16384> incoming_;

  bool may_push_ = false;
  std::int64_t beat_ns_ = 0;  // when somebody last waited

  // Motors of a last command past the line: three numbers, and above them whether there was one.
  std::atomic<std::uint64_t> emergency_stop_ = 0;
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free, "a signal handler writes it");
};

}  // namespace ghostforce
