#include "app/shell/desktop/lesson_picture.h"

#include <fmt/format.h>

#include "app/base/quoted.h"
#include "app/state/lesson_guide.h"

namespace ghostforce {

std::size_t answers_of(const LessonPicture& picture) {
  switch (picture.lesson->steps[picture.step].question) {
    case LessonQuestion::none:
      return 0;
    case LessonQuestion::choose:
      return picture.lesson->words.begin()->second.steps[picture.step].answers.size();
    case LessonQuestion::guess:
    case LessonQuestion::task:
      return 2;
  }
  return 0;
}

std::string find_problem(const LessonPicture& picture) {
  const std::string name = quoted_text(picture.lesson->name, longest_path);
  const std::size_t steps = picture.lesson->steps.size();
  if (picture.step >= steps) return fmt::format("the lesson {} has {} steps; give 1 to {}", name, steps, steps);
  const std::size_t answers = answers_of(picture);
  if (!picture.answer || (*picture.answer >= 1 && *picture.answer <= answers)) return {};
  if (answers == 0) return fmt::format("step {} of {} asks nothing; leave out the answer", picture.step + 1, name);
  return fmt::format("step {} of {} has {} answers; give 1 to {}", picture.step + 1, name, answers, answers);
}

void show_lesson(Session& session, const LessonPicture& picture) {
  begin_lesson(session, picture.lesson);
  show_lesson_step(session, picture.step);
  if (picture.answer) settle_in_lesson(session, *picture.answer - 1);
  session.stage_shown = lesson_view(session);
  session.fits_view = false;  // it stands there at once
}

}  // namespace ghostforce
