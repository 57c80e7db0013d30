// At rest nothing is drawn, and whatever a person could see asks for a frame at once. The servo is stepped by hand and
// every interval is given.
#include "app/stage/idle_show.h"
#include "app/state/key_bindings.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::at_rest_test {
namespace {

constexpr int ticks_per_look = 16;
constexpr double look_s = 0.016;  // as many ticks at 1 kHz

class AtRestTest : public DrivenWindow {
 protected:
  AtRestTest() { show(Face::stage); }

  void show(Face face) {
    session().face = face;
    frames(1, ticks_per_look);
    settle();
  }

  // As `run` lives while the person does nothing: looks, and frames only where they are needed. Returns how many.
  int live_for(double seconds) {
    int drawn = 0;
    for (double t = 0.0; t < seconds; t += look_s) {
      for (int k = 0; k < ticks_per_look; ++k) application_->servo().step();
      application_->update(look_s);
      if (!application_->needs_drawing()) continue;
      application_->draw();
      ++drawn;
    }
    return drawn;
  }
  Vector<2> drawn_at(Role role) const {
    return to_screen(screen().panes()[0].camera, place_of_mark(screen().panes()[0], role));
  }
  // Labels take their time to find better places.
  void settle() { live_for(4.0); }
  // A frame because the person did something.
  void stir() { frames(1, ticks_per_look); }
};

TEST_F(AtRestTest, NothingIsDrawnOnTheStage) {
  const Image before = picture();
  const double began_s = now().time_s;
  EXPECT_EQ(live_for(15.0), 0);
  EXPECT_NEAR(now().time_s - began_s, 15.0, 0.1) << "time has gone on";
  stir();
  EXPECT_EQ(picture(), before) << "there was nothing to draw";
}

TEST_F(AtRestTest, NothingIsDrawnInAnyModeOfTheStage) {
  for (const StageMode mode : {StageMode::predict, StageMode::why, StageMode::landscape, StageMode::ribbon}) {
    session().stage.mode = mode;
    stir();
    settle();
    EXPECT_EQ(live_for(30.0), 0) << static_cast<int>(mode);
  }
}

TEST_F(AtRestTest, TheWorkbenchOnlyBringsItsCountsUpToDate) {
  show(Face::workbench);
  EXPECT_NEAR(live_for(30.0), 15, 1);
  press(key::space);
  live_for(1.0);
  EXPECT_NEAR(live_for(30.0), 6, 1);
  EXPECT_TRUE(application_->is_idle());
}

TEST_F(AtRestTest, TheWordsAtTheDialGoInRealTime) {
  show(Face::workbench);
  press(key::digit_2);
  press(key::equal);
  live_for(3.0);
  EXPECT_TRUE(says("Only Anisotropic"));
  live_for(1.5);
  EXPECT_FALSE(says("Only Anisotropic")) << "a frame was drawn without them";
}

TEST_F(AtRestTest, EveryTickIsKeptThough) {
  const auto newest = [&] { return application_->history().moments().newest()->snapshot.tick; };
  std::int64_t last = newest();
  for (int look = 0; look < 200; ++look) {
    for (int k = 0; k < ticks_per_look; ++k) application_->servo().step();
    application_->update(look_s);
    ASSERT_FALSE(application_->needs_drawing());
    ASSERT_EQ(newest(), last + ticks_per_look);
    for (std::int64_t tick = last + 1; tick <= last + ticks_per_look; ++tick) {
      ASSERT_EQ(application_->history().moments().at((static_cast<double>(tick) + 0.5) * 0.001)->snapshot.tick, tick);
    }
    last = newest();
  }
  EXPECT_EQ(application_->report().loop.dropped_samples, 0U);
}

TEST_F(AtRestTest, NothingIsDrawnForAnAudienceEither) {
  act(ToggleAudience{});
  stir();
  ASSERT_TRUE(session().has_audience);
  settle();
  EXPECT_EQ(live_for(10.0), 0);
  session().goal += Vector<2>(0.004, -0.002);
  EXPECT_GT(live_for(0.5), 5);
}

TEST_F(AtRestTest, AHandThatMovesIsDrawnUntilItRests) {
  for (const Face face : {Face::stage, Face::workbench}) {
    show(face);
    session().goal += Vector<2>(0.004, -0.002);
    application_->update(look_s);
    EXPECT_TRUE(application_->needs_drawing());
    EXPECT_GT(live_for(0.5), 5);
    live_for(5.0);
    EXPECT_LE(live_for(5.0), face == Face::workbench ? 5 : 0);
    const Vector<2> before = drawn_at(Role::device);
    stir();
    EXPECT_LT(glm::distance(drawn_at(Role::device), before), 0.01) << "the last frame shows the rest";
  }
}

TEST_F(AtRestTest, AHandThatAScriptMovesIsDrawn) {
  open({.input = "script"});
  session().face = Face::stage;
  stir();
  const double duration_s = load_scene("wall45").duration;
  EXPECT_GT(live_for(1.0), 40);
  live_for(duration_s);
  EXPECT_EQ(live_for(10.0), 0) << "it has come to its end";
}

TEST_F(AtRestTest, AMoveLessThanAHundredthOfAPointIsNone) {
  const double point = 1.0 / screen().panes()[0].camera.points_per_metre;
  session().goal.x += 0.002 * point;
  EXPECT_EQ(live_for(1.0), 0);
  session().goal.x += 0.02 * point;
  EXPECT_GT(live_for(1.0), 0);
}

TEST_F(AtRestTest, AKeyThatSwitchesTheStrategyMovesTheStageForItsTime) {
  send_key(key::digit_3, GLFW_PRESS, 0);
  send_key(key::digit_3, GLFW_RELEASE, 0);
  stir();
  EXPECT_EQ(session().settings.active, StrategyId::anisotropic);
  const int drawn = live_for(0.6);
  EXPECT_GE(drawn, 36) << "every frame of 0.6 s";
  settle();
  EXPECT_EQ(live_for(5.0), 0);
}

TEST_F(AtRestTest, ARevealedGuessMovesTheStageAndNothingDoesAfterwards) {
  session().stage.mode = StageMode::predict;
  stir();
  live_for(2.0);
  ++session().stage.reveals_asked;
  stir();
  EXPECT_GT(live_for(3.5), 200);
  settle();
  EXPECT_EQ(live_for(10.0), 0);
  ++session().stage.reveals_asked;
  stir();
  ++session().stage.reveals_asked;
  stir();
  live_for(1.0);
  session().stage.mode = StageMode::none;  // in the middle of the answer
  stir();
  settle();
  EXPECT_EQ(live_for(10.0), 0);
}

TEST_F(AtRestTest, ANoticeComesAndGoes) {
  application_->show_notice("Something was saved.", false);
  EXPECT_TRUE(application_->needs_drawing());
  EXPECT_LE(live_for(5.0), 10) << "it stands still";
  EXPECT_TRUE(session().notice);
  EXPECT_GT(live_for(2.0), 0) << "it is gone";
  EXPECT_FALSE(session().notice);
  EXPECT_EQ(live_for(5.0), 0);
}

TEST_F(AtRestTest, ARecordingKeepsNothingAwake) {
  const TemporaryFolder folder;
  act(StartRecording{folder / "a.csv"});
  stir();
  EXPECT_TRUE(application_->needs_drawing());
  live_for(1.0);
  EXPECT_TRUE(application_->reading().recording.is_on);
  EXPECT_EQ(live_for(30.0), 0);
}

TEST_F(AtRestTest, ACircleTestIsDrawn) {
  act(ChooseInput{"circle"});
  stir();
  EXPECT_GT(live_for(2.0), 120);
}

TEST_F(AtRestTest, PlotsThatFollowTheTimeAreDrawn) {
  show(Face::workbench);
  session().plots.is_open = true;
  stir();
  EXPECT_GT(live_for(2.0), 120);
  session().plots.tab = PlotTab::ratio;
  stir();
  live_for(1.0);
  EXPECT_LE(live_for(10.0), 10);
  session().plots.tab = PlotTab::time;
  session().plots.follows = false;
  session().plots.to_s = now().time_s - 0.1;
  session().plots.from_s = session().plots.to_s - 1.0;
  stir();
  live_for(1.0);
  EXPECT_LE(live_for(10.0), 10);
}

TEST_F(AtRestTest, WhatTheServoRefusesIsSaidInTheWorkbench) {
  show(Face::workbench);
  press(key::space);
  live_for(1.0);
  ASSERT_FALSE(application_->needs_drawing());
  ServoCommand command;
  command.paused = true;
  command.speed = -1.0;
  application_->servo().send(command);
  application_->servo().step();
  application_->update(look_s);
  ASSERT_EQ(application_->report().refused_commands, 1U);
  EXPECT_TRUE(application_->needs_drawing());
}

TEST_F(AtRestTest, SettingsThatRunAwayAreSaid) {
  session().settings.stiffnesses.k_r = 1e6;
  session().settings.mass = 0.001;
  stir();
  live_for(1.0);
  EXPECT_TRUE(application_->report().diverged);
  EXPECT_EQ(live_for(10.0), 0);
}

TEST_F(AtRestTest, TheShowBeginsAfterItsTimeAndEndsWithATouch) {
  stir();
  point_at(640.0, 300.0);  // a touch
  stir();
  EXPECT_EQ(live_for(1.0), 0);
  EXPECT_EQ(live_for(IdleShow::begins_after_s - 1.5), 0);
  const Vector<2> before = drawn_at(Role::goal);
  EXPECT_GT(live_for(2.0), 80);
  EXPECT_GT(glm::distance(drawn_at(Role::goal), before), 10.0);
  EXPECT_GT(live_for(5.0), 300) << "it goes on by itself";
  point_at(650.0, 300.0);
  stir();
  live_for(2.0);
  EXPECT_EQ(live_for(IdleShow::begins_after_s - 3.0), 0);
}

TEST_F(AtRestTest, NoShowBeginsWhereItMustNot) {
  for (const bool in_workbench : {false, true}) {
    session().face = in_workbench ? Face::workbench : Face::stage;
    session().stage.is_black = !in_workbench;
    stir();
    live_for(1.0);
    EXPECT_LE(live_for(60.0), in_workbench ? 61 : 0);
  }
  session().face = Face::stage;
  stir();
  live_for(1.0);
  EXPECT_EQ(live_for(10.0), 0) << "the time in the workbench does not count";
}

TEST_F(AtRestTest, NothingMovesByItselfWhereMotionIsReduced) {
  act(FollowSystemMotion{true});
  stir();
  live_for(1.0);
  EXPECT_EQ(live_for(2.0 * IdleShow::begins_after_s), 0);
  act(ChangeMotion{ScreenMotion::full});
  stir();
  EXPECT_GT(live_for(2.0 * IdleShow::begins_after_s), 0) << "the person's choice comes before the system's";
}

TEST_F(AtRestTest, TheStageChangesAtOnceWhereMotionIsReduced) {
  act(ChangeMotion{ScreenMotion::reduced});
  stir();
  press(key::digit_3);
  EXPECT_EQ(session().settings.active, StrategyId::anisotropic);
  const Vector<2> device = drawn_at(Role::device);
  EXPECT_NEAR(device.x, on_window(now().strategies[index_of(StrategyId::anisotropic)].device).x, 1.0);
  session().stage.mode = StageMode::predict;
  stir();
  live_for(2.0);
  ++session().stage.reveals_asked;
  stir();
  EXPECT_LT(live_for(3.5), 60) << "no hand that presses in slowly";
}

TEST_F(AtRestTest, TheViewIsThereAtOnceWhereMotionIsReduced) {
  act(ChangeMotion{ScreenMotion::reduced});
  stir();
  session().stage_shown.width *= 3.0;
  stir();
  const double before = screen().panes()[0].camera.points_per_metre;
  act(FitView{});
  stir();
  const double fitted = screen().panes()[0].camera.points_per_metre;
  EXPECT_GT(fitted, 2.0 * before);
  live_for(1.0);
  EXPECT_EQ(screen().panes()[0].camera.points_per_metre, fitted);
}

TEST_F(AtRestTest, AHandThatIsHeldStillIsAtRestToo) {
  const Vector<2> at = on_window(now().goal);
  press_at(at);
  point_at(at + Vector<2>(30.0, 10.0));
  stir();
  ASSERT_TRUE(session().drags_goal);
  settle();
  EXPECT_EQ(live_for(30.0), 0);
  release();
  settle();
  EXPECT_EQ(live_for(5.0), 0);
}

TEST_F(AtRestTest, ACaretBlinks) {
  session().dialog = Dialog::save_scene;
  frames(5);
  ASSERT_TRUE(ImGui::GetIO().WantTextInput);
  EXPECT_GT(live_for(1.0), 50);
}

TEST_F(AtRestTest, TheGoalIsWhereThePointerIsInTheFirstFrame) {
  const Vector<2> begin = on_window(now().goal);
  press_at(begin);
  for (const Vector<2>& move : {Vector<2>(40.0, 12.0), Vector<2>(-75.0, 33.0), Vector<2>(3.0, -64.0)}) {
    const Vector<2> pointer = begin + move;
    const Vector<2> known = now().goal;
    point_at(pointer);
    application_->frame(frame_s);  // and not one tick
    EXPECT_EQ(now().goal, known) << "the loop has not seen it yet";
    // ImGui knows the pointer to a whole point.
    EXPECT_NEAR(drawn_at(Role::goal).x, pointer.x, 1.0);
    EXPECT_NEAR(drawn_at(Role::goal).y, pointer.y, 1.0);
    frames(3);
  }
  release();
}

}  // namespace
}  // namespace ghostforce::at_rest_test
