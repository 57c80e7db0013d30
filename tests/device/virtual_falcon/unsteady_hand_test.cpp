// The hand at the virtual Falcon is the scene's: as stiff as its path says, and as restless.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/device/virtual_falcon/rehearsal.h"

namespace ghostforce::unsteady_hand_test {
namespace {

TEST(UnsteadyHand, IsThatOfTheMomentOfTheRun) {
  const Scene scene = restless_scene();
  const TremorAndDriftMotion tremor_and_drift(scene.tremor_and_drift);
  Rehearsal rehearsal({}, {}, 0.0, scene);
  rehearsal.turn_on();
  const Vector<2> meant(0.005, -0.005);
  rehearsal.input().move_to(meant, 0.1);
  rehearsal.run(0.5);
  for (int tick = 0; tick < 2000; ++tick) {
    // What the hand is told in a tick, the device feels until the next one.
    const double told_s = rehearsal.report().snapshot.time_s;
    const SimulatedHand& hand = rehearsal.input().link().hand();
    ASSERT_EQ(hand.stiffness(), stiffness_at(scene.stiffness_path, told_s));
    const Vector<2> goal = FalconPlane(FalconCalibration{}, Vector<2>(0.0)).in_scene(hand.goal());
    // Some roundings on the way into the workspace and back.
    ASSERT_LT(glm::length(goal - tremor_and_drift.shaken(meant, told_s)), 1e-15);
    rehearsal.step();
  }
  ASSERT_EQ(rehearsal.motors().state, SafetyState::on);
}

// What pulls at the real arm is that hand: held in one place, it wanders.
TEST(UnsteadyHand, MovesTheHandle) {
  const auto travelled = [](const Scene& scene) {
    Rehearsal rehearsal({}, {}, 0.0, scene);
    EXPECT_TRUE(rehearsal.run_until_state(FalconState::idle));
    rehearsal.input().move_to(Rehearsal::free_place, 0.5);
    rehearsal.run(2.0);
    double way = 0.0;
    Vector<2> before = rehearsal.tip();
    for (int tick = 0; tick < 1000; ++tick) {
      rehearsal.step();
      way += glm::length(rehearsal.tip() - before);
      before = rehearsal.tip();
    }
    return way;
  };
  EXPECT_LT(travelled(rehearsal_scene()), 1e-4);
  // A second at 4 mm/s and more.
  EXPECT_GT(travelled(restless_scene()), 1e-3);
}

// Time of the model that stands still is the hand's too.
TEST(UnsteadyHand, StandsStillWhileTimeIsPaused) {
  Rehearsal rehearsal({}, {}, 0.0, restless_scene());
  ASSERT_TRUE(rehearsal.run_until_state(FalconState::idle));
  rehearsal.run(3.0);  // homing has an end too
  rehearsal.command().paused = true;
  rehearsal.run(0.1);
  const Vector<3> goal = rehearsal.input().link().hand().goal();
  const double stiffness = rehearsal.input().link().hand().stiffness();
  rehearsal.run(1.0);
  EXPECT_EQ(rehearsal.input().link().hand().goal(), goal);
  EXPECT_EQ(rehearsal.input().link().hand().stiffness(), stiffness);
}

TEST(UnsteadyHand, TellsTheServoHowStiffItIs) {
  const Scene scene = restless_scene();
  VirtualFalconInput unsteady({}, {}, scene, VirtualFalconInput::Clock::stepped);
  EXPECT_EQ(unsteady.user_stiffness(6000, 1000.0), 250.0);
  VirtualFalconInput steady({}, {}, rehearsal_scene(), VirtualFalconInput::Clock::stepped);
  EXPECT_FALSE(steady.user_stiffness(6000, 1000.0).has_value());
}

}  // namespace
}  // namespace ghostforce::unsteady_hand_test
