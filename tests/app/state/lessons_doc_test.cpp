// docs/lessons.md names all that a lesson's file may hold, and its examples are lessons.
#include <gtest/gtest.h>

#include "app/state/lesson_file.h"
#include "app/state/lesson_quantities.h"
#include "app/state/lesson_reader.h"
#include "app/state/lesson_search.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::lessons_doc_test {
namespace {

const std::string& doc() {
  static const std::string text = read_whole(source_path("/docs/lessons.md"));
  return text;
}

bool has_row(std::string_view name) {
  return doc().find("| `" + std::string(name) + "` |") != std::string::npos;
}

TEST(LessonsDoc, HasARowForEachWordOfAFile) {
  for (const auto& entry : lesson_control_catalog) EXPECT_TRUE(has_row(entry.name)) << entry.name;
  for (const auto& entry : lesson_secret_catalog) EXPECT_TRUE(has_row(entry.name)) << entry.name;
  for (const auto& entry : lesson_question_catalog) EXPECT_TRUE(has_row(entry.name)) << entry.name;
  for (const LessonQuantityEntry& entry : lesson_quantity_catalog()) EXPECT_TRUE(has_row(entry.name)) << entry.name;
}

// What stands between ```toml and ```.
std::vector<std::string> examples() {
  std::vector<std::string> found;
  constexpr std::string_view fence = "```toml\n";
  for (std::size_t at = doc().find(fence); at != std::string::npos; at = doc().find(fence, at + 1)) {
    const std::size_t begin = at + fence.size();
    found.push_back(doc().substr(begin, doc().find("```", begin) - begin));
  }
  return found;
}

TEST(LessonsDoc, LeadsFromAFrameToALessonThatCanBePlayed) {
  ASSERT_GE(examples().size(), 2U);
  try {
    read_lesson(examples().front(), "steep.toml");
    FAIL() << "the frame lacks a set-up";
  } catch (const ReadError& error) {
    EXPECT_NE(doc().find(error.what()), std::string::npos) << error.what();
  }
  const Lesson lesson = read_lesson(examples().back(), "steep.toml");
  EXPECT_EQ(lesson.steps.size(), 3U);
  for (const LessonStepFinding& finding : examine_lesson(lesson)) EXPECT_TRUE(finding.is_good) << finding.words;
}

TEST(LessonsDoc, NamesEachLesson) {
  for (const std::string_view name : shipped_lesson_names()) EXPECT_TRUE(has_row(name)) << name;
}

}  // namespace
}  // namespace ghostforce::lessons_doc_test
