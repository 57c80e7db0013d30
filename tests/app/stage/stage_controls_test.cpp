// The stage as a tree of words and controls: what is in it, and what its controls do.
#include "app/stage/stage_controls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "app/files/scene_file.h"
#include "app/stage/lesson_content.h"
#include "app/state/apply.h"
#include "app/state/lesson_file.h"
#include "app/state/lesson_guide.h"
#include "app/state/palette_catalog.h"
#include "app/state/permit.h"
#include "app/state/proposed_path.h"
#include "app/state/stage_moment.h"
#include "core/scene_shape.h"
#include "core/wall.h"
#include "tests/app/stage/stage_dice.h"

namespace ghostforce::stage_controls_test {
namespace {

using Kind = StageControlKind;

class StageControls : public testing::Test {
 protected:
  StageReading reading() const {
    StageCase shown = stage_case_at(session.settings, session.goal);
    shown.language = &stage_language(session.language);
    shown.moment = stage_moment_at_rest(session.settings, session.goal);
    shown.mode = session.stage.mode;
    shown.why_step = session.stage.why_step;
    shown.guess = {.at = session.stage.guess, .is_open = session.stage.guess_is_open};
    if (session.lesson) {
      shown.lesson = lesson_content(session);
      shown.hides = lesson_secrets(session);
    }
    return shown.read();
  }
  std::vector<StageControl> controls() const { return stage_controls(session, {}, reading()); }
  StageControl control(std::string_view id) const {
    const std::vector<StageControl> all = controls();
    const StageControl* const found = find_control(all, id);
    EXPECT_NE(found, nullptr) << id;
    return found == nullptr ? StageControl{} : *found;
  }
  bool has(std::string_view id) const {
    const std::vector<StageControl> all = controls();
    return find_control(all, id) != nullptr;
  }
  void use(std::string_view id, double value = 0.0) {
    const StageControl used = control(id);
    ASSERT_TRUE(used.refusal.empty()) << id << ": " << used.refusal;
    for (const Action& action : used.act(value)) apply(session, action);
  }

  Session session = session_of(load_scene("wall45"));
};

std::vector<const StageControl*> all_of(std::span<const StageControl> controls) {
  std::vector<const StageControl*> all;
  for (const StageControl& each : controls) {
    all.push_back(&each);
    for (const StageControl* part : all_of(each.parts)) all.push_back(part);
  }
  return all;
}

TEST_F(StageControls, PutTheMotorAtTheOtherJoint) {
  EXPECT_FALSE(has("switch-motor")) << "there are no joints";
  session = session_of(load_scene("arm"));
  use("switch-motor");
  EXPECT_EQ(session.settings.general.arm.motor, TwoLinkArm::Motor::elbow);
}

TEST_F(StageControls, HaveWordsAndAnIdOfTheirOwnInEachLanguage) {
  for (const StageLanguage* const language : stage_languages) {
    session.language = language->code;
    const std::vector<StageControl> tree = controls();
    std::set<std::string> ids;
    for (const StageControl* const each : all_of(tree)) {
      EXPECT_FALSE(each->words.empty()) << each->id;
      EXPECT_TRUE(ids.insert(each->id).second) << each->id << " is there twice";
      EXPECT_EQ(each->words.find('|'), std::string::npos) << each->words;
    }
  }
}

TEST_F(StageControls, TellTheNumbersOfTheStage) {
  session.face = Face::stage;
  EXPECT_EQ(control("value-ghost").words, "ghost force: 1.27 N");
  EXPECT_EQ(control("value-slide").words, "slide of the hollow mark: 12.0 mm");
  EXPECT_EQ(control("value-hand").words, "hand: 20.0 mm deep in the wall, 0.0 mm along it");
  EXPECT_EQ(control("sentence").words, reading().sentence);
  session.stage.guess = session.goal;
  session.stage.mode = StageMode::predict;
  EXPECT_EQ(control("value-ghost").words, "ghost force: hidden for now");
}

// Why? speaks of the wall's push too: one word for each.
TEST_F(StageControls, CallThePartOfTheWallsPushNotThePush) {
  EXPECT_EQ(control("value-share").words, "the motor's part of the wall's push: 2.12 N");
  session.settings.active = StrategyId::full;
  EXPECT_EQ(control("value-share").words, "the wall's push, which the motors give: 3.00 N");
  use("mode-why");
  EXPECT_EQ(control("why-1").words, "1  the wall pushes straight out: 3.00 N");
}

// Whoever hears of the hollow mark and of the cure has heard what they are, and no sentence says the opposite.
TEST(StageWords, SayWhatTheHollowMarkIsAndHowTheCureWorks) {
  for (const StageLanguage* const language : stage_languages) {
    const bool is_english = language == &english_stage;
    const auto& about = language->controls.about;
    EXPECT_NE(about[1].find(is_english ? "is the hollow mark, also called the proxy" : "es la marca hueca"),
              std::string_view::npos);
    EXPECT_NE(about[2].find(is_english ? "it follows only softly" : "lo sigue solo con suavidad"),
              std::string_view::npos);
    const std::string_view cured = language->sentences.why_cured;
    EXPECT_NE(cured.find(is_english ? "follows softly" : "sigue suave"), std::string_view::npos) << cured;
  }
}

// "Where" would be a place.
TEST(StageWords, CallTheDirectionWithoutAMotorADirection) {
  std::vector<std::string> all;
  for (const StageLanguage* const language : stage_languages) {
    for (const std::string_view words : words_of(*language)) all.emplace_back(words);
    for (const auto& lesson : shipped_lessons()) {
      const LessonWords& words = words_in(*lesson, language->code);
      for (const LessonStepWords& step : words.steps) all.push_back(step.text);
    }
  }
  for (const Strategy& each : strategy_catalog()) {
    for (const std::string_view words : {each.sentence, each.with_ghost, each.without_ghost}) all.emplace_back(words);
  }
  std::size_t count = 0;
  for (const std::string& words : all) {
    for (const std::string_view place : {"here no motor is", "onde no hay motor", "here there is no motor"}) {
      EXPECT_EQ(words.find(place), std::string::npos) << words;
    }
    for (const std::string_view direction : {"direction without a motor", "dirección sin motor"}) {
      if (words.find(direction) != std::string::npos) ++count;
    }
  }
  EXPECT_GE(count, 10U);
}

TEST_F(StageControls, ListActionsAndKeysUnderHeadingsWhatIsUsedMostFirst) {
  for (const std::string_view id : {"actions", "keys"}) {
    const StageControl list = control(id);
    EXPECT_EQ(list.kind, Kind::folded);
    ASSERT_GE(list.parts.size(), 6U);
    EXPECT_EQ(list.parts.front().words, "Strategies");
    EXPECT_EQ(list.parts.back().words, "Window and language");
    for (const StageControl& group : list.parts) {
      EXPECT_EQ(group.kind, Kind::rows);
      EXPECT_FALSE(group.parts.empty()) << group.words;
      EXPECT_LE(group.parts.size(), 25U) << group.words << ": more than anybody listens to";
    }
  }
  std::size_t count = 0;
  for (const StageControl& group : control("actions").parts) count += group.parts.size();
  EXPECT_EQ(count, palette_catalog(session, {}).size());
}

// No row of the list of keys is English on a Spanish page.
TEST_F(StageControls, ListKeysInTheirLanguage) {
  const auto rows = [&] {
    std::vector<std::string> words;
    for (const StageControl& group : control("keys").parts) {
      for (const StageControl& row : group.parts) words.push_back(row.words);
    }
    return words;
  };
  const std::vector<std::string> english = rows();
  session.language = "es";
  const std::vector<std::string> spanish = rows();
  ASSERT_EQ(english.size(), spanish.size());
  for (std::size_t i = 0; i < english.size(); ++i) EXPECT_NE(english[i], spanish[i]);
  EXPECT_EQ(std::ranges::count(spanish, "Espacio: Pausar o seguir; del último minuto, volver a ahora"), 1);
  EXPECT_EQ(std::ranges::count(english, "[  ]: Turn the motor 5° (Shift: 1°)"), 1);
}

TEST_F(StageControls, ChooseTheStrategy) {
  for (const Strategy& each : strategy_catalog()) {
    const std::string id = "strategy-" + std::string(each.name);
    use(id);
    EXPECT_EQ(session.settings.active, each.id);
    EXPECT_TRUE(control(id).is_on);
  }
}

TEST_F(StageControls, MoveTheHandIntoTheWallAndAlongIt) {
  const Wall<2> wall = wall_of(session.settings);
  use("hand-depth", 12.0);
  EXPECT_NEAR(depth(wall, session.goal), 0.012, 1e-12);
  EXPECT_FALSE(session.drags_goal);
  EXPECT_EQ(control("hand-depth").about, "12.0 mm deep in the wall");
  use("hand-along", 7.0);
  EXPECT_NEAR(depth(wall, session.goal), 0.012, 1e-12);
  EXPECT_NEAR(control("hand-along").value, 7.0, 1e-9);
  use("hand-depth", -3.0);
  EXPECT_EQ(control("hand-depth").about, "3.0 mm in front of the wall");
  EXPECT_NEAR(control("hand-along").value, 7.0, 1e-9);
}

TEST_F(StageControls, TurnMotorAndWallAndRatio) {
  use("motor", 30.0);
  EXPECT_NEAR(session.settings.actuated_angle, 30.0 * radians_per_degree, 1e-12);
  EXPECT_EQ(control("motor").about, "at 30°, counted from the right");
  // An angle is nothing without what it is measured from.
  for (const std::string_view id : {"motor", "wall"}) {
    EXPECT_TRUE(control(id).words.ends_with("counterclockwise from the right")) << control(id).words;
  }
  use("wall", -45.0);
  EXPECT_NEAR(session.settings.wall_normal_angle, -45.0 * radians_per_degree, 1e-12);
  const double before = tracking_ratio(session.settings.stiffnesses);
  use("ratio", control("ratio").value + 1.0);
  EXPECT_NEAR(tracking_ratio(session.settings.stiffnesses), 1.05 * before, 1e-9);
}

TEST_F(StageControls, LeadThroughWhyWithItsWords) {
  session.settings.active = StrategyId::naive;
  use("mode-why");
  EXPECT_TRUE(control("mode-why").is_on);
  EXPECT_TRUE(has("why-1"));
  EXPECT_FALSE(has("why-2"));
  for (int i = 0; i < 3; ++i) apply(session, GoOn{});
  EXPECT_EQ(control("why-3").words, "3  no motor gives the part upwards (2.12 N): the handle slides");
  EXPECT_EQ(control("why-4").words, "4  the slide adds: ghost force 1.27 N");
  session.settings.actuated_angle = 30.0 * radians_per_degree;
  EXPECT_TRUE(control("why-3").words.starts_with("3  no motor gives the part up and to the left (2.89 N): "))
      << control("why-3").words;
  session.settings.active = StrategyId::anisotropic;
  session.language = "es";
  session.settings.actuated_angle = 0.0;
  EXPECT_EQ(control("why-3").words, "3  falta la parte hacia arriba (2.12 N): solo cede el mango");
}

TEST_F(StageControls, MoveAGuess) {
  session.stage.mode = StageMode::predict;
  session.stage.guess = session.goal;
  use("guess-depth", 5.0);
  EXPECT_NEAR(depth(wall_of(session.settings), *session.stage.guess), 0.005, 1e-12);
  EXPECT_NEAR(depth(wall_of(session.settings), session.goal), 0.020, 1e-9);
  session.stage.guess_is_open = false;
  EXPECT_FALSE(has("guess-depth"));
}

TEST_F(StageControls, SetThePlaceOnTheLandscape) {
  apply(session, ToggleMode{StageMode::landscape});
  use("landscape-dial", 100.0);
  EXPECT_EQ(session.settings.active, StrategyId::anisotropic);
  const double before = landscape_point(session.settings).kappa;
  use("landscape-stiffness", control("landscape-stiffness").value + 1.0);
  EXPECT_NEAR(landscape_point(session.settings).kappa, 1.05 * before, 1e-9);
}

// Each step of each lesson: what may be done has its control, and nothing else is offered.
TEST_F(StageControls, AreThoseThatALessonLeavesToThePerson) {
  for (const auto& lesson : shipped_lessons()) {
    begin_lesson(session, lesson);
    for (std::size_t i = 0; i < lesson->steps.size(); ++i) {
      show_lesson_step(session, i);
      const LessonStep& step = lesson->steps[i];
      const std::string where = lesson->name + " " + std::to_string(i + 1);
      EXPECT_EQ(control("lesson-place").words, std::to_string(i + 1) + " of " + std::to_string(lesson->steps.size()));
      EXPECT_EQ(has("lesson-slider"), step.slider.has_value()) << where;
      EXPECT_EQ(has("wall"), step.controls.contains(LessonControl::wall)) << where;
      // A motor at a joint has no angle of its own.
      EXPECT_EQ(has("motor"), step.controls.contains(LessonControl::motor) && !has_joints(session.settings)) << where;
      EXPECT_EQ(has("strategies"), step.controls.contains(LessonControl::strategies)) << where;
      EXPECT_EQ(has("answer-1"), step.question == LessonQuestion::choose) << where;
      EXPECT_EQ(has("guess-depth"), step.question == LessonQuestion::guess) << where;
      EXPECT_FALSE(has("modes")) << where;
      if (step.slider) use("lesson-slider", 50.0);
    }
    leave_lesson(session);
  }
  EXPECT_FALSE(has("lesson"));
}

TEST_F(StageControls, AnswerALesson) {
  begin_lesson(session, std::make_shared<const Lesson>(load_lesson("ghost")));
  const std::size_t right = lesson_step(*session.lesson).right_answer;
  EXPECT_FALSE(has("lesson-outcome"));
  use("answer-" + std::to_string(right + 1));
  EXPECT_EQ(control("lesson-outcome").words, "Right.");
  EXPECT_EQ(control("answer-" + std::to_string(right + 1)).about, "right answer");
  EXPECT_FALSE(control("answer-1").refusal.empty()) << "the question is closed";
  use("lesson-next");
  EXPECT_EQ(session.lesson->step, 1U);
  use("lesson-back");
  EXPECT_EQ(session.lesson->step, 0U);
  use("lesson-leave");
  EXPECT_FALSE(session.lesson);
}

TEST_F(StageControls, TellATask) {
  begin_lesson(session, std::make_shared<const Lesson>(load_lesson("ghost")));
  show_lesson_step(session, 3);
  ASSERT_EQ(lesson_step(*session.lesson).question, LessonQuestion::task);
  EXPECT_TRUE(control("task-1").words.starts_with("ghost force: ")) << control("task-1").words;
}

TEST_F(StageControls, TellAnEffortInItsUnit) {
  Lesson lesson = load_lesson("an-arm");
  lesson.steps[4].conditions = {{.quantity = LessonQuantity::effort, .least = 0.2},
                                {.quantity = LessonQuantity::active_walls, .least = 1.0}};
  begin_lesson(session, std::make_shared<const Lesson>(lesson));
  show_lesson_step(session, 4);
  ASSERT_EQ(lesson_step(*session.lesson).question, LessonQuestion::task);
  const std::string effort = control("task-1").words;
  EXPECT_TRUE(effort.starts_with("effort of the motor that works hardest: ")) << effort;
  EXPECT_NE(effort.find(" N·m ("), std::string::npos) << effort;
  EXPECT_TRUE(control("task-2").words.starts_with("acting walls: ")) << control("task-2").words;
}

TEST_F(StageControls, AreOnlyTheLessonsForAVisitor) {
  session.kiosk_visit = KioskVisit{.lessons = {shipped_lessons().front()}, .language = "en"};
  begin_lesson(session, shipped_lessons().front());
  for (const std::string_view id : {"actions", "keys", "lessons", "modes", "lesson-leave"}) EXPECT_FALSE(has(id)) << id;
  session.dialog = Dialog::lessons;
  EXPECT_FALSE(has("dialog")) << "there is no way to it";
  EXPECT_EQ(control("lesson-language").words, "Español");
  EXPECT_EQ(control("lesson-language").language, "es");
}

TEST_F(StageControls, TellANoticeUntilItIsDismissed) {
  EXPECT_FALSE(has("notice"));
  session.notice = Notice{"Something", true};
  EXPECT_EQ(control("notice").kind, Kind::alert);
  EXPECT_EQ(control("notice").language, "") << "that of all";
  session.notice->language = "en";
  EXPECT_EQ(control("notice").language, "en");
  use("notice-close");
  EXPECT_FALSE(has("notice"));
}

TEST_F(StageControls, SayWhichSceneIsOpenedAndWhatIsClosed) {
  EXPECT_EQ(control("value-scene").words, "scene: " + session.scene->title);
  session.dialog = Dialog::save_picture;
  EXPECT_EQ(control("dialog").about, "Closed: Save a picture.");
  begin_lesson(session, shipped_lessons().front());
  EXPECT_FALSE(has("value-scene")) << "a lesson chooses it";
  EXPECT_EQ(control("lesson").about, "Closed: " + control("lesson").words + ".");
}

TEST_F(StageControls, SayWhereMotorAndWallPush) {
  apply(session, TurnMotorTo{0.5236});
  EXPECT_EQ(control("value-motor").words, "the motor pushes at 30°, counted from the right");
  EXPECT_EQ(control("value-wall").words, "the wall pushes at 135°, counted from the right");
}

TEST_F(StageControls, HaveWhatEachDialogCanDoAndAWayOut) {
  for (int i = 1; i <= static_cast<int>(Dialog::reset_preferences); ++i) {
    if (static_cast<Dialog>(i) == Dialog::save_clip) continue;  // on the desktop alone
    session.dialog = static_cast<Dialog>(i);
    const std::vector<StageControl> tree = controls();
    std::set<std::string> ids;
    for (const StageControl* const each : all_of(tree)) EXPECT_TRUE(ids.insert(each->id).second) << each->id;
    EXPECT_EQ(control("dialog").kind, Kind::dialog);
    EXPECT_GT(control("dialog").parts.size(), 1U) << "more than its way out, of dialog " << i;
    use("dialog-close");
    EXPECT_FALSE(has("dialog"));
  }
}

TEST_F(StageControls, HaveAListWhereItsDialogShowsIt) {
  for (const auto& [dialog, list, row] : {std::tuple{Dialog::lessons, "lessons", "begin-ghost"},
                                          {Dialog::help, "keys", "key-1"},
                                          {Dialog::palette, "actions", "action-1"}}) {
    session.dialog = dialog;
    EXPECT_FALSE(has(list)) << "twice the same";
    EXPECT_NE(find_control(control("dialog").parts, row), nullptr) << list;
    session.dialog = Dialog::none;
    EXPECT_TRUE(has(list));
  }
}

TEST_F(StageControls, SaveWhatADialogSavesUnderTheNameThatItProposes) {
  session.dialog = Dialog::save_picture;
  const std::vector<Action> actions = control("save-scene-alone").act(0.0);
  ASSERT_EQ(actions.size(), 2U);
  const SavePicture& saved = std::get<SavePicture>(actions.front());
  EXPECT_EQ(saved.path, proposed_path(session, Dialog::save_picture));
  EXPECT_TRUE(saved.scene_alone);
  EXPECT_TRUE(std::holds_alternative<CloseDialog>(actions.back()));
  EXPECT_FALSE(std::get<SavePicture>(control("save-window").act(0.0).front()).scene_alone);
}

// The dialog stays open over what could not be opened.
TEST_F(StageControls, SayWhyASceneCannotBeOpened) {
  session.dialog = Dialog::open_scene;
  EXPECT_FALSE(has("open-problem"));
  session.form.problem = "nothing is there";
  EXPECT_EQ(control("open-problem").kind, Kind::alert);
  EXPECT_EQ(control("open-problem").words, "nothing is there");
}

TEST_F(StageControls, CloseThePaletteBeforeWhatItsRowsDo) {
  session.dialog = Dialog::palette;
  const std::vector<Action> actions = control("action-1").act(0.0);
  ASSERT_GE(actions.size(), 2U);
  EXPECT_TRUE(std::holds_alternative<CloseDialog>(actions.front()));
}

TEST_F(StageControls, AskBeforeTheyForgetLessons) {
  session.dialog = Dialog::lessons;
  EXPECT_FALSE(has("forget")) << "there is nothing to forget";
  session.lesson_progress.lessons["ghost"] = {};
  EXPECT_EQ(control("forget").kind, Kind::folded);
  use("forget-lessons");
  EXPECT_FALSE(has("forget"));
}

TEST_F(StageControls, CallADialogAsItsActionIsCalled) {
  for (const auto& [dialog, name] : {std::pair{Dialog::doctor, "Device status"}, {Dialog::lessons, "Lessons"}}) {
    session.dialog = dialog;
    EXPECT_TRUE(control("dialog").words.find(name) != std::string::npos) << control("dialog").words;
  }
}

TEST(SettledTexts, TellWhatHasStoodForTwoLooks) {
  SettledTexts texts;
  const auto told = [&](const std::string& words, bool is_later) {
    std::vector<StageControl> one{{.id = "a", .kind = Kind::told, .words = words}};
    texts.settle(one, is_later);
    return one.front().words;
  };
  EXPECT_EQ(told("1", true), "1");
  EXPECT_EQ(told("2", true), "1");
  EXPECT_EQ(told("3", true), "1");
  EXPECT_EQ(told("3", false), "1") << "no time has passed";
  EXPECT_EQ(told("3", true), "3");
  std::vector<StageControl> nothing;
  texts.settle(nothing, true);
  EXPECT_EQ(told("4", true), "4") << "it is there anew";
}

// A hand that goes round never stands still.
TEST(SettledTexts, TellNowAndThenWhatGoesOnChanging) {
  SettledTexts texts;
  std::set<std::string> told;
  for (int look = 0; look <= 24; ++look) {
    std::vector<StageControl> one{{.id = "a", .kind = Kind::told, .words = std::to_string(look)}};
    texts.settle(one, true);
    told.insert(one.front().words);
  }
  EXPECT_EQ(told, (std::set<std::string>{"0", "8", "16", "24"}));
}

// Where the hand has come to and what that has led to are one message.
TEST(SettledTexts, TellTogetherWhatStandsTogether) {
  SettledTexts texts;
  const auto told = [&](const std::string& hand, const std::string& force) {
    std::vector<StageControl> two{{.id = "group",
                                   .kind = Kind::group,
                                   .words = "Values",
                                   .parts = {{.id = "hand", .kind = Kind::told, .words = hand},
                                             {.id = "force", .kind = Kind::told, .words = force}}}};
    texts.settle(two, true);
    return two.front().parts[0].words + " " + two.front().parts[1].words;
  };
  EXPECT_EQ(told("20", "1.27"), "20 1.27");
  EXPECT_EQ(told("18", "1.20"), "20 1.27");
  EXPECT_EQ(told("18", "1.14"), "20 1.27") << "the force still changes";
  EXPECT_EQ(told("18", "1.14"), "18 1.14");
}

TEST_F(StageControls, TellTheHandAndWhatItLeadsToOnceTheyHaveSettled) {
  for (const std::string_view id : {"value-hand", "value-ghost", "value-slide", "value-share"})
    EXPECT_EQ(control(id).kind, Kind::told);
}

}  // namespace
}  // namespace ghostforce::stage_controls_test
