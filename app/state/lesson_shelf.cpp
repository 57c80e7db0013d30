#include "app/state/lesson_shelf.h"

#include <algorithm>
#include <string>

#include "app/state/lesson_file.h"

namespace ghostforce {

const std::vector<std::shared_ptr<const Lesson>>& shipped_lessons() {
  static const std::vector<std::shared_ptr<const Lesson>> lessons = [] {
    std::vector<std::shared_ptr<const Lesson>> list;
    for (const std::string_view name : shipped_lesson_names()) {
      list.push_back(std::make_shared<const Lesson>(load_lesson(std::string(name))));
    }
    return list;
  }();
  return lessons;
}

std::size_t questions_of(const Lesson& lesson) noexcept {
  const auto asks = [](const LessonStep& step) { return step.question != LessonQuestion::none; };
  return static_cast<std::size_t>(std::ranges::count_if(lesson.steps, asks));
}

}  // namespace ghostforce
