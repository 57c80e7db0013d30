// LessonReader: from TOML to a lesson. First the steps, then the words of each language, which must fit them. One use
// each; used by lesson_file.h alone.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/toml_document.h"
#include "app/state/lesson.h"

namespace ghostforce {

class LessonReader {
 public:
  explicit LessonReader(std::string_view shown_path) : toml_(shown_path) {}

  // Throws ReadError(wrong) with all that is wrong.
  Lesson read(std::string_view text);

 private:
  // What the words of a step are compared with.
  struct StepFacts {
    std::optional<TomlValue> right;        // of a choice: the number of the right answer
    std::optional<std::size_t> answers{};  // how many there are in the language that is read first
    bool knows_question = true;            // if not, nobody can say which words it needs
  };

  void read_steps(const TomlValue& steps);
  void read_step(const TomlValue& table, LessonStep& step, StepFacts& facts);
  void read_name(const TomlValue& value, LessonStep& step);
  void read_language(std::string_view language, const TomlValue& table);
  void read_step_words(const TomlValue& table, std::size_t number, LessonStepWords& words);
  void compare_answers(const TomlValue& answers, std::size_t number, std::size_t count);

  TomlReader toml_;
  Lesson lesson_;
  std::vector<StepFacts> facts_;  // of each step
  std::string first_language_;
};

}  // namespace ghostforce
