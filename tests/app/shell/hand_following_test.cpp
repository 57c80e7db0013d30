// A belief that follows the hand, in the window: who changes it, who wins, and what keeps it.
#include "app/shell/hand_following.h"

#include <cmath>
#include <string>

#include "app/state/lesson_guide.h"
#include "app/state/set_up_of.h"
#include "app/state/stiffness_probe_guide.h"
#include "app/state/user_measurement_guide.h"
#include "tests/app/shell/driven_window.h"

namespace ghostforce::hand_following_test {
namespace {

class HandFollowingWindow : public DrivenWindow {
 protected:
  static constexpr double given = 200.0;  // of wall45, whose hand presses into the wall from the start [N/m]

  Stiffnesses& stiffnesses() { return session().settings.stiffnesses; }
  std::optional<double> believed() { return stiffnesses().believed_k_u; }
  const HandReading& hand() const { return application_->report().hand; }
  // Of model time, at 200 ticks a frame: drawing is what takes the time.
  void seconds(double count) { frames(static_cast<int>(std::lround(5.0 * count)), 200); }
  void follow() {
    session().belief_source = BeliefSource::live;
    frames(2);
  }
  // From a belief that is far off until the hand is known and the belief has come to it: at most 2.5 s of measuring, and
  // ln(1 + 600/200)/(1/s) at the slower of the two rates.
  void follow_until_it_is_right() {
    stiffnesses().believed_k_u = 900.0;
    frames(2);
    follow();
    seconds(5.0);
    ASSERT_TRUE(believed());
    // A hand without noise is known within 0.5 %.
    ASSERT_NEAR(*believed(), given, 0.005 * given);
  }
};

TEST_F(HandFollowingWindow, TheServoAloneChangesTheBeliefAndTheSessionShowsIt) {
  stiffnesses().believed_k_u = 900.0;
  stiffnesses().chosen_tracking_ratio = 2.5;
  frames(2);
  follow();
  EXPECT_EQ(stiffnesses().chosen_tracking_ratio, std::nullopt) << "the ratio follows the belief";
  EXPECT_TRUE(hand().is_measuring);
  const std::uint32_t generation = application_->report().settings_generation;
  for (int i = 0; i < 40; ++i) {
    seconds(0.2);
    EXPECT_EQ(believed(), hand().believed_k_u);
  }
  EXPECT_NEAR(*believed(), given, 0.005 * given) << "a hand without noise is known within 0.5 %";
  EXPECT_EQ(application_->report().settings_generation, generation) << "nothing was sent back";
  EXPECT_EQ(session().belief_source, BeliefSource::live);
}

TEST_F(HandFollowingWindow, FollowsAHandThatStiffens) {
  follow_until_it_is_right();
  stiffnesses().k_u = 500.0;
  seconds(6.0);
  EXPECT_NEAR(*believed(), 500.0, 0.1 * 500.0) << "nearer than the follower's hysteresis";
  EXPECT_EQ(session().belief_source, BeliefSource::live) << "another hand is no other belief";
}

TEST_F(HandFollowingWindow, WhoTypesABeliefWins) {
  follow_until_it_is_right();
  stiffnesses().believed_k_u = 700.0;
  frames(2);
  EXPECT_EQ(session().belief_source, BeliefSource::typed);
  seconds(1.0);
  EXPECT_EQ(believed(), 700.0);
  EXPECT_FALSE(hand().is_measuring);
  EXPECT_EQ(hand().believed_k_u, 700.0) << "the servo has it";
}

TEST_F(HandFollowingWindow, WhoTurnsTheRatioWins) {
  follow_until_it_is_right();
  const double before = *believed();
  turn_ratio(session(), 1.5);
  const double ratio = *stiffnesses().chosen_tracking_ratio;
  frames(2);
  EXPECT_EQ(session().belief_source, BeliefSource::typed);
  seconds(1.0);
  EXPECT_EQ(stiffnesses().chosen_tracking_ratio, ratio);
  EXPECT_NEAR(*believed(), before, 1e-9 * before) << "it was the hand's until then";
  EXPECT_FALSE(hand().is_measuring);
}

TEST_F(HandFollowingWindow, BeliefChosenWhileTimeStandsStillIsNotForgotten) {
  session().paused = true;
  frames(2);
  stiffnesses().believed_k_u = 640.0;
  frames(2);
  follow();
  frames(3);
  EXPECT_EQ(believed(), 640.0);
  EXPECT_EQ(session().belief_source, BeliefSource::live);
}

TEST_F(HandFollowingWindow, OtherSettingsChangeWithoutTheBelief) {
  follow_until_it_is_right();
  stiffnesses().k_r = 400.0;
  frames(3);
  seconds(1.0);
  EXPECT_EQ(session().belief_source, BeliefSource::live);
  EXPECT_EQ(stiffnesses().k_r, 400.0);
  EXPECT_NEAR(*believed(), given, 0.1 * given) << "within the follower's hysteresis";
}

TEST_F(HandFollowingWindow, ChoosingTheSourceIsOneStepHoweverOftenTheBeliefChanges) {
  stiffnesses().believed_k_u = 900.0;
  frames(3);
  follow();
  EXPECT_EQ(session().undo_offer.undo, "where the belief comes from");
  seconds(4.0);
  EXPECT_EQ(session().undo_offer.undo, "where the belief comes from");
  press(key::z, modifier::control);
  EXPECT_EQ(session().belief_source, BeliefSource::typed);
  EXPECT_EQ(believed(), 900.0);
  seconds(1.0);
  EXPECT_EQ(hand().believed_k_u, 900.0);
  EXPECT_EQ(session().undo_offer.undo, "the believed k_u");
  press(key::y, modifier::control);
  EXPECT_EQ(session().belief_source, BeliefSource::live);
  seconds(4.0);
  EXPECT_NEAR(*believed(), given, 0.005 * given);
}

TEST_F(HandFollowingWindow, UndoOfAnotherSettingLeavesTheBeliefToTheServo) {
  follow_until_it_is_right();
  const double k_r = stiffnesses().k_r;
  stiffnesses().k_r = 400.0;
  frames(3);
  stiffnesses().k_u = 500.0;
  seconds(6.0);
  const double now = *believed();
  ASSERT_GT(now, 400.0);
  press(key::z, modifier::control);  // the hand
  press(key::z, modifier::control);  // k_r
  EXPECT_EQ(stiffnesses().k_r, k_r);
  EXPECT_EQ(session().belief_source, BeliefSource::live);
  EXPECT_EQ(believed(), now);
}

TEST_F(HandFollowingWindow, ASceneSaysWhatIsBelieved) {
  follow_until_it_is_right();
  act(OpenScene{"fig3-normal"});
  frames(3);
  EXPECT_EQ(session().belief_source, BeliefSource::typed);
  EXPECT_EQ(session().settings, load_scene("fig3-normal").settings);
  press(key::z, modifier::control);
  EXPECT_EQ(session().belief_source, BeliefSource::live) << "as it was before";
  seconds(4.0);
  EXPECT_NEAR(*believed(), given, 0.005 * given);
}

TEST_F(HandFollowingWindow, AnotherInputGoesOnWithIt) {
  follow_until_it_is_right();
  const double now = *believed();
  act(ChooseInput{"virtual-falcon"});
  frames(2, 0);
  EXPECT_EQ(session().input, "virtual-falcon");
  EXPECT_EQ(session().belief_source, BeliefSource::live);
  EXPECT_EQ(believed(), now);
}

TEST_F(HandFollowingWindow, AResetOfTheSettingsEndsIt) {
  follow_until_it_is_right();
  press(key::r);
  EXPECT_EQ(session().belief_source, BeliefSource::live) << "only the motion starts again";
  press(key::r, modifier::alt);
  EXPECT_EQ(session().belief_source, BeliefSource::typed);
  EXPECT_EQ(session().settings, load_scene("wall45").settings);
}

TEST_F(HandFollowingWindow, AGuidedMeasurementGoesBackToIt) {
  follow_until_it_is_right();
  start_measuring(session());
  frames(3);
  EXPECT_EQ(session().belief_source, BeliefSource::typed);
  EXPECT_TRUE(is_measuring(session()));
  EXPECT_FALSE(hand().is_measuring) << "tones would give the answer away";
  cancel_measurement(session());
  frames(3);
  EXPECT_EQ(session().belief_source, BeliefSource::live);
  seconds(0.5);
  EXPECT_TRUE(hand().is_measuring);
}

TEST_F(HandFollowingWindow, AMeasuredBeliefIsOneUntilAnotherIsTyped) {
  start_measuring(session());
  session().measurement.readings.assign(readings_wanted, {4.0, 212.0});
  frames(2);
  believe_measurement(session());
  frames(2);
  EXPECT_EQ(session().belief_source, BeliefSource::measured);
  EXPECT_EQ(believed(), 212.0);
  stiffnesses().k_r = 300.0;
  frames(2);
  EXPECT_EQ(session().belief_source, BeliefSource::measured);
  stiffnesses().believed_k_u = 213.0;
  frames(2);
  EXPECT_EQ(session().belief_source, BeliefSource::typed);
  press(key::z, modifier::control);
  EXPECT_EQ(session().belief_source, BeliefSource::measured);
}

TEST_F(HandFollowingWindow, AProbeOnTheStageMeasuresOnceAndItsResultCanBeBelieved) {
  stiffnesses().believed_k_u = 900.0;
  frames(2);
  for (const double k_u : {given, 500.0}) {
    stiffnesses().k_u = k_u;
    seconds(1.0);
    start_stiffness_probe(session());
    frames(2);
    EXPECT_TRUE(hand().is_measuring);
    seconds(3.0);
    ASSERT_TRUE(session().stiffness_probe.is_known());
    EXPECT_FALSE(hand().is_measuring) << "once";
    EXPECT_EQ(session().belief_source, k_u == given ? BeliefSource::typed : BeliefSource::measured) << "as it was";
    believe_stiffness_probe(session());
    frames(3);
    EXPECT_EQ(session().belief_source, BeliefSource::measured);
    EXPECT_NEAR(*believed(), k_u, 0.005 * k_u) << "a hand without noise is known within 0.5 %";
    EXPECT_EQ(hand().believed_k_u, *believed());
  }
}

TEST_F(HandFollowingWindow, APathOfTheHandIsWhatThePlotCallsGiven) {
  Scene scene = *session().scene;
  scene.stiffness_path = {.values = {200.0, 500.0}, .times = {0.0, 20.0}};
  session().scene = std::make_shared<const Scene>(scene);
  press(key::r);
  const double start_s = now().time_s;
  seconds(1.0);
  const HandPoint* const point = application_->history().hand().at(start_s + 0.5);
  ASSERT_NE(point, nullptr);
  // Linear in between, but for rounding.
  EXPECT_NEAR(*point->given_k_u, 200.0 + 15.0 * point->time_s, 1e-9);
  EXPECT_GT(*point->given_k_u, 200.0);
}

TEST_F(HandFollowingWindow, ALessonComesWithoutItAndGivesItBack) {
  follow_until_it_is_right();
  act(OpenLesson{"ghost"});
  frames(3);
  ASSERT_TRUE(session().lesson);
  EXPECT_EQ(session().belief_source, BeliefSource::typed);
  leave_lesson(session());
  frames(3);
  EXPECT_EQ(session().belief_source, BeliefSource::live);
}

TEST_F(HandFollowingWindow, LookingBackGoesOnWhileTheBeliefMoves) {
  stiffnesses().believed_k_u = 900.0;
  frames(2);
  follow();
  seconds(2.0);
  const double then = now().time_s - 0.5;
  session().stage.looks_back_to_s = then;
  const double before = *believed();
  seconds(2.0);
  ASSERT_NE(believed(), before);
  EXPECT_EQ(session().stage.looks_back_to_s, then);
  EXPECT_EQ(application_->shown().settings.stiffnesses.believed_k_u,
            application_->history().hand().at(then)->believed_k_u);
}

TEST_F(HandFollowingWindow, ASetUpHasTheBeliefOfTheMoment) {
  follow_until_it_is_right();
  EXPECT_EQ(set_up_of(session(), application_->shown()).scene.settings.stiffnesses.believed_k_u, believed());
}

TEST_F(HandFollowingWindow, DialPanelAndPlotSayWhatIsMeasured) {
  session().plots.is_open = true;
  session().plots.tab = PlotTab::hand;
  frames(3);
  EXPECT_TRUE(says("not measured"));
  follow_until_it_is_right();
  for (const char* const words :
       {"live optimal", "hand: 4.0", "Measured live", "200 ± 1 N/m", "live", "believed", "given"}) {
    EXPECT_TRUE(says(words)) << words;
  }
  // As the word, so the needle: it is gone with the contact.
  session().goal = {0.0, 0.05};
  seconds(1.0);
  frames(2);
  EXPECT_FALSE(says("hand: "));
  EXPECT_TRUE(says("Unknown."));
  EXPECT_TRUE(says("holds"));
  start_measuring(session());
  frames(3);
  for (const char* const words : {"live optimal", "hand: ", "Measured live", "given"})
    EXPECT_FALSE(says(words)) << words;
}

}  // namespace
}  // namespace ghostforce::hand_following_test
