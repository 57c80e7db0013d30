// What a person may do, and when not, as values.
#include "app/state/permit.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/scene_file.h"
#include "app/state/apply.h"
#include "app/state/key_bindings.h"
#include "app/state/keys.h"
#include "app/state/kiosk_visit.h"
#include "app/state/lesson_file.h"
#include "app/state/lesson_guide.h"
#include "app/state/user_measurement_guide.h"
#include "core/scene_shape.h"

namespace ghostforce::permit_test {
namespace {

class PermitTest : public testing::Test {
 protected:
  bool may(const Action& action) const { return !permit(session, action); }
  std::string told() const { return session.notice ? session.notice->words : ""; }

  Session session = session_of(load_scene("wall45"));
};

// Whatever is open: each Escape closes something, until there is nothing left for it to do.
TEST_F(PermitTest, EscapeHasUseAsLongAsItClosesSomething) {
  EXPECT_FALSE(escape_has_use(session));
  const std::vector<Action> opening{ToggleBlank{}, ToggleMenu{}, OpenDialog{Dialog::help}, ToggleMode{StageMode::why},
                                    LookBackTo{1.0}};
  for (const Action& action : opening) {
    apply(session, action);
    EXPECT_TRUE(escape_has_use(session)) << action.index();
    for (int i = 0; i < 3; ++i) apply(session, Escape{});
    EXPECT_FALSE(escape_has_use(session)) << action.index();
  }
  begin_lesson(session, shipped_lessons().front());
  EXPECT_TRUE(escape_has_use(session));
  apply(session, Escape{});
  EXPECT_FALSE(escape_has_use(session));
  session.motors_may_push = true;
  EXPECT_TRUE(escape_has_use(session));
}

TEST_F(PermitTest, AVisitorHasNoWayToFilesClipboardOrWindow) {
  const std::vector<Action> forbidden{Quit{},
                                      ToggleFullScreen{},
                                      ToggleAudience{},
                                      Undo{},
                                      Redo{},
                                      OpenScene{"x"},
                                      OpenLesson{"x"},
                                      DropFiles{{"x"}},
                                      SaveScene{"x"},
                                      SavePicture{},
                                      SaveClip{},
                                      SavePlots{},
                                      CopyPicture{},
                                      CopyValues{},
                                      CopySetUp{},
                                      PasteSetUp{},
                                      ShowLink{},
                                      ShowControls{},
                                      StartRecording{"x"},
                                      StopRecording{},
                                      ResetPreferences{},
                                      ChooseInput{"circle"},
                                      StepBack{},
                                      LeaveLesson{},
                                      OpenDialog{Dialog::help},
                                      ToggleDialog{Dialog::palette},
                                      ToggleBlank{},
                                      ToggleMenu{},
                                      ToggleNumbers{}};
  for (const Action& action : forbidden) EXPECT_TRUE(may(action)) << action.index();
  begin_kiosk_visit(session, shipped_lessons());
  for (const Action& action : forbidden) {
    EXPECT_FALSE(may(action)) << action.index();
    EXPECT_TRUE(apply(session, action).empty()) << action.index();
  }
  EXPECT_TRUE(may(Quit{.ends_visit = true}));
  EXPECT_TRUE(may(NextStep{}) && may(NextLanguage{}) && may(StopMotors{}) && may(Escape{}));
  EXPECT_FALSE(session.notice) << "nothing is told";
}

TEST_F(PermitTest, KeysThatVisitorsHaveArePermittedOneByOne) {
  begin_kiosk_visit(session, shipped_lessons());
  std::ptrdiff_t theirs = 0;
  for (const KeyBinding& binding : key_table()) {
    if (!binding.action || !may(*binding.action)) continue;
    ++theirs;
    const bool is_arrow = binding.key >= key::right && binding.key <= key::up;
    const bool is_end = binding.key == key::q && binding.modifiers != modifier::control;
    EXPECT_FALSE(binding.key >= key::f1 && binding.key <= key::f12) << binding.shown;
    EXPECT_FALSE((binding.modifiers & modifier::control) != 0 && !is_arrow && !is_end) << binding.shown;
  }
  EXPECT_GT(theirs, 15) << "in the first step, where not all are";
  EXPECT_LT(theirs, static_cast<std::ptrdiff_t>(key_table().size()) - 40);
}

TEST_F(PermitTest, UndoInALessonWouldLeaveItsTask) {
  EXPECT_FALSE(apply(session, Undo{}).empty());
  begin_lesson(session, shipped_lessons().front());
  EXPECT_TRUE(apply(session, Undo{}).empty());
  EXPECT_TRUE(apply(session, Redo{}).empty());
  EXPECT_FALSE(apply(session, OpenScene{"fig1"}).empty()) << "another scene takes the lesson's place";
}

TEST_F(PermitTest, AnswersNeedAnOpenQuestionAndSlidersAStepThatHasOne) {
  EXPECT_FALSE(may(AnswerLesson{0}));
  session.pointer_moves_goal = false;
  EXPECT_FALSE(may(MoveHandBy{{0.001, 0.0}}));
  session.pointer_moves_goal = true;
  EXPECT_TRUE(may(MoveHandBy{{0.001, 0.0}}));
  for (const auto& lesson : shipped_lessons()) {
    begin_lesson(session, lesson);
    for (std::size_t step = 0; step < lesson->steps.size(); ++step) {
      show_lesson_step(session, step);
      const LessonStep& shown = lesson->steps[step];
      EXPECT_EQ(may(AnswerLesson{0}), shown.question == LessonQuestion::choose) << shown.name;
      EXPECT_EQ(may(ChooseStrategy{StrategyId::full}), shown.controls.contains(LessonControl::strategies));
      const bool has_joint = has_joints(session.settings);
      EXPECT_EQ(may(has_joint ? Action(SwitchMotor{}) : TurnMotorBy{5}), shown.controls.contains(LessonControl::motor))
          << shown.name;
      const bool has_way = shown.controls.contains(LessonControl::hand) || shown.slider || session.stage.guess;
      EXPECT_EQ(may(MoveHandBy{{0.001, 0.0}}), has_way) << shown.name;
    }
  }
}

TEST_F(PermitTest, ThePointerMovesWhatAStepAllowsAndWhatIsThere) {
  EXPECT_TRUE(may(MoveHandTo{}) && may(TurnWallTo{}) && may(TurnMotorTo{}) && may(MoveView{}));
  EXPECT_FALSE(may(MoveGuessTo{}) || may(MoveSliderTo{}) || may(GoToLandscapePoint{}) || may(TurnLandscapeDial{}));
  apply(session, ToggleMode{StageMode::landscape});
  EXPECT_FALSE(may(MoveView{}) || may(ZoomView{2.0})) << "the map has a view of its own";
  EXPECT_TRUE(may(GoToLandscapePoint{}) && may(TurnLandscapeDial{}));
  session.settings.active = StrategyId::full;
  EXPECT_FALSE(may(TurnLandscapeDial{})) << "there is none";
  for (const auto& lesson : shipped_lessons()) {
    begin_lesson(session, lesson);
    for (std::size_t step = 0; step < lesson->steps.size(); ++step) {
      show_lesson_step(session, step);
      const LessonStep& shown = lesson->steps[step];
      EXPECT_EQ(may(MoveHandTo{}), shown.controls.contains(LessonControl::hand)) << shown.name;
      EXPECT_EQ(may(TurnWallTo{}), shown.controls.contains(LessonControl::wall)) << shown.name;
      EXPECT_EQ(may(MoveSliderTo{}), shown.slider.has_value()) << shown.name;
      EXPECT_EQ(may(MoveGuessTo{}), session.stage.guess_is_open && session.stage.guess) << shown.name;
    }
  }
}

TEST_F(PermitTest, AHandIsHeldUntilThePointerLetsGo) {
  apply(session, MoveHandTo{{10.0, 0.01}});
  EXPECT_TRUE(session.drags_goal);
  EXPECT_EQ(session.goal, nearest_in_scene({10.0, 0.01})) << "in sight of a scene's file";
  apply(session, LetGoOfHand{});
  EXPECT_FALSE(session.drags_goal);
}

TEST_F(PermitTest, WhatWouldShowTheHandWaitsForTheMeasurement) {
  session.plots.tab = PlotTab::ratio;
  EXPECT_TRUE(may(SavePlots{"a.csv"}));
  start_measuring(session);
  EXPECT_TRUE(apply(session, SavePlots{"a.csv"}).empty());
  for (const PlotTab tab : {PlotTab::wall_angle, PlotTab::hand}) {
    session.plots.tab = tab;
    EXPECT_FALSE(may(SavePlots{"a.svg"}));
  }
  EXPECT_NE(told().find("would show the answer"), std::string::npos) << told();
  EXPECT_TRUE(session.notice->is_problem) << "it stays until it has been read";
  EXPECT_FALSE(may(Redo{}));
  EXPECT_TRUE(may(Undo{})) << "it cancels";
  EXPECT_FALSE(may(MeasureHand{}));
  apply(session, ToggleMode{StageMode::measure});
  EXPECT_EQ(session.stage.mode, StageMode::none);
  EXPECT_NE(told().find("First finish or cancel"), std::string::npos) << told();
  session.plots.tab = PlotTab::time;
  EXPECT_TRUE(may(SavePlots{"a.csv"})) << "what has been seen anyway";
  cancel_measurement(session);
  session.plots.tab = PlotTab::ratio;
  EXPECT_TRUE(may(SavePlots{"a.csv"}));
}

TEST_F(PermitTest, OnlyWhatWasMeasuredIsBelieved) {
  EXPECT_FALSE(may(Believe{BeliefSource::measured}));
  EXPECT_FALSE(may(BelieveMeasurement{}));
  const Settings before = session.settings;
  apply(session, BelieveMeasurement{});
  EXPECT_EQ(session.settings, before);
  apply(session, Believe{BeliefSource::typed, 250.0});
  EXPECT_EQ(session.settings.stiffnesses.believed_k_u, 250.0);
  session.measured_k_u = 321.0;
  apply(session, Believe{BeliefSource::measured});
  EXPECT_EQ(session.settings.stiffnesses.believed_k_u, 321.0);
  EXPECT_EQ(session.belief_source, BeliefSource::measured);
}

// A button that says that it opens something never closes it, and a key does both.
TEST_F(PermitTest, OpeningADialogTwiceLeavesItOpen) {
  for (int i = 0; i < 2; ++i) apply(session, OpenDialog{Dialog::help});
  EXPECT_EQ(session.dialog, Dialog::help);
  apply(session, ToggleDialog{Dialog::help});
  EXPECT_EQ(session.dialog, Dialog::none);
}

TEST_F(PermitTest, EachRefusalIsASentenceInEachLanguage) {
  for (const StageLanguage* const language : stage_languages) {
    std::set<std::string_view> seen;
    for (const std::string_view words : words_of(language->refusals)) {
      EXPECT_TRUE(words.ends_with('.')) << words;
      EXPECT_TRUE(seen.insert(words).second) << words;
    }
  }
  start_measuring(session);
  session.language = "es";
  apply(session, ToggleMode{StageMode::measure});
  EXPECT_EQ(told(), spanish_stage.refusals.measures_otherwise);
}

// The palette has what otherwise is on the workbench alone, where no lesson leads.
TEST_F(PermitTest, ALessonKeepsItsHand) {
  const std::vector<Action> kept{ChooseInput{"circle"}, BeginCircleTest{}, EndCircleTest{}, StartMeasuring{}};
  for (const Action& action : kept) EXPECT_TRUE(may(action)) << action.index();
  begin_lesson(session, shipped_lessons().front());
  for (const Action& action : kept) EXPECT_FALSE(may(action)) << action.index();
}

TEST_F(PermitTest, WhatTheStageDoesNotShowIsLeftToTheWorkbench) {
  const std::vector<Action> unseen{NextCompareMode{}, ToggleViewOption{&ViewOptions::trails}, ChangeViewOptions{},
                                   StartMeasuring{}};
  for (const Action& action : unseen) EXPECT_TRUE(may(action)) << action.index();
  apply(session, ShowFace{Face::stage});
  for (const Action& action : unseen) EXPECT_FALSE(may(action)) << action.index();
}

// Its line follows the handle, and the device says where it is.
TEST_F(PermitTest, ADeviceWhoseLineTurnsIsNotTurnedByAPersonAndHasTwoMotors) {
  session.motor_line_turns = true;
  session.has_motors = true;
  for (const Action& action : {Action(TurnMotorTo{0.2}), Action(TurnMotorBy{5}), Action(MeasureHand{})}) {
    EXPECT_FALSE(may(action)) << action.index();
  }
  const Settings before = session.settings;
  EXPECT_TRUE(may(SwitchMotor{}));
  apply(session, SwitchMotor{});
  EXPECT_EQ(session.device_motor, 1U);
  apply(session, SwitchMotor{});
  EXPECT_EQ(session.device_motor, 0U);
  EXPECT_EQ(session.settings, before);
  apply(session, ConfirmZeroPose{});
  EXPECT_EQ(session.zero_poses_confirmed, 1U);
}

}  // namespace
}  // namespace ghostforce::permit_test
