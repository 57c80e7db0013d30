// LessonPicture: a step of a lesson as a picture, as it stands when nobody has answered it, or after an answer. Values;
// pure, any thread.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "app/state/session.h"

namespace ghostforce {

struct LessonPicture {
  std::shared_ptr<const Lesson> lesson;  // never null
  std::size_t step = 0;                  // from 0
  // From 1: of a choice the answer's number; of a guess 1 a right one and 2 a wrong one; of a task 1 done and 2 given up.
  std::optional<std::size_t> answer{};
};

// How many answers the picture's step can have; 0: it asks nothing.
std::size_t answers_of(const LessonPicture& picture);

// What is wrong with its step or answer, as a sentence; empty: nothing.
std::string find_problem(const LessonPicture& picture);

// Brings the session to that step, at once. Only without problems.
void show_lesson(Session& session, const LessonPicture& picture);

}  // namespace ghostforce
