// The hand at the virtual Falcon, measured live: encoders, legs, the cable's delay and the safety chain in between.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/device/virtual_falcon/rehearsal.h"

namespace ghostforce::measured_hand_test {
namespace {

TEST(MeasuredHand, IsKnownThroughTheWholeDevice) {
  for (const double k_u : {100.0, 300.0, 600.0}) {
    SCOPED_TRACE(k_u);
    Scene scene = rehearsal_scene();
    scene.settings.stiffnesses.k_u = k_u;
    Rehearsal rehearsal({}, {}, 0.0, scene);
    rehearsal.turn_on();
    rehearsal.input().move_to({0.006, -0.006}, 0.2);
    rehearsal.run(0.5);
    rehearsal.command().measures_hand = true;
    rehearsal.run(3.0);
    ASSERT_EQ(rehearsal.motors().state, SafetyState::on);
    const HandEstimate& hand = rehearsal.report().hand.estimate;
    ASSERT_TRUE(hand.is_known()) << sentence_of(hand.why);
    // What is asked of hands that tremble; this one is still, and its encoders count steps of some 15 µm.
    EXPECT_NEAR(hand.k_u, k_u, 0.01 * k_u);
  }
}

TEST(MeasuredHand, IsFollowedWhileItGripsHarder) {
  Rehearsal rehearsal({}, {}, 0.0, restless_scene());
  rehearsal.turn_on();
  rehearsal.input().move_to({0.008, -0.008}, 0.2);
  rehearsal.command().belief_follows_hand = true;
  rehearsal.run(12.0);
  ASSERT_EQ(rehearsal.motors().state, SafetyState::on);
  // It ends at 400 N/m; the window and the rates lag behind by some two seconds.
  EXPECT_NEAR(std::log(rehearsal.report().hand.believed_k_u / 400.0), 0.0, 0.25);
}

}  // namespace
}  // namespace ghostforce::measured_hand_test
