#include "device/input/unsteady_input.h"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/simulate.h"
#include "device/input/circle_input.h"
#include "device/input/mouse_input.h"
#include "device/input/scripted_input.h"
#include "tests/device/servo/servo_scenes.h"

namespace ghostforce::unsteady_input_test {
namespace {

Scene restless_wall() {
  Scene scene = slanted_wall();
  scene.stiffness_path = {{100.0, 800.0, 150.0}, {0.0, 0.6, 1.1}};
  scene.tremor_and_drift = {.tremor_rms = 0.0004, .drift_speed = 0.01, .seed = 5.0};
  scene.settings.encoder_step = 60e-6;
  return scene;
}

std::unique_ptr<Input> script_of(const Scene& scene) {
  return in_hand_of(scene, std::make_unique<ScriptedInput>(scene.goal), false);
}

TEST(UnsteadyInputTest, ASteadyHandNeedsNoneOfIt) {
  auto mouse = std::make_unique<MouseInput>();
  const Input* const same = mouse.get();
  EXPECT_EQ(in_hand_of(slanted_wall(), std::move(mouse), false).get(), same);
}

// The same loop by two ways, bit for bit: a servo that is given the hand tick by tick, and the scene that is simulated.
TEST(UnsteadyInputTest, TheServosHandIsTheSimulatedOne) {
  const Scene scene = restless_wall();
  std::vector<Snapshot> wanted;
  simulate(scene, last_tick(scene), [&](const Snapshot& snapshot) { wanted.push_back(snapshot); });
  Servo servo(script_of(scene), start_of(scene));
  for (const Snapshot& tick : wanted) {
    servo.step();
    ASSERT_EQ(servo.newest().snapshot.tick, tick.tick);
    expect_same(servo.newest().snapshot, tick);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(UnsteadyInputTest, SettingsDoNotChangeWithTheHand) {
  const Scene scene = restless_wall();
  Servo servo(script_of(scene), start_of(scene));
  for (int k = 0; k < 1000; ++k) servo.step();
  std::size_t samples = 0;
  for (Sample sample; servo.take_sample(sample); ++samples) ASSERT_EQ(sample.settings, scene.settings);
  EXPECT_EQ(samples, 1000U);
}

// A recorded hand trembled when it was recorded.
TEST(UnsteadyInputTest, AHandWithItsOwnUnrestGetsTheStiffnessAlone) {
  const Scene scene = restless_wall();
  const auto input = in_hand_of(scene, std::make_unique<ScriptedInput>(scene.goal), true);
  for (int tick = 1; tick < 1500; ++tick) {
    ASSERT_EQ(input->goal(tick, 1000.0), goal_at(scene.goal, tick / 1000.0));
    ASSERT_EQ(input->user_stiffness(tick, 1000.0), stiffness_at(scene.stiffness_path, tick / 1000.0));
  }
}

// A mouse that nobody moves holds the goal where the run goes on, wherever the hand was just then.
TEST(UnsteadyInputTest, AMouseMeansThePlaceAroundWhichTheHandMoves) {
  const Scene scene = restless_wall();
  const TremorAndDriftMotion tremor_and_drift(scene.tremor_and_drift);
  const Vector<2> meant(0.01, -0.02);
  for (const std::int64_t begin : {std::int64_t{0}, std::int64_t{3000}}) {
    const auto input = in_hand_of(scene, std::make_unique<MouseInput>(), false);
    input->restart(tremor_and_drift.shaken(meant, time_of(begin, 1000.0)));
    for (std::int64_t tick = begin + 1; tick < begin + 2000; ++tick) {
      const Vector<2> goal = input->goal(tick, 1000.0);
      // Two roundings of a number of that size.
      ASSERT_NEAR(goal.x, tremor_and_drift.shaken(meant, time_of(tick, 1000.0)).x, 1e-17);
      ASSERT_NEAR(goal.y, tremor_and_drift.shaken(meant, time_of(tick, 1000.0)).y, 1e-17);
    }
  }
}

TEST(UnsteadyInputTest, LeadsMouseAndCircle) {
  const Scene scene = restless_wall();
  auto mouse = std::make_unique<MouseInput>();
  MouseInput& pointer = *mouse;
  const auto input = in_hand_of(scene, std::move(mouse), false);
  input->restart(Vector<2>(0.0));
  input->goal(1, 1000.0);
  pointer.move_to({0.03, 0.0}, 0.01);
  Vector<2> goal(0.0);
  for (std::int64_t tick = 2; tick < 100; ++tick) goal = input->goal(tick, 1000.0);
  EXPECT_NEAR(goal.x, 0.03, 0.01);
  EXPECT_EQ(input->haptic_device(), nullptr);

  const Circle circle{.center = {0.0, 0.0}, .radius = 0.01};
  const auto round = in_hand_of(scene, std::make_unique<CircleInput>(circle), false);
  CircleInput still(circle);
  round->restart(Vector<2>(0.0));
  still.restart(Vector<2>(0.0));
  const TremorAndDriftMotion tremor_and_drift(scene.tremor_and_drift);
  for (std::int64_t tick = 1; tick < 3000; ++tick) {
    ASSERT_EQ(round->goal(tick, 1000.0), tremor_and_drift.shaken(still.goal(tick, 1000.0), time_of(tick, 1000.0)));
  }
}

}  // namespace
}  // namespace ghostforce::unsteady_input_test
