// The scenes that are not the paper's, in the whole program: each opens, is dragged through, and switches.
#include <gtest/gtest.h>

#include <variant>
#include <vector>

#include <glm/geometric.hpp>

#include "app/state/stage_language.h"
#include "app/state/stage_view.h"
#include "core/scene_shape.h"
#include "tests/app/shell/driven_window.h"

namespace ghostforce::any_device_window_test {
namespace {

constexpr std::array<const char*, 5> scenes{"arm", "pantograph", "string", "corner", "curve"};

class AnyDeviceWindow : public DrivenWindow {
 protected:
  AnyDeviceWindow() { open({.face = Face::stage}); }
  std::string_view refusal() { return session().notice ? std::string_view(session().notice->words) : ""; }
};

TEST_F(AnyDeviceWindow, EachSceneOpensDragsAndSwitchesWithoutAWarning) {
  for (const char* const name : scenes) {
    SCOPED_TRACE(name);
    act(OpenScene{name});
    frames(3);
    EXPECT_EQ(session().face, Face::stage);
    const Vector<2> goal = session().scene->goal.points.back();
    for (const StrategyId id : {StrategyId::full, StrategyId::naive, StrategyId::anisotropic}) {
      act(ChooseStrategy{id});
      for (const Vector<2>& to : {goal, goal + Vector<2>(0.01, 0.0), goal + Vector<2>(0.0, 0.03), 0.5 * goal, goal}) {
        act(MoveHandTo{to});
        frames(4, 100);
        act(LetGoOfHand{});
        frames(2, 100);
        EXPECT_FALSE(session().notice) << refusal();
        EXPECT_FALSE(application_->report().diverged);
      }
      frames(10, 100);
      const auto rest = rest_of(id, session().settings, session().goal);
      ASSERT_TRUE(rest);
      EXPECT_LT(glm::distance(now().strategies[index_of(id)].device, rest->at.device), 1e-4);
    }
  }
}

TEST_F(AnyDeviceWindow, ModesWorkOrSayThatTheyDoNot) {
  for (const char* const name : scenes) {
    SCOPED_TRACE(name);
    act(OpenScene{name});
    frames(3);
    for (const StageMode mode : {StageMode::predict, StageMode::why, StageMode::round, StageMode::ribbon}) {
      act(ToggleMode{mode});
      frames(3);
      EXPECT_EQ(session().stage.mode, mode);
      act(GoOn{});
      frames(30, 100);
      EXPECT_FALSE(session().notice) << refusal();
      act(ToggleMode{mode});
      frames(3);
    }
    const std::string_view words = english_stage.refusals.not_with_this_device;
    std::vector refused{Action(ToggleMode{StageMode::measure}), Action(TurnRatio{1.05})};
    if (!has_joints(session().settings)) refused.emplace_back(ToggleMode{StageMode::landscape});
    for (const Action& action : refused) {
      act(action);
      EXPECT_EQ(refusal(), words);
      EXPECT_EQ(session().face, Face::stage);
      EXPECT_EQ(session().stage.mode, StageMode::none);
      session().notice.reset();
    }
  }
}

TEST_F(AnyDeviceWindow, TheWorkbenchShowsThemAndTellsWhatItLacks) {
  for (const char* const name : scenes) {
    SCOPED_TRACE(name);
    act(OpenScene{name});
    frames(3);
    act(ShowFace{Face::workbench});
    frames(3);
    ASSERT_EQ(session().face, Face::workbench);
    drag(on_window(session().goal), on_window(session().goal) + Vector<2>(-40.0, 30.0));
    frames(30, 100);
    for (const StrategyId id : {StrategyId::full, StrategyId::naive, StrategyId::anisotropic}) {
      act(ChooseStrategy{id});
      frames(20, 100);
      const auto rest = rest_of(id, session().settings, session().goal);
      if (!rest) continue;
      EXPECT_LT(glm::distance(now().strategies[index_of(id)].device, rest->at.device), 1e-4) << strategy(id).name;
    }
    EXPECT_FALSE(session().notice) << refusal();
    for (const PlotTab tab : {PlotTab::time, PlotTab::wall_angle, PlotTab::ratio, PlotTab::hand}) {
      PlotView plots = session().plots;
      plots.is_open = true;
      plots.tab = tab;
      act(ChangePlots{plots});
      frames(3);
    }
    act(StartMeasuring{});
    EXPECT_EQ(refusal(), english_stage.refusals.not_with_this_device);
    session().notice.reset();
    EXPECT_EQ(session().measurement.stage, UserMeasurement::Stage::off);
    act(ShowFace{Face::stage});
    frames(3);
    EXPECT_EQ(session().face, Face::stage);
  }
}

TEST_F(AnyDeviceWindow, WhatIsMovedComesBackByUndo) {
  act(OpenScene{"arm"});
  frames(3);
  const Settings before = session().settings;
  act(SwitchMotor{});
  frames(3);
  act(MovePart{ScenePart::left_base, before.general.arm.base + Vector<2>(0.01, 0.0)});
  frames(3);
  EXPECT_NE(session().settings, before);
  EXPECT_EQ(session().undo_offer.undo, "the walls or the device");
  act(Undo{});
  frames(2);
  act(Undo{});
  frames(2);
  EXPECT_EQ(session().settings, before);
}

// The map of its walls follows the wall, and the motor that is chosen.
TEST_F(AnyDeviceWindow, AWallThatIsTurnedChangesTheMap) {
  const auto map = [&] {
    for (const Mark& mark : screen().stage().picture().pane.marks) {
      if (const auto* const raster = std::get_if<Raster>(&mark.form)) return raster->cells;
    }
    return std::vector<Colour>();
  };
  act(OpenScene{"arm"});
  frames(3);
  const SceneView before = session().stage_shown;
  act(ToggleMode{StageMode::landscape});
  frames(10);
  EXPECT_EQ(session().stage.mode, StageMode::landscape);
  EXPECT_GT(session().stage_shown.width, 2.0 * before.width) << "all of the workspace";
  const auto first = map();
  ASSERT_FALSE(first.empty());
  ASSERT_TRUE(screen().stage().picture().wall_grips);
  const Vector<2> grip = (*screen().stage().picture().wall_grips)[0];
  point_at(grip);
  frames(2);
  button(GLFW_PRESS);
  frames(2);
  point_at(grip + Vector<2>(120.0, 160.0));
  frames(2);
  button(GLFW_RELEASE);
  frames(2);
  EXPECT_NE(session().settings.wall_normal_angle, session().scene->settings.wall_normal_angle);
  const auto turned = map();
  EXPECT_NE(turned, first);
  act(SwitchMotor{});
  frames(2);
  EXPECT_NE(map(), turned);
  act(ToggleMode{StageMode::landscape});
  frames(10);
  EXPECT_LT(session().stage_shown.width, 0.7 * workspace_view(session().settings).width) << "the contact again";
}

// The motor at the other joint leaves the naïve handle without a rest.
TEST_F(AnyDeviceWindow, AHandleThatRunsAwayIsSeenAndTheSentenceTellsTheWayOut) {
  act(OpenScene{"arm"});
  frames(3);
  act(ChooseStrategy{StrategyId::naive});
  act(SwitchMotor{});
  frames(200, 100);
  ASSERT_FALSE(rest_of(StrategyId::naive, session().settings, session().goal));
  const auto is_seen = [&] {
    const StagePicture& picture = screen().stage().picture();
    const Vector<2> handle = now().strategies[index_of(StrategyId::naive)].device;
    return contains(picture.scene, to_screen(picture.pane.camera, handle));
  };
  EXPECT_TRUE(is_seen());
  act(FitView{});
  frames(30);
  EXPECT_TRUE(is_seen());
  EXPECT_EQ(application_->stage_reading().sentence, english_stage.sentences.no_rest);
  act(ChooseStrategy{StrategyId::anisotropic});
  frames(60, 100);
  EXPECT_TRUE(rest_of(StrategyId::anisotropic, session().settings, session().goal));
}

TEST_F(AnyDeviceWindow, ACirclesGripStaysUnderThePointer) {
  act(OpenScene{"curve"});
  frames(30);
  const auto grip = [&] {
    const std::vector<StagePart>& parts = screen().stage().picture().parts;
    const auto found =
        std::ranges::find_if(parts, [](const StagePart& part) { return part.placed.part == ScenePart::circle_edge; });
    return found == parts.end() ? Vector<2>(-1.0) : found->place;
  };
  const Vector<2> from = grip();
  const double radius = session().settings.general.circle_radius;
  point_at(from);
  frames(2);
  button(GLFW_PRESS);
  frames(2);
  for (const Vector<2>& beside : {Vector<2>(60.0, -40.0), Vector<2>(160.0, -30.0), Vector<2>(90.0, -120.0)}) {
    point_at(from + beside);
    frames(3);
    EXPECT_LT(glm::distance(grip(), from + beside), 3.0) << beside.x;
  }
  button(GLFW_RELEASE);
  frames(3);
  EXPECT_NE(session().settings.general.circle_radius, radius);
}

// Dragged by the pointer, where it is seen.
TEST_F(AnyDeviceWindow, TheBaseIsDraggedAndAPressMovesTheMotor) {
  act(OpenScene{"arm"});
  frames(40);
  const std::vector<StagePart>& parts = screen().stage().picture().parts;
  ASSERT_FALSE(parts.empty());
  const auto base =
      std::ranges::find_if(parts, [](const StagePart& part) { return part.placed.part == ScenePart::left_base; });
  ASSERT_NE(base, parts.end());
  const Vector<2> at = base->place;
  const Settings before = session().settings;
  point_at(at);
  frames(2);
  button(GLFW_PRESS);
  frames(2);
  button(GLFW_RELEASE);
  frames(3);
  EXPECT_EQ(session().settings, with_other_motor(before));
  button(GLFW_PRESS);
  frames(2);
  point_at(at + Vector<2>(30.0, -20.0));
  frames(2);
  button(GLFW_RELEASE);
  frames(3);
  EXPECT_EQ(session().settings.general.arm.motor, with_other_motor(before).general.arm.motor);
  EXPECT_GT(glm::distance(session().settings.general.arm.base, before.general.arm.base), 0.002);
}

}  // namespace
}  // namespace ghostforce::any_device_window_test
