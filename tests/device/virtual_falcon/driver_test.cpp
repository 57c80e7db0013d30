// The Falcon's driver, on a device that does what real ones have been seen to do: up to readiness, down again, and what
// a person is told on the way.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "tests/device/virtual_falcon/rehearsal.h"
#include "tests/support/long_run.h"

namespace ghostforce::driver_test {
namespace {

TEST(FalconDriver, ComesFromNothingToReady) {
  Rehearsal rehearsal;
  std::vector<FalconState> seen;
  rehearsal.run_until(30.0, [&] {
    if (seen.empty() || seen.back() != rehearsal.falcon().state) seen.push_back(rehearsal.falcon().state);
    return seen.back() == FalconState::idle;
  });
  EXPECT_EQ(seen,
            (std::vector{FalconState::opening, FalconState::loading_firmware, FalconState::homing, FalconState::idle}));
  const FalconReport& report = rehearsal.falcon();
  EXPECT_EQ(report.serial.text(), VirtualLink::serial_number);
  EXPECT_EQ(report.bytes_echoed, report.firmware_size);
  EXPECT_EQ(report.fault, FalconFault::none);
  EXPECT_EQ(report.faults, 0U);
}

TEST(FalconDriver, TellsHowFarTheUploadIs) {
  Rehearsal rehearsal;
  ASSERT_TRUE(rehearsal.run_until_state(FalconState::loading_firmware));
  std::uint32_t before = 0;
  int steps = 0;
  rehearsal.run_until(10.0, [&] {
    const FalconReport& report = rehearsal.falcon();
    EXPECT_GE(report.bytes_echoed, before);
    steps += report.bytes_echoed > before ? 1 : 0;
    before = report.bytes_echoed;
    return report.state != FalconState::loading_firmware;
  });
  EXPECT_GT(steps, 50);
  EXPECT_EQ(rehearsal.falcon().attempt, 1);
}

TEST(FalconDriver, TellsWhichMotorsHaveHomed) {
  Rehearsal rehearsal;
  ASSERT_TRUE(rehearsal.run_until_state(FalconState::homing));
  std::vector<int> homed;
  rehearsal.run_until(20.0, [&] {
    const auto& has_homed = rehearsal.falcon().has_homed;
    const int count = static_cast<int>(has_homed[0]) + static_cast<int>(has_homed[1]) + static_cast<int>(has_homed[2]);
    if (homed.empty() || homed.back() != count) homed.push_back(count);
    return rehearsal.falcon().state == FalconState::idle;
  });
  EXPECT_EQ(homed, (std::vector{0, 1, 2, 3}));
}

TEST(FalconDriver, KnowsWhereTheHandleIsWithinTheEncodersResolutionAndWithoutLag) {
  Rehearsal rehearsal;
  ASSERT_TRUE(rehearsal.run_until_state(FalconState::idle));
  rehearsal.run(2.0);
  // At rest. Half a count of each motor is worth some 25 µm in the worst direction near the middle.
  for (const Vector<2> goal : {Vector<2>(-0.03, 0.01), Vector<2>(0.0, 0.0), Vector<2>(0.035, -0.02)}) {
    rehearsal.input().move_to(goal, 0.3);
    rehearsal.run(2.0);
    EXPECT_LT(glm::length(rehearsal.motors().handle - rehearsal.tip()), 30e-6);
    EXPECT_LT(glm::length(rehearsal.motors().handle - goal), 1e-4);
  }
  // In motion: what was read belongs to no earlier moment than the newest exchange, which takes about a millisecond.
  rehearsal.input().move_to({-0.035, -0.02}, 0.5);
  double worst = 0.0;
  double fastest = 0.0;
  for (int i = 0; i < 400; ++i) {
    rehearsal.step();
    worst = std::max(worst, glm::length(rehearsal.motors().handle - rehearsal.tip()));
    fastest = std::max(fastest, rehearsal.motors().handle_speed);
  }
  EXPECT_GT(fastest, 0.05);
  EXPECT_LT(worst, 30e-6 + 0.002 * fastest);
}

TEST(FalconDriver, ExchangesAThousandTimesASecond) {
  Rehearsal rehearsal;
  ASSERT_TRUE(rehearsal.run_until_state(FalconState::idle));
  rehearsal.run(2.0);
  EXPECT_GT(rehearsal.falcon().exchange_hz, 900.0);
  EXPECT_LT(rehearsal.falcon().exchange_hz, 1100.0);
  EXPECT_LT(rehearsal.falcon().worst_exchange_s, 0.003);
  EXPECT_EQ(rehearsal.falcon().lost_exchanges, 0U);
  EXPECT_EQ(rehearsal.falcon().discarded_bytes, 0U);
}

TEST(FalconDriver, ASecondDriverFindsTheDeviceHomed) {
  VirtualLink::Options options{.clock = VirtualLink::Clock::stepped};
  options.device.starts_with_firmware = true;
  options.device.starts_homed = true;
  Falcon falcon(std::make_unique<VirtualLink>(options), {});
  for (int i = 0; i < 1000 && !falcon.report().is_readable(); ++i) {
    falcon.update();
    falcon.link().wait_until(falcon.link().now_ns() + 1'000'000);
  }
  EXPECT_EQ(falcon.report().state, FalconState::idle);
  EXPECT_EQ(falcon.report().attempt, 0);
}

TEST(FalconDriver, SaysThatThereIsNoFirmwareForIt) {
  Falcon falcon(std::make_unique<VirtualLink>(VirtualLink::Options{.clock = VirtualLink::Clock::stepped}), {});
  for (int i = 0; i < 1000; ++i) {
    falcon.update();
    falcon.link().wait_until(falcon.link().now_ns() + 1'000'000);
  }
  EXPECT_EQ(falcon.report().state, FalconState::fault);
  EXPECT_EQ(falcon.report().fault, FalconFault::no_firmware);
}

struct Trouble {
  const char* injected_fault;
  FalconFault fault;
};

// What keeps the device from ever getting ready, by its own name each.
TEST(FalconDriver, TellsEveryFaultApart) {
  for (const Trouble& trouble : {
           Trouble{"not-allowed", FalconFault::not_allowed},
           Trouble{"busy", FalconFault::busy},
           Trouble{"always-corrupted-echo", FalconFault::echo_differs},
           Trouble{"upload-stops", FalconFault::echo_missing},
           Trouble{"silence", FalconFault::no_handshake},
           Trouble{"power-lost", FalconFault::no_handshake},
       }) {
    InjectedFault injected_fault;
    find_injected_fault(trouble.injected_fault)->add(injected_fault);
    Rehearsal rehearsal(injected_fault);
    EXPECT_TRUE(rehearsal.run_until(300.0, [&] { return rehearsal.falcon().state == FalconState::fault; }))
        << trouble.injected_fault;
    EXPECT_EQ(rehearsal.falcon().fault, trouble.fault) << trouble.injected_fault;
    // And once it behaves, it is had without a restart of the program.
    rehearsal.input().inject({});
    EXPECT_TRUE(rehearsal.run_until_state(FalconState::idle, 60.0)) << trouble.injected_fault;
    EXPECT_EQ(rehearsal.falcon().fault, FalconFault::none) << trouble.injected_fault;
  }
}

TEST(FalconDriver, LooksUntilTheDeviceIsPluggedIn) {
  InjectedFault absent;
  absent.link = LinkFault::absent;
  Rehearsal rehearsal(absent);
  rehearsal.run(5.0);
  EXPECT_EQ(rehearsal.falcon().state, FalconState::absent);
  EXPECT_EQ(rehearsal.falcon().faults, 0U);
  rehearsal.input().inject({});
  EXPECT_TRUE(rehearsal.run_until_state(FalconState::opening, 1.0));
}

// Nuisances that have been seen on real devices: each is got over without a person's help.
TEST(FalconDriver, GetsOverWhatRealDevicesDo) {
  for (const char* name : {"lost-first-replies", "leading-00", "leading-13", "no-cts", "corrupted-echo", "lost-echo",
                           "split-packets", "joined-packets", "short-frames", "garbage", "late-5ms"}) {
    InjectedFault injected_fault;
    find_injected_fault(name)->add(injected_fault);
    Rehearsal rehearsal(injected_fault);
    EXPECT_TRUE(rehearsal.run_until_state(FalconState::idle, 120.0)) << name;
    rehearsal.run(1.0);
    EXPECT_EQ(rehearsal.falcon().state, FalconState::idle) << name;
    // No frame that was cut or glued was ever taken for another position.
    EXPECT_LT(glm::length(rehearsal.motors().handle - rehearsal.tip()), 1e-3) << name;
  }
}

TEST(FalconDriver, WaitsForAHandThatDoesNotHome) {
  InjectedFault injected_fault;
  find_injected_fault("never-homes")->add(injected_fault);
  Rehearsal rehearsal(injected_fault);
  EXPECT_FALSE(rehearsal.run_until_state(FalconState::idle, 30.0));
  EXPECT_EQ(rehearsal.falcon().state, FalconState::homing);
  EXPECT_EQ(rehearsal.falcon().motors, MotorNumbers{});
}

TEST(FalconDriver, FrozenEncodersKeepItFromBeingArmed) {
  InjectedFault injected_fault;
  Rehearsal rehearsal(injected_fault);
  ASSERT_TRUE(rehearsal.run_until_state(FalconState::homing));
  ASSERT_TRUE(rehearsal.run_until(20.0, [&] { return rehearsal.falcon().is_homed(); }));
  find_injected_fault("frozen-encoders")->add(injected_fault);
  rehearsal.input().inject(injected_fault);
  rehearsal.run(2.0);
  ++rehearsal.command().arms_asked;
  rehearsal.run(3.0);
  EXPECT_FALSE(rehearsal.falcon().encoders_move());
  EXPECT_EQ(rehearsal.motors().state, SafetyState::arming);
  EXPECT_EQ(rehearsal.motors().obstacle, ArmingObstacle::device_not_ready);
}

// While it pushes: what ends the force, how soon, and that nothing brings it back by itself.
TEST(FalconDriver, EveryLossEndsTheForceAndStaysOff) {
  struct Loss {
    const char* injected_fault;
    OffReason reason;
    double within_s;  // that the servo knows
  };
  for (const Loss& loss :
       {Loss{"unplugged", OffReason::unplugged, 0.005}, Loss{"silence", OffReason::loop_late, 0.025},
        Loss{"power-lost", OffReason::loop_late, 0.025}, Loss{"late-50ms", OffReason::loop_late, 0.060}}) {
    Rehearsal rehearsal;
    rehearsal.turn_on();
    rehearsal.input().move_to({0.02, -0.02}, 0.5);
    rehearsal.run(1.5);
    ASSERT_GT(glm::length(rehearsal.motors().sent), 0.5) << loss.injected_fault;
    InjectedFault injected_fault;
    find_injected_fault(loss.injected_fault)->add(injected_fault);
    rehearsal.input().inject(injected_fault);
    EXPECT_TRUE(rehearsal.run_until(loss.within_s, [&] { return rehearsal.motors().state != SafetyState::on; }))
        << loss.injected_fault;
    rehearsal.run(2.0);
    EXPECT_EQ(rehearsal.motors().state, SafetyState::off) << loss.injected_fault;
    EXPECT_EQ(rehearsal.motors().reason, loss.reason) << loss.injected_fault;
    EXPECT_EQ(rehearsal.motors().sent, Vector<2>(0.0)) << loss.injected_fault;
    rehearsal.input().inject({});
    rehearsal.input().move_to(Rehearsal::free_place, 0.1);
    EXPECT_TRUE(rehearsal.run_until_state(FalconState::idle, 60.0)) << loss.injected_fault;
    rehearsal.run(3.0);
    EXPECT_EQ(rehearsal.motors().state, SafetyState::off) << loss.injected_fault;
    EXPECT_EQ(rehearsal.input().link().motors(), MotorNumbers{}) << loss.injected_fault;
    rehearsal.turn_on();  // by a person it can be
  }
}

// Replies that come later and later: whatever asking again does to the order of things, none that is older than 20 ms
// is ever taken for a fresh one.
TEST(FalconDriver, RepliesThatCreepLateEndTheForceToo) {
  Rehearsal rehearsal;
  rehearsal.turn_on();
  rehearsal.input().move_to({0.02, -0.02}, 0.5);
  rehearsal.run(1.5);
  InjectedFault late;
  std::int64_t off_at_ms = 0;
  for (std::int64_t ms = 0; ms < 60 && off_at_ms == 0; ++ms) {
    late.reply_delay_ns = ms * 1'000'000;
    rehearsal.input().inject(late);
    rehearsal.run(0.3);
    if (rehearsal.motors().state == SafetyState::off) off_at_ms = ms;
  }
  EXPECT_EQ(rehearsal.motors().reason, OffReason::loop_late);
  EXPECT_GT(off_at_ms, 5);
  EXPECT_LE(off_at_ms, 20);
  // Nor can it be armed so.
  for (const std::int64_t ms : {26, 30, 48, 55}) {
    late.reply_delay_ns = ms * 1'000'000;
    rehearsal.input().inject(late);
    rehearsal.input().move_to(Rehearsal::free_place, 0.5);
    rehearsal.run(3.0);
    ++rehearsal.command().acknowledgements;
    rehearsal.run(0.1);
    ++rehearsal.command().arms_asked;
    rehearsal.run(3.0);
    EXPECT_EQ(rehearsal.motors().gain, 0.0) << ms;
  }
}

// What the motors get in truth, behind driver, cable and firmware, while everything misbehaves in turn.
TEST(FalconDriver, MotorsNeverGetWhatTheyShouldNotWhateverHappensOnTheWay) {
  std::mt19937_64 random{5};
  Rehearsal rehearsal;
  rehearsal.turn_on();
  int pushed_ticks = 0;
  int off_ticks = 0;
  for (int i = 0; i < trials(200'000); ++i) {
    if (random() % 500 == 0) {
      InjectedFault wrong;
      const auto kinds = injected_fault_catalog();
      kinds[random() % kinds.size()].add(wrong);
      rehearsal.input().inject(wrong);
    }
    if (random() % 300 == 0) rehearsal.input().inject({});
    if (random() % 200 == 0) {
      rehearsal.input().move_to(
          {1e-4 * static_cast<double>(random() % 600) - 0.03, 1e-4 * static_cast<double>(random() % 600) - 0.03}, 0.3);
    }
    if (random() % 400 == 0) rehearsal.use(static_cast<StrategyId>(random() % 3));
    if (random() % 700 == 0) ++rehearsal.command().offs_asked;
    if (random() % 250 == 0) ++rehearsal.command().acknowledgements;
    if (random() % 250 == 0) ++rehearsal.command().arms_asked;
    const Vector<2> before = rehearsal.motors().sent;
    rehearsal.step();
    const MotorReport& motors = rehearsal.motors();
    ASSERT_TRUE(std::isfinite(motors.sent.x) && std::isfinite(motors.sent.y)) << i;
    ASSERT_LE(glm::length(motors.sent), motors.limit + 1e-12) << i;
    if (motors.sent != Vector<2>(0.0)) {
      ASSERT_LE(glm::length(motors.sent - before), ForceLimiter::slew * ForceLimiter::longest_step_s + 1e-9) << i;
      ++pushed_ticks;
    }
    // An exchange that was under way is waited for, 20 ms at most, and a frame that a fault cuts short is said again.
    off_ticks = motors.state == SafetyState::off ? off_ticks + 1 : 0;
    if (off_ticks > 25) {
      ASSERT_EQ(rehearsal.falcon().motors, MotorNumbers{}) << i;
    }
    for (const std::int16_t counts : rehearsal.input().link().motors()) ASSERT_LE(std::abs(counts), 4095) << i;
  }
  EXPECT_GT(pushed_ticks, trials(10'000));
}

TEST(FalconDriver, TheGripIsADeadMansSwitch) {
  Rehearsal rehearsal;
  rehearsal.command().safety.needs_button = true;
  rehearsal.input().press(ReplyFrame::button_centre);
  rehearsal.turn_on();
  rehearsal.input().press(0);
  rehearsal.run(0.5);
  EXPECT_EQ(rehearsal.motors().reason, OffReason::button_released);
  EXPECT_EQ(rehearsal.motors().state, SafetyState::off);
}

TEST(FalconDriver, TheEndOfTheProgramIsNoForceOnTheDeviceItself) {
  Rehearsal rehearsal;
  rehearsal.turn_on();
  rehearsal.input().move_to({0.02, -0.02}, 0.5);
  rehearsal.run(1.5);
  ASSERT_NE(rehearsal.input().link().motors(), MotorNumbers{});
  rehearsal.input().shut_down();
  EXPECT_EQ(rehearsal.input().link().motors(), MotorNumbers{});
  EXPECT_EQ(rehearsal.input().link().device().lights(), 0);
}

}  // namespace
}  // namespace ghostforce::driver_test
