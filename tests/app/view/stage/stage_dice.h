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
#include <random>
#include <string>
#include <string_view>

#include "app/paint/vector/vector_painter.h"
#include "app/view/stage/stage.h"
#include "app/view/stage/stage_transition.h"
#include "core/prediction.h"
#include "core/simulate.h"

namespace ghostforce {

// All that a picture is made of, held by value.
struct StageCase {
  Settings settings{};
  StageMoment moment{};
  SceneView shown{};
  double reference_force = 1.0;
  Vector<2> size{1280.0, 720.0};
  double scale = 1.0;
  std::string_view theme = "light";
  StageMode mode = StageMode::none;
  StageAudience audience{};
  std::optional<StageHint> hint{};
  std::optional<StageAction> hovered{};
  bool has_grips = false;
  StageGuess guess{};
  int why_step = 0;
  std::optional<StageRound> round{};
  std::shared_ptr<const MomentHistory> moments{};
  std::optional<double> looks_back_to_s{};
  std::optional<StageCornerButton> corner{};
  std::string_view warning{};

  StagePicture compose(LabelMemory& memory, double interval_s) const {
    static const MeasureText measure = measure_vector_text;
    return compose_stage({.settings = settings,
                          .moment = moment,
                          .theme = *find_theme(theme),
                          .measure = measure,
                          .shown = shown,
                          .reference_force = reference_force,
                          .size = size,
                          .scale = scale,
                          .mode = mode,
                          .audience = audience,
                          .hint = hint,
                          .hovered = hovered,
                          .has_grips = has_grips,
                          .guess = guess,
                          .why_step = why_step,
                          .round = round,
                          .moments = moments.get(),
                          .looks_back_to_s = looks_back_to_s,
                          .corner = corner,
                          .warning = warning},
                         memory, interval_s);
  }
  StagePicture compose() const {
    LabelMemory memory;
    return compose(memory, 0.0);
  }
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

class StageDice {
 public:
  explicit StageDice(unsigned seed) : random_(seed) {}

  double between(double least, double greatest) {
    return std::uniform_real_distribution<double>(least, greatest)(random_);
  }
  double decades(double least, double greatest) { return std::pow(10.0, between(least, greatest)); }
  bool one_in(int count) { return std::uniform_int_distribution<int>(1, count)(random_) == 1; }
  template <typename T, std::size_t count>
  const T& one_of(const std::array<T, count>& all) {
    return all[std::uniform_int_distribution<std::size_t>(0, count - 1)(random_)];
  }

  Settings settings() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Settings made;
    made.wall_point = one_in(4) ? Vector<2>(between(-1.0, 1.0), between(-1.0, 1.0))
                                : Vector<2>(between(-0.05, 0.05), between(-0.05, 0.05));
    // Right angles and no angles are the ones that go wrong.
    const auto angle = [&] {
      return one_in(4) ? 0.25 * std::numbers::pi * std::floor(between(-8.0, 8.0)) : between(-7.0, 7.0);
    };
    made.wall_normal_angle = angle();
    made.actuated_angle =
        one_in(6) ? made.wall_normal_angle + 0.5 * std::numbers::pi * std::floor(between(0.0, 4.0)) : angle();
    made.mass = decades(-1.5, 0.5);
    made.damping = decades(0.0, 1.3);
    made.rate = 1000.0;
    const bool is_usual = !one_in(4);
    Stiffnesses& all = made.stiffnesses;
    all.k_u = is_usual ? decades(1.7, 2.9) : decades(-1.0, 6.0);
    all.k_r = is_usual ? all.k_u * decades(-0.3, 1.3) : one_in(12) ? 0.0 : decades(-1.0, 6.0);
    all.k_t = is_usual ? all.k_r * decades(-0.7, 0.7) : decades(-1.0, 6.0);
    all.k_c = one_in(3) ? infinity : is_usual ? decades(2.5, 6.0) : decades(0.0, 9.0);
    if (one_in(3)) {
      const double believed = one_in(5) ? all.k_u : all.k_u * decades(-1.5, 1.5);
      all.believed_k_u = user_stiffness_range.nearest_to(believed);
    }
    if (one_in(8)) all.chosen_tracking_ratio = one_in(4) ? 1.0 : decades(-3.0, 3.0);
    made.active = one_of(std::array{StrategyId::full, StrategyId::naive, StrategyId::naive, StrategyId::anisotropic});
    return made;
  }

  // In the wall for the most part.
  Vector<2> goal(const Settings& settings) {
    const Wall<2> wall = wall_of(settings);
    const Vector<2> along{-wall.normal.y, wall.normal.x};
    const double depth = one_in(6) ? -between(0.0, 0.02) : one_in(6) ? between(0.0, 0.0005) : between(0.0, 0.05);
    return wall.point + along * between(-0.03, 0.03) - wall.normal * depth;
  }

  // Some motion from rest under one goal to rest under another, stopped somewhere.
  Snapshot moving_snapshot(const Settings& settings, const Vector<2>& from, const Vector<2>& to) {
    const TickCoefficients<2> coefficients = coefficients_of(settings);
    TickState<2> state = equilibrium_state(settings, from);
    const int ticks = static_cast<int>(between(1.0, 300.0));
    for (int i = 1; i <= ticks; ++i) {
      const double share = std::min(1.0, i / 100.0);
      tick(coefficients, from + (to - from) * share, state);
    }
    return snapshot_of(coefficients, state);
  }

  Vector<2> size() {
    return one_of(std::array{Vector<2>(1024.0, 640.0), Vector<2>(1024.0, 768.0), Vector<2>(1280.0, 720.0),
                             Vector<2>(1280.0, 800.0), Vector<2>(1366.0, 768.0), Vector<2>(1600.0, 1200.0),
                             Vector<2>(1920.0, 1080.0), Vector<2>(2560.0, 1440.0), Vector<2>(3440.0, 1440.0),
                             Vector<2>(3840.0, 2160.0),
                             Vector<2>(std::round(between(1024.0, 3840.0)), std::round(between(640.0, 2160.0)))});
  }
  double scale() { return one_in(3) ? between(0.75, 3.0) : one_of(std::array{0.75, 1.0, 1.0, 1.5, 2.0, 3.0}); }
  std::string_view theme() { return one_of(std::array<std::string_view, 3>{"light", "dark", "projector"}); }

 private:
  std::mt19937 random_;
};

inline Snapshot snapshot_at_rest_of_all(const Settings& settings, const Vector<2>& goal) {
  return snapshot_of(coefficients_of(settings), equilibrium_state(settings, goal));
}

// A picture of anything.
inline StageCase stage_case_by(StageDice& dice) {
  const Settings settings = dice.settings();
  const Vector<2> seen_goal = dice.goal(settings);
  StageCase made = stage_case_at(settings, seen_goal);
  made.size = dice.size();
  made.scale = dice.scale();
  made.theme = dice.theme();
  Vector<2> goal = seen_goal;
  if (dice.one_in(2)) {
    // Where a pointer can drag it to.
    const Camera camera = stage_camera(made.shown, made.size, 0.86 * made.size.y);
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
    if (dice.one_in(2))
      made.corner =
          StageCornerButton{StageCommand::motors, dice.one_in(2) ? "Arm the motors" : "MOTORS ON. Esc: off", true};
  }
  // A loop that has run away is another sentence's matter.
  if (!(glm::length(made.moment.handle) < 10.0 && glm::length(made.moment.wall_share) < 1e7)) {
    made.moment = stage_moment_at_rest(settings, goal);
  }
  made.mode = dice.one_of(std::array{StageMode::none, StageMode::none, StageMode::none, StageMode::predict,
                                     StageMode::why, StageMode::round, StageMode::ribbon});
  made.audience.can_drag = !made.moment.is_measured && !dice.one_in(5);
  made.has_grips = dice.one_in(2);
  if (dice.one_in(5)) made.hint = dice.one_of(std::array{StageHint::drag, StageHint::cure, StageHint::motor});
  if (dice.one_in(10)) {
    made.hovered =
        dice.one_of(std::array<StageAction, 4>{StageMode::why, StageMode::round, StrategyId::naive, Face::workbench});
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
  if (dice.one_in(25)) made.warning = "These settings make the simulation unstable: F4, and a lower k_r.";
  return made;
}

}  // namespace ghostforce
