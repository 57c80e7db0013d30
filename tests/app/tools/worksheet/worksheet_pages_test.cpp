// Worksheets as pages: each lesson that comes with the program fits on one, in each language and on each paper, and none
// says which answer is right before it is asked to.
#include <algorithm>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/paint/vector/vector_painter.h"
#include "app/picture/screen_box.h"
#include "app/state/lesson_file.h"
#include "app/tools/worksheet/worksheet.h"

namespace ghostforce::worksheet_pages_test {
namespace {

using Pages = std::vector<std::vector<Pane>>;

struct Word {
  std::string text;
  TextStyle style;
  ScreenBox box;  // on the page
};

ScreenBox box_of(const Pane& pane) {
  return {pane.corner, pane.corner + pane.camera.size};
}

std::vector<Word> words_on(const Pane& pane) {
  std::vector<Word> words;
  for (const Mark& mark : pane.marks) {
    const auto* const label = std::get_if<Label>(&mark.form);
    if (label == nullptr) continue;
    const Vector<2> corner = pane.corner + to_screen(pane.camera, label->anchor) + label->offset;
    words.push_back({label->text, label->style, {corner, corner + measure_vector_text(label->text, label->style)}});
  }
  return words;
}

// All words of the pages without their pictures, as somebody reads them.
std::string text_of(const Pages& pages) {
  std::string text;
  for (const std::vector<Pane>& page : pages) {
    for (const Word& word : words_on(page.front())) text += word.text + ' ';
  }
  return text;
}

std::size_t count_of(const Pane& pane, Role role) {
  return static_cast<std::size_t>(std::ranges::count(pane.marks, role, &Mark::role));
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Lesson, language, paper, and whether with the answers.
using Case = std::tuple<std::string_view, std::string_view, std::string_view, bool>;

class ShippedWorksheet : public testing::TestWithParam<Case> {
 protected:
  std::shared_ptr<const Lesson> lesson_ =
      std::make_shared<const Lesson>(load_lesson(std::string(std::get<0>(GetParam()))));
  std::string language_{std::get<1>(GetParam())};
  WorksheetPaper paper_ = *std::ranges::find(worksheet_paper_catalog, std::get<2>(GetParam()), &WorksheetPaper::name);
  WorksheetSide side_ = std::get<3>(GetParam()) ? WorksheetSide::answers : WorksheetSide::questions;
  Pages pages_ = worksheet_of(lesson_, {.language = language_, .paper = &paper_, .side = side_});
  const LessonWords& words_ = lesson_->words.at(language_);
};

std::string name_of_case(const testing::TestParamInfo<Case>& tested) {
  const auto& [lesson, language, paper, has_answers] = tested.param;
  std::string name = fmt::format("{}_{}_{}_{}", lesson, language, paper, has_answers ? "answers" : "questions");
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, ShippedWorksheet,
                         testing::Combine(testing::ValuesIn(shipped_lesson_names()), testing::Values("en", "es"),
                                          testing::Values("a4", "letter"), testing::Bool()),
                         name_of_case);

TEST_P(ShippedWorksheet, FitsOnOnePageWithNothingCutOffOrCovered) {
  ASSERT_EQ(pages_.size(), 1U);
  const std::vector<Pane>& page = pages_.front();
  constexpr double rounding = 0.01;
  const ScreenBox inside = ScreenBox{Vector<2>(0.0), paper_.size}.grown(rounding - worksheet_margin);
  std::vector<Word> words = words_on(page.front());
  for (const Word& word : words) {
    EXPECT_TRUE(contains(inside, word.box.least) && contains(inside, word.box.most)) << word.text;
    for (std::size_t i = 1; i < page.size(); ++i) {
      EXPECT_EQ(overlap(word.box, box_of(page[i])), 0.0) << word.text << " covers a picture";
    }
    // Lines to write on begin behind the words.
    for (const Mark& mark : page.front().marks) {
      const auto* const line = std::get_if<Line>(&mark.form);
      if (line == nullptr || mark.role != Role::grid) continue;
      ScreenPiece piece{to_screen(page.front().camera, line->from), to_screen(page.front().camera, line->to)};
      EXPECT_TRUE(contains(inside, piece.from) && contains(inside, piece.to));
      EXPECT_FALSE(clip(word.box.grown(-0.5), piece)) << word.text << " is crossed out";
    }
  }
  for (std::size_t i = 1; i < page.size(); ++i) {
    EXPECT_TRUE(contains(inside, box_of(page[i]).least) && contains(inside, box_of(page[i]).most));
    for (std::size_t k = 1; k < i; ++k) EXPECT_EQ(overlap(box_of(page[i]), box_of(page[k])), 0.0);
    for (const Word& word : words_on(page[i])) {
      EXPECT_TRUE(contains(box_of(page[i]), word.box.least) && contains(box_of(page[i]), word.box.most)) << word.text;
      words.push_back(word);
    }
  }
  for (std::size_t i = 0; i < words.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_LT(overlap(words[i].box.grown(-0.5), words[k].box.grown(-0.5)), rounding)
          << words[i].text << " / " << words[k].text;
    }
  }
}

TEST_P(ShippedWorksheet, HasNoSmallLetters) {
  constexpr double line_of_em = 1.1641;  // of the font: a line's height over its size
  for (const Pane& pane : pages_.front()) {
    for (const Word& word : words_on(pane)) EXPECT_GE(word.style.height / line_of_em, least_worksheet_em) << word.text;
  }
}

TEST_P(ShippedWorksheet, AsksEachQuestionAndAnswersOnlyWhenAskedTo) {
  const std::string text = text_of(pages_);
  const bool has_answers = side_ == WorksheetSide::answers;
  EXPECT_TRUE(holds(text, words_.title));
  std::size_t choices = 0;
  for (std::size_t i = 0; i < lesson_->steps.size(); ++i) {
    if (lesson_->steps[i].question == LessonQuestion::none) continue;
    const LessonStepWords& words = words_.steps[i];
    EXPECT_TRUE(holds(text, words.text)) << words.text;
    for (const std::string& answer : words.answers) EXPECT_TRUE(holds(text, answer)) << answer;
    EXPECT_EQ(holds(text, words.wrong), has_answers) << words.wrong;
    if (!has_answers) {
      EXPECT_FALSE(holds(text, words.right)) << words.right;
    }
    if (lesson_->steps[i].question != LessonQuestion::choose) continue;
    ++choices;
    const std::vector<Word> all = words_on(pages_.front().front());
    const std::string& right = words.answers[lesson_->steps[i].right_answer];
    EXPECT_EQ(std::ranges::any_of(all, [&](const Word& word) { return word.text == right && word.style.is_bold; }),
              has_answers)
        << right;
  }
  // Two strokes are a tick.
  EXPECT_EQ(count_of(pages_.front().front(), Role::hint), has_answers ? 2 * choices : 0);
}

// What a picture shows of the lesson's step that it stands beside.
TEST_P(ShippedWorksheet, ShowsInPicturesWhatMayBeSeen) {
  const std::vector<WorksheetItem> items = worksheet_items(*lesson_, language_, side_);
  std::size_t picture = 0;
  for (const WorksheetItem& item : items) {
    if (item.picture_share == 0.0) continue;
    ASSERT_LT(++picture, pages_.front().size());
    const Pane& pane = pages_.front()[picture];
    const LessonStep& step = lesson_->steps[item.step];
    const bool is_open = side_ == WorksheetSide::questions;
    const bool has_handle = !is_open || (step.question != LessonQuestion::guess && !item.hides_handle);
    EXPECT_EQ(count_of(pane, Role::device) > 0, has_handle) << item.number;
    EXPECT_EQ(count_of(pane, Role::guess), 0U) << "the ring is on the screen";
    EXPECT_EQ(count_of(pane, Role::button) + count_of(pane, Role::sentence), 0U) << item.number;
    if (is_open && step.secrets.contains(LessonSecret::force)) {
      EXPECT_EQ(count_of(pane, Role::ghost_force) + count_of(pane, Role::wall_share), 0U) << item.number;
    }
    if (is_open && step.secrets.contains(LessonSecret::slide)) {
      EXPECT_EQ(count_of(pane, Role::proxy_drift), 0U) << item.number;
    }
  }
  EXPECT_EQ(picture + 1, pages_.front().size());
}

// However it is looked at, the page is the same whatever is right.
TEST(Worksheet, OfTheQuestionsKnowsNothingOfTheAnswers) {
  for (const std::string_view name : shipped_lesson_names()) {
    const auto lesson = std::make_shared<const Lesson>(load_lesson(std::string(name)));
    auto other = std::make_shared<Lesson>(*lesson);
    for (std::size_t i = 0; i < other->steps.size(); ++i) {
      LessonStepWords& words = other->words.at("en").steps[i];
      if (!words.answers.empty()) {
        other->steps[i].right_answer = (other->steps[i].right_answer + 1) % words.answers.size();
      }
      words.right = words.wrong = "Something else.";
    }
    const auto file = [](const std::shared_ptr<const Lesson>& each, WorksheetSide side) {
      const WorksheetChoice choice{.side = side};
      return worksheet_file(worksheet_of(each, choice), *choice.paper, "");
    };
    EXPECT_TRUE(file(lesson, WorksheetSide::questions) == file(other, WorksheetSide::questions)) << name;
    EXPECT_FALSE(file(lesson, WorksheetSide::answers) == file(other, WorksheetSide::answers)) << name;
  }
}

TEST(Worksheet, OfALongLessonTakesMorePagesAndNoSmallerLetters) {
  auto lesson = std::make_shared<Lesson>(load_lesson("ghost"));
  const std::vector<LessonStep> steps = lesson->steps;
  for (int i = 0; i < 3; ++i) {
    lesson->steps.insert(lesson->steps.end(), steps.begin(), steps.end());
    for (auto& [language, words] : lesson->words) {
      words.steps.insert(words.steps.end(), words.steps.begin(),
                         words.steps.begin() + static_cast<std::ptrdiff_t>(steps.size()));
    }
  }
  for (const WorksheetSide side : {WorksheetSide::questions, WorksheetSide::answers}) {
    const WorksheetChoice choice{.side = side};
    const Pages pages = worksheet_of(lesson, choice);
    EXPECT_GT(pages.size(), 2U);
    std::size_t pictures = 0;
    for (const std::vector<Pane>& page : pages) {
      pictures += page.size() - 1;
      for (const Word& word : words_on(page.front())) {
        EXPECT_TRUE(contains(box_of(page.front()).grown(-worksheet_margin + 0.01), word.box.most)) << word.text;
      }
    }
    EXPECT_EQ(pictures, 20U) << "of 5 questions, four times";
    EXPECT_TRUE(holds(text_of(pages), fmt::format("1 / {}", pages.size())));
  }
}

TEST(Worksheet, SaysHowItsLessonIsOpened) {
  const auto text_for = [](const std::string& file, WorksheetSide side) {
    auto lesson = std::make_shared<Lesson>(load_lesson("ghost"));
    lesson->file = file;
    return text_of(worksheet_of(lesson, {.side = side}));
  };
  EXPECT_TRUE(holds(text_for("", WorksheetSide::questions), "Open this lesson on the screen (F5). Answer each"));
  EXPECT_TRUE(holds(text_for("", WorksheetSide::questions), "ghostforce run --lesson ghost "));
  const std::string own = text_for("lessons/my own.toml", WorksheetSide::questions);
  EXPECT_TRUE(holds(own, "Open this lesson on the screen. Answer each"));
  EXPECT_FALSE(holds(own, "F5"));
  EXPECT_TRUE(holds(own, "ghostforce run --lesson 'lessons/my own.toml' "));
  EXPECT_TRUE(holds(text_for("gh\xffst.toml", WorksheetSide::answers), "ghostforce run --lesson 'gh\\xFFst.toml' "));
  const std::string far = text_for(std::string(300, 'a') + "/own.toml", WorksheetSide::answers);
  EXPECT_TRUE(holds(far, "ghostforce run --lesson own.toml ")) << "in its folder, where the whole path has no room";
  EXPECT_FALSE(holds(text_for(std::string(250, 'w') + ".toml", WorksheetSide::answers), "--lesson"));
}

TEST(Worksheet, IsInALanguageThatTheLessonHas) {
  auto lesson = std::make_shared<Lesson>(load_lesson("ghost"));
  lesson->words.erase("es");
  const WorksheetChoice choice{.language = "es"};
  EXPECT_TRUE(holds(text_of(worksheet_of(lesson, choice)), "Name Date 3  The ghost"));
}

}  // namespace
}  // namespace ghostforce::worksheet_pages_test
