// The controls of a lesson, and the list of lessons.
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "app/picture/text.h"
#include "app/stage/control_pieces.h"
#include "app/state/kiosk_visit.h"
#include "app/state/lesson_file.h"
#include "app/state/lesson_guide.h"
#include "app/state/lesson_progress.h"
#include "app/state/lesson_quantities.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

using Kind = StageControlKind;

// In the order of LessonQuantity.
constexpr std::array decimals_of_quantities{1, 2, 2, 1, 1, 0, 2, 0, 2, 0, 2, 0, 0};
static_assert(decimals_of_quantities.size() == static_cast<std::size_t>(LessonQuantity::active_walls) + 1);
static_assert(sizeof(StageLanguage::Quantities) / sizeof(std::string_view) == decimals_of_quantities.size(),
              "assets/languages: each quantity of a task has words");

// What stands in a condition, and what is wanted of it. What nobody knows is a dash.
std::string condition_words(const LessonCondition& condition, const LessonReading& now, const StageLanguage& language) {
  const auto index = static_cast<std::size_t>(condition.quantity);
  const auto number = [&](double value) {
    return std::isnan(value) ? "–" : decimal_text(value, decimals_of_quantities.at(index));
  };
  const StageLanguage::Controls& all = language.controls;
  std::string value = number(lesson_quantity(condition.quantity).read(now));
  if (condition.quantity == LessonQuantity::effort) value += has_joints(now.settings) ? " N·m" : " N";
  const std::string is = filled(words_of(language.quantities).at(index), value);
  if (!std::isfinite(condition.greatest)) return filled(all.at_least, is, number(condition.least));
  if (!std::isfinite(condition.least)) return filled(all.at_most, is, number(condition.greatest));
  return filled(all.between, is, number(condition.least), number(condition.greatest));
}

void add_answers(const ControlSource& source, const StageLesson& lesson, ControlParts& parts) {
  const std::vector<std::string>& answers = lesson.row().answers;
  const StageLanguage::Controls& all = source.language.controls;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    StageControl button = button_control(source, fmt::format("answer-{}", i + 1),
                                         fmt::format("{}: {}", i + 1, answers[i]), AnswerLesson{i});
    button.kind = Kind::toggle;
    button.is_on = lesson.chosen == i;
    const LessonMark mark = i < lesson.marks.size() ? lesson.marks[i] : LessonMark::none;
    if (mark == LessonMark::right) button.about = all.right_answer;
    if (mark == LessonMark::wrong) button.about = all.your_answer;
    if (!button.refusal.empty()) button.refusal = all.answered;
    parts.push_back(std::move(button));
  }
}

void add_task(const ControlSource& source, const LessonStep& step, ControlParts& parts) {
  if (!has_open_question(source.session, LessonQuestion::task)) return;
  const StageSecrets& hides = source.reading.hides;
  if (hides.numbers || hides.force || hides.slide) return;
  const StiffnessProbe& probe = source.session.stiffness_probe;
  const LessonReading now{.moment = source.reading.moment,
                          .settings = source.reading.settings,
                          .circle = source.loop.circle ? &*source.loop.circle : nullptr,
                          .hand_k_u = probe.is_known() ? std::optional(probe.estimate.k_u) : std::nullopt};
  for (std::size_t i = 0; i < step.conditions.size(); ++i) {
    parts.push_back(text_control(fmt::format("task-{}", i + 1), Kind::text,
                                 condition_words(step.conditions[i], now, source.language)));
  }
}

void add_slider(const ControlSource& source, const LessonStep& step, const StageLesson& lesson, ControlParts& parts) {
  if (!step.slider) return;
  const LessonSlider& slider = *step.slider;
  const StageLessonSlider& shown = *lesson.row().slider;
  parts.push_back(range_control(source, "lesson-slider", shown.words, shown.value,
                                {.value = 100.0 * shown.share, .least = 0.0, .greatest = 100.0, .step = 1.0},
                                [slider](double hundredths) {
                                  return std::vector<Action>{MoveSliderTo{slider_value_at(slider, 0.01 * hundredths)}};
                                }));
}

}  // namespace

StageControl lesson_control(const ControlSource& source) {
  const StageLesson& lesson = *source.reading.lesson;
  const LessonStep& step = lesson_step(*source.session.lesson);
  ControlParts parts;
  parts.push_back(text_control("lesson-place", Kind::status, lesson.place));
  if (lesson.is_right) {
    parts.push_back(text_control("lesson-outcome", Kind::status, std::string(source.language.controls.right)));
  }
  add_answers(source, lesson, parts);
  add_slider(source, step, lesson, parts);
  if (has_open_question(source.session, LessonQuestion::guess)) add_guess_controls(source, parts);
  add_task(source, step, parts);
  if (!lesson.back.empty()) parts.push_back(button_control(source, "lesson-back", lesson.back, PreviousStep{}));
  parts.push_back(button_control(source, "lesson-next", lesson.next, GoOn{}));
  if (lesson.has_way_out) {
    const std::string leave(source.language.actions.leave_lesson.words);
    parts.push_back(button_control(source, "lesson-leave", leave, LeaveLesson{}));
  }
  if (!lesson.other_language.empty()) {
    StageControl button = button_control(source, "lesson-language", lesson.other_language, NextLanguage{});
    button.language = next_language(source.session);
    parts.push_back(std::move(button));
  }
  StageControl group = group_control("lesson", Kind::group, lesson.title, std::move(parts));
  group.about = filled(source.language.controls.closed, lesson.title);
  return group;
}

StageControl lesson_list(const ControlSource& source) {
  ControlParts parts;
  const auto& lessons = shipped_lessons();
  for (std::size_t i = 0; i < lessons.size(); ++i) {
    const Lesson& lesson = *lessons[i];
    const LessonWords& words = words_in(lesson, source.session.language);
    StageControl button = button_control(source, "begin-" + lesson.name, numbered_title(i, source.session.language),
                                         OpenLesson{lesson.name});
    button.about = fmt::format("{} {}", words.about,
                               progress_words(lesson, source.session.lesson_progress, source.language.picker));
    parts.push_back(std::move(button));
  }
  return group_control("lessons", Kind::folded, source.language.picker.title, std::move(parts));
}

}  // namespace ghostforce
