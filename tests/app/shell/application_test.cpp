// What the window does with the servo: starting at rest, dragging, pausing, resetting, minimising.
#include "app/state/key_bindings.h"
#include "tests/app/shell/driven_window.h"

namespace ghostforce::application_test {
namespace {

class ApplicationTest : public DrivenWindow {};

TEST_F(ApplicationTest, StartsAtRestAtTheEndOfTheScenesPath) {
  const Snapshot& now = application_->report().snapshot;
  const Scene scene = load_scene("wall45");
  EXPECT_EQ(now.goal, scene.goal.points.back());
  EXPECT_TRUE(now.strategies[index_of(StrategyId::naive)].in_contact);
  EXPECT_GT(glm::length(now.strategies[index_of(StrategyId::naive)].ghost_force), 1.0);
  EXPECT_GT(application_->history().points().size(), 50U) << "the way there is on screen as a trail";
}

TEST_F(ApplicationTest, TheGoalFollowsADragAnywhereInTheScene) {
  const Vector<2> target{0.005, 0.012};
  const Vector<2> there = on_window(target);
  point_at(there.x - 120.0, there.y + 60.0);
  frames(2);
  button(GLFW_PRESS);
  frames(2);
  point_at(there.x, there.y);
  frames(10);
  const Snapshot& now = application_->report().snapshot;
  // ImGui knows the pointer to a whole point.
  const double point = 1.0 / screen().panes()[0].camera.points_per_metre;
  EXPECT_NEAR(now.goal.x, target.x, point);
  EXPECT_NEAR(now.goal.y, target.y, point);
  button(GLFW_RELEASE);
  frames(2);
  point_at(there.x + 50.0, there.y);
  frames(5);
  EXPECT_NEAR(application_->report().snapshot.goal.x, target.x, point) << "let go of";
}

TEST_F(ApplicationTest, ADragOutOfTheSceneLeavesTheGoalAtItsEdge) {
  const Vector<2> inside = on_window({0.0, 0.0});
  point_at(inside.x, inside.y);
  frames(2);
  button(GLFW_PRESS);
  frames(2);
  point_at(5000.0, -300.0);
  frames(10);
  const Vector<2> at = to_screen(screen().panes()[0].camera, application_->report().snapshot.goal);
  EXPECT_NEAR(at.x, screen().panes()[0].camera.size.x, 1e-3);
  EXPECT_NEAR(at.y, 0.0, 1e-3);
  button(GLFW_RELEASE);
  frames(2);
}

TEST_F(ApplicationTest, ResetStartsTheMotionAgainAndAltResetTheSettingsToo) {
  session().settings.stiffnesses.k_r = 1234.0;
  frames(30);
  const std::int64_t before = application_->report().snapshot.tick;
  press(key::r);
  EXPECT_LT(application_->report().snapshot.tick, before);
  EXPECT_EQ(session().settings.stiffnesses.k_r, 1234.0);
  press(key::r, modifier::alt);
  EXPECT_EQ(session().settings, load_scene("wall45").settings);
  EXPECT_EQ(application_->report().snapshot.goal, load_scene("wall45").goal.points.back());
}

TEST_F(ApplicationTest, AChangedSettingReachesTheServo) {
  const double before = glm::length(application_->report().snapshot.strategies[index_of(StrategyId::full)].force);
  session().settings.stiffnesses.k_u *= 2.0;
  frames(200);
  const double after = glm::length(application_->report().snapshot.strategies[index_of(StrategyId::full)].force);
  EXPECT_GT(after, 1.2 * before);
}

TEST_F(ApplicationTest, EveryStrategyButtonWorksUnderThePointer) {
  // The three buttons stand side by side at the left of the top bar.
  click_at(230.0, 22.0);
  EXPECT_EQ(session().settings.active, StrategyId::naive);
  click_at(350.0, 22.0);
  EXPECT_EQ(session().settings.active, StrategyId::anisotropic);
  click_at(90.0, 22.0);
  EXPECT_EQ(session().settings.active, StrategyId::full);
}

TEST_F(ApplicationTest, AWindowMinimisedToNothingDrawsNothingAndComesBack) {
  const Image before = picture();
  window_->resize(0, 0);
  if (window_->pixel_width() != 0) glfwIconifyWindow(window_->handle());
  frames(5);
  window_->resize(1280, 800);
  frames(5);
  EXPECT_EQ(picture().rgb.size(), before.rgb.size());
}

TEST_F(ApplicationTest, UnstableSettingsAreSaidAndLeftAgain) {
  session().settings.stiffnesses.k_r = 1e6;
  session().settings.mass = 0.001;
  frames(20);
  EXPECT_TRUE(application_->report().diverged);
  press(key::r);
  frames(20);
  EXPECT_TRUE(application_->report().diverged);
  press(key::r, modifier::alt);
  frames(5);
  EXPECT_FALSE(application_->report().diverged);
  EXPECT_NEAR(application_->report().snapshot.goal.x, 0.01414, 1e-5);
}

}  // namespace
}  // namespace ghostforce::application_test
