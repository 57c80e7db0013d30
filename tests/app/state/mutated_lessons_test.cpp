// Lessons that were damaged in many ways: each is read, or told to be wrong with a place, and nothing else happens.
#include <gtest/gtest.h>

#include <random>

#include "app/state/lesson_file.h"
#include "tests/app/state/lesson_text.h"

namespace ghostforce::mutated_lessons_test {
namespace {

class Mutation {
 public:
  explicit Mutation(std::uint32_t seed) : dice_(seed) {}

  std::string apply(std::string text) {
    for (std::size_t i = 0, count = 1 + below(3); i < count && !text.empty(); ++i) change(text);
    return text;
  }

 private:
  std::size_t below(std::size_t end) { return dice_() % end; }

  void change(std::string& text) {
    constexpr std::string_view bytes = "\"'[]{}=,.#\n\\ -0129xe_\x01\x7f\xc3\xff";
    constexpr std::string_view values[] = {"1e999", "-1", "nan", "true", "[]", "{}", "\"\"", "[[1]]", "1979-05-27"};
    const std::size_t at = below(text.size());
    const std::size_t length = std::min(below(40), text.size() - at);
    switch (below(6)) {
      case 0:
        text[at] = bytes[below(bytes.size())];
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(below(text.size()), text.substr(at, length));
        break;
      case 3: {  // a line is missing, or there twice
        const std::size_t begin = text.rfind('\n', at) + 1;
        const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
        const std::string line = text.substr(begin, end - begin);
        below(2) == 0 ? text.erase(begin, line.size()) : text.insert(begin, line);
        break;
      }
      case 4: {  // another value
        const std::size_t equals = text.find("= ", at);
        if (equals == std::string::npos) break;
        const std::size_t end = std::min(text.find_first_of(",\n}", equals), text.size());
        text.replace(equals + 2, end - equals - 2, values[below(std::size(values))]);
        break;
      }
      default:
        text.resize(at);
    }
  }

  std::mt19937 dice_;
};

TEST(MutatedLessons, AreReadOrRefused) {
  int good = 0;
  constexpr std::uint32_t tries = 3000;
  for (std::uint32_t seed = 1; seed <= tries; ++seed) {
    const std::string text = Mutation(seed).apply(std::string(small_lesson));
    SCOPED_TRACE(seed);
    try {
      const Lesson lesson = read_lesson(text, "mutated.toml");
      ++good;
      ASSERT_FALSE(lesson.steps.empty());
      ASSERT_NE(lesson.steps.front().set_up, nullptr);
      for (const auto& [language, words] : lesson.words) {
        ASSERT_EQ(words.steps.size(), lesson.steps.size());
        for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
          ASSERT_FALSE(words.steps[i].text.empty());
          if (lesson.steps[i].question == LessonQuestion::choose) {
            ASSERT_LT(lesson.steps[i].right_answer, words.steps[i].answers.size());
          }
        }
      }
    } catch (const ReadError& error) {
      ASSERT_EQ(error.kind(), ReadError::Kind::wrong);
      ASSERT_FALSE(error.problems().empty());
      ASSERT_GT(error.problems().front().line, 0U);
      for (const char c : std::string_view(error.what())) {
        ASSERT_TRUE(c == '\n' || (static_cast<unsigned char>(c) >= 0x20 && c != 0x7F)) << error.what();
      }
    }
  }
  EXPECT_GT(good, 30) << "else most of the reader was never reached";
  EXPECT_LT(good, 2000) << "else little was damaged";
}

}  // namespace
}  // namespace ghostforce::mutated_lessons_test
