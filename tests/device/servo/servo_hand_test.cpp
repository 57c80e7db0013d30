// The servo while it measures the hand: when the tones sound, what they tell, and how the belief follows.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/belief.h"
#include "device/input/mouse_input.h"
#include "device/servo/servo.h"
#include "tests/device/servo/servo_scenes.h"

namespace ghostforce::servo_hand_test {
namespace {

// A hand of 200 N/m that holds its goal 20 mm inside a wall at 45°, under motors along x.
class ServoHand : public testing::Test {
 protected:
  ServoHand() {
    command_.settings = slanted_wall().settings;
    command_.settings.active = StrategyId::anisotropic;
    command_.settings.stiffnesses = {200.0, {}, 600.0, 600.0, 1e5, {}};
    command_.restart_state = state_at_start(Vector<2>(0.014, -0.014));
    servo_ = std::make_unique<Servo>(std::make_unique<MouseInput>(), command_);
  }

  MouseInput& mouse() { return dynamic_cast<MouseInput&>(servo_->input()); }
  void send() { servo_->send(command_); }
  // The samples of so many ticks.
  std::vector<Sample> samples(std::int64_t ticks) {
    std::vector<Sample> samples;
    for (std::int64_t i = 0; i < ticks; ++i) {
      servo_->step();
      for (Sample sample; servo_->take_sample(sample);) samples.push_back(sample);
    }
    return samples;
  }
  void change(const auto& edit) {
    edit(command_.settings);
    ++command_.settings_generation;
    send();
  }
  const HandReading& hand() { return servo_->newest().hand; }

  ServoCommand command_;
  std::unique_ptr<Servo> servo_;
};

double greatest_tone(const std::vector<Sample>& samples) {
  double greatest = 0.0;
  for (const Sample& sample : samples) greatest = std::max(greatest, glm::length(sample.tone));
  return greatest;
}

TEST_F(ServoHand, IsLeftAloneUnlessAsked) {
  const std::vector<Sample> quiet = samples(3000);
  EXPECT_EQ(greatest_tone(quiet), 0.0);
  EXPECT_EQ(hand().estimate.why, HandUnknown::no_tones);
  EXPECT_FALSE(hand().estimate.has_number());
  EXPECT_FALSE(hand().is_measuring);
}

TEST_F(ServoHand, IsKnownAfterTheWindowUnderEachStrategy) {
  for (const Strategy& strategy : strategy_catalog()) {
    SCOPED_TRACE(strategy.name);
    change([&](Settings& settings) { settings.active = strategy.id; });
    command_.measures_hand = true;
    send();
    samples(2000);
    EXPECT_FALSE(hand().estimate.is_known()) << "the window is not full yet";
    EXPECT_LT(hand().filled, 1.0);
    samples(1000);
    ASSERT_TRUE(hand().estimate.is_known()) << sentence_of(hand().estimate.why);
    // The bound for a hand without noise.
    EXPECT_NEAR(hand().estimate.k_u, 200.0, 0.005 * 200.0);
    // Of the tick: backward Euler damps by up to m dt ω²/2 + k dt/2, 0.6 N·s/m at 16 Hz.
    EXPECT_NEAR(hand().estimate.mass, command_.settings.mass, 0.01 * command_.settings.mass);
    EXPECT_NEAR(hand().estimate.damping, command_.settings.damping, 0.7);
    EXPECT_EQ(hand().filled, 1.0);
    EXPECT_LE(hand().at_s, servo_->newest().snapshot.time_s);
  }
}

TEST_F(ServoHand, TonesLieAlongTheMotorAndFadeInAndOut) {
  change([](Settings& settings) { settings.actuated_angle = 0.3; });
  command_.measures_hand = true;
  send();
  const std::vector<Sample> begin = samples(200);
  const Vector<2> across = direction_at(0.3 + 0.5 * std::acos(-1.0));
  for (std::size_t i = 0; i < begin.size(); ++i) {
    EXPECT_NEAR(glm::dot(begin[i].tone, across), 0.0, 1e-16);
    // Their envelope rises by a tick's share of 0.2 s.
    EXPECT_LE(glm::length(begin[i].tone), usual_tone_force * static_cast<double>(i + 1) / 200.0 + 1e-12);
  }
  const double full = greatest_tone(samples(1000));
  EXPECT_LE(full, usual_tone_force);
  EXPECT_GT(full, 0.9 * usual_tone_force) << "both tones peak together within a second";
  command_.measures_hand = false;
  send();
  EXPECT_GT(greatest_tone(samples(100)), 0.0) << "nothing jumps";
  samples(100);
  EXPECT_EQ(greatest_tone(samples(100)), 0.0);
}

TEST_F(ServoHand, TonesAreOffOutOfContact) {
  command_.measures_hand = true;
  send();
  samples(2500);
  ASSERT_TRUE(hand().estimate.is_known());
  mouse().move_to({-0.03, 0.03}, 0.1);
  samples(1000);
  EXPECT_EQ(greatest_tone(samples(500)), 0.0);
  EXPECT_EQ(hand().estimate.why, HandUnknown::no_contact);
  EXPECT_FALSE(hand().estimate.has_number());
  EXPECT_TRUE(hand().is_measuring) << "and they come back";
  mouse().move_to({0.01, -0.01}, 0.1);
  samples(3000);
  EXPECT_TRUE(hand().estimate.is_known());
}

// The tone is part of the held force of (23), of the active device alone.
TEST_F(ServoHand, TonesShakeTheActiveDeviceAlone) {
  change([](Settings& settings) { settings.active = StrategyId::naive; });
  Servo quiet(std::make_unique<MouseInput>(), command_);
  command_.measures_hand = true;
  send();
  double greatest = 0.0;
  for (int i = 0; i < 1000; ++i) {
    quiet.step();
    servo_->step();
    const Snapshot& with = servo_->newest().snapshot;
    const Snapshot& without = quiet.newest().snapshot;
    for (const StrategyId id : {StrategyId::full, StrategyId::anisotropic}) {
      ASSERT_EQ(with.strategies[index_of(id)].device, without.strategies[index_of(id)].device);
    }
    const std::size_t active = index_of(StrategyId::naive);
    greatest = std::max(greatest, glm::distance(with.strategies[active].device, without.strategies[active].device));
  }
  EXPECT_GT(greatest, 1e-4);
}

TEST_F(ServoHand, ARestartOrAnotherStrategyBeginsTheWindowAnew) {
  command_.measures_hand = true;
  send();
  samples(2500);
  ASSERT_TRUE(hand().estimate.is_known());
  change([](Settings& settings) { settings.active = StrategyId::naive; });
  samples(200);
  EXPECT_EQ(hand().estimate.why, HandUnknown::collecting);
  samples(2500);
  ASSERT_TRUE(hand().estimate.is_known());
  ++command_.restarts_asked;
  send();
  samples(200);
  EXPECT_FALSE(hand().estimate.is_known());
  EXPECT_LT(hand().filled, 0.1);
}

TEST_F(ServoHand, AnotherRateMeasuresAnew) {
  for (const double rate : {500.0, 2000.0}) {
    SCOPED_TRACE(rate);
    change([&](Settings& settings) { settings.rate = rate; });
    command_.measures_hand = true;
    send();
    samples(std::llround(3.0 * rate));
    ASSERT_TRUE(hand().estimate.is_known()) << sentence_of(hand().estimate.why);
    // At 500 Hz the tick's own delay shows: (ω dt)²/12 of m ω² is 0.3 % of the mass.
    EXPECT_NEAR(hand().estimate.k_u, 200.0, 0.005 * 200.0);
  }
  change([](Settings& settings) { settings.rate = 100.0; });
  samples(400);
  EXPECT_EQ(hand().estimate.why, HandUnknown::rate_too_low);
}

// What a hand feels goes on: a tone that is cut off is a knock.
TEST_F(ServoHand, AnotherRateDoesNotCutTheTonesOff) {
  command_.measures_hand = true;
  send();
  Vector<2> before = samples(1000).back().tone;
  change([](Settings& settings) { settings.rate = 2000.0; });
  // The two tones at their steepest, from one tick to the next at the slower rate.
  const double steepest = usual_tone_force * 2.0 * std::numbers::pi * (low_tone_hz + 0.6 * high_tone_hz) / 1.6 / 1000.0;
  for (const Sample& sample : samples(400)) {
    EXPECT_LE(glm::distance(sample.tone, before), 1.001 * steepest);
    before = sample.tone;
  }
  EXPECT_EQ(hand().tone_gain, 1.0);
}

// --- The belief that follows ---

double ratio_of(const Sample& sample) {
  return tracking_ratio(sample.settings.stiffnesses);
}

TEST_F(ServoHand, TheBeliefFollowsNoFasterThanTheLoopCanTake) {
  for (const double believed : {40.0, 900.0}) {
    SCOPED_TRACE(believed);
    change([&](Settings& settings) { settings.stiffnesses.believed_k_u = believed; });
    command_.belief_follows_hand = true;
    send();
    const std::vector<Sample> all = samples(7000);
    std::size_t changed_at = 0;
    int changes = 0;
    for (std::size_t i = 1; i < all.size(); ++i) {
      const double way = std::log(ratio_of(all[i]) / ratio_of(all[i - 1]));
      if (way == 0.0) continue;
      ++changes;
      EXPECT_TRUE(changed_at == 0 || i - changed_at >= 100) << "more often than every 0.1 s, at " << i;
      changed_at = i;
      // Rounding alone.
      EXPECT_LE(way, 0.3 + 1e-12);
      EXPECT_GE(way, -0.1 - 1e-12);
    }
    EXPECT_GT(changes, 2);
    const double end = believed_user_stiffness(all.back().settings.stiffnesses);
    EXPECT_NEAR(std::log(end / 200.0), 0.0, BeliefFollower::hysteresis + 0.005);
    EXPECT_EQ(hand().believed_k_u, end);
    command_.belief_follows_hand = false;
    send();
    samples(1);
  }
}

TEST_F(ServoHand, WhileItFollowsTheBeliefIsTheServosAlone) {
  change([](Settings& settings) { settings.stiffnesses.chosen_tracking_ratio = 1.5; });
  command_.belief_follows_hand = true;
  send();
  std::vector<Sample> all = samples(5000);
  EXPECT_FALSE(all.back().settings.stiffnesses.chosen_tracking_ratio);
  const auto followed = all.back().settings.stiffnesses.believed_k_u;
  change([](Settings& settings) {
    settings.stiffnesses.believed_k_u = 5.0;
    settings.wall_normal_angle += 0.01;
  });
  all = samples(10);
  EXPECT_EQ(all.back().settings.stiffnesses.believed_k_u, followed);
  EXPECT_EQ(all.back().settings.wall_normal_angle, command_.settings.wall_normal_angle);
  command_.belief_follows_hand = false;
  change([](Settings& settings) { settings.stiffnesses.believed_k_u = 5.0; });
  all = samples(10);
  EXPECT_EQ(all.back().settings.stiffnesses.believed_k_u, 5.0);
}

TEST_F(ServoHand, AnUnknownHandIsHeldAndThenBelievedWithLeastRegret) {
  command_.belief_follows_hand = true;
  send();
  samples(5000);
  mouse().move_to({-0.03, 0.03}, 0.1);
  samples(2500);
  EXPECT_NEAR(hand().believed_k_u, 200.0, 20.0) << "held";
  samples(6000);
  const double fallback = least_regret_belief(command_.settings);
  EXPECT_EQ(hand().believed_k_u, fallback);
  EXPECT_GT(std::abs(std::log(fallback / 200.0)), 0.05) << "else this shows nothing";
}

TEST_F(ServoHand, RefusesAToneForceOutOfRange) {
  command_.measures_hand = true;
  for (const double force : {-0.1, 0.5, std::nan("")}) {
    command_.tone_force = force;
    send();
    servo_->step();
  }
  EXPECT_EQ(servo_->newest().refused_commands, 3U);
  EXPECT_EQ(greatest_tone(samples(1000)), 0.0);
  command_.tone_force = 0.2;
  send();
  const double quiet = greatest_tone(samples(1000));
  EXPECT_GT(quiet, 0.1);
  EXPECT_LE(quiet, 0.2);
}

}  // namespace
}  // namespace ghostforce::servo_hand_test
