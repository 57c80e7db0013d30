// From OFF to ON and back: which way leads where, and why.
#include "core/safety.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace ghostforce::safety_test {
namespace {

constexpr double dt = 0.001;

SafetyReading good_reading() {
  return {.device_is_ready = true, .loop_is_healthy = true, .is_outside_wall = true};
}

class SafetyTest : public testing::Test {
 protected:
  void run(double seconds) {
    for (double t = 0.0; t < seconds - 0.5 * dt; t += dt) safety_.update(reading_, options_, dt);
  }
  void turn_on() {
    safety_.arm();
    run(1.1);
    ASSERT_EQ(safety_.state(), SafetyState::on);
  }

  Safety safety_;
  SafetyReading reading_ = good_reading();
  SafetyOptions options_;
};

TEST_F(SafetyTest, IsOffUntilAPersonArmsIt) {
  run(10.0);
  EXPECT_EQ(safety_.state(), SafetyState::off);
  EXPECT_EQ(safety_.gain(), 0.0);
}

TEST_F(SafetyTest, GoesFromOffToOnWithARampOfASecond) {
  safety_.arm();
  run(dt);
  EXPECT_EQ(safety_.state(), SafetyState::ramp);
  EXPECT_EQ(safety_.gain(), 0.0);
  double before = 0.0;
  for (int i = 1; i < 1000; ++i) {
    run(dt);
    EXPECT_NEAR(safety_.gain(), i * dt, 1e-9);
    EXPECT_GT(safety_.gain(), before);
    before = safety_.gain();
  }
  run(2 * dt);
  EXPECT_EQ(safety_.state(), SafetyState::on);
  EXPECT_EQ(safety_.gain(), 1.0);
}

TEST_F(SafetyTest, TheForceGrowsOnlyOnceTheMotorsAreChecked) {
  reading_.motors_are_checked = false;
  safety_.arm();
  run(10.0);
  EXPECT_EQ(safety_.state(), SafetyState::ramp);
  EXPECT_EQ(safety_.gain(), 0.0);
  reading_.motors_are_checked = true;
  run(0.5);
  EXPECT_NEAR(safety_.gain(), 0.5, 1e-9);
}

TEST_F(SafetyTest, ArmingWaitsAndSaysWhatFor) {
  const std::vector<std::pair<std::function<void(SafetyReading&)>, ArmingObstacle>> obstacles{
      {[](SafetyReading& r) { r.device_is_ready = false; }, ArmingObstacle::device_not_ready},
      {[](SafetyReading& r) { r.loop_is_healthy = false; }, ArmingObstacle::loop_not_healthy},
      {[](SafetyReading& r) { r.since_exchange_s = 0.021; }, ArmingObstacle::loop_not_healthy},
      {[](SafetyReading& r) { r.since_window_s = 0.6; }, ArmingObstacle::loop_not_healthy},
      {[](SafetyReading& r) { r.is_outside_wall = false; }, ArmingObstacle::inside_wall},
      {[](SafetyReading& r) { r.wanted_force = 0.21; }, ArmingObstacle::force},
      {[](SafetyReading& r) { r.speed = 1.1; }, ArmingObstacle::force},
      {[](SafetyReading& r) { r.is_still = false; }, ArmingObstacle::force},
      {[](SafetyReading& r) { r.has_focus = false; }, ArmingObstacle::focus},
      {[](SafetyReading& r) { r.deadman_held = false; }, ArmingObstacle::button},
  };
  options_.needs_button = true;
  for (const auto& [spoil, obstacle] : obstacles) {
    safety_ = {};
    reading_ = good_reading();
    reading_.deadman_held = true;
    spoil(reading_);
    safety_.arm();
    run(5.0);
    EXPECT_EQ(safety_.state(), SafetyState::arming);
    EXPECT_EQ(safety_.obstacle(), obstacle);
    EXPECT_FALSE(entry_of(obstacle).sentence.empty());
    EXPECT_EQ(safety_.gain(), 0.0);
    reading_ = good_reading();
    reading_.deadman_held = true;
    run(2 * dt);
    EXPECT_EQ(safety_.state(), SafetyState::ramp) << entry_of(obstacle).sentence;
  }
}

TEST_F(SafetyTest, ArmingCanBeCalledOff) {
  reading_.is_outside_wall = false;
  safety_.arm();
  run(0.1);
  safety_.turn_off(OffReason::key);
  EXPECT_EQ(safety_.state(), SafetyState::off);
  reading_.is_outside_wall = true;
  run(5.0);
  EXPECT_EQ(safety_.state(), SafetyState::off);
}

struct Stop {
  OffReason reason;
  std::function<void(SafetyReading&)> cause;  // none: turn_off()
};

const std::vector<Stop>& stops() {
  static const std::vector<Stop> all{
      {OffReason::key, {}},
      {OffReason::visitor_gone, {}},
      {OffReason::button_released, [](SafetyReading& r) { r.deadman_held = false; }},
      {OffReason::focus_lost, [](SafetyReading& r) { r.has_focus = false; }},
      {OffReason::too_fast, [](SafetyReading& r) { r.speed = 1.01; }},
      {OffReason::over_force, [](SafetyReading& r) { r.wanted_force = 41.0; }},
      {OffReason::loop_late, [](SafetyReading& r) { r.since_exchange_s = 0.0201; }},
      {OffReason::window_stalled, [](SafetyReading& r) { r.since_window_s = 0.51; }},
      {OffReason::unplugged, [](SafetyReading& r) { r.trouble = OffReason::unplugged; }},
      {OffReason::not_homed, [](SafetyReading& r) { r.trouble = OffReason::not_homed; }},
      {OffReason::program_ending, {}},
      {OffReason::overruled, [](SafetyReading& r) { r.trouble = OffReason::overruled; }},
      {OffReason::machine_sleeps, {}},
      {OffReason::calibration, [](SafetyReading& r) { r.trouble = OffReason::calibration; }},
      {OffReason::fault, [](SafetyReading& r) { r.trouble = OffReason::fault; }},
  };
  return all;
}

TEST_F(SafetyTest, EveryReasonEndsInOffAndStaysUntilAPersonActs) {
  EXPECT_EQ(stops().size() + 1, off_reason_catalog().size());
  for (const Stop& stop : stops()) {
    const std::string name(entry_of(stop.reason).name);
    safety_ = {};
    options_.needs_button = true;
    reading_ = good_reading();
    reading_.deadman_held = true;
    turn_on();
    if (stop.cause) {
      stop.cause(reading_);
      run(dt);
    } else {
      safety_.turn_off(stop.reason);
    }
    EXPECT_EQ(safety_.reason(), stop.reason) << name;
    EXPECT_EQ(safety_.state(), entry_of(stop.reason).at_once ? SafetyState::off : SafetyState::fade) << name;
    run(Safety::fade_s + 2 * dt);
    EXPECT_EQ(safety_.state(), SafetyState::off) << name;
    EXPECT_EQ(safety_.gain(), 0.0) << name;
    // Well again: nothing happens by itself, nor by arming before the reason was acknowledged.
    reading_ = good_reading();
    reading_.deadman_held = true;
    safety_.arm();
    run(2.0);
    EXPECT_EQ(safety_.state(), SafetyState::off) << name;
    EXPECT_EQ(safety_.reason(), stop.reason) << name;
    safety_.acknowledge();
    run(2.0);
    EXPECT_EQ(safety_.state(), SafetyState::off) << name;
    EXPECT_EQ(safety_.last_reason(), stop.reason) << name;
    turn_on();
    EXPECT_EQ(safety_.last_reason(), OffReason::none) << name;
  }
}

TEST_F(SafetyTest, TheFirstReasonStays) {
  turn_on();
  reading_.speed = 2.0;
  run(0.01);
  reading_.has_focus = false;
  run(1.0);
  EXPECT_EQ(safety_.reason(), OffReason::too_fast);
}

TEST_F(SafetyTest, AFadeThatLosesItsDeviceEndsAtOnce) {
  turn_on();
  safety_.turn_off(OffReason::key);
  run(0.05);
  EXPECT_EQ(safety_.state(), SafetyState::fade);
  reading_.trouble = OffReason::unplugged;
  run(dt);
  EXPECT_EQ(safety_.state(), SafetyState::off);
  EXPECT_EQ(safety_.reason(), OffReason::key);
}

TEST_F(SafetyTest, NumbersThatAreNoneTurnItOff) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::function<void(SafetyReading&)>> causes{
      [](SafetyReading& r) { r.speed = nan; }, [](SafetyReading& r) { r.wanted_force = nan; },
      [](SafetyReading& r) { r.since_exchange_s = nan; }, [](SafetyReading& r) { r.since_window_s = nan; }};
  for (const auto& cause : causes) {
    safety_ = {};
    reading_ = good_reading();
    turn_on();
    cause(reading_);
    run(0.3);
    EXPECT_EQ(safety_.state(), SafetyState::off);
    EXPECT_NE(safety_.reason(), OffReason::none);
    safety_.acknowledge();
    safety_.arm();
    run(1.0);
    EXPECT_EQ(safety_.state(), SafetyState::arming);  // nor does it let anything on
  }
}

TEST_F(SafetyTest, TimeThatStandsStillOrRunsBackwardsDoesNotRaiseTheForce) {
  safety_.arm();
  for (const double elapsed : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    for (int i = 0; i < 2000; ++i) safety_.update(reading_, options_, elapsed);
    EXPECT_EQ(safety_.gain(), 0.0);
  }
}

// Whatever comes in whatever order: the motors are on only after a person armed them and while nothing spoke against
// it.
TEST_F(SafetyTest, NeverPushesUnaskedOrAgainstAReason) {
  std::mt19937_64 random{7};
  bool asked = false;
  std::int64_t ticks_on = 0;
  for (int i = 0; i < 2'000'000; ++i) {
    const std::uint64_t dice = random() % 4096;
    if (dice < 8) reading_ = good_reading();
    if (dice >= 8 && dice < 8 + stops().size()) {
      const Stop& stop = stops()[dice - 8];
      if (stop.cause) stop.cause(reading_);
    }
    if (dice >= 100 && dice < 116) {
      reading_ = good_reading();
      safety_.acknowledge();
      safety_.arm();
      asked = true;
    }
    if (dice == 200) safety_.turn_off(OffReason::key);
    if (dice == 201) options_.needs_button = !options_.needs_button;
    const double before = safety_.gain();
    safety_.update(reading_, options_, dt);
    ASSERT_GE(safety_.gain(), 0.0);
    ASSERT_LE(safety_.gain(), 1.0);
    if (!asked) {
      ASSERT_EQ(safety_.gain(), 0.0);
    }
    if (safety_.state() == SafetyState::off) {
      ASSERT_EQ(safety_.gain(), 0.0);
      asked = false;
    }
    if (safety_.gain() > before) {
      ASSERT_EQ(reading_.trouble, OffReason::none);
      ASSERT_TRUE(reading_.has_focus);
      ASSERT_LE(reading_.speed, Safety::greatest_speed);
    }
    ticks_on += safety_.state() == SafetyState::on ? 1 : 0;
  }
  EXPECT_GT(ticks_on, 1000);
}

TEST(OffReasons, StandInTheirOrderAndSayWhatToDo) {
  for (std::size_t i = 0; i < off_reason_catalog().size(); ++i) {
    const OffReasonEntry& entry = off_reason_catalog()[i];
    EXPECT_EQ(static_cast<std::size_t>(entry.id), i);
    EXPECT_FALSE(entry.name.empty());
    EXPECT_FALSE(entry.title.empty());
    EXPECT_FALSE(entry.remedy.empty());
  }
}

}  // namespace
}  // namespace ghostforce::safety_test
