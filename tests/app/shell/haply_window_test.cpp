// A whole rehearsal with the Haply in the window: from a board that answers to one motor that pushes along a line which
// turns with the handle. The board is in memory, and its clock is moved by the servo's steps.
#include "app/shell/haply_input_link.h"

#include <cmath>
#include <memory>
#include <string>

#include "app/files/run_reader.h"
#include "app/runs/replay.h"
#include "app/state/permit.h"
#include "app/state/stage_action.h"
#include "app/tools/doctor/readiness.h"
#include "device/virtual_haply/virtual_port.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::haply_window_test {
namespace {

class HaplyWindow : public DrivenWindow {
 protected:
  HaplyWindow() {
    ApplicationOptions options;
    options.input = "haply";
    options.face = Face::stage;
    options.inputs = {haply_entry(
        {{{"haply", "Haply 2DIY", ""}},
         [this](const Scene& scene, const InputOptions& made) {
           auto port = std::make_unique<VirtualPort>(VirtualPort::Options{.clock = VirtualPort::Clock::stepped});
           port_ = port.get();
           HaplyOptions haply = made.haply;
           haply.is_virtual = true;
           return std::make_unique<HaplyInput>(std::move(port), haply, scene.view.center);
         }},
        [](const HaplyReport& report, const MotorReport& motors) { return readiness_of(report, &motors); })};
    open(options);
  }
  ~HaplyWindow() override { application_.reset(); }

  HaplyInput& haply() { return dynamic_cast<HaplyInput&>(application_->servo().input()); }
  const MotorReport& motors() { return application_->report().motors; }
  std::string sentence() { return application_->stage_reading().sentence; }

  // Null: it is not there.
  const StageButton* button_for(const StageAction& action) {
    const std::vector<StageButton>& buttons = screen().stage().picture().buttons;
    const auto found = std::ranges::find(buttons, action, &StageButton::action);
    return found == buttons.end() ? nullptr : &*found;
  }

  // To a place in the scene of wall45, whose middle is the view's.
  void lead_hand_to(const Vector<2>& place, double k_u = 200.0) {
    const HaplyCalibration& calibration = usual_haply_variant().calibration;
    const HaplyPlane plane(calibration, session().scene->view.center);
    HaplyHandPlan plan = haply_hand_at(plane.in_workspace(place), 0.5);
    plan.stiffness = k_u;
    port_->lead_hand(plan);
    frames(12, 100);
  }
  void confirm() {
    ASSERT_TRUE(frames_until(3.0, [&] { return motors().waits_for_zero_pose; }));
    port_->hold_zero_pose(true);
    frames(20, 100);
    act(ConfirmZeroPose{});
    ASSERT_TRUE(frames_until(1.0, [&] { return haply().report().state == HaplyState::idle; }));
    port_->hold_zero_pose(false);
  }
  void get_ready() {
    confirm();
    lead_hand_to({-0.03, -0.01});
    lead_hand_to(outside);
    ASSERT_TRUE(frames_until(1.0, [&] { return motors().is_ready; }));
  }
  void turn_on() {
    get_ready();
    act(ArmMotors{});
    ASSERT_TRUE(frames_until(6.0, [&] { return motors().state == SafetyState::on; }));
  }

  static constexpr Vector<2> outside{-0.02, 0.02};
  static constexpr Vector<2> inside{0.006, -0.006};
  VirtualPort* port_ = nullptr;
};

TEST_F(HaplyWindow, AsksForTheZeroPoseAndTakesItFromAPersonAlone) {
  ASSERT_TRUE(frames_until(3.0, [&] { return motors().waits_for_zero_pose; }));
  frames(2);
  EXPECT_TRUE(sentence().starts_with("Put the arms as they are drawn")) << sentence();
  // As they are to be put, and nothing that nobody knows.
  EXPECT_GT(count_marks(Role::linkage), 3);
  for (const Role role : {Role::device, Role::force, Role::wall_share, Role::ghost_force, Role::motor_axis, Role::hand,
                          Role::hand_spring, Role::tracking_link, Role::number}) {
    EXPECT_EQ(count_marks(role), 0) << static_cast<int>(role);
  }
  EXPECT_FALSE(application_->stage_reading().numbers.force);
  ASSERT_TRUE(motors().linkage);
  const HaplyCalibration& calibration = usual_haply_variant().calibration;
  const auto pose = pose_at(calibration.geometry, zero_pose_of(calibration));
  ASSERT_TRUE(pose);
  const HaplyPlane plane(calibration, session().scene->view.center);
  EXPECT_NEAR(glm::distance(motors().linkage->joints[4], plane.in_scene(pose->handle)), 0.0, 1e-12);
  const std::optional<Action> button = action_of_motor_button(motors());
  ASSERT_TRUE(button);
  EXPECT_TRUE(std::holds_alternative<ConfirmZeroPose>(*button));
  frames(20, 100);
  EXPECT_TRUE(motors().waits_for_zero_pose) << "nobody has said so";
  confirm();
  EXPECT_FALSE(motors().waits_for_zero_pose);
  frames(2);
  EXPECT_GT(count_marks(Role::device), 0);
  EXPECT_GT(count_marks(Role::motor_axis), 0);
}

TEST_F(HaplyWindow, ALostCountIsSaidAndThenAsksForTheZeroPose) {
  turn_on();
  InjectedHaplyFault jump;
  find_injected_haply_fault("encoder-jump")->add(jump);
  port_->inject(jump);
  lead_hand_to(inside);
  ASSERT_TRUE(frames_until(1.0, [&] { return motors().reason == OffReason::not_homed; }));
  frames(3);
  EXPECT_TRUE(sentence().starts_with("The device does not know where its arms are")) << sentence();
  EXPECT_TRUE(std::holds_alternative<AcknowledgeOff>(*action_of_motor_button(motors())))
      << "whoever wants to stop motors must not confirm anything";
  act(AcknowledgeOff{});
  frames(3);
  EXPECT_TRUE(sentence().starts_with("Put the arms as they are drawn")) << sentence();
  EXPECT_TRUE(std::holds_alternative<ConfirmZeroPose>(*action_of_motor_button(motors())));
}

TEST_F(HaplyWindow, DrawsNoLinksOfABoardThatDoesNotAnswer) {
  confirm();
  frames(2);
  ASSERT_GT(count_marks(Role::linkage), 3);
  InjectedHaplyFault mute;
  mute.reply = HaplyReplyFault::lost;
  port_->inject(mute);
  frames(2, 100);
  EXPECT_GT(count_marks(Role::device), 0) << "one late answer is not to be seen";
  frames(20, 20);
  ASSERT_FALSE(motors().waits_for_zero_pose);
  EXPECT_EQ(count_marks(Role::linkage), 0) << "they would be taken for the pose to put the arms into";
  EXPECT_EQ(count_marks(Role::device), 0);
}

TEST_F(HaplyWindow, TheViewFollowsHandAndTarget) {
  const auto is_in_view = [&](const Vector<2>& place) {
    const StagePicture& picture = screen().stage().picture();
    return contains(picture.scene, to_screen(picture.pane.camera, place));
  };
  turn_on();
  lead_hand_to({-0.05, 0.06});
  frames(60);
  EXPECT_TRUE(is_in_view(motors().handle));
  const Vector<2> target = projection(wall_of(session().settings), session().scene->goal.points.back());
  EXPECT_EQ(count_marks(Role::target), 0);
  act(AimAtTarget{true});
  frames(60);
  EXPECT_TRUE(is_in_view(target));
  EXPECT_GE(count_marks(Role::target), 2) << "to aim at, before anybody touches the wall";
  EXPECT_TRUE(sentence().starts_with("Aim at the target")) << sentence();
  // Whoever moves the view away has it so, until Fit.
  act(MoveView{{0.0, 0.15}});
  frames(2);
  act(FitView{});
  frames(60);
  EXPECT_TRUE(is_in_view(target));
  EXPECT_TRUE(is_in_view(motors().handle));
  lead_hand_to({0.0, 0.0});
  lead_hand_to({0.02, -0.02}, 600.0);
  frames(60);
  ASSERT_EQ(motors().state, SafetyState::on);
  EXPECT_TRUE(is_in_view(now().goal)) << "where the hand pulls to, as far as the force tells";
}

TEST_F(HaplyWindow, ARecordingRepeatsWhatIsSimulatedBesideIt) {
  const TemporaryFolder folder;
  get_ready();
  act(StartRecording{folder / "run.csv"});
  frames(3, 100);
  act(ArmMotors{});
  ASSERT_TRUE(frames_until(6.0, [&] { return motors().state == SafetyState::on; }));
  lead_hand_to(inside);
  act(SwitchMotor{});
  frames(10, 100);
  ASSERT_TRUE(now().measured);
  press(key::escape);
  ASSERT_TRUE(frames_until(1.0, [&] { return motors().state == SafetyState::off; }));
  frames(3, 100);
  act(StopRecording{});
  frames(2);
  const auto run = load_run(folder / "run.csv");
  EXPECT_TRUE(run.warnings.empty()) << run.warnings.front();
  const ReplayReport report = replay(run, [](const ReplayedTick&) {});
  EXPECT_FALSE(report.first) << report.first->column << " at " << report.first->time_s;
  EXPECT_EQ(report.skipped, 0);
  EXPECT_GT(report.measured, 1000);
  EXPECT_GT(report.compared, report.measured + 100);
}

TEST_F(HaplyWindow, ItsRailTurnsWithTheHandleAndIsNeitherSentBackNorUndone) {
  confirm();
  lead_hand_to({-0.03, 0.02});
  const double left = session().settings.actuated_angle;
  const std::uint32_t generation = application_->report().settings_generation;
  lead_hand_to({0.03, 0.02});
  frames(2);
  const double turn = std::remainder(session().settings.actuated_angle - left, std::numbers::pi);
  EXPECT_GT(std::abs(turn), 10.0 * radians_per_degree);
  EXPECT_EQ(application_->report().settings_generation, generation);
  EXPECT_TRUE(session().undo_offer.undo.empty()) << session().undo_offer.undo;
  EXPECT_TRUE(permit(session(), TurnMotorTo{0.0}));
  EXPECT_TRUE(permit(session(), MeasureHand{})) << "tones need one line";
}

TEST_F(HaplyWindow, PushesWithOneMotorAndNothingWithTheOther) {
  turn_on();
  lead_hand_to(inside);
  ASSERT_EQ(motors().state, SafetyState::on);
  EXPECT_GT(std::abs(port_->duties()[0]), 0.05);
  EXPECT_EQ(port_->duties()[1], 0.0);
  act(SwitchMotor{});
  frames(10, 100);
  ASSERT_EQ(motors().state, SafetyState::on);
  EXPECT_EQ(motors().pushing_motor, 1U);
  EXPECT_EQ(port_->duties()[0], 0.0);
  EXPECT_GT(std::abs(port_->duties()[1]), 0.05);
  act(ChooseStrategy{StrategyId::full});
  frames(10, 100);
  EXPECT_GT(std::abs(port_->duties()[0]), 0.02);
  EXPECT_GT(std::abs(port_->duties()[1]), 0.02);
  press(key::escape);
  EXPECT_TRUE(frames_until(1.0, [&] { return motors().state == SafetyState::off; }));
  EXPECT_EQ(port_->duties(), (std::array<double, 2>{}));
}

TEST_F(HaplyWindow, DrawsItsLinksAndAPressOnAJointChoosesItsMotor) {
  confirm();
  lead_hand_to(outside);
  frames(3);
  EXPECT_GT(count_marks(Role::linkage), 3);
  ASSERT_TRUE(motors().linkage);
  EXPECT_EQ(motors().linkage->joint_count, 5U);
  EXPECT_NEAR(glm::distance(motors().linkage->joints[4], motors().handle), 0.0, 1e-12);
  EXPECT_EQ(session().device_motor, 0U);
  act(SwitchMotor{});
  frames(3);
  EXPECT_EQ(session().device_motor, 1U);
  EXPECT_EQ(motors().pushing_motor, 1U);
}

TEST_F(HaplyWindow, ButtonsAboveTheStrategiesChooseTheMotors) {
  frames(2);
  EXPECT_EQ(button_for(MotorsInUse::first), nullptr) << "nobody knows where its motors are";
  confirm();
  lead_hand_to(outside);
  frames(3);
  for (const MotorsInUse command : {MotorsInUse::first, MotorsInUse::second, MotorsInUse::both}) {
    ASSERT_NE(button_for(command), nullptr);
    EXPECT_LT(button_for(command)->box.most.y, button_for(StrategyId::naive)->box.least.y);
  }
  click_on(MotorsInUse::second);
  frames(3);
  EXPECT_EQ(session().device_motor, 1U);
  EXPECT_EQ(motors().pushing_motor, 1U);
  click_on(MotorsInUse::both);
  frames(3);
  EXPECT_EQ(session().settings.active, StrategyId::full);
  click_on(MotorsInUse::first);
  frames(3);
  EXPECT_EQ(session().device_motor, 0U);
  EXPECT_EQ(session().settings.active, StrategyId::naive) << "the strategy that renders as if both were there";
}

TEST_F(HaplyWindow, NamesAMotorThatPushesTheWrongWayUntilAPersonHasReadIt) {
  confirm();
  lead_hand_to({-0.03, -0.01});
  lead_hand_to(outside, 100.0);
  ASSERT_TRUE(frames_until(1.0, [&] { return motors().is_ready; }));
  InjectedHaplyFault wrong;
  wrong.reversed_motors = 2;
  port_->inject(wrong);
  act(ArmMotors{});
  ASSERT_TRUE(frames_until(6.0, [&] { return motors().reason == OffReason::calibration; }));
  frames(3);
  EXPECT_EQ(motors().finding, (MotorFinding{MotorVerdict::wrong_way, 1}));
  EXPECT_TRUE(sentence().starts_with("Motor 2 pushes the wrong way: ")) << sentence();
  EXPECT_TRUE(remedy_words(motors(), "F2").starts_with("Motor 2 pushes the wrong way. "))
      << remedy_words(motors(), "F2");
  act(ChooseLanguage{"es"});
  frames(3);
  EXPECT_TRUE(sentence().starts_with("El motor 2 empuja al revés: ")) << sentence();
  act(AcknowledgeOff{});
  frames(3);
  EXPECT_EQ(sentence().find("motor 2"), std::string::npos) << sentence();
}

TEST_F(HaplyWindow, SaysWhenTheMotorCanGiveNoMore) {
  turn_on();
  Stiffnesses strong = session().settings.stiffnesses;
  strong.k_r = 800.0;
  act(ChangeStiffnesses{strong});
  lead_hand_to({0.02, -0.02}, 600.0);
  frames(5, 100);
  ASSERT_EQ(motors().state, SafetyState::on) << static_cast<int>(motors().reason);
  EXPECT_TRUE(motors().motor_is_at_limit);
  EXPECT_NE(sentence().find("can give no more"), std::string::npos) << sentence();
  const std::optional<double> shown = application_->stage_reading().numbers.force;
  ASSERT_TRUE(shown);
  EXPECT_NEAR(*shown, glm::length(motors().sent), 0.3) << "what is given, not what was asked for";
  EXPECT_DOUBLE_EQ(std::max(std::abs(port_->duties()[0]), std::abs(port_->duties()[1])), 1.0);
}

TEST_F(HaplyWindow, SaysWhatTheHandCannotSee) {
  get_ready();
  frames(2);
  EXPECT_TRUE(sentence().starts_with("Motors off: the wall is only simulated.")) << sentence();
  act(ArmMotors{});
  ASSERT_TRUE(frames_until(6.0, [&] { return motors().is_checking; }));
  frames(2);
  EXPECT_NE(sentence().find("hold the handle loosely"), std::string::npos) << sentence();
  ASSERT_TRUE(frames_until(6.0, [&] { return motors().state == SafetyState::on; }));
  lead_hand_to(inside);
  EXPECT_TRUE(sentence().starts_with("Nobody knows where you aim")) << sentence();
  act(AimAtTarget{true});
  frames(3);
  EXPECT_FALSE(sentence().starts_with("Nobody knows")) << sentence();
  press(key::escape);
  ASSERT_TRUE(frames_until(1.0, [&] { return motors().state == SafetyState::off; }));
  frames(2);
  EXPECT_TRUE(sentence().starts_with("Motors off:")) << sentence();
}

}  // namespace
}  // namespace ghostforce::haply_window_test
