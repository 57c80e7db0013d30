// Lessons in the window: each that comes with the program is played to its end, rightly with the pointer and wrongly with
// the keys, forwards and backwards; the picker; a device in the hand; and somebody who presses whatever there is.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "app/state/lesson_file.h"
#include "app/state/lesson_guide.h"
#include "app/state/lesson_quantities.h"
#include "app/state/lesson_search.h"
#include "app/widgets/focus.h"
#include "core/general_tick.h"
#include "core/mechanism.h"
#include "core/scene_shape.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::lesson_window_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double two_pi = 2.0 * pi;

class LessonWindow : public DrivenWindow {
 protected:
  void begin(const std::shared_ptr<const Lesson>& lesson, std::string language = "en", std::string input = "mouse") {
    ApplicationOptions options;
    options.face = Face::stage;
    options.input = std::move(input);
    options.input_options.virtual_falcon_clock = VirtualLink::Clock::stepped;
    options.lesson = lesson;
    options.language = std::move(language);
    open(options);
    arrive();
  }
  // Until hand and picture stand still.
  void arrive() {
    for (int i = 0; i < 200 && session().lesson && session().lesson->glide; ++i) frames(1);
    frames(30);
  }
  LessonState& lesson() { return *session().lesson; }
  const LessonStep& step() { return lesson_step(lesson()); }
  LessonOutcome outcome() { return lesson_step_state(lesson()).outcome; }

  void press_digit(std::size_t answer) { press(key::digit_1 + static_cast<int>(answer)); }

  Vector<2> rest() { return stage_moment_at_rest(session().settings, session().goal).handle; }

  // By one of its ends, freely.
  void turn(const std::optional<std::array<Vector<2>, 2>>& ends, const Vector<2>& pivot, double counter_clockwise) {
    ASSERT_TRUE(ends) << step().name << ": nothing to take hold of";
    const Vector<2> arm = (*ends)[1] - pivot;
    const double cosine = std::cos(-counter_clockwise);  // y is down
    const double sine = std::sin(-counter_clockwise);
    press_at(pivot + arm);
    hold_control(true);
    point_at(pivot + Vector<2>(cosine * arm.x - sine * arm.y, sine * arm.x + cosine * arm.y));
    frames(10);
    hold_control(false);
    release();
    frames(1);
  }

  // The one that is drawn hollow, and can have the motor.
  void press_joint_without_motor() {
    const Settings& settings = session().settings;
    const Vector<2>& handle = now().strategies[index_of(settings.active)].device;
    const Vector<2> motor = pose_at(mechanism_of(settings), handle)->joints[0];
    const std::vector<StagePart>& parts = screen().stage().picture().parts;
    const auto joint = std::ranges::find_if(parts, [&](const StagePart& part) {
      return part.placed.may_have_motor && glm::distance(part.placed.at, motor) > 0.01;
    });
    ASSERT_NE(joint, parts.end()) << step().name;
    click_at(joint->place.x, joint->place.y);
  }

  void do_task() {
    const ghostforce::SetUp start{.scene = {.title = {},
                                            .about = {},
                                            .settings = session().settings,
                                            .stiffness_path = {},
                                            .tremor_and_drift = {},
                                            .goal = {.points = {session().goal}, .times = {0.0}},
                                            .duration = 0.0,
                                            .view = {}},
                                  .goal = session().goal,
                                  .face = Face::stage,
                                  .mode = session().stage.mode};
    const TaskFinding finding = examine_task(step(), start);
    ASSERT_TRUE(finding.solution) << step().name;
    const Settings& solved = finding.solution->scene.settings;
    if (finding.solution->goal != session().goal) {
      drag(on_window(session().goal), on_window(finding.solution->goal));
      session().goal = finding.solution->goal;  // to the last micrometre
      arrive();
    }
    if (step().slider) {
      const double wanted = slider_value(*step().slider, solved).value_or(0.0);
      move_lesson_slider(session(), wanted);
    }
    if (solved.active != session().settings.active) click_on(StageAction(solved.active));
    const Settings& now = session().settings;
    const StagePicture& shown = screen().stage().picture();
    if (solved.wall_normal_angle != now.wall_normal_angle) {
      const double way = std::remainder(solved.wall_normal_angle - now.wall_normal_angle, two_pi);
      turn(shown.wall_grips, on_window(now.wall_point), way);
      EXPECT_LT(std::abs(std::remainder(solved.wall_normal_angle - now.wall_normal_angle, two_pi)), 0.5 * std::abs(way))
          << step().name;
    }
    if (solved.general != now.general) {
      ASSERT_EQ(solved.general, with_other_motor(now).general) << step().name;
      press_joint_without_motor();
      EXPECT_EQ(now.general, solved.general) << step().name;
    }
    if (solved.actuated_angle != now.actuated_angle) {
      const double way = std::remainder(solved.actuated_angle - now.actuated_angle, pi);
      // About the handle, which moves meanwhile.
      turn(shown.motor_grips, on_window(shown.pivot), way);
      EXPECT_LT(std::abs(std::remainder(solved.actuated_angle - now.actuated_angle, pi)), 0.5 * std::abs(way))
          << step().name;
    }
    if (session().stage.mode == StageMode::measure) click_on(StageCommand::measure);
    // To the last digit.
    session().settings.actuated_angle = solved.actuated_angle;
    session().settings.wall_normal_angle = solved.wall_normal_angle;
    for (int i = 0; i < 700 && outcome() == LessonOutcome::open; ++i) frames(1);
    EXPECT_EQ(outcome(), LessonOutcome::right) << step().name;
  }

  void answer_rightly() {
    switch (step().question) {
      case LessonQuestion::none:
        return;
      case LessonQuestion::choose:
        return click_on(static_cast<StageAnswer>(step().right_answer));
      case LessonQuestion::guess:
        ASSERT_TRUE(session().stage.guess);
        drag(on_window(*session().stage.guess), on_window(rest()));
        return click_on(StageCommand::next);
      case LessonQuestion::task:
        return do_task();
    }
  }
  void answer_wrongly() {
    switch (step().question) {
      case LessonQuestion::none:
        return;
      case LessonQuestion::choose:
        return press_digit(step().right_answer == 0 ? 1 : 0);
      case LessonQuestion::guess: {
        // Away from where it rests, by the arrows.
        const bool is_above = session().stage.guess->y >= rest().y;
        const double before = session().stage.guess->y;
        for (int i = 0; i < 3; ++i) press(is_above ? key::up : key::down, modifier::control);
        EXPECT_NEAR(std::abs(session().stage.guess->y - before), 0.03, 1e-9);
        return press(key::enter);
      }
      case LessonQuestion::task:
        return press(key::page_down);
    }
  }
};

// Nothing can be taken hold of that the step does not offer, and all that it does.
TEST_F(LessonWindow, OffersEndsToTurnWhereItsStepAllowsIt) {
  for (const std::string_view name : shipped_lesson_names()) {
    const auto played = std::make_shared<const Lesson>(load_lesson(std::string(name)));
    begin(played);
    for (std::size_t i = 0; i < played->steps.size(); ++i) {
      show_lesson_step(session(), i);
      frames(2);
      const StagePicture& shown = screen().stage().picture();
      const auto allows = [&](LessonControl control) { return played->steps[i].controls.contains(control); };
      const bool has_joint = has_joints(session().settings);  // such a motor is pressed, not turned
      EXPECT_EQ(shown.motor_grips.has_value(), allows(LessonControl::motor) && !has_joint) << name << " " << i;
      EXPECT_EQ(shown.wall_grips.has_value(), allows(LessonControl::wall)) << name << " " << i;
    }
  }
}

TEST_F(LessonWindow, EachLessonCanBePlayedRightlyWithThePointer) {
  for (const auto& each : shipped_lessons()) {
    SCOPED_TRACE(each->name);
    begin(each);
    const Settings before = lesson().before.settings;
    for (std::size_t i = 0; i < each->steps.size(); ++i) {
      SCOPED_TRACE(each->steps[i].name);
      ASSERT_TRUE(session().lesson);
      ASSERT_EQ(lesson().step, i);
      answer_rightly();
      frames(2);
      EXPECT_EQ(outcome(), step().question == LessonQuestion::none ? LessonOutcome::open : LessonOutcome::right);
      arrive();
      click_on(StageCommand::next);
      arrive();
    }
    EXPECT_FALSE(session().lesson);
    EXPECT_EQ(session().dialog, Dialog::lessons);
    EXPECT_EQ(session().settings, before);
    const LessonRecord& record = session().lesson_progress.lessons.at(each->name);
    EXPECT_TRUE(record.is_finished);
    for (const LessonStep& step : each->steps) {
      EXPECT_EQ(record.right.contains(step.name), step.question != LessonQuestion::none) << step.name;
    }
  }
}

TEST_F(LessonWindow, EachLessonCanBePlayedWronglyWithTheKeysAndBackwards) {
  for (const auto& each : shipped_lessons()) {
    SCOPED_TRACE(each->name);
    begin(each, "es");
    for (std::size_t i = 0; i < each->steps.size(); ++i) {
      SCOPED_TRACE(each->steps[i].name);
      ASSERT_EQ(lesson().step, i);
      answer_wrongly();
      if (step().question != LessonQuestion::none) {
        EXPECT_NE(outcome(), LessonOutcome::open);
        EXPECT_NE(outcome(), LessonOutcome::right);
      }
      if (i + 1 < each->steps.size()) press(key::page_down);
      arrive();
    }
    for (std::size_t i = each->steps.size(); i-- > 0;) {
      ASSERT_EQ(lesson().step, i);
      press(key::page_up);
      arrive();
    }
    EXPECT_TRUE(session().lesson_progress.lessons.at(each->name).right.empty());
    press(key::escape);
    EXPECT_FALSE(session().lesson);
  }
}

TEST_F(LessonWindow, ThePickerNeedsNoMouse) {
  open({.face = Face::stage});
  press(key::f5);
  ASSERT_EQ(session().dialog, Dialog::lessons);
  frames(3);
  EXPECT_TRUE(has_focus()) << "at the lesson to begin with";
  press(key::enter);
  frames(5);
  ASSERT_TRUE(session().lesson);
  EXPECT_EQ(lesson().lesson->name, shipped_lessons().front()->name);
  EXPECT_EQ(session().dialog, Dialog::none);
  // One that is done is not the one to begin with any more.
  session().lesson_progress.lessons[lesson().lesson->name].is_finished = true;
  press(key::f5);
  frames(3);
  press(key::enter);
  frames(5);
  ASSERT_TRUE(session().lesson);
  EXPECT_EQ(lesson().lesson->name, shipped_lessons()[1]->name);
}

TEST_F(LessonWindow, TheEndOfOneLeadsOnToTheNext) {
  begin(shipped_lessons()[3]);
  while (session().lesson) {
    next_lesson_step(session());
    frames(1);
  }
  ASSERT_EQ(session().dialog, Dialog::lessons);
  frames(5);
  EXPECT_TRUE(says("Next: 5. Anisotropic rendering"));
  press(key::enter);
  frames(5);
  ASSERT_TRUE(session().lesson);
  EXPECT_EQ(lesson().lesson->name, shipped_lessons()[4]->name);
}

TEST_F(LessonWindow, TheWayOutGivesTheStageBack) {
  begin(shipped_lessons().front());
  click_on(StageCommand::leave);
  EXPECT_FALSE(session().lesson);
  EXPECT_EQ(session().settings, load_scene("wall45").settings);
}

TEST_F(LessonWindow, ALessonThatIsDroppedBegins) {
  const TemporaryFolder folder;
  const std::string path = folder / "mine.toml";
  write_whole(path, read_whole(source_path("/assets/lessons/ghost.toml")));
  open({.face = Face::workbench});
  drop({path.c_str()});
  ASSERT_TRUE(session().lesson);
  EXPECT_EQ(lesson().lesson->name, "mine");
  EXPECT_EQ(session().face, Face::stage);
  // A broken one says what is wrong, and changes nothing.
  write_whole(path, "format = 1\n[[step]]\nnaem = \"x\"\n");
  drop({path.c_str()});
  EXPECT_EQ(lesson().lesson->name, "mine");
  EXPECT_NE(notice().find("mine.toml:3"), std::string::npos) << notice();
}

TEST_F(LessonWindow, AnotherSceneEndsALesson) {
  begin(shipped_lessons().front());
  act(OpenScene{"fig1"});
  frames(3);
  EXPECT_FALSE(session().lesson);
  EXPECT_EQ(session().settings, load_scene("fig1").settings);
}

TEST_F(LessonWindow, ASliderIsMovedByPointerAndKeys) {
  const auto lesson_with_slider = std::ranges::find_if(shipped_lessons(), [](const auto& each) {
    return std::ranges::any_of(each->steps, [](const LessonStep& step) { return step.slider.has_value(); });
  });
  ASSERT_NE(lesson_with_slider, shipped_lessons().end());
  begin(*lesson_with_slider);
  while (!step().slider) next_lesson_step(session());
  arrive();
  const LessonSlider& slider = *step().slider;
  const auto value = [&] { return slider_value(slider, session().settings).value_or(0.0); };
  const auto& buttons = screen().stage().picture().buttons;
  const auto box = std::ranges::find(buttons, StageAction(StageCommand::slider), &StageButton::action)->box;
  const double y = box.most.y - 10.0;
  drag({box.least.x + 30.0, y}, {box.most.x + 50.0, y});
  EXPECT_EQ(value(), slider.greatest);
  drag({box.most.x - 30.0, y}, {box.least.x - 50.0, y});
  EXPECT_EQ(value(), slider.least);
  // With the focus, the arrows are its own.
  for (int i = 0; i < 30 && !focus_takes_arrows(); ++i) press(key::tab);
  ASSERT_TRUE(focus_takes_arrows());
  press(key::right);
  EXPECT_GT(value(), slider.least);
  press(key::end);
  EXPECT_EQ(value(), slider.greatest);
}

TEST_F(LessonWindow, WorksWithADeviceInTheHand) {
  const auto with_guess = std::ranges::find_if(shipped_lessons(), [](const auto& each) {
    return std::ranges::any_of(each->steps, [](const LessonStep& s) { return s.question == LessonQuestion::guess; });
  });
  ASSERT_NE(with_guess, shipped_lessons().end());
  begin(*with_guess, "en", "virtual-falcon");
  ASSERT_TRUE(frames_until(30.0, [&] { return virtual_falcon().report().state == FalconState::idle; }));
  while (step().question != LessonQuestion::guess) next_lesson_step(session());
  arrive();
  ++session().arms_asked;
  frames(20, 400);
  ASSERT_TRUE(session().motors_may_push);
  const Vector<2> wanted = rest();
  drag(on_window(*session().stage.guess), on_window(wanted));
  EXPECT_LT(glm::distance(*session().stage.guess, wanted), 0.001);
  press(key::enter);
  EXPECT_EQ(outcome(), LessonOutcome::right);
  press(key::escape);
  EXPECT_TRUE(session().lesson) << "motors off comes first";
  frames(20, 400);
  ASSERT_FALSE(session().motors_may_push);
  press(key::escape);
  EXPECT_FALSE(session().lesson);
}

// Wherever the step before has left it.
TEST_F(LessonWindow, AStepThatSaysWhereTheHandIsBringsItThere) {
  begin(std::make_shared<const Lesson>(load_lesson("lose-a-motor")));
  const Vector<2> stated = session().goal;
  drag(on_window(session().goal), on_window({-0.01, -0.05}));
  ASSERT_NE(session().goal, stated);
  click_on(StageCommand::next);
  arrive();
  EXPECT_EQ(session().goal, stated);
  const StagePicture& shown = screen().stage().picture();
  EXPECT_TRUE(contains(shown.scene, to_screen(shown.pane.camera, session().goal)));
}

TEST_F(LessonWindow, AHandDoesNotGlideWhereMotionIsReduced) {
  begin(std::make_shared<const Lesson>(load_lesson("lose-a-motor")));
  act(ChangeMotion{ScreenMotion::reduced});
  const Vector<2> stated = session().goal;
  drag(on_window(session().goal), on_window({-0.01, -0.05}));
  ASSERT_NE(session().goal, stated);
  act(NextStep{});
  frames(1);
  EXPECT_EQ(session().goal, stated);
}

TEST_F(LessonWindow, ProgressIsForgottenOnceThePersonHasSaidSoTwice) {
  open({.face = Face::stage});
  const StageLanguage::Picker& said = english_stage.picker;
  press(key::f5);
  frames(3);
  EXPECT_FALSE(place_of(said.forget)) << "there is nothing to forget";
  session().lesson_progress.lessons["ghost"] = {.farthest = 2, .right = {"press"}};
  frames(3);
  click_on_words(said.forget);
  click_on_words(said.forget_no);
  EXPECT_NE(session().lesson_progress, LessonProgress{});
  click_on_words(said.forget);
  click_on_words(said.forget_yes);
  EXPECT_EQ(session().lesson_progress, LessonProgress{});
}

}  // namespace
}  // namespace ghostforce::lesson_window_test
