// The servo with motors, stepped by hand on a device that does exactly as it is told: when do they push, with what, and
// what makes them stop.
#include "device/servo/servo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "core/proxy.h"
#include "device/servo/servo_thread.h"
#include "tests/device/servo/puppet_servo.h"
#include "tests/support/long_run.h"

namespace ghostforce::servo_motors_test {
namespace {

class ServoMotors : public PuppetServo {};

TEST_F(ServoMotors, HandleIsTheGoalUntilTheyAreArmed) {
  puppet_->reading.position = inside;
  run(1.0);
  EXPECT_EQ(report().snapshot.goal, inside);
  EXPECT_FALSE(report().snapshot.measured);
  EXPECT_GT(glm::length(report().snapshot.strategies[0].force), 0.1);  // the model's
  EXPECT_EQ(puppet_->pushed, Vector<2>(0.0));
  EXPECT_FALSE(puppet_->armed);
  EXPECT_EQ(motors().state, SafetyState::off);
}

TEST_F(ServoMotors, ArmedTheHandleIsTheDevice) {
  turn_on();
  puppet_->reading.position = inside;
  run(0.2);
  const Snapshot& snapshot = report().snapshot;
  ASSERT_EQ(snapshot.measured, StrategyId::anisotropic);
  EXPECT_EQ(snapshot.strategies[index_of(StrategyId::anisotropic)].device, inside);
  const Vector<2> force = wanted(inside, command_.settings);
  EXPECT_EQ(puppet_->pushed, force);
  EXPECT_EQ(motors().sent, force);
  EXPECT_TRUE(puppet_->armed);
  EXPECT_EQ(snapshot.goal, inside - force / 100.0);
  EXPECT_EQ(force.y, 0.0);  // one motor, along x
  EXPECT_LT(force.x, -0.5);
}

TEST_F(ServoMotors, EveryStrategyPushesAsItsOwn) {
  turn_on();
  puppet_->reading.position = inside;
  for (const Strategy& entry : strategy_catalog()) {
    command_.settings.active = entry.id;
    ++command_.settings_generation;
    run(0.3);
    EXPECT_EQ(puppet_->pushed, wanted(inside, command_.settings)) << entry.name;
    EXPECT_EQ(puppet_->pushed.y != 0.0, entry.has_every_motor) << entry.name;
  }
}

// Between two times that the motors are on, the hand goes where it likes, and the simulated devices too.
TEST_F(ServoMotors, ArmingAgainAndSwitchingStrategiesDoNoWork) {
  const auto energy = [this] { return report().snapshot.strategies[index_of(command_.settings.active)].energy; };
  turn_on();
  puppet_->reading.position = inside;
  run(0.3);
  command_.paused = true;  // armed there is no pause; later no tick happens until the motors are on again
  ++command_.offs_asked;
  run(0.3);
  const double before = energy();
  puppet_->reading.position = outside;
  run(0.1);
  ++command_.acknowledgements;
  turn_on();
  EXPECT_EQ(energy(), before);
  puppet_->reading.position = inside;
  run(0.3);
  for (const Strategy& entry : strategy_catalog()) {
    command_.settings.active = entry.id;
    ++command_.settings_generation;
    const double others = report().snapshot.strategies[index_of(entry.id)].energy;
    step();
    ASSERT_EQ(report().snapshot.measured, entry.id);
    EXPECT_EQ(energy(), others) << entry.name;
    run(0.2);
  }
}

TEST_F(ServoMotors, ForceComesInOverASecond) {
  arm();
  step();
  step();
  ASSERT_EQ(motors().state, SafetyState::ramp);
  puppet_->reading.position = inside;
  const double full = glm::length(wanted(inside, command_.settings));
  for (int i = 1; i <= 9; ++i) {
    run(0.1);
    EXPECT_NEAR(glm::length(puppet_->pushed), full * motors().gain, 1e-9);
    EXPECT_NEAR(motors().gain, 0.1 * i, 0.002);
  }
}

TEST_F(ServoMotors, ChangesLeadOverAndDoNotLeap) {
  turn_on();
  puppet_->reading.position = inside;
  run(0.5);
  for (int change = 0; change < 6; ++change) {
    if (change % 2 == 0) command_.settings.active = change == 0 ? StrategyId::full : StrategyId::naive;
    if (change % 2 == 1) command_.settings.stiffnesses.k_r = change == 1 ? 100.0 : 700.0;
    ++command_.settings_generation;
    Vector<2> before = puppet_->pushed;
    for (int i = 0; i < 300; ++i) {
      step();
      // A cross-fade of 150 ms between forces that differ by some newtons.
      EXPECT_LT(glm::length(puppet_->pushed - before), 0.1);
      before = puppet_->pushed;
    }
    EXPECT_NEAR(glm::length(puppet_->pushed - wanted(inside, command_.settings)), 0.0, 1e-12);
  }
}

TEST_F(ServoMotors, HoldAStiffWallSofterUntilAPersonTypesMore) {
  command_.settings.stiffnesses.k_r = 2000.0;
  ++command_.settings_generation;
  turn_on();
  puppet_->reading.position = {0.002, -0.002};
  run(0.3);
  Settings held = command_.settings;
  held.stiffnesses.k_r = 800.0;
  EXPECT_EQ(puppet_->pushed, wanted({0.002, -0.002}, held));
  EXPECT_EQ(motors().held_k_r, 800.0);
  command_.safety.greatest_k_r = 3000.0;
  run(0.3);
  EXPECT_EQ(puppet_->pushed, wanted({0.002, -0.002}, command_.settings));
  EXPECT_EQ(motors().held_k_r, 0.0);
}

TEST_F(ServoMotors, AScaleLeavesTheWallAsStiffInTheHand) {
  puppet_->gain = 1.0 / 3.0;  // three metres of the scene per metre of the handle
  turn_on();
  puppet_->reading.position = inside;
  run(0.3);
  EXPECT_NEAR(glm::length(puppet_->pushed - wanted(inside, command_.settings) / 3.0), 0.0, 1e-12);
  // The model's force is the scene's.
  EXPECT_EQ(report().snapshot.strategies[index_of(StrategyId::anisotropic)].force, wanted(inside, command_.settings));
}

TEST_F(ServoMotors, ALawOfTheMomentBeforeDoesNotReachIntoFreeSpace) {
  turn_on();
  puppet_->reading.position = inside;
  run(0.5);
  command_.settings.active = StrategyId::full;
  ++command_.settings_generation;
  run(0.02);
  puppet_->reading.position = outside;
  run(0.01);  // 3 N go in 6 ms at 500 N/s
  EXPECT_EQ(puppet_->pushed, Vector<2>(0.0));
}

TEST_F(ServoMotors, LimitCountsWithWhatIsNotKnownOfThem) {
  puppet_->uncertainty = 2.0;
  turn_on();
  puppet_->reading.position = {0.03, -0.03};
  run(0.5);
  EXPECT_NEAR(glm::length(puppet_->pushed), SafetyOptions{}.force_limit / 2.0, 1e-12);
  EXPECT_TRUE(motors().is_saturated);
  // What is felt is what tells of the goal, and not what was wanted.
  EXPECT_NEAR(glm::length(report().snapshot.goal - (Vector<2>{0.03, -0.03} - puppet_->pushed / 100.0)), 0.0, 1e-12);
}

TEST_F(ServoMotors, PauseAndSlowMotionAreNotForAnArmedDevice) {
  turn_on();
  command_.paused = true;
  command_.speed = 0.1;
  const std::int64_t tick = report().snapshot.tick;
  const std::int64_t began = puppet_->now;
  run(0.1);
  EXPECT_EQ(report().snapshot.tick, tick + 100);
  EXPECT_NEAR(static_cast<double>(puppet_->now - began) * 1e-9, 0.1, 0.0015);
}

struct Stop {
  OffReason reason;
  std::function<void(PuppetInput&, ServoCommand&)> cause;
};

// Each way out of ON that does not need a thread, and the promise of each: no force, and none again without a person.
TEST_F(ServoMotors, EveryReasonEndsInNoForce) {
  const std::vector<Stop> stops{
      {OffReason::key, [](PuppetInput&, ServoCommand& c) { ++c.offs_asked; }},
      {OffReason::visitor_gone, [](PuppetInput&, ServoCommand& c) { ++c.departures; }},
      {OffReason::button_released, [](PuppetInput& p, ServoCommand&) { p.reading.deadman_held = false; }},
      {OffReason::focus_lost, [](PuppetInput&, ServoCommand& c) { c.has_focus = false; }},
      {OffReason::too_fast, [](PuppetInput& p, ServoCommand&) { p.reading.speed = 1.2; }},
      {OffReason::over_force,
       [](PuppetInput& p, ServoCommand&) {
         p.reading.position = {0.5, -0.5};
       }},
      {OffReason::loop_late, [](PuppetInput& p, ServoCommand&) { p.answers = false; }},
      {OffReason::unplugged, [](PuppetInput& p, ServoCommand&) { p.reading.trouble = OffReason::unplugged; }},
      {OffReason::not_homed, [](PuppetInput& p, ServoCommand&) { p.reading.trouble = OffReason::not_homed; }},
      {OffReason::machine_sleeps, [](PuppetInput&, ServoCommand& c) { c.machine_sleeps = true; }},
      {OffReason::calibration, [](PuppetInput& p, ServoCommand&) { p.reading.trouble = OffReason::calibration; }},
      {OffReason::fault, [](PuppetInput& p, ServoCommand&) { p.reading.trouble = OffReason::fault; }},
  };
  for (const Stop& stop : stops) {
    begin();
    command_.safety.needs_button = true;
    puppet_->reading.deadman_held = true;
    turn_on();
    puppet_->reading.position = inside;
    run(0.1);
    ASSERT_GT(glm::length(puppet_->pushed), 0.5);
    const HandleReading good = puppet_->reading;
    stop.cause(*puppet_, command_);
    run(0.3);
    const std::string name(entry_of(stop.reason).name);
    EXPECT_EQ(motors().state, SafetyState::off) << name;
    EXPECT_EQ(motors().reason, stop.reason) << name;
    EXPECT_EQ(puppet_->pushed, Vector<2>(0.0)) << name;
    EXPECT_FALSE(puppet_->armed) << name;
    EXPECT_FALSE(report().snapshot.measured) << name;
    puppet_->reading = good;
    puppet_->answers = true;
    command_.has_focus = true;
    command_.machine_sleeps = false;
    run(2.0);
    EXPECT_EQ(motors().state, SafetyState::off) << name;
    EXPECT_EQ(puppet_->pushed, Vector<2>(0.0)) << name;
    puppet_->reading.position = outside;
    ++command_.acknowledgements;
    step();
    EXPECT_EQ(motors().reason, OffReason::none) << name;
    turn_on();
  }
}

TEST_F(ServoMotors, AWindowThatStallsTakesTheForceAway) {
  turn_on();
  puppet_->reading.position = inside;
  run(0.1);
  for (int i = 0; i < 450; ++i) servo_->step();
  EXPECT_EQ(motors().state, SafetyState::on);
  for (int i = 0; i < 300; ++i) servo_->step();
  EXPECT_EQ(motors().state, SafetyState::off);
  EXPECT_EQ(motors().reason, OffReason::window_stalled);
  EXPECT_EQ(puppet_->pushed, Vector<2>(0.0));
}

TEST_F(ServoMotors, ANumberThatIsNoneTakesTheForceAwayAtOnce) {
  turn_on();
  puppet_->reading.position = inside;
  run(0.1);
  puppet_->reading.position.x = std::numeric_limits<double>::quiet_NaN();
  step();
  EXPECT_EQ(puppet_->pushed, Vector<2>(0.0));
  run(0.3);
  EXPECT_EQ(motors().state, SafetyState::off);
}

TEST_F(ServoMotors, SettingsThatRunAwayTakeTheForceAway) {
  turn_on();
  puppet_->reading.position = inside;
  run(0.1);
  command_.settings.mass = 0.001;  // of the simulated others
  command_.settings.damping = 0.0;
  command_.settings.rate = 20.0;
  ++command_.settings_generation;
  run(20.0);
  ASSERT_TRUE(report().diverged);
  EXPECT_EQ(motors().reason, OffReason::fault);
  EXPECT_EQ(puppet_->pushed, Vector<2>(0.0));
}

TEST_F(ServoMotors, TheEndOfTheThreadIsTheEndOfTheForce) {
  PuppetInput* const puppet = puppet_;
  ServoThread thread;
  thread.start(*servo_);
  thread.stop();
  EXPECT_TRUE(puppet->finished);
  EXPECT_FALSE(puppet->armed);
  EXPECT_EQ(puppet->pushed, Vector<2>(0.0));
}

// Whatever handle and window do: what reaches the motors is a number, under the limit, and no faster than allowed.
TEST_F(ServoMotors, KeepTheirPromiseUnderMillionsOfHostileTicks) {
  std::mt19937_64 random{11};
  const auto any = [&](double least, double greatest) {
    return std::uniform_real_distribution<double>(least, greatest)(random);
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const HandleReading good = puppet_->reading;
  int armed_ticks = 0;
  const int ticks = is_long_run() ? 10'000'000 : trials(1'000'000);
  for (int i = 0; i < ticks; ++i) {
    HandleReading& reading = puppet_->reading;
    switch (random() % 400) {
      case 0:
        reading.position = {any(-0.1, 0.1), any(-0.1, 0.1)};
        break;
      case 1:
        reading.position = {nan, any(-1.0, 1.0)};
        break;
      case 2:
        reading.position = {any(-1e9, 1e9), 1e300};
        break;
      case 3:
        reading.speed = any(0.0, 1.3);
        break;
      case 4:
        reading.trouble = static_cast<OffReason>(random() % 12);
        break;
      case 5:
        puppet_->answers = random() % 2 == 0;
        break;
      case 6:
        reading.is_known = random() % 2 == 0;
        break;
      case 7:
        command_.settings.active = static_cast<StrategyId>(random() % 3), ++command_.settings_generation;
        break;
      case 8:
        command_.settings.stiffnesses.k_r = std::pow(10.0, any(-1.0, 6.0));
        ++command_.settings_generation;
        break;
      case 9:
        command_.settings.stiffnesses.k_c = std::pow(10.0, any(0.0, 9.0));
        command_.settings.stiffnesses.chosen_tracking_ratio = std::pow(10.0, any(-3.0, 3.0));
        ++command_.settings_generation;
        break;
      case 10:
        command_.settings.wall_normal_angle = any(-9.0, 9.0), ++command_.settings_generation;
        break;
      case 11:
        command_.safety.force_limit = random() % 8 == 0 ? nan : any(0.0, 12.0);
        break;
      case 12:
        command_.safety.greatest_k_r = random() % 8 == 0 ? nan : std::pow(10.0, any(0.0, 6.0));
        break;
      case 13:
        command_.paused = !command_.paused;
        break;
      case 14:
        command_.settings.stiffnesses.k_u = any(-1.0, 1e3), ++command_.settings_generation;
        break;
      case 15:
        ++command_.offs_asked;
        break;
      case 16:
        puppet_->now += static_cast<std::int64_t>(random() % 30'000'000);
        break;
      default:
        break;
    }
    if (random() % 60 == 0) {
      reading = good;
      reading.position = outside;
      puppet_->answers = true;
      command_.settings = motor_settings(StrategyId::anisotropic);
      ++command_.settings_generation;
      ++command_.acknowledgements;
      arm();
    }
    if (reading.is_known && random() % 3 != 0) reading.position += Vector<2>{any(-1e-4, 2e-4), any(-2e-4, 1e-4)};
    const Vector<2> before = puppet_->pushed;
    const bool was_armed = puppet_->armed;
    step();
    const Vector<2> force = puppet_->pushed;
    ASSERT_TRUE(std::isfinite(force.x) && std::isfinite(force.y)) << i;
    ASSERT_LE(glm::length(force), force_ceiling + 1e-12) << i;
    if (force != Vector<2>(0.0)) {
      ASSERT_TRUE(puppet_->armed) << i;
      // 500 N/s for 2 ms at most, however late the tick.
      ASSERT_LE(glm::length(force - before), ForceLimiter::slew * ForceLimiter::longest_step_s + 1e-9) << i;
    }
    armed_ticks += was_armed && force != Vector<2>(0.0) ? 1 : 0;
  }
  EXPECT_GT(armed_ticks, ticks / 100);
}

}  // namespace
}  // namespace ghostforce::servo_motors_test
