// A whole rehearsal in the window: from nothing to motors that push and back, with the virtual Falcon behind the real
// driver, led by the pointer. Its clock is moved by the servo's steps.

#include "app/state/stage_action.h"
#include "app/state/stage_language.h"
#include "tests/app/shell/driven_window.h"

namespace ghostforce::rehearsal_window_test {
namespace {

class RehearsalWindow : public DrivenWindow {
 protected:
  RehearsalWindow() {
    ApplicationOptions options;
    options.input = "virtual-falcon";
    options.input_options.virtual_falcon_clock = VirtualLink::Clock::stepped;
    open(options);
  }

  FalconState state() { return virtual_falcon().report().state; }
  const MotorReport& motors() { return application_->report().motors; }

  // Few frames and many ticks: drawing is what takes the time.
  static constexpr int ticks = 100;

  void press_motor_button() { click_at(1240.0, 23.0); }
  void get_ready() {
    ASSERT_TRUE(frames_until(30.0, [&] { return state() == FalconState::idle; }));
    lead_to(outside);
  }
  void turn_on() {
    get_ready();
    press_motor_button();
    ASSERT_TRUE(frames_until(3.0, [&] { return motors().state == SafetyState::on; }));
  }

  static constexpr Vector<2> outside{-0.015, 0.015};
  static constexpr Vector<2> inside{0.012, -0.012};
};

TEST_F(RehearsalWindow, TakesEveryStepAndPushes) {
  EXPECT_EQ(motors().state, SafetyState::off);
  frames(1);
  ASSERT_FALSE(motors().is_ready);
  press_motor_button();
  EXPECT_EQ(session().dialog, Dialog::doctor) << "which says what is missing";
  session().dialog = Dialog::none;
  turn_on();
  lead_to(inside);
  EXPECT_TRUE(now().measured);
  EXPECT_GT(glm::length(motors().sent), 0.5);
  EXPECT_NE(virtual_falcon().link().motors(), MotorNumbers{});
  // What is measured, estimated and only simulated beside it looks different, and what cannot be known is not drawn.
  EXPECT_EQ(count_marks(Role::ghost_force), 0);
  EXPECT_EQ(count_marks(Role::proxy_drift), 0);
  press(key::escape);
  EXPECT_TRUE(frames_until(1.0, [&] { return motors().state == SafetyState::off; }));
  EXPECT_EQ(motors().reason, OffReason::key);
  EXPECT_EQ(virtual_falcon().link().motors(), MotorNumbers{});
  EXPECT_FALSE(now().measured);
}

TEST_F(RehearsalWindow, EscTurnsTheMotorsOffFromWithinThePaletteToo) {
  turn_on();
  press(key::p, modifier::control);
  ASSERT_EQ(session().dialog, Dialog::palette);
  type("landscape");
  press(key::escape);
  EXPECT_TRUE(frames_until(1.0, [&] { return motors().state == SafetyState::off; }));
  EXPECT_EQ(motors().reason, OffReason::key);
  EXPECT_EQ(session().dialog, Dialog::palette) << "a second one closes it";
  press(key::escape);
  EXPECT_EQ(session().dialog, Dialog::none);
}

TEST_F(RehearsalWindow, AFrameRoundTheSceneAndAFilledButtonSayThatMotorsMayPush) {
  EXPECT_TRUE(application_->input_link().is_opening()) << "late ticks do not count yet";
  get_ready();
  EXPECT_FALSE(application_->input_link().is_opening());
  const auto has_problem_colour = [this](double x, double y) {
    return pixel(picture(), static_cast<int>(x), static_cast<int>(y)) == session().appearance.theme->problem;
  };
  const auto shows_motors = [&](bool whether) {
    const Vector<2> end = in_window(screen().scene_size());
    const Vector<2> corner = in_window({0.0, 0.0});
    for (const double inset : {1.0, 6.0}) {
      EXPECT_EQ(has_problem_colour(corner.x + inset, 0.5 * (corner.y + end.y)), whether) << inset;
      EXPECT_EQ(has_problem_colour(end.x - 1.0 - inset, 0.5 * (corner.y + end.y)), whether) << inset;
      EXPECT_EQ(has_problem_colour(0.5 * (corner.x + end.x), corner.y + inset), whether) << inset;
      EXPECT_EQ(has_problem_colour(0.5 * (corner.x + end.x), end.y - 1.0 - inset), whether) << inset;
    }
    EXPECT_EQ(has_problem_colour(1260.0, 14.0), whether) << "the button";
  };
  shows_motors(false);
  turn_on();
  point_at(600.0, 795.0);  // off the button
  frames(3, ticks);
  shows_motors(true);
  press(key::escape);
  ASSERT_TRUE(frames_until(1.0, [&] { return motors().state == SafetyState::off; }));
  frames(2, ticks);
  shows_motors(false);
}

TEST_F(RehearsalWindow, OneCanLookBackAndTheHandGoesOn) {
  turn_on();
  lead_to(inside);
  frames(5, ticks);
  press(key::comma);
  ASSERT_TRUE(session().stage.looks_back_to_s);
  const double looked_at_s = *session().stage.looks_back_to_s;
  const std::int64_t present = now().tick;
  frames(10, ticks);
  EXPECT_FALSE(session().paused) << "nobody stops the time of a real hand";
  EXPECT_GT(now().tick, present);
  EXPECT_EQ(motors().state, SafetyState::on);
  EXPECT_EQ(session().stage.looks_back_to_s, looked_at_s);
  EXPECT_LE(application_->shown().snapshot.time_s, looked_at_s);
  press(key::escape);
  EXPECT_TRUE(frames_until(1.0, [&] { return motors().state == SafetyState::off; }));
  EXPECT_TRUE(session().stage.looks_back_to_s) << "it stops the motors, and a second one does the rest";
  press(key::escape);
  EXPECT_FALSE(session().stage.looks_back_to_s);
}

TEST_F(RehearsalWindow, EveryStepChangesThePicture) {
  const Image at_first = picture();
  ASSERT_TRUE(frames_until(30.0, [&] { return state() == FalconState::idle; }));
  press(key::f2);
  EXPECT_EQ(session().dialog, Dialog::doctor);
  const Image shown = picture();
  EXPECT_NE(shown.rgb, at_first.rgb);
  press(key::f2);
  lead_to(outside);
  const Image ready = picture();
  press_motor_button();
  ASSERT_TRUE(frames_until(3.0, [&] { return motors().state == SafetyState::on; }));
  EXPECT_NE(picture().rgb, ready.rgb);
}

TEST_F(RehearsalWindow, TheMotorButtonArmsNothingInHaste) {
  turn_on();
  press(key::escape);
  frames(5, ticks);
  ASSERT_EQ(motors().reason, OffReason::key);
  for (int i = 0; i < 3; ++i) press_motor_button();
  frames(15, ticks);
  EXPECT_EQ(motors().reason, OffReason::key);
  EXPECT_EQ(motors().state, SafetyState::off);
  frames(80, ticks);
  press_motor_button();  // arm
  EXPECT_TRUE(frames_until(3.0, [&] { return motors().state == SafetyState::on; }));
  press_motor_button();  // off
  EXPECT_TRUE(frames_until(1.0, [&] { return motors().state == SafetyState::off; }));
}

TEST_F(RehearsalWindow, WhoTurnsThemOffHasNothingToDismiss) {
  turn_on();
  press(key::escape);
  ASSERT_TRUE(frames_until(1.0, [&] { return motors().state == SafetyState::off; }));
  ASSERT_EQ(motors().reason, OffReason::key);
  EXPECT_EQ(motor_words(motors(), english_stage), "Motors are off");
  EXPECT_EQ(motor_words(motors(), spanish_stage), "Los motores están parados");
  EXPECT_FALSE(action_of_motor_button(motors())) << "pressed in haste";
  frames(80, 20);
  EXPECT_EQ(motors().reason, OffReason::none);
  EXPECT_EQ(motors().state, SafetyState::off) << "nothing arms by itself";
  EXPECT_TRUE(std::holds_alternative<ArmMotors>(action_of_motor_button(motors()).value()));
}

TEST_F(RehearsalWindow, WhatWentWrongStaysUntilItIsRead) {
  turn_on();
  ImGui_ImplGlfw_WindowFocusCallback(window_->handle(), GLFW_FALSE);
  ASSERT_TRUE(frames_until(1.0, [&] { return motors().state == SafetyState::off; }));
  frames(80, 20);
  EXPECT_EQ(motors().reason, OffReason::focus_lost);
  EXPECT_NE(motor_words(motors(), english_stage).find("Dismiss"), std::string::npos);
  ImGui_ImplGlfw_WindowFocusCallback(window_->handle(), GLFW_TRUE);
}

TEST_F(RehearsalWindow, EscapeTurnsOffAlsoBehindAMenuAndWhileTyping) {
  turn_on();
  press(key::s, modifier::control);
  ASSERT_EQ(session().dialog, Dialog::save_scene);
  type("name");
  press(key::escape);
  EXPECT_TRUE(frames_until(0.5, [&] { return motors().state == SafetyState::off; }));
}

TEST_F(RehearsalWindow, WordsPromiseNoKeyThatCannotArrive) {
  const auto words = [&](const StageLanguage& language) {
    return motor_words(application_->reading().motors, language);
  };
  const auto promises_escape = [&] {
    return words(english_stage).find("Esc") != std::string::npos ||
           words(spanish_stage).find("Esc") != std::string::npos;
  };
  turn_on();
  EXPECT_TRUE(promises_escape());
  ImGui_ImplGlfw_WindowFocusCallback(window_->handle(), GLFW_FALSE);
  frames(1, 0);  // nor before the servo has heard of it
  EXPECT_EQ(motors().state, SafetyState::on);
  EXPECT_FALSE(promises_escape()) << words(english_stage);
  EXPECT_TRUE(frames_until(1.0, [&] { return motors().state == SafetyState::off; }));
  EXPECT_EQ(motors().reason, OffReason::focus_lost);
  press_motor_button();  // read
  frames(2, ticks);
  press_motor_button();  // arm: in vain
  EXPECT_TRUE(frames_until(1.0, [&] { return motors().state == SafetyState::arming; }));
  EXPECT_EQ(motors().obstacle, ArmingObstacle::focus);
  EXPECT_FALSE(promises_escape()) << words(english_stage);
  ImGui_ImplGlfw_WindowFocusCallback(window_->handle(), GLFW_TRUE);
  EXPECT_TRUE(frames_until(3.0, [&] { return motors().state == SafetyState::on; }));
  EXPECT_TRUE(promises_escape());
}

TEST_F(RehearsalWindow, SleepWaitsForTheMotorsWhichStayOffUntilItIsOver) {
  turn_on();
  EXPECT_TRUE(application_->delays_sleep(false));
  frames(1, ticks);
  EXPECT_EQ(motors().state, SafetyState::on);
  EXPECT_TRUE(application_->delays_sleep(true));
  frames(1, 10);
  EXPECT_TRUE(application_->delays_sleep(true)) << "they are not off yet";
  EXPECT_TRUE(frames_until(1.0, [&] { return !application_->delays_sleep(true); }));
  EXPECT_EQ(motors().state, SafetyState::off);
  EXPECT_EQ(motors().reason, OffReason::machine_sleeps);
  press_motor_button();  // read
  press_motor_button();  // arm: in vain
  EXPECT_FALSE(frames_until(0.5, [&] { return motors().state != SafetyState::off; }));
  EXPECT_TRUE(application_->delays_sleep(false)) << "awake again";
  press_motor_button();
  EXPECT_TRUE(frames_until(3.0, [&] { return motors().state == SafetyState::on; }));
}

TEST_F(RehearsalWindow, PullingThePlugIsSaidAndPuttingItInDoesNotArm) {
  turn_on();
  lead_to(inside);
  InjectedFault unplugged;
  unplugged.link = LinkFault::unplugged;
  virtual_falcon().inject(unplugged);
  frames(1);
  EXPECT_EQ(motors().state, SafetyState::off);
  EXPECT_EQ(motors().reason, OffReason::unplugged);
  EXPECT_TRUE(frames_until(1.0, [&] { return state() == FalconState::fault; }));
  virtual_falcon().inject({});
  lead_to(outside);
  EXPECT_TRUE(frames_until(30.0, [&] { return state() == FalconState::idle; }));
  frames(20, ticks);
  EXPECT_EQ(motors().state, SafetyState::off);
  EXPECT_EQ(motors().reason, OffReason::unplugged);
}

TEST_F(RehearsalWindow, AnotherSceneOrInputNeverTakesTheForceAlong) {
  turn_on();
  lead_to(inside);
  ASSERT_GT(glm::length(motors().sent), 0.5);
  act(OpenScene{"fig1"});
  frames(5);
  EXPECT_EQ(motors().state, SafetyState::off);
  EXPECT_EQ(motors().sent, Vector<2>(0.0));
  act(ChooseInput{"mouse"});
  frames(5);
  EXPECT_FALSE(motors().has_motors);
  EXPECT_TRUE(application_->reading().readiness.empty());
}

// Whoever has F2 closed sees it too.
TEST_F(RehearsalWindow, SaysThatMotorsMayStillPushUntilTheDeviceHasAnswered) {
  turn_on();
  lead_to(inside);
  session().face = Face::stage;
  const auto sentence = [&] { return application_->stage_reading().sentence; };
  EXPECT_EQ(sentence().find("may still push"), std::string::npos) << sentence();
  session().injected_fault = "unplugged";
  ASSERT_TRUE(frames_until(1.0, [&] { return state() == FalconState::fault; }));
  EXPECT_TRUE(motors().may_still_push);
  EXPECT_NE(sentence().find("may still push"), std::string::npos) << sentence();
  EXPECT_EQ(motor_words(motors(), english_stage), english_stage.motors.may_still_push);
  EXPECT_TRUE(std::holds_alternative<OpenDialog>(action_of_motor_button(motors()).value()));
  session().injected_fault = "none";
  ASSERT_TRUE(frames_until(30.0, [&] { return state() == FalconState::idle; }));
  EXPECT_FALSE(motors().may_still_push);
  EXPECT_EQ(sentence().find("may still push"), std::string::npos) << sentence();
}

TEST_F(RehearsalWindow, TheStageSaysWhatArmingWaitsFor) {
  get_ready();
  lead_to(inside);
  session().face = Face::stage;
  act(ArmMotors{});
  EXPECT_TRUE(frames_until(1.0, [&] { return motors().obstacle == ArmingObstacle::inside_wall; }));
  EXPECT_EQ(application_->stage_reading().sentence, "Arming: move the handle out of the wall.");
  lead_to(outside);
  EXPECT_TRUE(frames_until(3.0, [&] { return motors().state == SafetyState::on; }));
  EXPECT_EQ(application_->stage_reading().sentence.find("Arming"), std::string::npos);
}

TEST_F(RehearsalWindow, SaysThatASceneDoesNotFitTheWorkspace) {
  act(OpenScene{"fig1"});
  frames(5);
  EXPECT_NE(application_->reading().device_remark.find("Set scale"), std::string::npos);
  act(OpenScene{"wall45"});
  frames(5);
  EXPECT_EQ(application_->reading().device_remark, "");
}

}  // namespace
}  // namespace ghostforce::rehearsal_window_test
