#include "app/state/lesson_check.h"

#include <fmt/format.h>

#include "app/files/scene_file.h"
#include "app/state/lesson_search.h"
#include "app/state/set_up_line.h"
#include "app/state/stage_language.h"

namespace ghostforce {
namespace {

LessonStepFinding examine_choice(const LessonStep& step, const LessonWords& words, std::size_t number) {
  return {true,
          fmt::format("choose: answer {} of {} is right", step.right_answer + 1, words.steps[number].answers.size()),
          ""};
}

LessonStepFinding examine_guess(const LessonStep& step, const SetUp& start) {
  if (can_be_guessed(step, start)) return {true, "guess: the handle comes to rest at the wall", ""};
  return {
      false,
      "guess: the handle rests in front of the wall, or where the ring begins; put the hand deeper into the wall, or "
      "make within_mm smaller",
      ""};
}

LessonStepFinding examine_task_of(const LessonStep& step, const SetUp& start) {
  const TaskFinding found = examine_task(step, start);
  if (found.is_met_at_start) {
    return {false, "task: it is done before anybody has done anything; change set_up or until", ""};
  }
  if (!found.solution) {
    return {false, "task: no way to do it was found; give other controls, a longer slider or wider limits in until",
            ""};
  }
  SetUp example = *found.solution;
  example.scene = rounded_to_file(example.scene);
  example.goal = example.scene.goal.points.back();
  return {true, "task: it is not done at the start, and can be done", set_up_line(example)};
}

}  // namespace

std::vector<LessonStepFinding> examine_lesson(const Lesson& lesson) {
  const std::vector<const SetUp*> starts = set_ups_at_start(lesson);
  std::vector<LessonStepFinding> findings;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const LessonStep& step = lesson.steps[i];
    switch (step.question) {
      case LessonQuestion::none:
        findings.push_back({true, "text", ""});
        break;
      case LessonQuestion::choose:
        findings.push_back(examine_choice(step, lesson.words.begin()->second, i));
        break;
      case LessonQuestion::guess:
        findings.push_back(examine_guess(step, *starts[i]));
        break;
      case LessonQuestion::task:
        findings.push_back(examine_task_of(step, *starts[i]));
        break;
    }
  }
  return findings;
}

std::vector<std::string_view> languages_missing_in(const Lesson& lesson) {
  std::vector<std::string_view> missing;
  for (const StageLanguage* const language : stage_languages) {
    if (!lesson.words.contains(std::string(language->code))) missing.push_back(language->code);
  }
  return missing;
}

}  // namespace ghostforce
