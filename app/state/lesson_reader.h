// How the file of a lesson is read: what it calls its controls, secrets and questions, how long its words may be, and
// the reader itself. The reader and the docs' test walk the same lists, which are immutable, any thread; a reader is
// for one thread.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/toml_document.h"
#include "app/state/lesson.h"

namespace ghostforce {

// Something that a lesson can name, and its name.
template <typename Id>
struct LessonWord {
  Id id;
  std::string_view name;  // in files
};

inline constexpr std::array lesson_control_catalog{
    LessonWord<LessonControl>{LessonControl::hand, "hand"},
    LessonWord<LessonControl>{LessonControl::strategies, "strategies"},
    LessonWord<LessonControl>{LessonControl::wall, "wall"},
    LessonWord<LessonControl>{LessonControl::motor, "motor"},
};

inline constexpr std::array lesson_secret_catalog{
    LessonWord<LessonSecret>{LessonSecret::numbers, "numbers"},
    LessonWord<LessonSecret>{LessonSecret::force, "force"},
    LessonWord<LessonSecret>{LessonSecret::slide, "slide"},
    LessonWord<LessonSecret>{LessonSecret::rest, "rest"},
};

inline constexpr std::array lesson_subject_catalog{
    LessonWord<LessonSubject>{LessonSubject::everything, "everything"},
    LessonWord<LessonSubject>{LessonSubject::handle, "handle"},
    LessonWord<LessonSubject>{LessonSubject::hand, "hand"},
    LessonWord<LessonSubject>{LessonSubject::forces, "forces"},
    LessonWord<LessonSubject>{LessonSubject::ghost_force, "ghost_force"},
    LessonWord<LessonSubject>{LessonSubject::slide, "slide"},
    LessonWord<LessonSubject>{LessonSubject::loop, "loop"},
};

// Without `none`.
inline constexpr std::array lesson_question_catalog{
    LessonWord<LessonQuestion>{LessonQuestion::choose, "choose"},
    LessonWord<LessonQuestion>{LessonQuestion::guess, "guess"},
    LessonWord<LessonQuestion>{LessonQuestion::task, "task"},
};

// How long words may be, in characters, so that they fit on the stage.
inline constexpr std::size_t longest_lesson_title = 40;
inline constexpr std::size_t longest_lesson_text = 160;  // and `about`
inline constexpr std::size_t longest_lesson_answer = 32;
inline constexpr std::size_t fewest_lesson_answers = 2;
inline constexpr std::size_t most_lesson_answers = 3;
inline constexpr std::size_t most_lesson_steps = 40;

// From TOML to a lesson: first the steps, then the words of each language, which must fit them. One use each; used by
// lesson_file.cpp alone.
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
