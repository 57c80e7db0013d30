// The lessons that come with the program, read once. Immutable, any thread.
#pragma once

#include <memory>
#include <vector>

#include "app/state/lesson.h"

namespace ghostforce {

// In the order of their numbers.
const std::vector<std::shared_ptr<const Lesson>>& shipped_lessons();

// How many of its steps ask something.
std::size_t questions_of(const Lesson& lesson) noexcept;

}  // namespace ghostforce
