#include "app/state/lesson_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "app/files/scene_file.h"
#include "app/state/lesson_quantities.h"
#include "app/state/set_up.h"
#include "app/state/stage_language.h"
#include "app/state/stage_view.h"
#include "core/conventions.h"
#include "core/scene_shape.h"
#include "core/simulate.h"

namespace ghostforce {
namespace {

// Of the stage while the task is open: with the place where its answer will be.
SceneView view_of(const LessonStep& task, const SetUp& start) {
  const Settings& settings = start.scene.settings;
  std::vector<Vector<2>> goals{start.goal};
  if (task.reveal) {
    const Settings& revealed = task.reveal->scene.settings;
    const bool is_same_wall =
        revealed.wall_point == settings.wall_point && revealed.wall_normal_angle == settings.wall_normal_angle;
    if (is_same_wall) goals.push_back(task.reveal->goal);
  }
  return stage_view_of(settings, goals, reference_force_of(settings, start.goal));
}

bool is_about_rounds(const LessonCondition& condition) {
  return condition.quantity == LessonQuantity::energy || condition.quantity == LessonQuantity::turns;
}

// The first complete round of a hand that begins at rest on the circle. Its sense was chosen when the step began.
CircleReading first_round(const Settings& settings, const Vector<2>& goal, bool is_clockwise) {
  const Circle circle = circle_inside(wall_of(settings), goal, {.radius = {}, .is_clockwise = is_clockwise});
  CircleEnergyMeter meter;
  meter.start(settings, circle);
  const TickCoefficients<2> coefficients = coefficients_of(settings);
  TickState<2> state = equilibrium_state(settings, position_on(circle, 0.0));
  const double longest_s = circle_begins_s + 2.0 * period_of(circle);
  while (meter.reading().turns == 0 && time_of(state.tick, settings.rate) < longest_s) {
    const double time_s = time_of(state.tick + 1, settings.rate);
    tick(coefficients, position_on(circle, std::max(0.0, time_s - circle_begins_s)), state);
    meter.add(snapshot_of(coefficients, state));
  }
  return meter.reading();
}

// A place among all that a person can do in a task: each coordinate from 0 to 1, the way of that control.
using Place = std::vector<double>;

class TaskSearch {
 public:
  TaskSearch(const LessonStep& task, const SetUp& start)
      : task_(task),
        start_(start),
        view_(view_of(task, start)),
        needs_rounds_(std::ranges::any_of(task.conditions, is_about_rounds)) {}

  // 0: it is done there; else the larger, the farther it is from that.
  double missed_by_all(const SetUp& tried) const {
    const Settings& settings = tried.scene.settings;
    const StageMoment moment = stage_moment_at_rest(settings, tried.goal);
    std::optional<CircleReading> circle;
    if (needs_rounds_ && start_.mode == StageMode::round) {
      circle = first_round(settings, tried.goal, makes_energy_clockwise(start_.scene.settings));
      // It goes on as long as it has to.
      for (const LessonCondition& condition : task_.conditions) {
        if (condition.quantity != LessonQuantity::turns) continue;
        circle->turns = std::max(circle->turns, static_cast<int>(std::ceil(std::min(condition.least, 1e6))));
      }
    }
    // Who is in the wall there can have the hand measured.
    const bool can_be_measured = start_.mode == StageMode::measure && moment.in_contact;
    const LessonReading reading{moment, settings, circle ? &*circle : nullptr,
                                can_be_measured ? std::optional(settings.stiffnesses.k_u) : std::nullopt};
    double missed = 0.0;
    for (const LessonCondition& condition : task_.conditions) {
      constexpr double of_unknown = 1e3;
      const double by = missed_by(condition, reading);
      missed += std::isnan(by) ? of_unknown : by;
    }
    return missed;
  }

  std::optional<SetUp> solution() const {
    for (const StrategyId id : strategies_to_try()) {
      if (std::optional<SetUp> found = solution_with(id)) return found;
    }
    return std::nullopt;
  }

 private:
  bool can(LessonControl control) const { return task_.controls.contains(control); }

  std::vector<StrategyId> strategies_to_try() const {
    const StrategyId active = start_.scene.settings.active;
    if (task_.with && *task_.with != active && !can(LessonControl::strategies)) return {};
    if (task_.with) return {*task_.with};
    std::vector<StrategyId> ids{active};
    for (const Strategy& each : strategy_catalog()) {
      if (can(LessonControl::strategies) && each.id != active) ids.push_back(each.id);
    }
    return ids;
  }

  std::size_t coordinates() const {
    return (can(LessonControl::hand) ? 2U : 0U) + (can(LessonControl::wall) ? 1U : 0U) +
           (can(LessonControl::motor) ? 1U : 0U) + (task_.slider ? 1U : 0U);
  }

  SetUp at(const Place& place, StrategyId id) const {
    SetUp tried = start_;
    Settings& settings = tried.scene.settings;
    settings.active = id;
    auto next = place.begin();
    if (can(LessonControl::hand)) {
      // What the stage shows, without its edges.
      constexpr Vector<2> share{0.84, 0.44};
      const double x = *next++ - 0.5;
      const double y = *next++ - 0.5;
      tried.goal = view_.center + view_.width * share * Vector<2>(x, y);
    }
    if (can(LessonControl::wall)) settings.wall_normal_angle = 2.0 * std::numbers::pi * *next++;
    if (can(LessonControl::motor)) move_motor(*next++, settings);
    if (task_.slider) {
      const LessonSlider& slider = *task_.slider;
      set_number(tried.scene, *slider.key, std::lerp(slider.least, slider.greatest, *next++));
    }
    tried.scene.goal.points.back() = tried.goal;
    return tried;
  }

  // A motor at a joint can be at the other one, any other has an angle.
  static void move_motor(double coordinate, Settings& settings) {
    if (!has_joints(settings)) {
      settings.actuated_angle = std::numbers::pi * coordinate;
    } else if (coordinate >= 0.5) {
      settings = with_other_motor(settings);
    }
  }

  void round_slider(Scene& scene, double per_unit) const {
    const SceneKey& key = *task_.slider->key;
    const std::optional<double> number = number_of(scene, key);
    if (number) set_number(scene, key, std::round(*number * per_unit) / per_unit);
  }

  // The nearest one in as few digits as will do, for people to read.
  SetUp in_round_numbers(const SetUp& found) const {
    for (const double per_unit : {1.0, 10.0, 100.0, 1000.0}) {
      const auto round = [per_unit](double& si, double file_units) {
        si = std::round(si * file_units * per_unit) / per_unit / file_units + 0.0;  // no minus before a zero
      };
      SetUp rounded = found;
      Settings& settings = rounded.scene.settings;
      if (can(LessonControl::hand)) {
        round(rounded.goal.x, mm_per_m);
        round(rounded.goal.y, mm_per_m);
        rounded.scene.goal.points.back() = rounded.goal;
      }
      if (can(LessonControl::wall)) round(settings.wall_normal_angle, degrees_per_radian);
      if (can(LessonControl::motor)) round(settings.actuated_angle, degrees_per_radian);
      if (task_.slider) round_slider(rounded.scene, per_unit);
      if (missed_by_all(rounded) == 0.0) return rounded;
    }
    return found;
  }

  std::optional<SetUp> solution_with(StrategyId id) const {
    SetUp untouched = start_;
    untouched.scene.settings.active = id;
    if (missed_by_all(untouched) == 0.0) return untouched;
    // Rounds are simulated, which takes a thousand times as long.
    const std::size_t tries = needs_rounds_ ? 40 : 4000;
    const std::size_t refined = needs_rounds_ ? 1 : 8;
    const double finest = needs_rounds_ ? 0.002 : 1e-6;
    std::mt19937 dice(1);
    std::vector<std::pair<double, Place>> found;
    for (std::size_t i = 0; i < tries && coordinates() > 0; ++i) {
      Place place(coordinates());
      for (double& coordinate : place) coordinate = static_cast<double>(dice()) / std::mt19937::max();
      found.emplace_back(missed_by_all(at(place, id)), std::move(place));
      if (found.back().first == 0.0) return in_round_numbers(at(found.back().second, id));
    }
    std::ranges::sort(found);
    found.resize(std::min(found.size(), refined));
    for (auto& [missed, place] : found) {
      if (refine(missed, place, id, finest) == 0.0) return in_round_numbers(at(place, id));
    }
    return std::nullopt;
  }

  // Downhill, one coordinate after another, in ever smaller steps.
  double refine(double missed, Place& place, StrategyId id, double finest) const {
    for (double step = 0.1; step > finest && missed > 0.0; step *= 0.5) {
      for (bool is_better = true; is_better && missed > 0.0;) {
        is_better = false;
        for (double& coordinate : place) {
          const double before = coordinate;
          for (const double tried : {before - step, before + step}) {
            const double kept = std::exchange(coordinate, std::clamp(tried, 0.0, 1.0));
            const double now = missed_by_all(at(place, id));
            now < missed ? void(is_better = true) : void(coordinate = kept);
            missed = std::min(missed, now);
          }
        }
      }
    }
    return missed;
  }

  const LessonStep& task_;
  const SetUp& start_;
  SceneView view_;  // of the stage
  bool needs_rounds_;
};

}  // namespace

std::vector<const SetUp*> set_ups_at_start(const Lesson& lesson) {
  std::vector<const SetUp*> result;
  const SetUp* now = nullptr;
  for (const LessonStep& step : lesson.steps) {
    if (step.set_up) now = step.set_up.get();
    result.push_back(now);
    if (step.reveal) now = step.reveal.get();
  }
  return result;
}

TaskFinding examine_task(const LessonStep& task, const SetUp& start) {
  const StageMoment moment = stage_moment_at_rest(start.scene.settings, start.goal);
  const CircleReading no_round;
  const CircleReading* const circle = start.mode == StageMode::round ? &no_round : nullptr;
  return {is_done(task, {moment, start.scene.settings, circle}), TaskSearch(task, start).solution()};
}

bool can_be_guessed(const LessonStep& guess, const SetUp& start) {
  const StageMoment rest = stage_moment_at_rest(start.scene.settings, start.goal);
  return rest.in_contact && glm::distance(rest.handle, neutral_guess(start.scene.settings, start.goal)) > guess.within;
}

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
