// Whether a lesson can be done: what stands on the stage when each step begins, and a way to do each task, found by
// search among what its controls and its slider reach. What `check` tells a teacher. Closed forms and the sampled loop,
// so the same on every run. Not for the servo or the UI thread: a task about rounds takes a second.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/state/lesson.h"

namespace ghostforce {

// What each step begins with, for a person who touches nothing and has every answer shown. Never null: the first step
// has a set-up.
std::vector<const SetUp*> set_ups_at_start(const Lesson& lesson);

struct TaskFinding {
  bool is_met_at_start = false;
  std::optional<SetUp> solution;  // empty: nothing was found
};

// `start`: what the task begins with.
TaskFinding examine_task(const LessonStep& task, const SetUp& start);

// Where the handle comes to rest under the hand of a guess is in contact with the wall, and not where the ring begins.
bool can_be_guessed(const LessonStep& guess, const SetUp& start);

// What can be said of a step: whether it can be done as it is meant.
struct LessonStepFinding {
  bool is_good = true;
  std::string words;    // "task: can be done, with …", or what is wrong and what to do
  std::string example;  // of a task: a set-up that does it, as a line; may be empty
};

// One finding for each step.
std::vector<LessonStepFinding> examine_lesson(const Lesson& lesson);

// The languages of the stage that the lesson has no words in.
std::vector<std::string_view> languages_missing_in(const Lesson& lesson);

}  // namespace ghostforce
