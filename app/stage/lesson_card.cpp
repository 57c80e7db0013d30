#include "app/stage/lesson_card.h"

#include "app/stage/stage.h"
#include "app/state/lesson_shelf.h"
#include "app/state/stage_view.h"
#include "core/wall.h"

namespace ghostforce {
namespace {

// The set-up of the lesson that says most about it: one with an explanation or a map, else one in which the hand is in the
// wall.
const SetUp* telling_set_up(const Lesson& lesson) {
  const SetUp* found = nullptr;
  for (const LessonStep& step : lesson.steps) {
    for (const SetUp* const set_up : {step.set_up.get(), step.reveal.get()}) {
      if (set_up == nullptr) continue;
      if (set_up->mode == StageMode::why || set_up->mode == StageMode::landscape) return set_up;
      const bool is_better = found == nullptr || depth(wall_of(found->scene.settings), found->goal) <= 0.0;
      if (is_better) found = set_up;
    }
  }
  return found;
}

// Things alone: words would be too small.
bool is_thing(const Mark& mark) {
  switch (mark.role) {
    case Role::button:
    case Role::hint:
    case Role::number:
    case Role::sentence:
      return false;
    default:
      return !std::holds_alternative<Label>(mark.form);
  }
}

Pane stage_pane(const SetUp& set_up, const Theme& theme, const Vector<2>& size, double scale) {
  const MeasureText no_words = [](std::string_view, const TextStyle&) { return Vector<2>(0.0); };
  const Settings& settings = set_up.scene.settings;
  constexpr int whole_explanation = 4;
  constexpr double height_of_design = 720.0;
  LabelMemory memory;
  Pane pane = compose_stage({.settings = settings,
                             .moment = stage_moment_at_rest(settings, set_up.goal),
                             .language = english_stage,
                             .keys = {},
                             .theme = theme,
                             .measure = no_words,
                             .shown = stage_view_of(settings, set_up.goal),
                             .reference_force = reference_force_of(settings, set_up.goal),
                             .size = size,
                             .scale = scale * height_of_design / size.y,
                             .mode = set_up.mode == StageMode::ribbon ? StageMode::none : set_up.mode,
                             .why_step = whole_explanation,
                             .landscape_dial = settings.active == StrategyId::anisotropic ? 1.0 : 0.0},
                            memory, 0.0)
                  .pane;
  std::erase_if(pane.marks, [](const Mark& mark) { return !is_thing(mark); });
  return pane;
}

}  // namespace

Pane lesson_card(std::size_t number, const Theme& theme, const Vector<2>& size, double scale) {
  const SetUp nothing;
  const SetUp* const set_up = telling_set_up(*shipped_lessons()[number]);
  return stage_pane(set_up == nullptr ? nothing : *set_up, theme, size, scale);
}

}  // namespace ghostforce
