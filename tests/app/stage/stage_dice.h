// Moments of the stage by dice: any settings, any goal that a pointer can reach, all modes, in any window; and a picture
// of one, without a window.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include "app/paint/vector/vector_painter.h"
#include "app/stage/stage.h"
#include "app/stage/stage_transition.h"
#include "app/state/stage_view.h"
#include "core/prediction.h"
#include "core/simulate.h"
#include "tests/app/picture/picture_dice.h"

namespace ghostforce {

// All that a picture is made of, held by value.
struct StageCase {
  Settings settings{};
  StageMoment moment{};
  SceneView shown{};
  double reference_force = 1.0;
  const StageLanguage* language = &english_stage;
  Vector<2> size{1280.0, 720.0};
  double scale = 1.0;
  std::string_view theme = "light";
  const Theme* own_theme = nullptr;  // in place of that one
  StageMode mode = StageMode::none;
  StageAudience audience{};
  std::optional<StageHint> hint{};
  bool is_dragging = false;
  std::optional<StageAction> hovered{};
  bool may_turn_motor = false;
  bool may_turn_wall = false;
  bool may_move_parts = false;
  StageGuess guess{};
  int why_step = 0;
  std::optional<StageRound> round{};
  std::shared_ptr<const MomentHistory> moments{};
  std::optional<double> looks_back_to_s{};
  std::optional<StageMeasuring> measuring{};
  std::optional<StageMeasuringButton> measuring_button{};
  std::optional<StageCornerButton> corner{};
  std::optional<StageLesson> lesson{};
  StageSecrets hides{};
  std::string_view warning{};
  bool is_bare = false;
  bool shows_menu = false;
  StageKeys keys{.lessons = "F5", .help = "F1"};

  template <typename Use>
  auto with_content(Use&& use) const {
    static const MeasureText measure = measure_vector_text;
    return use(StageContent{.settings = settings,
                            .moment = moment,
                            .language = *language,
                            .keys = keys,
                            .theme = own_theme != nullptr ? *own_theme : *find_theme(theme),
                            .measure = measure,
                            .shown = shown,
                            .reference_force = reference_force,
                            .size = size,
                            .scale = scale,
                            .mode = mode,
                            .audience = audience,
                            .hint = hint,
                            .is_dragging = is_dragging,
                            .hovered = hovered,
                            .may_turn_motor = may_turn_motor,
                            .may_turn_wall = may_turn_wall,
                            .may_move_parts = may_move_parts,
                            .guess = guess,
                            .why_step = why_step,
                            .round = round,
                            .measuring = measuring,
                            .measuring_button = measuring_button,
                            .moments = moments.get(),
                            .looks_back_to_s = looks_back_to_s,
                            .corner = corner,
                            .lesson = lesson,
                            .hides = hides,
                            .warning = std::string(warning),
                            .is_bare = is_bare,
                            .shows_menu = shows_menu});
  }
  StagePicture compose(LabelMemory& memory, double interval_s) const {
    return with_content([&](const StageContent& content) { return compose_stage(content, memory, interval_s); });
  }
  StagePicture compose() const {
    LabelMemory memory;
    return compose(memory, 0.0);
  }
  StageReading read() const { return with_content(stage_reading); }
};

// At rest under one goal, with this view of it.
inline StageCase stage_case_at(const Settings& settings, const Vector<2>& goal) {
  StageCase made;
  made.settings = settings;
  made.moment = stage_moment_at_rest(settings, goal);
  made.shown = stage_view_of(settings, goal);
  made.reference_force = reference_force_of(settings, goal);
  return made;
}

// The shipped picture.
inline Settings wall45(StrategyId active = StrategyId::naive) {
  Settings settings;
  settings.wall_normal_angle = 0.75 * std::numbers::pi;
  settings.mass = 0.1;
  settings.damping = 5.0;
  settings.rate = 1000.0;
  settings.stiffnesses = {
      .k_u = 200.0, .believed_k_u = {}, .k_r = 600.0, .k_t = 600.0, .k_c = 1e5, .chosen_tracking_ratio = {}};
  settings.active = active;
  return settings;
}
inline const Vector<2> wall45_goal{0.014142135623730951, -0.014142135623730951};

// A picture of anything.
inline StageCase stage_case_by(PictureDice& dice, const StageLanguage& language = english_stage) {
  const Settings settings = dice.settings();
  const Vector<2> seen_goal = dice.goal(settings);
  StageCase made = stage_case_at(settings, seen_goal);
  made.language = &language;
  made.size = dice.size();
  made.scale = dice.scale();
  made.theme = dice.theme();
  Vector<2> goal = seen_goal;
  if (dice.one_in(2)) {
    // Where a pointer can drag it to.
    const Camera camera = camera_on(made.shown.center, made.shown.width, made.size);
    goal = to_world(camera, made.size * Vector<2>(dice.between(0.0, 1.0), dice.between(0.0, 1.0)));
    made.moment = stage_moment_at_rest(settings, goal);
  }
  // On the way between two strategies, or in motion, or with a device in the hand.
  if (dice.one_in(5)) {
    const StageBlend blend{dice.one_in(2) ? 0.0 : dice.between(0.0, 1.0), dice.between(0.0, 1.0)};
    made.moment = stage_moment_between(settings, snapshot_at_rest_of_all(settings, goal), goal, blend);
  } else if (dice.one_in(5)) {
    made.moment = stage_moment(settings, dice.moving_snapshot(settings, seen_goal, goal), goal);
  } else if (settings.active != StrategyId::full && dice.one_in(5)) {
    Snapshot snapshot = snapshot_at_rest_of_all(settings, goal);
    snapshot.measured = settings.active;
    for (auto& strategy : snapshot.strategies) strategy.ghost_force = strategy.proxy_drift = Vector<2>(0.0);
    made.moment = stage_moment(settings, snapshot, goal);
    if (dice.one_in(2)) {
      const std::string_view words = dice.one_in(2) ? language.motors.arm : language.motors.on;
      made.corner = StageCornerButton{StageCommand::motors, std::string(words), true};
    }
  }
  // A loop that has run away is another sentence's matter.
  if (!(glm::length(made.moment.handle) < 10.0 && glm::length(made.moment.wall_share) < 1e7)) {
    made.moment = stage_moment_at_rest(settings, goal);
  }
  made.mode = dice.one_of(std::array{StageMode::none, StageMode::none, StageMode::none, StageMode::predict,
                                     StageMode::why, StageMode::round, StageMode::ribbon});
  made.audience.can_drag = !made.moment.is_measured && !dice.one_in(5);
  made.may_turn_motor = made.may_turn_wall = dice.one_in(2);
  if (dice.one_in(5)) made.hint = dice.one_of(std::array{StageHint::drag, StageHint::cure, StageHint::motor});
  if (dice.one_in(10)) {
    made.hovered = dice.one_of(
        std::array<StageAction, 4>{StageMode::why, StageCommand::menu, StrategyId::naive, StageCommand::lessons});
  }
  if (made.mode == StageMode::predict) {
    made.guess.at = made.moment.goal + Vector<2>(dice.between(-0.02, 0.02), dice.between(-0.02, 0.02));
    made.guess.is_open = dice.one_in(2);
    if (!made.guess.is_open && dice.one_in(2)) made.guess.missed_by = dice.decades(-5.0, 0.0);
  }
  made.why_step = static_cast<int>(dice.between(0.0, 4.999));
  if (made.mode == StageMode::round) {
    StageRound round;
    const Vector<2> middle = made.moment.handle;
    const double radius = dice.between(0.003, 0.02);
    const double flatness = dice.between(0.1, 1.0);
    if (!dice.one_in(4)) {
      for (int i = 0; i < 60; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 60.0;
        round.loop.push_back(middle + radius * Vector<2>(std::cos(angle), flatness * std::sin(angle)));
      }
      round.reading.turns = 1;
      for (CircleEnergy& energy : round.reading.strategies) {
        energy.last.energy = (dice.one_in(2) ? 1.0 : -1.0) * dice.decades(-6.0, -0.5);
      }
    }
    made.round = round;
  }
  if (made.mode == StageMode::ribbon) {
    auto history = std::make_shared<MomentHistory>();
    for (int i = 0; i <= 60; ++i) {
      Snapshot snapshot = snapshot_at_rest_of_all(settings, seen_goal + (goal - seen_goal) * (i / 60.0));
      snapshot.tick = 5 * i;
      snapshot.time_s = 0.005 * i;
      history->add(snapshot, settings);
    }
    if (dice.one_in(2)) made.looks_back_to_s = dice.between(0.0, 0.3);
    made.audience.looks_back = made.looks_back_to_s.has_value();
    made.moments = std::move(history);
  }
  if (dice.one_in(25)) made.warning = language.warnings.unstable;
  return made;
}

// So many letters of words as long as Spanish ones.
inline std::string lesson_words_by(PictureDice& dice, std::size_t letters) {
  std::string words;
  while (words.size() < letters) {
    if (!words.empty()) words.push_back(' ');
    const auto length = static_cast<std::size_t>(dice.between(1.0, 13.0));
    words.append(std::min(length, letters - std::min(letters, words.size())), dice.one_in(3) ? 'm' : 'a');
  }
  words.resize(letters, 'a');
  if (words.back() == ' ') words.back() = 'a';
  return words;
}

inline StageLessonRow lesson_row_by(PictureDice& dice) {
  StageLessonRow row;
  const int answers = dice.one_in(2) ? 0 : static_cast<int>(dice.between(2.0, 5.999));
  for (int i = 0; i < answers; ++i) {
    row.answers.push_back(
        lesson_words_by(dice, static_cast<std::size_t>(dice.between(2.0, dice.one_in(5) ? 70.0 : 30.0))));
  }
  if (dice.one_in(3)) {
    row.slider = StageLessonSlider{.words = "rigidez que suponemos en la mano",
                                   .value = dice.one_in(4) ? "" : "444 N/m",
                                   .share = dice.between(0.0, 1.0),
                                   .longest = "800 N/m"};
  }
  row.has_strategies = dice.one_in(3);
  return row;
}

// The same picture in a step of some lesson.
inline StageCase lesson_case_by(PictureDice& dice, const StageLanguage& language = english_stage) {
  StageCase made = stage_case_by(dice, language);
  made.hint.reset();
  made.warning = {};
  if (made.corner && made.corner->action != StageAction(StageCommand::motors)) made.corner.reset();
  const auto mark = [&] { return dice.one_of(std::array{LessonMark::none, LessonMark::right, LessonMark::wrong}); };
  StageLesson lesson{.title = lesson_words_by(dice, static_cast<std::size_t>(dice.between(4.0, 40.0))),
                     .place = {},
                     .text = lesson_words_by(dice, static_cast<std::size_t>(dice.between(10.0, 175.0))),
                     .is_right = dice.one_in(2),
                     .longest_text = lesson_words_by(dice, 175),
                     .back = dice.one_in(4) ? "" : "Atrás",
                     .next = dice.one_in(3) ? "Esa es mi apuesta" : "Siguiente",
                     .other_language = {}};
  const auto steps = static_cast<std::size_t>(dice.between(1.0, 12.999));
  if (steps % 2 == 0) {
    // As visitors have it.
    lesson.has_way_out = false;
    lesson.other_language = "Español";
  }
  for (std::size_t i = 0; i < steps; ++i) {
    lesson.rows.push_back(lesson_row_by(dice));
    lesson.dots.push_back(mark());
  }
  lesson.step = static_cast<std::size_t>(dice.between(0.0, static_cast<double>(steps) - 0.001));
  lesson.furthest = lesson.step;
  lesson.place = std::to_string(lesson.step + 1).append(" de ").append(std::to_string(steps));
  lesson.is_open = !lesson.row().answers.empty() && dice.one_in(2);
  for (std::size_t i = 0; i < lesson.row().answers.size(); ++i) {
    lesson.marks.push_back(lesson.is_open ? LessonMark::none : mark());
  }
  if (!lesson.is_open && !lesson.marks.empty()) lesson.chosen = 0;
  made.hides = {dice.one_in(4), dice.one_in(4), dice.one_in(4), dice.one_in(4), dice.one_in(4)};
  if (dice.one_in(3)) {
    made.guess = {.at = made.moment.goal + Vector<2>(dice.between(-0.02, 0.02), dice.between(-0.02, 0.02)),
                  .is_open = made.hides.handle,
                  .missed_by = 0.0123};
  }
  if (dice.one_in(6))
    made.hovered =
        dice.one_of(std::array<StageAction, 3>{StageCommand::leave, StageCommand::slider, StageCommand::next});
  made.lesson = std::move(lesson);
  return made;
}

}  // namespace ghostforce
