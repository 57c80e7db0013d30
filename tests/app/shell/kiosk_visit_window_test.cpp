// Visitors at the window: through all lessons with keys and pointer, away for 90 seconds, and at everything that is not
// theirs.
#include <algorithm>
#include <array>
#include <string>

#include "app/state/key_bindings.h"
#include "app/widgets/focus.h"
#include "device/falcon/falcon_report.h"
#include "tests/app/shell/kiosk_visit_window.h"
#include "tests/support/places.h"

namespace ghostforce::kiosk_visit_window_test {
namespace {

class KioskVisitWindowTest : public KioskVisitWindow {
 protected:
  const LessonState& lesson() { return *session().lesson; }
  const StageButton* button_for(const StageAction& action) const {
    const auto& buttons = screen().stage().picture().buttons;
    const auto found = std::ranges::find(buttons, action, &StageButton::action);
    return found == buttons.end() ? nullptr : &*found;
  }
};

TEST_F(KioskVisitWindowTest, TheStageSpeaksOfNothingThatAVisitorDoesNotHave) {
  begin();
  for (const std::string language : {"en", "es"}) {
    for (const auto& each : shipped_lessons()) {
      ASSERT_EQ(lesson().lesson->name, each->name);
      for (std::size_t i = 0; lesson().lesson == each && i < 2 * each->steps.size(); ++i) {
        SCOPED_TRACE(each->name + " " + each->steps[lesson().step].name);
        for (const std::string key : {"F1", "F2", "F3", "F4", "F5", "Ctrl", "Esc"})
          EXPECT_FALSE(scene_says(key)) << key;
        const std::array<StageAction, 3> not_theirs{StageCommand::leave, StageCommand::lessons, StageCommand::menu};
        for (const StageAction& action : not_theirs) EXPECT_EQ(button_for(action), nullptr);
        EXPECT_NE(button_for(StageCommand::language), nullptr);
        press(key::page_down);
      }
    }
    if (language == "en") click_on(StageCommand::language);
  }
}

TEST_F(KioskVisitWindowTest, AButtonChangesTheLanguageAndTheNextVisitorBeginsWithTheFirst) {
  begin();
  EXPECT_TRUE(scene_says("Feel a wall"));
  EXPECT_TRUE(scene_says("Español"));
  click_on(StageCommand::language);
  EXPECT_TRUE(scene_says("Siente una pared"));
  EXPECT_TRUE(scene_says("English"));
  wait(91.0);
  EXPECT_TRUE(scene_says("Feel a wall"));
}

TEST_F(KioskVisitWindowTest, TheFocusGoesWithTheVisitor) {
  begin();
  press(key::tab);
  press(key::tab);
  EXPECT_TRUE(has_focus());
  wait(91.0);
  frames(3);
  EXPECT_FALSE(has_focus());
}

TEST_F(KioskVisitWindowTest, InvitesWhileNobodyIsThere) {
  begin();
  EXPECT_TRUE(scene_says("drag me"));
  frames(150);  // until the window has settled
  point_at(300.0, 300.0);
  frames(3);
  EXPECT_FALSE(scene_says("drag me"));
  wait(91.0);
  EXPECT_TRUE(scene_says("drag me"));
  const auto hand = [&] { return place_of_mark(screen().panes().front(), Role::goal); };
  const Vector<2> before = hand();
  const Vector<2> goal = session().goal;
  wait(23.0);
  EXPECT_GT(glm::distance(hand(), before), 0.002) << "a hand shows how";
  EXPECT_EQ(session().goal, goal) << "of which the simulation knows nothing";
  point_at(400.0, 300.0);
  frames(40);
  EXPECT_LT(glm::distance(hand(), before), 1e-9);
  EXPECT_FALSE(scene_says("drag me"));
}

TEST_F(KioskVisitWindowTest, ANewStartIsDrawnThoughNothingHasMoved) {
  begin();
  frames(150);
  point_at(300.0, 300.0);
  frames(120);
  for (int i = 0; i < 87; ++i) application_->update(1.0);
  EXPECT_FALSE(application_->needs_drawing());
  for (int i = 0; i < 3; ++i) application_->update(1.0);
  EXPECT_TRUE(application_->needs_drawing());
}

TEST_F(KioskVisitWindowTest, NoKeyOfTheTableLeadsAway) {
  begin();
  for (const KeyBinding& binding : key_table()) {
    const bool is_end = binding.key == key::q && (binding.modifiers & modifier::alt) != 0;
    if (is_end) continue;
    press(binding.key, binding.modifiers);
    EXPECT_EQ(what_is_forbidden(), "") << binding.shown << ' ' << binding.sentence << ' ' << binding.key;
  }
}

TEST_F(KioskVisitWindowTest, OnlyTheChordEndsIt) {
  begin();
  ask_to_close();
  EXPECT_FALSE(window_->should_close());
  press(key::q, modifier::control);
  EXPECT_FALSE(window_->should_close());
  press(key::q, modifier::control | modifier::alt);
  press(key::q, modifier::control | modifier::shift);
  EXPECT_FALSE(window_->should_close());
  press(key::q, modifier::control | modifier::alt | modifier::shift);
  EXPECT_TRUE(window_->should_close());
}

TEST_F(KioskVisitWindowTest, WhatIsDroppedIsNotTaken) {
  begin();
  const TemporaryFolder elsewhere;
  const std::string lesson_path = elsewhere / "mine.toml";
  write_whole(lesson_path, read_whole(source_path("/assets/lessons/ghost.toml")));
  const std::string scene_path = elsewhere / "scene.toml";
  write_whole(scene_path, scene_text(load_scene("fig1")));
  const std::string missing = elsewhere / "missing";
  const std::string picture = source_path("/docs/stage-why.png");
  for (const std::string& path : {lesson_path, scene_path, picture, missing}) {
    drop({path.c_str()});
    frames(3);
    ASSERT_EQ(what_is_forbidden(), "") << path;
    EXPECT_EQ(lesson().lesson->name, shipped_lessons().front()->name) << path;
  }
}

TEST_F(KioskVisitWindowTest, TheWheelAndTheRightButtonLeaveTheViewAlone) {
  begin();
  frames(60);
  const SceneView shown = session().stage_shown;
  point_at(640.0, 400.0);
  frames(2);
  scroll(3.0);
  drag({640.0, 400.0}, {800.0, 500.0}, GLFW_MOUSE_BUTTON_RIGHT);
  frames(10);
  EXPECT_EQ(session().stage_shown, shown);
}

TEST_F(KioskVisitWindowTest, MotorsOfADeviceGoOffWhenTheVisitorHasGone) {
  begin("virtual-falcon");
  ASSERT_TRUE(frames_until(30.0, [&] { return virtual_falcon().report().state == FalconState::idle; }));
  frames(60, 100);
  // The button is there for them.
  ASSERT_NE(button_for(StageCommand::motors), nullptr) << words_of_scene();
  const auto& motors = [&]() -> const MotorReport& { return application_->report().motors; };
  click_on(StageCommand::motors);
  frames(30, 400);
  ASSERT_EQ(motors().state, SafetyState::on);
  press(key::page_down);
  const auto wait_with_ticks = [&](double seconds) {
    for (double passed_s = 0.0; passed_s < seconds; passed_s += 0.25) {
      for (int k = 0; k < 250; ++k) application_->servo().step();
      application_->frame(0.25);
    }
  };
  wait_with_ticks(85.0);
  EXPECT_EQ(motors().state, SafetyState::on) << "somebody may be there";
  EXPECT_EQ(lesson().step, 1U);
  wait_with_ticks(10.0);
  EXPECT_EQ(lesson().step, 0U);
  EXPECT_EQ(motors().state, SafetyState::off);
  EXPECT_EQ(motors().reason, OffReason::visitor_gone);
  // Nothing arms by itself, and the next visitor reads why they are off before they can.
  wait_with_ticks(200.0);
  EXPECT_EQ(motors().state, SafetyState::off);
  EXPECT_EQ(motors().reason, OffReason::visitor_gone);
  EXPECT_TRUE(scene_says("nobody there"));
  click_on(StageCommand::motors);
  frames(4, 100);
  EXPECT_EQ(motors().reason, OffReason::none);
  EXPECT_EQ(motors().state, SafetyState::off);
}

TEST_F(KioskVisitWindowTest, MotorsThatAreOffStayAsTheyAre) {
  begin("virtual-falcon");
  ASSERT_TRUE(frames_until(30.0, [&] { return virtual_falcon().report().state == FalconState::idle; }));
  press(key::page_down);
  wait(200.0);
  frames(10, 100);
  EXPECT_EQ(application_->report().motors.state, SafetyState::off);
  EXPECT_EQ(application_->report().motors.reason, OffReason::none);
}

TEST_F(KioskVisitWindowTest, WhoMovesTheHandleOfADeviceIsThere) {
  begin("virtual-falcon");
  ASSERT_TRUE(frames_until(30.0, [&] { return virtual_falcon().report().state == FalconState::idle; }));
  press(key::page_down);
  for (int i = 0; i < 6; ++i) {
    wait(60.0);
    virtual_falcon().move_to({-0.02, i % 2 == 0 ? 0.02 : 0.03}, 0.1);
    frames(10, 100);
  }
  EXPECT_EQ(session().kiosk_visit->departures, 0U);
  EXPECT_EQ(lesson().step, 1U);
  wait(91.0);
  EXPECT_EQ(session().kiosk_visit->departures, 1U);
}

}  // namespace
}  // namespace ghostforce::kiosk_visit_window_test
