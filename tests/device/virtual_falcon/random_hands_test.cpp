// People at the virtual Falcon for an hour, or for a tenth of it: weak and strong, heavy and light, trembling, resting,
// pushing, tapping, under every strategy, on devices that are not quite what their calibration says. The checks of motors
// and encoders never stop one of them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/tremor_and_drift.h"
#include "tests/device/virtual_falcon/held_falcon.h"
#include "tests/support/hand_at_wall.h"
#include "tests/support/long_run.h"

namespace ghostforce::random_hands_test {
namespace {

// A person and the device that they hold.
struct Person {
  HeldFalcon::Options options;
  TremorAndDrift tremor_and_drift;
};

Person person(HandRandom& random) {
  Person person;
  SimulatedArm::Options& arm = person.options.arm;
  person.options.stiffness = random.over_decades(50.0, 2000.0);
  arm.mass = random.over_decades(0.08, 0.5);
  arm.damping = random.over_decades(4.0, 30.0);
  arm.friction = random.uniform(0.0, 1.0) < 0.5 ? 0.0 : random.uniform(0.0, 0.3);
  arm.weight = random.uniform(0.0, 1.0) < 0.5 ? 0.0 : 0.9;
  arm.counts_per_newton_metre = random.over_decades(3530.0, 10000.0);
  for (glm::length_t leg = 0; leg < 3; ++leg) arm.motor_strengths[leg] = random.uniform(0.8, 1.2);
  const auto presets = geometry_catalog();
  arm.geometry = presets[static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(presets.size())))].geometry;
  person.tremor_and_drift.tremor_rms = random.uniform(0.0, 1.0) < 0.3 ? 0.0 : random.over_decades(10e-6, 200e-6);
  person.tremor_and_drift.drift_speed = random.uniform(0.0, 1.0) < 0.5 ? 0.0 : random.over_decades(0.5e-3, 5e-3);
  person.tremor_and_drift.seed = std::floor(random.uniform(1.0, 1e6));
  return person;
}

constexpr std::array wrong_motors{LegNumbers{-1, -2, -3}, LegNumbers{-1, 2, 3}, LegNumbers{1, -2, 3},
                                  LegNumbers{1, 2, -3},   LegNumbers{2, 1, 3},  LegNumbers{2, 3, 1}};

// What they did in all.
struct Hour {
  double seconds = 0.0;
  double armed_s = 0.0;
  double pushed_s = 0.0;
  int armings = 0;
  int comings_on = 0;
};

void spend(double seconds, HandRandom& random, Hour& hour) {
  const Person who = person(random);
  SCOPED_TRACE(testing::Message() << "after " << hour.seconds << " s, hand of " << who.options.stiffness << " N/m, "
                                  << who.options.arm.mass << " kg, " << who.options.arm.damping << " N·s/m");
  HeldFalcon falcon(who.options);
  const TremorAndDriftMotion tremor_and_drift(who.tremor_and_drift);
  double time_s = 0.0;
  double until_s = 0.0;
  falcon.lead({-0.03, 0.0}, 0.3);
  SafetyState before = SafetyState::off;
  while (time_s < seconds) {
    if (time_s >= until_s) {
      // Somewhere, at some speed, for some time; more often than not into the wall.
      const bool taps = random.uniform(0.0, 1.0) < 0.2;
      const double depth = random.uniform(-0.02, 0.03);
      const double along = random.uniform(-0.02, 0.02);
      const double lasts_s = taps ? random.uniform(0.05, 0.2) : random.uniform(0.1, 2.0);
      falcon.lead({depth * 0.7 + along * 0.7, along * 0.7 - depth * 0.7},
                  taps ? lasts_s : random.uniform(0.1, lasts_s));
      until_s = time_s + lasts_s;
      if (random.uniform(0.0, 1.0) < 0.2) falcon.use(static_cast<StrategyId>(random.uniform(0.0, 3.0)));
      if (random.uniform(0.0, 1.0) < 0.1) falcon.disarm();
    }
    const Vector<2> way = tremor_and_drift.at(time_s);
    falcon.link().shake_hand({way.x, way.y, 0.5 * (way.x + way.y)}, std::nullopt);
    if (falcon.motors().state == SafetyState::off) falcon.ask_to_arm();
    falcon.step();
    time_s += 0.001;
    const MotorReport& motors = falcon.motors();
    ASSERT_NE(motors.reason, OffReason::calibration) << time_s << " s";
    hour.armings += motors.state == SafetyState::ramp && before == SafetyState::arming ? 1 : 0;
    hour.comings_on += motors.state == SafetyState::on && before == SafetyState::ramp ? 1 : 0;
    hour.armed_s += motors.state == SafetyState::on ? 0.001 : 0.0;
    hour.pushed_s += glm::length(motors.sent) > 0.3 ? 0.001 : 0.0;
    before = motors.state;
  }
  hour.seconds += time_s;
}

TEST(RandomHands, AreNeverTakenForMotorsThatDoNotMatch) {
  HandRandom random(20261124);
  const double seconds = is_long_run() ? 3600.0 : 360.0;
  Hour hour;
  while (hour.seconds < seconds && !testing::Test::HasFatalFailure()) spend(20.0, random, hour);
  // It was about something.
  EXPECT_GT(hour.armed_s, 0.3 * hour.seconds);
  EXPECT_GT(hour.pushed_s, 0.1 * hour.seconds);
}

// The same people, with a device that has some motors mixed up or the wrong way round: it never pushes against them.
TEST(RandomHands, NeverFeelMotorsThatDoNotMatch) {
  HandRandom random(20261125);
  const int people = is_long_run() ? 600 : 60;
  int found_out = 0;
  for (int i = 0; i < people; ++i) {
    Person who = person(random);
    who.options.calibration.motor_of_leg = wrong_motors[static_cast<std::size_t>(i) % wrong_motors.size()];
    HeldFalcon falcon(who.options);
    const TremorAndDriftMotion tremor_and_drift(who.tremor_and_drift);
    falcon.lead({-0.03, 0.0}, 0.3);
    for (int ms = 0; ms < 6000; ++ms) {
      if (ms % 1500 == 800) falcon.lead(HeldFalcon::free_place, 0.2);
      if (ms % 1500 == 1400) falcon.lead(HeldFalcon::deep_place, 0.1);
      const Vector<2> way = tremor_and_drift.at(0.001 * ms);
      falcon.link().shake_hand({way.x, way.y, 0.5 * (way.x + way.y)}, std::nullopt);
      if (falcon.motors().state == SafetyState::off) falcon.ask_to_arm();
      falcon.step();
      ASSERT_EQ(falcon.motors().gain, 0.0) << i << ", " << who.options.stiffness << " N/m";
      if (falcon.motors().reason != OffReason::calibration) continue;
      ++found_out;
      break;
    }
  }
  // Some are too lively for the check, and wait.
  EXPECT_GT(found_out, people / 2);
}

}  // namespace
}  // namespace ghostforce::random_hands_test
