// The stage in a lesson, over many steps by dice: all that is said has room, nothing covers anything else, and what an open
// question asks for is not to be seen.
#include <gtest/gtest.h>

#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "app/stage/lesson_content.h"
#include "app/state/lesson_file.h"
#include "core/conventions.h"
#include "tests/app/stage/stage_faults.h"

namespace ghostforce::stage_lesson_test {
namespace {

constexpr int cases = 700;

class StageInLesson : public testing::TestWithParam<const StageLanguage*> {};
INSTANTIATE_TEST_SUITE_P(InEachLanguage, StageInLesson, testing::ValuesIn(stage_languages),
                         [](const auto& each) { return std::string(each.param->code); });

// Long texts, many answers and every secret.
TEST_P(StageInLesson, HasNoWordsOverMarksOrEachOtherOrCutOff) {
  PictureDice dice(20261122);
  int faulty = 0;
  for (int i = 0; i < cases; ++i) {
    const StageCase shown = lesson_case_by(dice, *GetParam());
    const Drawn drawn(shown.compose());
    const std::vector<std::string> faults = faults_of(shown, drawn);
    if (faults.empty()) continue;
    if (++faulty > 20) continue;
    for (const std::string& fault : faults) ADD_FAILURE() << "case " << i << " " << words_for(shown) << ": " << fault;
  }
  EXPECT_EQ(faulty, 0);
}

// All of what a lesson says and asks is there, and each button is as large as a finger.
TEST_P(StageInLesson, HasRoomForAllOfALesson) {
  PictureDice dice(3);
  for (int i = 0; i < cases / 2; ++i) {
    const StageCase shown = lesson_case_by(dice, *GetParam());
    const Drawn drawn(shown.compose());
    std::string said;
    for (const LabelExtent& label : drawn.extents.labels) said += label.words + ' ';
    const StageLesson& lesson = *shown.lesson;
    std::vector<std::string> wanted{lesson.text, lesson.title, lesson.place, lesson.next};
    wanted.insert(wanted.end(), lesson.row().answers.begin(), lesson.row().answers.end());
    for (const std::string& words : wanted) {
      EXPECT_NE(said.find(words), std::string::npos) << words << " in " << i << " " << words_for(shown);
    }
    const ScreenBox window{Vector<2>(0.0), shown.size};
    for (const StageButton& button : drawn.picture.buttons) {
      EXPECT_TRUE(lies_in(button.box, window)) << i << " " << words_for(shown);
      EXPECT_GE(std::min(button.box.extent().x, button.box.extent().y), 40.0 * drawn.picture.unit - rounding);
    }
    if (drawn.picture.ribbon) continue;  // it takes a share of its own
    EXPECT_GE(drawn.picture.scene.extent().y, 0.3 * shown.size.y) << i << " " << words_for(shown);
  }
}

TEST_P(StageInLesson, HasFitAndReset) {
  PictureDice dice(5);
  for (int i = 0; i < cases / 2; ++i) {
    StageCase shown = lesson_case_by(dice, *GetParam());
    const auto has = [&](StageCommand command) {
      return std::ranges::count(Drawn(shown.compose()).picture.buttons, StageAction(command), &StageButton::action) ==
             1;
    };
    const bool has_view = shown.mode != StageMode::landscape && shown.mode != StageMode::round;
    for (const StageCommand command : {StageCommand::fit, StageCommand::reset}) {
      shown.lesson->has_way_out = true;
      EXPECT_EQ(has(command), has_view) << i << " " << words_for(shown);
      shown.lesson->has_way_out = false;
      EXPECT_FALSE(has(command)) << "of a visitor: " << i << " " << words_for(shown);
    }
  }
}

TEST_P(StageInLesson, TellsNoSecrets) {
  StageCase shown = stage_case_at(wall45(), wall45_goal);
  shown.language = GetParam();
  const StageLanguage::Labels& labels = GetParam()->labels;
  PictureDice dice(1);
  shown.lesson = lesson_case_by(dice, *GetParam()).lesson;
  shown.lesson->rows[shown.lesson->step] = {};
  shown.lesson->marks.clear();
  const auto words = [&] {
    std::string said;
    for (const LabelExtent& label : Drawn(shown.compose()).extents.labels) said += label.words + '|';
    return said;
  };
  ASSERT_NE(words().find("1.27"), std::string::npos);
  shown.hides = {.numbers = true};
  EXPECT_EQ(words().find("1.27"), std::string::npos);
  EXPECT_EQ(words().find("12.0"), std::string::npos);
  EXPECT_NE(Drawn(shown.compose()).label(Role::ghost_force), nullptr) << "it may be seen";
  shown.hides = {.force = true};
  EXPECT_EQ(words().find("1.27"), std::string::npos);
  EXPECT_EQ(Drawn(shown.compose()).label(Role::ghost_force), nullptr);
  EXPECT_NE(words().find("12.0"), std::string::npos);
  shown.hides = {.slide = true};
  EXPECT_EQ(words().find("12.0"), std::string::npos);
  EXPECT_NE(words().find("1.27"), std::string::npos);
  ASSERT_NE(Drawn(shown.compose()).label(Role::expected_rest), nullptr);
  shown.hides = {.rest = true};
  EXPECT_EQ(words().find(labels.should_rest), std::string::npos);
  EXPECT_EQ(Drawn(shown.compose()).label(Role::expected_rest), nullptr);
  EXPECT_NE(words().find(labels.handle), std::string::npos);
  shown.hides = {.handle = true};
  const Drawn hidden(shown.compose());
  for (const Role role : {Role::device, Role::proxy, Role::ghost_force, Role::wall_share, Role::proxy_drift,
                          Role::expected_rest, Role::number}) {
    EXPECT_TRUE(std::ranges::none_of(hidden.picture.pane.marks, [&](const Mark& mark) { return mark.role == role; }))
        << role_name(role);
  }
}

// What is read aloud tells no more than what is seen.
TEST(StageLesson, TellsNoSecretsToListeners) {
  StageCase shown = stage_case_at(wall45(), wall45_goal);
  PictureDice dice(1);
  shown.lesson = lesson_case_by(dice).lesson;
  const auto hiding = [&](const StageSecrets& secrets) {
    shown.hides = secrets;
    return shown.read().numbers;
  };
  const StageNumbers all = hiding({});
  EXPECT_NEAR(all.ghost_force.value(), 1.27, 0.005);
  for (const StageSecrets& secrets : {StageSecrets{.numbers = true}, StageSecrets{.handle = true}}) {
    const StageNumbers none = hiding(secrets);
    EXPECT_FALSE(none.force || none.wall_share || none.ghost_force || none.slide);
  }
  const StageNumbers without_force = hiding({.force = true});
  EXPECT_FALSE(without_force.force || without_force.wall_share || without_force.ghost_force);
  EXPECT_EQ(without_force.slide, all.slide);
  const StageNumbers without_slide = hiding({.slide = true});
  EXPECT_FALSE(without_slide.slide);
  EXPECT_EQ(without_slide.ghost_force, all.ghost_force);
  shown.mode = StageMode::landscape;
  EXPECT_TRUE(shown.read().sentence.starts_with(shown.lesson->text)) << "the map's verdict may be the answer";
}

TEST(StageLesson, ReadsTheAnswersOfAnOpenQuestion) {
  StageCase shown = stage_case_at(wall45(), wall45_goal);
  StageLesson& lesson = shown.lesson.emplace();
  lesson.text = "Where to?";
  lesson.rows = {{.answers = {"Up", "Down"}}};
  lesson.is_open = true;
  EXPECT_EQ(shown.read().sentence, "Where to? 1: Up. 2: Down.");
  lesson.is_open = false;
  EXPECT_EQ(shown.read().sentence, "Where to?");
}

// Letters are as large in one step as in the next.
TEST_P(StageInLesson, HasLettersOfOneSizeInALesson) {
  PictureDice dice(8);
  for (int i = 0; i < 40; ++i) {
    StageCase shown = lesson_case_by(dice, *GetParam());
    std::set<double> units;
    for (std::size_t step = 0; step < shown.lesson->rows.size(); ++step) {
      shown.lesson->step = step;
      shown.lesson->marks.assign(shown.lesson->row().answers.size(), LessonMark::none);
      shown.lesson->chosen.reset();
      units.insert(shown.compose().unit);
    }
    EXPECT_EQ(units.size(), 1U) << words_for(shown);
  }
}

// Where things are, to a tenth of a millimetre.
std::string things_of(const Pane& pane) {
  std::string things;
  const auto add = [&](Role role, const Vector<2>& place) {
    things += fmt::format("{} {:.1f} {:.1f}\n", role_name(role), mm_per_m * place.x, mm_per_m * place.y);
  };
  for (const Mark& mark : pane.marks) {
    if (const auto* line = std::get_if<Line>(&mark.form)) add(mark.role, line->from), add(mark.role, line->to);
    if (const auto* marker = std::get_if<Marker>(&mark.form)) add(mark.role, marker->center);
  }
  return things;
}

TEST(LessonCards, DifferFromOneAnother) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < shipped_lessons().size(); ++i) {
    const Pane card = lesson_card(i, *find_theme("light"), {150.0, 92.0}, 0.5);
    EXPECT_TRUE(seen.insert(things_of(card)).second) << shipped_lessons()[i]->name;
  }
}

// What lies on top in each field of a grid, as somebody sees it from afar; a role's number, or -1.
std::vector<int> seen_in(const Pane& card) {
  constexpr double field = 5.0;  // [points]
  const PictureExtents extents(card, measure);
  std::vector<int> seen;
  for (double y = 0.0; y < card.camera.size.y; y += field) {
    for (double x = 0.0; x < card.camera.size.x; x += field) {
      const Vector<2> middle = Vector<2>(x, y) + Vector<2>(0.5 * field);
      int top = -1;
      for (const Extent& extent : extents.marks) {
        if (reach_into(ScreenBox{middle, middle}.grown(0.3 * field), extent) <= 0.0) continue;
        const std::optional<StrategyId> strategy = card.marks[extent.mark].strategy;
        top = 4 * static_cast<int>(extent.role) + (strategy ? static_cast<int>(index_of(*strategy)) : 3);
      }
      seen.push_back(top);
    }
  }
  return seen;
}

// Also for who does not look closely.
TEST(LessonCards, LookDifferentFromAfar) {
  std::vector<std::vector<int>> all;
  for (std::size_t i = 0; i < shipped_lessons().size(); ++i) {
    all.push_back(seen_in(lesson_card(i, *find_theme("light"), {150.0, 92.0}, 0.5)));
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      int differing = 0;
      for (std::size_t field = 0; field < all[i].size(); ++field) differing += all[i][field] != all[k][field] ? 1 : 0;
      EXPECT_GE(differing, static_cast<int>(all[i].size() / 8))
          << shipped_lessons()[k]->name << " and " << shipped_lessons()[i]->name;
    }
  }
}

}  // namespace
}  // namespace ghostforce::stage_lesson_test
