#include "app/tools/sweep/point_equilibrium.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "core/batch.h"
#include "core/divergence.h"
#include "core/general_tick.h"

namespace ghostforce {
namespace {

// Ticks between two looks at whether the devices stand still: a look costs about as much as twenty ticks of a lane.
constexpr std::int64_t ticks_between_checks = 64;

// Ticks that a general scene's hand is held still at most: its handles that run away come back from the edge of the
// workspace, again and again.
constexpr std::int64_t most_held_general_ticks = 60'000;

constexpr double picometre = 1e-12;  // [m]

// Far above what counts as rest, so that it must die away, and far below anything that matters.
const Vector<2> nudge{0.8e-9, 0.6e-9};  // [m]

// Roundings that add up in one force: those of q_h, q_p and o, of their difference and of the products.
constexpr double roundings = 16.0;

// What tells whether a lane is at rest.
struct Balance {
  double k_u;             // [N/m]
  double still;           // √(k_u m) [N·s/m]
  double least;           // F of point_equilibrium.h without the roundings [N]
  double rounding;        // what a position's roundings make of it [N/m]
  double farthest_given;  // the greater one of q_u² and o² [m²]
};

Balance balance_of(const Settings& settings, const TickCoefficients<2>& coefficients, std::size_t strategy,
                   const Vector<2>& goal) noexcept {
  const Stiffnesses& stiffnesses = settings.stiffnesses;
  const double gain = glm::length(coefficients.strategies[strategy].proxy_gain);
  const double still = std::sqrt(stiffnesses.k_u * settings.mass);
  // Springs make forces of positions; damping and inertia hold a device back until a tick moves it by an ulp.
  const double stiffness =
      stiffnesses.k_u + stiffnesses.k_r * (1.0 + gain) + (settings.damping + still) * settings.rate;
  return {stiffnesses.k_u, still, stiffnesses.k_u * picometre,
          roundings * std::numeric_limits<double>::epsilon() * stiffness,
          std::max(glm::dot(goal, goal), glm::dot(settings.wall_point, settings.wall_point))};
}

enum class Course { moving, at_rest, run_away };

// Squares are compared where that saves a root: most looks find a device that moves.
Course course_of(const Balance& balance, const Batch::Lane& now, const Vector<2>& goal) noexcept {
  const double device = glm::dot(now.device, now.device);
  if (!is_near(now.device) || !is_finite(now.force)) return Course::run_away;
  const double farthest = std::max({balance.farthest_given, device, glm::dot(now.proxy, now.proxy)});
  const double negligible = balance.least + balance.rounding * std::sqrt(farthest);
  const Vector<2> pull = balance.k_u * (goal - now.device) + now.force;
  const Vector<2> inertia = balance.still * now.velocity;
  const bool is_balanced = glm::dot(pull, pull) <= negligible * negligible;
  const bool is_still = glm::dot(inertia, inertia) <= negligible * negligible;
  return is_balanced && is_still ? Course::at_rest : Course::moving;
}

// Who is in a lane.
struct Occupant {
  std::size_t point;
  std::size_t strategy;
  Balance balance;
};

// All lanes follow the path as simulate.h and `simulate` do, a piece of it at a time.
void follow(const GoalPath& path, double rate, std::int64_t last, Batch& batch) noexcept {
  std::array<Vector<2>, 256> goals;
  std::int64_t k = 0;
  const auto is_over = [&] { return k >= last || time_of(k, rate) >= path.times.back(); };
  while (!is_over()) {
    std::size_t count = 0;
    for (; count < goals.size() && !is_over(); ++count) goals[count] = goal_at(path, time_of(++k, rate));
    batch.follow({goals.data(), count});
  }
}

// Points that share each tick's goal, having one rate and one duration. `equilibria` has a place for each, empty yet.
void simulate_together(const GoalPath& path, std::span<const SimulatedPoint> points,
                       std::span<SimulatedEquilibria> equilibria) {
  const Vector<2> start = goal_at(path, 0.0);
  const Vector<2> goal = path.points.back();
  Batch batch;
  std::vector<Occupant> lanes;
  lanes.reserve(points.size() * strategy_count);
  for (std::size_t point = 0; point < points.size(); ++point) {
    const Settings& settings = points[point].settings;
    const TickCoefficients<2> coefficients = coefficients_of(settings);
    for (const Strategy& strategy : strategy_catalog()) {
      batch.add(coefficients, strategy.id, start);
      lanes.push_back({point, index_of(strategy.id), balance_of(settings, coefficients, index_of(strategy.id), goal)});
    }
  }

  const double rate = points.front().settings.rate;
  follow(path, rate, std::llround(points.front().duration * rate), batch);
  // A hand that comes straight at the wall excites nothing along it, and an unstable loop could stand on its edge.
  batch.displace(nudge);
  for (std::size_t i = 0; i < lanes.size(); ++i) batch.set_goal(i, goal);
  for (std::int64_t held = 0; held < most_held_ticks && !lanes.empty(); held += ticks_between_checks) {
    batch.hold(ticks_between_checks);
    // Backwards: the lane that comes in a removed one's place has been looked at.
    for (std::size_t i = lanes.size(); i-- > 0;) {
      const Batch::Lane now = batch[i];
      const Course course = course_of(lanes[i].balance, now, goal);
      if (course == Course::moving) continue;
      if (course == Course::at_rest) {
        equilibria[lanes[i].point][lanes[i].strategy] = SimulatedEquilibrium{now.device, now.proxy, now.force};
      }
      batch.remove(i);
      lanes[i] = lanes.back();
      lanes.pop_back();
    }
  }
}

// --- A general scene ---------------------------------------------------------------------------------------------------

// As balance_of(), for a strategy of the general loop: its hand is as stiff as in its stiffer direction.
Balance general_balance_of(const Settings& settings, const Vector<2>& goal) noexcept {
  const Stiffnesses& stiffnesses = settings.stiffnesses;
  const double k_u = std::max(stiffnesses.k_u, settings.general.k_u_second.value_or(stiffnesses.k_u));
  const double still = std::sqrt(k_u * settings.mass);
  // The proxy is at most as far as the softest tracking lets it.
  const double gain = 1.0 + stiffnesses.k_r / std::min(stiffnesses.k_u, k_u);
  const double stiffness = k_u + stiffnesses.k_r * (1.0 + gain) + (settings.damping + still) * settings.rate;
  const double reach = glm::length(settings.general.circle_center) + settings.general.circle_radius;
  const bool is_round = settings.general.constraint == ConstraintKind::circle;
  return {
      k_u, still, k_u * picometre, roundings * std::numeric_limits<double>::epsilon() * stiffness,
      std::max(glm::dot(goal, goal), is_round ? reach * reach : glm::dot(settings.wall_point, settings.wall_point))};
}

}  // namespace

SimulatedEquilibria simulate_general_to_equilibrium(const GoalPath& path, const SimulatedPoint& point) {
  const GeneralCoefficients coefficients = general_coefficients_of(point.settings);
  const Vector<2> goal = path.points.back();
  TickState<2> state = state_at_start(point.settings, goal_at(path, 0.0));
  const std::int64_t last = std::llround(point.duration * coefficients.rate);
  while (state.tick < last && time_of(state.tick, coefficients.rate) < path.times.back()) {
    tick(coefficients, goal_at(path, time_of(state.tick + 1, coefficients.rate)), state);
  }
  for (auto& own : state.strategies) own.motion.position += nudge;
  const Balance balance = general_balance_of(point.settings, goal);
  SimulatedEquilibria equilibria;
  PerStrategy<bool> is_over{};
  for (std::int64_t held = 0; held < most_held_general_ticks; held += ticks_between_checks) {
    for (std::int64_t i = 0; i < ticks_between_checks; ++i) tick(coefficients, goal, state);
    for (std::size_t i = 0; i < strategy_count; ++i) {
      if (is_over[i]) continue;
      const auto& own = state.strategies[i];
      const Batch::Lane now{own.motion.position, own.motion.velocity, own.proxy, own.force};
      if (!is_near(now.device) || !is_finite(now.force)) is_over[i] = true;
      const double farthest =
          std::max({balance.farthest_given, glm::dot(now.device, now.device), glm::dot(now.proxy, now.proxy)});
      const double negligible = balance.least + balance.rounding * std::sqrt(farthest);
      const Vector<2> pull = coefficients.user_stiffness * (goal - now.device) + now.force;
      const bool is_at_rest =
          glm::length(pull) <= negligible && balance.still * glm::length(now.velocity) <= negligible;
      if (is_over[i] || !is_at_rest || own.contact.status == ContactStatus::outside_workspace) continue;
      equilibria[i] = SimulatedEquilibrium{now.device, now.proxy, now.force, own.contact.efforts};
      is_over[i] = true;
    }
    if (std::ranges::all_of(is_over, std::identity{})) break;
  }
  return equilibria;
}

std::vector<SimulatedEquilibria> simulate_to_equilibrium(const GoalPath& path, std::span<const SimulatedPoint> points) {
  std::vector<SimulatedEquilibria> equilibria(points.size());
  const auto is_alike = [](const SimulatedPoint& one, const SimulatedPoint& other) {
    return one.settings.rate == other.settings.rate && one.duration == other.duration;
  };
  for (std::size_t first = 0; first < points.size();) {
    std::size_t count = 1;
    while (first + count < points.size() && is_alike(points[first], points[first + count])) ++count;
    simulate_together(path, points.subspan(first, count), std::span(equilibria).subspan(first, count));
    first += count;
  }
  return equilibria;
}

PointEquilibria::PointEquilibria(const EquilibriumKind& kind, std::size_t expected, bool are_general)
    : kind_(kind), are_general_(are_general) {
  points_.reserve(expected);
  if (kind.simulated) to_simulate_.reserve(expected);
}

void PointEquilibria::add(const Scene& scene) {
  const Vector<2>& goal = scene.goal.points.back();
  PointEquilibrium& point = points_.emplace_back();
  const Settings at_end = settings_at(scene, scene.settings, scene.duration);
  if (are_general_) {
    const GeneralScene general = general_scene_of(at_end);
    point.is_general = true;
    point.motors = motor_count(general.mechanism);
    point.depth = -signed_distance(general.constraint, goal);
    if (kind_.predicted) point.general = predicted_general_equilibria(general, goal);
    if (kind_.simulated) to_simulate_.push_back({at_end, scene.duration});
    return;
  }
  point.depth = depth(wall_of(scene.settings), goal);
  if (kind_.predicted) point.predicted = predicted_equilibria(at_end, goal);
  if (kind_.simulated) to_simulate_.push_back({at_end, scene.duration});
}

std::vector<PointEquilibrium> PointEquilibria::take(const GoalPath& path) {
  if (are_general_) {
    for (std::size_t i = 0; i < to_simulate_.size(); ++i) {
      points_[i].simulated = simulate_general_to_equilibrium(path, to_simulate_[i]);
    }
    return std::move(points_);
  }
  const std::vector<SimulatedEquilibria> equilibria = simulate_to_equilibrium(path, to_simulate_);
  for (std::size_t i = 0; i < equilibria.size(); ++i) points_[i].simulated = equilibria[i];
  return std::move(points_);
}

}  // namespace ghostforce
