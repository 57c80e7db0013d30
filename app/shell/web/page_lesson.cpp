#include "app/shell/web/page_lesson.h"

#include <array>
#include <cstddef>

#include "app/state/lesson_guide.h"

namespace ghostforce {
namespace {

constexpr std::array outcome_names{"open", "right", "wrong", "shown"};
constexpr std::array question_names{"", "choose", "guess", "task"};

}  // namespace

nlohmann::ordered_json lesson_json(const Session& session) {
  if (!session.lesson) return nullptr;
  const LessonState& state = *session.lesson;
  const LessonStep& step = lesson_step(state);
  const bool is_open = lesson_step_state(state).outcome == LessonOutcome::open;
  nlohmann::ordered_json json{{"name", state.lesson->name},
                              {"step", state.step + 1},
                              {"steps", state.lesson->steps.size()},
                              {"is_complete", state.is_finished},
                              {"question", nullptr},
                              {"outcome", outcome_names[static_cast<std::size_t>(lesson_step_state(state).outcome)]},
                              {"is_open", step.question != LessonQuestion::none && is_open},
                              {"right_answer", step.right_answer + 1},
                              {"chosen", nullptr},
                              {"missed_by_m", nullptr}};
  const LessonStepState& answered = lesson_step_state(state);
  if (answered.chosen) json["chosen"] = *answered.chosen + 1;
  if (answered.missed_by) json["missed_by_m"] = *answered.missed_by;
  if (step.question != LessonQuestion::none) json["question"] = question_names[static_cast<std::size_t>(step.question)];
  return json;
}

}  // namespace ghostforce
