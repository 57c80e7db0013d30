// What a lesson's file calls its controls, secrets and questions. The lists that the reader, the docs' test and `check`
// walk. Immutable, any thread.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "app/state/lesson.h"

namespace ghostforce {

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

}  // namespace ghostforce
