// HaplyBench: the whole simulated device behind its cable: board, arms, a hand and what goes wrong. It reads no clock
// and has no thread: each call says what time it is, and what has happened up to then has happened. Both ways to it
// (virtual_port.h, pty_board.h) are made of this. Allocates and throws nothing; one thread, but for what is said of
// inject(), lead_hand() and hold_zero_pose(). Times in ns, on any clock that does not go back.
//
// Motor and wiring: the torque at a shaft is the port's duty (haply_board.h) × what the motor gives in full × a sign,
// which with the variant's directions on an M0 or an M3 makes a positive torque in an exchange increase that arm's
// angle. The same wiring on a dev kit makes the motor at port 1 push the other way, because that board's pins do.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/fixed_queue.h"
#include "core/latest_value.h"
#include "device/virtual_haply/haply_arms.h"
#include "device/virtual_haply/haply_board.h"
#include "device/virtual_haply/haply_fault.h"
#include "device/virtual_haply/haply_hand.h"
#include "device/virtual_haply/virtual_haply_truth.h"
#include "device/virtual_haply/virtual_haply_variant.h"

namespace ghostforce {

class HaplyBench {
 public:
  // Arms and hand move in steps of this, on a grid of the clock.
  static constexpr std::int64_t step_ns = 50'000;

  struct Options {
    HaplyBoard::Options board{};
    std::string_view variant = "v3.1";  // an unknown name stands for this one
    HaplyArms::Options arms{};
    // How the device really is, by arm.
    Vector<2> full_torques{0.123};               // at the full duty [N·m]
    Vector<2> wiring_signs{1.0};                 // −1: the motor's leads are the other way round
    std::optional<Vector<2>> counts_per_turn{};  // see right_counts_per_turn()
    HaplyHandPlan hand{};
    InjectedHaplyFault fault{};
    bool starts_in_zero_pose = false;  // held there; otherwise in the middle
  };

  // What a host must send so that angles are right, by arm: what the variant's table says; on an M0 twice that, as its
  // firmware reckons with half of what it is sent. (Whether a real device with an M0 is like that, or misses half of
  // the edges as well, so that the table's numbers are right there, only a device can tell: give the table's numbers in
  // Options::counts_per_turn then.)
  static Vector<2> right_counts_per_turn(const VirtualHaplyVariant& variant, HaplyBoard::Kind kind) noexcept;

  HaplyBench(const Options& options, std::int64_t now_ns) noexcept;

  // Who has not looked for longer than a second finds that nothing has happened before that second.
  void live_until(std::int64_t now_ns) noexcept;

  // A packet of the host's reaches the board.
  void receive(std::span<const std::uint8_t> packet, std::int64_t at_ns) noexcept;

  // The next packet that reaches the host, not before next_arrival_ns(), which is far away while nothing is on its way.
  // Returns its size; 0: there is none now.
  static constexpr std::size_t most_bytes = HaplyBoard::Reply::most_bytes;
  std::size_t take(std::span<std::uint8_t, most_bytes> into, std::int64_t now_ns) noexcept;
  std::int64_t next_arrival_ns() const noexcept;
  // Before which nothing arrives, and nothing is put on its way either, unless the host sends something.
  std::int64_t next_event_ns() const noexcept;

  // The cable is out: what is on it is lost.
  void lose_cable() noexcept;

  // One other thread each, or the same one; hold_zero_pose() any.
  void inject(const InjectedHaplyFault& wrong) noexcept { faults_.publish(wrong); }
  void lead_hand(const HaplyHandPlan& plan) noexcept { hand_.follow(plan); }
  void hold_zero_pose(bool holds) noexcept { hand_.hold_zero_pose(holds); }

  // What inject() has asked for last, if it has not been obeyed yet; whether there was something. It does not happen by
  // itself, because ports have their share in it.
  bool obey_injected_fault() noexcept;
  const InjectedHaplyFault& fault() const noexcept { return wrong_; }

  HaplyTruth truth() const noexcept { return truth_with(board_); }
  // As it would be if the board were another one: what it would become.
  HaplyTruth truth_with(const HaplyBoard& board) const noexcept;
  const HaplyBoard& board() const noexcept { return board_; }
  const HaplyArms& arms() const noexcept { return arms_; }
  const VirtualHaplyHand& hand() const noexcept { return hand_; }
  const VirtualHaplyVariant& variant() const noexcept { return variant_; }

 private:
  struct OnItsWay {
    std::int64_t arrival_ns = 0;
    std::array<std::uint8_t, most_bytes> bytes{};
    std::size_t size = 0;
  };

  void run_board(std::int64_t now_ns) noexcept;
  void answer(HaplyBoard::Reply reply) noexcept;
  void send(std::span<const std::uint8_t> bytes, std::int64_t left_ns) noexcept;
  HaplyReplyFault fault_of_reply() noexcept;
  void spoil(HaplyBoard::Reply& reply, HaplyReplyFault fault) const noexcept;
  void step() noexcept;
  Vector<2> torques_of(const HaplyBoard& board) const noexcept;
  void turn_encoder(std::size_t arm, double angle, double share) noexcept;

  Options options_;
  const VirtualHaplyVariant& variant_;
  Vector<2> counts_per_turn_;
  std::int64_t lived_ns_;

  LatestValue<InjectedHaplyFault> faults_;
  InjectedHaplyFault wrong_;
  unsigned replies_ = 0;  // since the fault was asked for
  bool tears_packet_ = false;
  double leap_ = 0.0;              // of the encoder of arm 1, as soon as a motor pushes [rad]
  std::int64_t next_line_ns_ = 0;  // of a chatty program

  HaplyBoard board_;
  HaplyArms arms_;
  VirtualHaplyHand hand_;
  std::array<double, 2> edges_{};  // by arm, since the beginning; those that are whole have been counted

  FixedQueue<OnItsWay, 512> on_their_way_;
  std::uint64_t packets_ = 0;
  std::int64_t last_packet_ns_ = 0;
};

}  // namespace ghostforce
