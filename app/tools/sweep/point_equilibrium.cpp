#include "app/tools/sweep/point_equilibrium.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "core/batch.h"
#include "core/divergence.h"

namespace ghostforce {
namespace {

// Ticks between two looks at whether the devices stand still: a look costs about as much as twenty ticks of a lane.
constexpr std::int64_t ticks_between_checks = 64;

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

}  // namespace

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

PointEquilibria::PointEquilibria(const EquilibriumKind& kind, std::size_t expected) : kind_(kind) {
  points_.reserve(expected);
  if (kind.simulated) to_simulate_.reserve(expected);
}

void PointEquilibria::add(const Scene& scene) {
  const Vector<2>& goal = scene.goal.points.back();
  PointEquilibrium& point = points_.emplace_back();
  point.depth = depth(wall_of(scene.settings), goal);
  const Settings at_end = settings_at(scene, scene.settings, scene.duration);
  if (kind_.predicted) point.predicted = predicted_equilibria(at_end, goal);
  if (kind_.simulated) to_simulate_.push_back({at_end, scene.duration});
}

std::vector<PointEquilibrium> PointEquilibria::take(const GoalPath& path) {
  const std::vector<SimulatedEquilibria> equilibria = simulate_to_equilibrium(path, to_simulate_);
  for (std::size_t i = 0; i < equilibria.size(); ++i) points_[i].simulated = equilibria[i];
  return std::move(points_);
}

}  // namespace ghostforce
