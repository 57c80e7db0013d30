// What goes wrong while the motors push, all of the catalog: how long it is until nothing pushes, by the simulated
// board itself; what ends the force and what is got over; and what comes back by itself. With
// GHOSTFORCE_PRINT_HAPLY_FAULTS in the environment the times are printed as a table.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/device/haply/held_haply.h"

namespace ghostforce::haply_faults_test {
namespace {

constexpr double longest_ms = 25.0;

enum class End : std::uint8_t {
  at_once,  // within longest_ms
  later,    // within a time of its own, or in a test of its own
  none,     // the force goes on, and rightly so
  out_of_reach,
};

struct Fault {
  std::string_view name;
  End end;
  OffReason reason = OffReason::none;
  bool loses_home = false;  // the zero pose has to be confirmed anew
  double later_ms = 0.0;    // of what ends later; 0: it has a test of its own
};

constexpr std::array faults{
    Fault{"absent", End::out_of_reach, OffReason::unplugged, true},
    Fault{"not-allowed", End::none},
    Fault{"busy", End::none},
    Fault{"unplugged", End::out_of_reach, OffReason::unplugged, true},
    Fault{"power-lost", End::at_once, OffReason::calibration, true},
    Fault{"unconfigured", End::out_of_reach, OffReason::not_homed, true},
    Fault{"other-id", End::at_once, OffReason::not_homed, true},
    Fault{"torn-packet", End::at_once, OffReason::not_homed, true},
    Fault{"late-5ms", End::later, OffReason::loop_late, false, 60.0},
    Fault{"late-50ms", End::at_once, OffReason::loop_late},
    Fault{"late-creeping", End::later, OffReason::loop_late, false, 150.0},
    Fault{"lost-reply", End::none},
    Fault{"lost-replies", End::none},
    Fault{"mute", End::at_once, OffReason::loop_late, true},
    Fault{"short-reply", End::none},
    Fault{"duplicated-replies", End::none},
    Fault{"garbage", End::none},
    Fault{"wrong-sign-1", End::none},
    Fault{"wrong-sign-2", End::later},
    Fault{"half-resolution", End::none},
    Fault{"wrong-zero-pose", End::none},
    Fault{"impossible-angles", End::at_once, OffReason::not_homed, true},
    Fault{"frozen-encoder", End::later},
    Fault{"frozen-encoders", End::later, OffReason::calibration, true, 80.0},
    Fault{"encoder-jump", End::at_once, OffReason::not_homed, true},
    Fault{"restarts", End::at_once, OffReason::not_homed, true},
    Fault{"touched-1200-baud", End::none},
    Fault{"no-dtr", End::at_once, OffReason::loop_late, true},
    Fault{"garbage-float", End::none},
    Fault{"not-a-number", End::none},
    Fault{"silent", End::out_of_reach, OffReason::loop_late, true},
    Fault{"chatty", End::out_of_reach, OffReason::loop_late, true},
};

// No packet asks for what a motor may not be asked for; and, with one motor, nothing of the other one.
struct PacketAudit {
  explicit PacketAudit(HeldHaply& haply) {
    haply.port().on_write = [this, &haply](std::span<const std::uint8_t> packet) {
      if (is_exchange(packet)) look(packet, haply.motors().state == SafetyState::ramp);
    };
  }
  void look(std::span<const std::uint8_t> packet, bool is_checking) {
    for (const std::size_t port : {0U, 1U}) {
      const float torque = torque_in(packet, port);
      is_sound &= std::isfinite(torque) && std::abs(torque) <= HaplyBoard::full_torque;
    }
    if (is_checking) return;  // both motors are pushed with, one after the other
    const float other = torque_in(packet, port_of_other_motor);
    if (std::bit_cast<std::uint32_t>(other) != 0) ++packets_for_other_motor;
    greatest_of_other_motor = std::max(greatest_of_other_motor, std::abs(other));
  }

  // Arm 2's motor of this variant is at port 1, arm 1's at port 2.
  static constexpr std::size_t port_of_other_motor = 1;

  bool is_sound = true;
  int packets_for_other_motor = 0;
  float greatest_of_other_motor = 0.0F;
};

void print_row(const Fault& fault, const PushWatch& watch, HeldHaply& haply) {
  if (std::getenv("GHOSTFORCE_PRINT_HAPLY_FAULTS") == nullptr) return;
  const bool is_on = haply.motors().state == SafetyState::on;
  std::printf("| %-18s | %8s | %5.2f | %5.1f | %-11s | %-12s | %-14s |\n", std::string(fault.name).c_str(),
              haply.pushes() ? "stays on" : std::to_string(watch.ms_pushing()).substr(0, 5).c_str(),
              watch.greatest_force(), mm_per_m * watch.farthest(), is_on ? "on" : std::string(haply.reason()).c_str(),
              std::string(entry_of(haply.haply().fault).name).c_str(),
              haply.haply().may_still_push ? "may still push" : "");
}

// Torques that hold no command of the board are dropped after a torn packet, and nothing has happened.
bool was_got_over(const Fault& fault, HeldHaply& haply) {
  return fault.name == "torn-packet" && haply.motors().state == SafetyState::on && haply.truth().is_configured;
}

TEST(HaplyFaults, TheTableIsTheCatalog) {
  const auto catalog = injected_haply_fault_catalog();
  ASSERT_EQ(faults.size(), catalog.size());
  for (std::size_t i = 0; i < catalog.size(); ++i) EXPECT_EQ(faults[i].name, catalog[i].name);
}

TEST(HaplyFaults, EndTheForceOrAreGotOver) {
  if (std::getenv("GHOSTFORCE_PRINT_HAPLY_FAULTS") != nullptr) {
    std::printf("| fault | force until [ms] | greatest [N] | handle went [mm] | off | fault | |\n");
  }
  for (const Fault& fault : faults) {
    SCOPED_TRACE(fault.name);
    HeldHaply haply;
    const PacketAudit audit(haply);
    ASSERT_TRUE(haply.press());
    ASSERT_LT(haply.force(), 2.0);
    haply.inject(fault.name);
    PushWatch watch(haply);
    haply.run(1.0);
    print_row(fault, watch, haply);
    EXPECT_LT(watch.greatest_force(), 2.3) << "no more than the motor has";
    EXPECT_TRUE(audit.is_sound);
    switch (fault.end) {
      case End::at_once:
        EXPECT_LE(watch.ms_pushing(), longest_ms);
        EXPECT_FALSE(haply.pushes());
        EXPECT_EQ(haply.motors().state, SafetyState::off);
        EXPECT_EQ(haply.motors().reason, fault.reason) << haply.reason();
        break;
      case End::none:
        EXPECT_EQ(haply.motors().state, SafetyState::on) << haply.reason();
        EXPECT_FALSE(haply.motors().may_still_push);
        break;
      case End::out_of_reach:
        EXPECT_EQ(haply.motors().state, SafetyState::off);
        EXPECT_EQ(haply.motors().reason, fault.reason) << haply.reason();
        EXPECT_TRUE(haply.pushes()) << "else it belongs elsewhere in the table";
        EXPECT_TRUE(haply.motors().may_still_push) << "a person is told to pull the plug";
        EXPECT_EQ(haply.haply().owed_serial.text(), VirtualPort::serial_number);
        break;
      case End::later:
        if (fault.later_ms == 0.0) break;
        EXPECT_LE(watch.ms_pushing(), fault.later_ms);
        EXPECT_FALSE(haply.pushes());
        EXPECT_EQ(haply.motors().reason, fault.reason) << haply.reason();
        break;
    }
  }
}

// At any moment of an exchange, and with any torque under way.
TEST(HaplyFaults, EndTheForceWheneverTheyCome) {
  for (const Fault& fault : faults) {
    if (fault.end != End::at_once) continue;
    double slowest = 0.0;
    for (int after_ms = 0; after_ms < 60; after_ms += 14) {
      HeldHaply haply;
      ASSERT_TRUE(haply.press(after_ms % 28 == 0 ? HeldHaply::deep_place : Vector<2>(0.013, -0.007)));
      haply.lead({0.006, -0.014}, 0.08);
      haply.run(0.001 * after_ms);
      // Somewhere within the tick.
      haply.port().wait_until(haply.port().now_ns() + 97'000 * (after_ms % 10));
      haply.inject(fault.name);
      PushWatch watch(haply);
      haply.run(0.3);
      if (was_got_over(fault, haply)) continue;
      EXPECT_LE(watch.ms_pushing(), longest_ms) << fault.name << ' ' << after_ms << ' ' << haply.reason();
      EXPECT_FALSE(haply.pushes()) << fault.name << ' ' << after_ms;
      slowest = std::max(slowest, watch.ms_pushing());
    }
    if (std::getenv("GHOSTFORCE_PRINT_HAPLY_FAULTS") != nullptr) {
      std::printf("%s: at most %.2f ms\n", std::string(fault.name).c_str(), slowest);
    }
  }
}

// Fully actuated.
TEST(HaplyFaults, EndTheForceOfBothMotors) {
  for (const Fault& fault : faults) {
    if (fault.end != End::at_once) continue;
    HeldHaply::Options options;
    options.settings = haply_settings(StrategyId::full);
    HeldHaply haply(options);
    const PacketAudit audit(haply);
    ASSERT_TRUE(haply.press({0.010, -0.010})) << fault.name << haply.force();
    haply.inject(fault.name);
    PushWatch watch(haply);
    haply.run(0.5);
    EXPECT_TRUE(audit.is_sound) << fault.name;
    if (was_got_over(fault, haply)) continue;
    EXPECT_LE(watch.ms_pushing(), longest_ms) << fault.name;
    EXPECT_FALSE(haply.pushes()) << fault.name;
  }
}

// A naive and an anisotropic device has one motor. The other one gets no torque at all, not even a little of it: at
// rest, where a hand is asked whether its encoders count, and in motion, where the line turns.
TEST(HaplyFaults, TheOtherMotorGetsExactlyNothing) {
  for (const StrategyId active : {StrategyId::naive, StrategyId::anisotropic}) {
    HeldHaply::Options options;
    options.settings = haply_settings(active);
    HeldHaply haply(options);
    PacketAudit audit(haply);
    ASSERT_TRUE(haply.press());
    haply.run(0.5);
    EXPECT_EQ(audit.packets_for_other_motor, 0)
        << "at rest, up to " << audit.greatest_of_other_motor << " N·m; " << strategy_catalog()[index_of(active)].name;
    audit.packets_for_other_motor = 0;
    audit.greatest_of_other_motor = 0.0F;
    for (int i = 0; i < 20; ++i) {
      haply.lead({0.011 + (i % 2 == 0 ? 0.01 : -0.01), -0.011 + (i % 2 == 0 ? 0.01 : -0.01)}, 0.04);
      haply.run(0.15);
    }
    ASSERT_EQ(haply.motors().state, SafetyState::on) << haply.reason();
    EXPECT_EQ(audit.packets_for_other_motor, 0) << "in motion, up to " << audit.greatest_of_other_motor << " N·m";
    audit.packets_for_other_motor = 0;
    audit.greatest_of_other_motor = 0.0F;
    // Out of the wall, into it, and off.
    haply.lead(HeldHaply::free_place, 0.05);
    haply.run(0.5);
    haply.lead(HeldHaply::deep_place, 0.05);
    haply.run(0.5);
    haply.disarm();
    haply.run(0.5);
    EXPECT_EQ(audit.packets_for_other_motor, 0) << "on the way out, up to " << audit.greatest_of_other_motor << " N·m";
  }
}

// What goes away needs no restart of the program, and nothing comes on again by itself.
TEST(HaplyFaults, WhenTheyGoAwayTheBoardIsHadAgain) {
  for (const Fault& fault : faults) {
    SCOPED_TRACE(fault.name);
    HeldHaply haply;
    ASSERT_TRUE(haply.press());
    haply.inject(fault.name);
    haply.run(1.5);
    const bool was_off = haply.motors().state == SafetyState::off;
    haply.lead(HeldHaply::free_place, 0.2);
    haply.mend();
    PushWatch watch(haply);
    haply.run(3.0);
    EXPECT_EQ(haply.motors().state == SafetyState::off, was_off) << "only a person arms, or turns off";
    if (was_off) {
      EXPECT_FALSE(haply.pushes());
      EXPECT_LE(watch.ms_pushing(), 250.0);
      if (fault.end == End::out_of_reach && std::getenv("GHOSTFORCE_PRINT_HAPLY_FAULTS") != nullptr) {
        std::printf("%s: stopped %.2f ms after it went away\n", std::string(fault.name).c_str(), watch.ms_pushing());
      }
    }
    EXPECT_FALSE(haply.motors().may_still_push);
    const bool wants_zero_pose = haply.haply().state == HaplyState::zero_pose;
    EXPECT_TRUE(wants_zero_pose || haply.haply().is_readable()) << name_of(haply.haply().state);
    if (fault.end != End::later) {
      EXPECT_EQ(wants_zero_pose, fault.loses_home);
    }
    if (wants_zero_pose) {
      haply.ask_to_arm();
      haply.run(0.5);
      EXPECT_EQ(haply.motors().gain, 0.0);
      ASSERT_TRUE(haply.set_zero_pose());
    }
    if (haply.motors().state != SafetyState::on) {
      ASSERT_TRUE(haply.move_a_little());
      ASSERT_TRUE(haply.arm()) << haply.reason();
    }
    EXPECT_LT(haply.misplaced(), 0.3e-3) << "a place that the driver is sure of is where the handle is";
  }
}

// While a board may push that cannot be heard, nothing else is done with the port but to ask it to stop.
TEST(HaplyFaults, ADebtIsPaidBeforeAllElse) {
  HeldHaply haply;
  ASSERT_TRUE(haply.press());
  haply.inject("unplugged");
  haply.run(2.0);
  EXPECT_TRUE(haply.motors().may_still_push);
  haply.port().packets.clear();
  haply.port().keeps_packets = true;
  haply.mend();
  PushWatch watch(haply);
  haply.run(0.05);
  haply.run(0.2);
  ASSERT_FALSE(haply.port().packets.empty());
  for (const WatchedPort::Packet& packet : haply.port().packets) {
    ASSERT_TRUE(is_exchange(packet.bytes));
    EXPECT_EQ(torque_in(packet.bytes, 0), 0.0F);
    EXPECT_EQ(torque_in(packet.bytes, 1), 0.0F);
  }
  EXPECT_LE(watch.ms_pushing(), 110.0) << "it is looked for ten times a second, and gets zeros as soon as it is open";
}

// It has restarted, or somebody else has set it up, while it was off the cable: zeros do not reach it then.
TEST(HaplyFaults, ADebtIsPaidToABoardThatHasForgotten) {
  HeldHaply haply;
  ASSERT_TRUE(haply.press());
  haply.inject("unplugged");
  haply.run(1.0);
  InjectedHaplyFault taken = haply_fault_named("unplugged");
  taken.is_another_programs = true;
  haply.board().inject(taken);
  haply.run(0.5);
  ASSERT_TRUE(haply.pushes());
  haply.mend();
  PushWatch watch(haply);
  haply.run(1.0);
  EXPECT_GT(watch.ms_pushing(), 0.0);
  EXPECT_LE(watch.ms_pushing(), 250.0);
  EXPECT_FALSE(haply.pushes());
  EXPECT_FALSE(haply.motors().may_still_push);
}

// None that is older than 20 ms is ever taken for a fresh one, however slowly they grow late.
TEST(HaplyFaults, RepliesThatCreepLateEndTheForce) {
  HeldHaply haply;
  ASSERT_TRUE(haply.press());
  haply.inject("late-creeping");
  PushWatch watch(haply);
  ASSERT_TRUE(haply.run_until(1.5, [&] { return haply.motors().state == SafetyState::off; }));
  EXPECT_EQ(haply.motors().reason, OffReason::loop_late);
  haply.run(1.0);
  EXPECT_FALSE(haply.pushes());
  EXPECT_LT(watch.greatest_force(), 2.3);
  haply.ask_to_arm();
  haply.run(3.0);
  EXPECT_EQ(haply.motors().gain, 0.0) << "nor can it be armed so";
  EXPECT_FALSE(haply.pushes());
}

// Any delay, in steps: whichever does not end the force leaves it where it belongs.
TEST(HaplyFaults, ADelayEndsTheForceOrDoesNotShakeTheHand) {
  for (const std::int64_t delay_ms : {1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 18, 20, 25}) {
    SCOPED_TRACE(delay_ms);
    HeldHaply haply;
    ASSERT_TRUE(haply.press());
    InjectedHaplyFault late;
    late.reply_delay_ns = delay_ms * 1'000'000;
    haply.board().inject(late);
    haply.run(1.0);
    PushWatch watch(haply);
    haply.run(1.0);
    const bool is_on = haply.motors().state == SafetyState::on;
    if (std::getenv("GHOSTFORCE_PRINT_HAPLY_FAULTS") != nullptr) {
      std::printf("delay %2d ms: %s, handle moves by %.2f mm, up to %.2f N, %.0f exchanges/s\n",
                  static_cast<int>(delay_ms), is_on ? "on" : std::string(haply.reason()).c_str(),
                  mm_per_m * watch.farthest(), watch.greatest_force(), haply.haply().exchange_hz);
    }
    if (is_on) {
      EXPECT_LT(watch.farthest(), 5e-3);
    }
    EXPECT_TRUE(is_on || !haply.pushes());
  }
}

}  // namespace
}  // namespace ghostforce::haply_faults_test
