// The servo while it measures the hand at motors: what they get, and what that tells of a hand that really pulls.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "device/servo/servo.h"
#include "tests/device/servo/motor_settings.h"

namespace ghostforce::servo_hand_motors_test {
namespace {

// A handle with a mass, in a hand that pulls it to a goal; motors push it. A clock that only waiting moves. `gain`: of
// force at the handle for force in the scene; ways in the scene are as much longer.
class HeldHandle final : public Input, public HapticDevice {
 public:
  void restart(const Vector<2>& /*goal*/) noexcept override {}
  Vector<2> goal(std::int64_t /*tick*/, double /*rate*/) noexcept override { return aim; }
  HapticDevice* haptic_device() noexcept override { return this; }

  std::int64_t now_ns() const noexcept override { return now; }
  void wait_until(std::int64_t deadline_ns) noexcept override {
    // Twenty steps a tick: what is left of their delay is far below the bounds here.
    constexpr int steps = 20;
    const double dt = static_cast<double>(deadline_ns - now) * 1e-9 / steps;
    for (int i = 0; i < steps; ++i) {
      const Vector<2> force = (armed ? pushed / gain : Vector<2>(0.0)) + stiffness * (aim - place) - damping * velocity;
      velocity += dt / mass * force;
      place += dt * velocity;
    }
    now = deadline_ns;
    if (answers) answered_ns = now;
  }
  HandleReading read() noexcept override {
    return {.position = place,
            .speed = glm::length(velocity),
            .is_known = true,
            .time_ns = answered_ns,
            .is_ready = true,
            .is_healthy = true};
  }
  double force_at_handle() const noexcept override { return gain; }
  Vector<2> set_force(const Vector<2>& force, bool is_armed) noexcept override {
    pushed = force;
    armed = is_armed;
    return force;
  }
  double force_uncertainty() const noexcept override { return 1.0; }
  void shut_down() noexcept override { armed = false; }

  double stiffness = 310.0;
  double mass = 0.25;
  double damping = 6.0;
  double gain = 1.0;
  Vector<2> aim{-0.02, 0.02};
  Vector<2> place{-0.02, 0.02};
  Vector<2> velocity{0.0};
  Vector<2> pushed{0.0};
  bool armed = false;
  bool answers = true;
  std::int64_t now = 1'000'000'000;
  std::int64_t answered_ns = now;
};

class ServoHandAtMotors : public testing::Test {
 protected:
  ServoHandAtMotors() {
    auto input = std::make_unique<HeldHandle>();
    handle_ = input.get();
    command_.settings = motor_settings(StrategyId::anisotropic);
    command_.settings.wall_normal_angle = std::acos(-1.0) * 0.75;
    command_.settings.stiffnesses.believed_k_u = 100.0;
    command_.restart_state = state_at_start(handle_->place);
    servo_ = std::make_unique<Servo>(std::move(input), command_);
  }

  std::vector<Sample> run(double seconds) {
    std::vector<Sample> samples;
    for (std::int64_t i = 0; i < std::llround(seconds * 1000.0); ++i) {
      ++command_.heartbeats;
      servo_->send(command_);
      servo_->step();
      for (Sample sample; servo_->take_sample(sample);) samples.push_back(sample);
    }
    return samples;
  }
  void turn_on_and_press() {
    ++command_.arms_asked;
    run(1.2);
    ASSERT_EQ(motors().state, SafetyState::on);
    handle_->aim = {0.008, -0.008};
    run(0.5);
  }
  const HandReading& hand() { return servo_->newest().hand; }
  const MotorReport& motors() { return servo_->newest().motors; }

  HeldHandle* handle_ = nullptr;
  ServoCommand command_;
  std::unique_ptr<Servo> servo_;
};

TEST_F(ServoHandAtMotors, KnowsTheHandThatHoldsTheHandle) {
  turn_on_and_press();
  command_.measures_hand = true;
  run(2.5);
  ASSERT_TRUE(hand().estimate.is_known()) << sentence_of(hand().estimate.why);
  EXPECT_NEAR(hand().estimate.k_u, 310.0, 0.005 * 310.0);
  EXPECT_NEAR(hand().estimate.mass, 0.25, 0.01 * 0.25);
  EXPECT_NEAR(hand().estimate.damping, 6.0, 0.1 * 6.0) << "of the pairing of a tick's force with the way in it";
}

TEST_F(ServoHandAtMotors, AWayThatIsShownEnlargedChangesNoStiffness) {
  handle_->gain = 0.4;
  turn_on_and_press();
  command_.measures_hand = true;
  run(2.5);
  ASSERT_TRUE(hand().estimate.is_known()) << sentence_of(hand().estimate.why);
  EXPECT_NEAR(hand().estimate.k_u, 310.0, 0.005 * 310.0);
}

TEST_F(ServoHandAtMotors, TonesAreAddedToTheForceAndBoundedWithIt) {
  turn_on_and_press();
  command_.measures_hand = true;
  const TickCoefficients<2> coefficients = coefficients_of(command_.settings);
  const auto& own = coefficients.strategies[index_of(StrategyId::anisotropic)];
  double greatest = 0.0;
  for (const Sample& sample : run(1.0)) {
    const auto& now = sample.snapshot.strategies[index_of(StrategyId::anisotropic)];
    const Vector<2> wanted = own.rendering * (now.proxy - now.device);
    // The same sum, in another order of its roundings.
    EXPECT_NEAR(glm::distance(sample.sent, wanted + sample.tone), 0.0, 1e-12);
    EXPECT_EQ(sample.tone.y, 0.0) << "one motor, along x";
    greatest = std::max(greatest, std::abs(sample.tone.x));
  }
  EXPECT_GT(greatest, 0.35);
  command_.safety.force_limit = 1.0;
  handle_->aim = {0.03, -0.03};
  run(0.3);
  for (const Sample& sample : run(0.5)) EXPECT_LE(glm::length(sample.sent), 1.0 + 1e-12);
  EXPECT_TRUE(motors().is_saturated);
  run(0.2);
  EXPECT_EQ(hand().estimate.why, HandUnknown::at_limit);
  EXPECT_FALSE(hand().estimate.has_number());
}

TEST_F(ServoHandAtMotors, NothingIsSentInFreeSpaceOrWhileTheyAreOff) {
  command_.measures_hand = true;
  ++command_.arms_asked;
  for (const Sample& sample : run(2.0)) EXPECT_EQ(sample.sent, Vector<2>(0.0));
  ASSERT_EQ(motors().state, SafetyState::on);
  handle_->aim = {0.008, -0.008};
  run(2.7);
  ASSERT_TRUE(hand().estimate.is_known());
  ++command_.offs_asked;
  run(0.3);
  ASSERT_EQ(motors().state, SafetyState::off);
  for (const Sample& sample : run(1.0)) EXPECT_EQ(sample.sent, Vector<2>(0.0));
}

// A cross-fade would be a low pass of 150 ms on the whole force for as long as the belief moves.
TEST_F(ServoHandAtMotors, TheForceIsNotHeldBackWhileTheBeliefMoves) {
  turn_on_and_press();
  command_.belief_follows_hand = true;
  run(2.3);
  int moves = 0;
  std::optional<double> before;
  for (const Sample& sample : run(1.0)) {
    const auto& now = sample.snapshot.strategies[index_of(StrategyId::anisotropic)];
    const auto coefficients = coefficients_of(sample.settings);
    const Vector<2> wanted =
        coefficients.strategies[index_of(StrategyId::anisotropic)].rendering * (now.proxy - now.device);
    EXPECT_NEAR(glm::distance(sample.sent, wanted + sample.tone), 0.0, 1e-12);
    if (before && before != sample.settings.stiffnesses.believed_k_u) ++moves;
    before = sample.settings.stiffnesses.believed_k_u;
  }
  EXPECT_GT(moves, 3) << "else nothing was shown";
}

TEST_F(ServoHandAtMotors, TheInferredGoalDoesNotTrembleWithTheTones) {
  turn_on_and_press();
  command_.settings.stiffnesses.believed_k_u = 310.0;
  ++command_.settings_generation;
  run(0.5);
  command_.measures_hand = true;
  run(1.0);
  Vector<2> shown(1.0, -1.0);  // the least and the greatest
  Vector<2> inferred = shown;
  const auto note = [](double x, Vector<2>& range) { range = {std::min(x, range[0]), std::max(x, range[1])}; };
  for (const Sample& sample : run(1.0)) {
    note(sample.snapshot.goal.x, shown);
    const Vector<2> device = sample.snapshot.strategies[index_of(StrategyId::anisotropic)].device;
    note((device - sample.sent / 310.0).x, inferred);
  }
  // A low pass of 2 Hz leaves 0.55 of 3 Hz and 0.12 of 16 Hz.
  EXPECT_GT(inferred[1] - inferred[0], 5e-4) << "else this shows nothing";
  EXPECT_LT(shown[1] - shown[0], 0.6 * (inferred[1] - inferred[0]));
  EXPECT_NEAR(0.5 * (shown[0] + shown[1]), 0.008, 2e-4);
}

TEST_F(ServoHandAtMotors, AGapInTheReadingsIsNoWindow) {
  turn_on_and_press();
  command_.measures_hand = true;
  run(2.5);
  ASSERT_TRUE(hand().estimate.is_known());
  handle_->answers = false;
  run(0.008);
  handle_->answers = true;
  run(1.0);
  ASSERT_EQ(motors().state, SafetyState::on) << "such a gap is no fault";
  EXPECT_EQ(hand().estimate.why, HandUnknown::damaged);
  EXPECT_FALSE(hand().estimate.has_number());
  run(1.5);
  EXPECT_TRUE(hand().estimate.is_known());
}

// A device with its motors off has a simulated one beside it, whose hand is not the person's.
TEST_F(ServoHandAtMotors, ADeviceWithoutItsMotorsMeasuresNobody) {
  handle_->aim = {0.008, -0.008};
  command_.belief_follows_hand = true;
  for (const Sample& sample : run(3.0)) EXPECT_EQ(sample.tone, Vector<2>(0.0));
  EXPECT_EQ(hand().estimate.why, HandUnknown::no_tones);
  EXPECT_NEAR(hand().believed_k_u, 100.0, 1e-9) << "held";
}

TEST_F(ServoHandAtMotors, TheGoalInFrontOfTheWallIsTheHandle) {
  turn_on_and_press();
  command_.measures_hand = true;
  run(1.0);
  handle_->aim = {-0.02, 0.02};
  int fading = 0;
  for (const Sample& sample : run(0.6)) {
    const auto& device = sample.snapshot.strategies[index_of(StrategyId::anisotropic)];
    if (depth(wall_of(sample.settings), device.device) > 0.0) continue;
    if (sample.tone != Vector<2>(0.0)) ++fading;
    // What is left of the wall's force on its way down, 500 N/s, lasts a few ticks.
    const Vector<2> rest = sample.sent - sample.tone;
    EXPECT_NEAR(glm::distance(sample.snapshot.goal, device.device), glm::length(rest) / 100.0, 1e-9);
  }
  EXPECT_GT(fading, 20) << "else this shows nothing";
}

TEST_F(ServoHandAtMotors, AnotherAxisBeginsTheWindowAnew) {
  turn_on_and_press();
  command_.measures_hand = true;
  run(2.5);
  ASSERT_TRUE(hand().estimate.is_known());
  command_.settings.actuated_angle = 0.02;
  ++command_.settings_generation;
  run(0.5);
  EXPECT_FALSE(hand().estimate.is_known());
  EXPECT_LT(hand().filled, 0.3);
}

}  // namespace
}  // namespace ghostforce::servo_hand_motors_test
