// What can be said of a lesson that was read, step by step: whether it can be done as it is meant. Not for the servo or
// the UI thread (lesson_search.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/state/lesson.h"

namespace ghostforce {

struct LessonStepFinding {
  bool is_good = true;
  std::string words;    // "task: can be done, with …", or what is wrong and what to do
  std::string example;  // of a task: a set-up that does it, as a line; may be empty
};

// One per step.
std::vector<LessonStepFinding> examine_lesson(const Lesson& lesson);

// The languages of the stage that the lesson has no words in.
std::vector<std::string_view> languages_missing_in(const Lesson& lesson);

}  // namespace ghostforce
