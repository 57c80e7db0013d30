#include "app/sweep/settle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/geometric.hpp>

namespace ghostforce {
namespace {

// Ticks between two looks at whether the devices stand still: a look costs about as much as a tick.
constexpr std::int64_t ticks_between_looks = 32;

constexpr double picometre = 1e-12;  // [m]

// Far above what counts as rest, so that it must die away, and far below anything that matters.
constexpr double nudge_m = 1e-9;

// Roundings that add up in one force: those of q_h, q_p and o, of their difference and of the products.
constexpr double roundings = 16.0;

// F of settle.h [N].
double negligible_force(const Settings& settings, const TickPlan<2>& plan, std::size_t strategy,
                        const StrategySnapshot<2>& now, const Vector<2>& goal) noexcept {
  const Impedances& impedances = settings.impedances;
  const double farthest =
      std::max({glm::length(now.device), glm::length(now.proxy), glm::length(goal), glm::length(settings.wall_point)});
  const double step = glm::length(plan.strategies[strategy].proxy_step);
  // Springs make forces of positions; damping and inertia hold a device back until a tick moves it by an ulp.
  const double stiffness = impedances.k_u + impedances.k_r * (1.0 + step) + settings.damping * settings.rate +
                           std::sqrt(impedances.k_u * settings.mass) * settings.rate;
  return impedances.k_u * picometre + roundings * std::numeric_limits<double>::epsilon() * farthest * stiffness;
}

enum class Course { moving, at_rest, run_away };

Course course_of(const Settings& settings, const TickPlan<2>& plan, const TickState<2>& state, std::size_t strategy,
                 const StrategySnapshot<2>& now) noexcept {
  const Vector<2>& velocity = state.strategies[strategy].motion.velocity;
  if (!std::isfinite(glm::dot(now.device, now.device)) || !std::isfinite(glm::dot(now.force, now.force))) {
    return Course::run_away;
  }
  const double k_u = settings.impedances.k_u;
  const double negligible = negligible_force(settings, plan, strategy, now, state.goal);
  const bool is_balanced = glm::length(k_u * (state.goal - now.device) + now.force) <= negligible;
  const bool is_still = std::sqrt(k_u * settings.mass) * glm::length(velocity) <= negligible;
  return is_balanced && is_still ? Course::at_rest : Course::moving;
}

// A hand that comes straight at the wall excites nothing along it, and an unstable loop could stand on its edge.
void nudge(TickState<2>& state) noexcept {
  for (auto& strategy : state.strategies) strategy.motion.position += nudge_m * Vector<2>(0.8, 0.6);
}

}  // namespace

PerStrategy<std::optional<SimulatedRest>> settle(const Scene& scene) noexcept {
  const TickPlan<2> plan = plan_of(scene.settings);
  TickState<2> state = state_at_start(goal_at(scene.goal, 0.0));
  const std::int64_t last = last_tick(scene);
  for (; state.tick < last && time_of(state.tick, plan.rate) < scene.goal.times.back();) {
    tick(plan, goal_at(scene.goal, time_of(state.tick + 1, plan.rate)), state);
  }

  nudge(state);
  const Vector<2> goal = scene.goal.points.back();
  PerStrategy<std::optional<SimulatedRest>> rests;
  PerStrategy<bool> is_done{};
  for (std::int64_t held = 0; held < most_held_ticks && std::ranges::count(is_done, false) > 0;
       held += ticks_between_looks) {
    for (std::int64_t i = 0; i < ticks_between_looks; ++i) tick(plan, goal, state);
    const Snapshot snapshot = snapshot_of(plan, state);
    for (std::size_t i = 0; i < strategy_count; ++i) {
      if (is_done[i]) continue;
      const StrategySnapshot<2>& now = snapshot.strategies[i];
      const Course course = course_of(scene.settings, plan, state, i, now);
      is_done[i] = course != Course::moving;
      if (course == Course::at_rest) rests[i] = SimulatedRest{now.device, now.proxy, now.force};
    }
  }
  return rests;
}

}  // namespace ghostforce
