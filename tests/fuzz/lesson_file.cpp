// A lesson file: it is read whole, or told to be wrong.

#include "app/state/lesson_file.h"
#include "tests/fuzz/fuzz.h"

using namespace ghostforce;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const Lesson lesson = read_lesson(text_of({data, size}), "fuzz.toml");
    require(!lesson.steps.empty() && lesson.steps.front().set_up, "a lesson begins with a set-up");
    require(!lesson.words.empty(), "a lesson has words");
    for (const auto& [language, words] : lesson.words) {
      require(words.steps.size() == lesson.steps.size(), "each step has words in each language");
      for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const LessonStep& step = lesson.steps[i];
        require(!words.steps[i].text.empty(), "each step has a text");
        require(step.question != LessonQuestion::choose || step.right_answer < words.steps[i].answers.size(),
                "the right answer is one of them");
      }
    }
  } catch (const ReadError& error) {
    require(error.kind() == ReadError::Kind::wrong, "a text that is no lesson says something wrong");
    require(*error.what() != '\0', "it is said what is wrong");
    for (const char c : std::string_view(error.what())) {
      require(c == '\n' || (static_cast<unsigned char>(c) >= 0x20 && c != 0x7F), "no message moves a cursor");
    }
  }
  return 0;
}
