// Measuring the hand on the stage, in the whole program: the simulated hand's stiffness is known, and is found.
#include <string>

#include "app/state/stiffness_probe_guide.h"
#include "tests/app/shell/driven_window.h"

namespace ghostforce::stiffness_probe_window_test {
namespace {

class StiffnessProbeWindow : public DrivenWindow {
 protected:
  StiffnessProbeWindow() { open({.face = Face::stage}); }

  const StiffnessProbe& probe() { return session().stiffness_probe; }
  // At most for so long.
  void measure(double seconds = 3.0) {
    for (double gone = 0.0; gone < seconds && probe().is_running(); gone += frame_s) frames(1);
  }
  std::string sentence() { return application_->stage_reading().sentence; }
  bool says(const std::string& words) { return sentence().find(words) != std::string::npos; }
};

TEST_F(StiffnessProbeWindow, FindsTheGivenStiffnessAndUsesIt) {
  // Not what is believed of it where nothing is typed.
  session().settings.stiffnesses.k_u = 320.0;
  session().settings.stiffnesses.believed_k_u = 150.0;
  frames(60);
  press(key::s);
  EXPECT_TRUE(probe().is_running());
  EXPECT_TRUE(says("Keep pressing")) << sentence();
  measure();
  ASSERT_TRUE(probe().is_known());
  // The hand has no noise: the estimator alone is off, by half a percent at most.
  EXPECT_NEAR(probe().estimate.k_u, 320.0, 0.005 * 320.0);
  EXPECT_TRUE(says("Your hand: 320")) << sentence();
  press(key::enter);
  EXPECT_NEAR(session().settings.stiffnesses.believed_k_u.value_or(0.0), 320.0, 0.005 * 320.0);
  EXPECT_TRUE(says("Anisotropic (3) now counts on a hand of 320 N/m")) << sentence();
}

TEST_F(StiffnessProbeWindow, AsksForTheWallFirst) {
  session().goal = {-0.02, 0.02};
  frames(60);
  press(key::s);
  frames(300);
  EXPECT_TRUE(probe().is_running());
  EXPECT_TRUE(says("Drag the hand into the wall.")) << sentence();
  session().goal = load_scene("wall45").goal.points.back();
  measure();
  EXPECT_TRUE(probe().is_known());
}

TEST_F(StiffnessProbeWindow, ItsButtonsDoWhatItsKeysDo) {
  click_on(StageCommand::menu);
  click_on(StageMode::measure);
  EXPECT_TRUE(probe().is_running());
  measure();
  ASSERT_TRUE(probe().is_known());
  click_on(StageCommand::measure);
  EXPECT_TRUE(stiffness_probe_is_believed(session()));
  press(key::escape);
  EXPECT_EQ(session().stage.mode, StageMode::none);
}

// A belief that follows the hand has the tones sound all the time. Nobody can hold still enough for them to go away.
TEST_F(StiffnessProbeWindow, ABeliefThatFollowsBlamesNobodyForItsTrembling) {
  session().settings.active = StrategyId::anisotropic;
  frames(120);
  ASSERT_TRUE(says("the ghost force is gone")) << sentence();
  session().belief_source = BeliefSource::live;
  frames(30);
  int with_trembling = 0;
  for (int i = 0; i < 120; ++i) {
    frames(1);
    EXPECT_FALSE(says("Hold the hand still")) << i;
    if (says("All that is left is the trembling")) ++with_trembling;
  }
  EXPECT_GT(with_trembling, 60);
}

// While the ring fills there is something new in each frame; and when all is said, nothing.
TEST_F(StiffnessProbeWindow, IsDrawnWhileItRunsAndThenRests) {
  press(key::s);
  frames(30);
  for (int i = 0; i < 30; ++i) {
    for (int k = 0; k < 16; ++k) application_->servo().step();
    application_->update(frame_s);
    EXPECT_TRUE(application_->needs_drawing()) << i;
    application_->draw();
  }
  measure();
  point_at(5.0, 5.0);
  frames(240);
  EXPECT_FALSE(application_->needs_drawing());
}

}  // namespace
}  // namespace ghostforce::stiffness_probe_window_test
