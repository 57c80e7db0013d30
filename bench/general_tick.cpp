#include "bench/general_tick.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/general_by_hand.h"
#include "bench/support/contest.h"
#include "tests/core/general_scenes.h"

namespace ghostforce::bench {
namespace {

constexpr std::size_t goal_count = 1024;

// Into the wall and out again, and most of the time inside.
std::vector<Vector<2>> goals_along(const Vector<2>& inwards) {
  std::vector<Vector<2>> goals;
  for (std::size_t k = 0; k < goal_count; ++k) {
    const double turn = 2.0 * std::numbers::pi * static_cast<double>(k) / goal_count;
    goals.push_back((0.01 + 0.012 * std::sin(turn)) * inwards);
  }
  return goals;
}

template <typename ByHand>
void compare(std::string_view what, const Settings& settings, const Vector<2>& inwards, double limit_ns,
             Report& report) {
  const GeneralCoefficients coefficients = general_coefficients_of(settings);
  const std::vector<Vector<2>> goals = goals_along(inwards);
  const ByHand hand(coefficients);
  TickState<2> state = state_at_start(Vector<2>(0.0));
  std::array<HandState, strategy_count> states{};
  const auto ours = [&](std::int64_t ticks) {
    for (std::int64_t k = 0; k < ticks; ++k) tick(coefficients, goals[static_cast<std::size_t>(k) % goal_count], state);
    keep(state);
  };
  const auto by_hand = [&](std::int64_t ticks) {
    for (std::int64_t k = 0; k < ticks; ++k) {
      const Vector<2>& goal = goals[static_cast<std::size_t>(k) % goal_count];
      for (std::size_t i = 0; i < strategy_count; ++i) hand.tick(i, goal.x, goal.y, states[i]);
    }
    keep(states);
  };
  ours(4 * goal_count);
  by_hand(4 * goal_count);
  for (std::size_t i = 0; i < strategy_count; ++i) {
    const auto& own = state.strategies[i];
    if (!(std::abs(own.motion.position.x - states[i].x) < 1e-10 && std::abs(own.force.y - states[i].fy) < 1e-7)) {
      throw std::runtime_error("the general loops differ");
    }
  }
  const Contest contest({{"ours", ours}, {"by hand", by_hand}}, {.rounds = 201, .seconds_per_turn = 0.001});
  const double ratio = contest.ratio("ours", "by hand");
  const double ours_ns = 1e9 * contest.median_seconds("ours");
  report.row(fmt::format("general, {}: all three", what), fmt::format("{:.0f} ns", ours_ns),
             at_most(ours_ns, limit_ns, "ns"));
  report.row(fmt::format("… against {:.0f} ns by hand", 1e9 * contest.median_seconds("by hand")),
             fmt::format("{:.2f} times", ratio), at_most(ratio, 1.25));
}

}  // namespace

void compare_general(Report& report) {
  Settings plane = common_general_settings();
  plane.wall_normal_angle = 2.3;
  plane.general.k_u_second = 100.0;
  plane.general.k_u_first_angle = 0.4;
  compare<WallsByHand<1>>("a plane", plane, -direction_at(2.3), 250.0, report);
  compare<WallsByHand<2>>("a corner", corner_settings(), Vector<2>(0.3, -1.0), 1000.0, report);
  Settings strings = string_settings();
  compare<StringsByHand>("two strings", strings, -direction_at(strings.wall_normal_angle), 1000.0, report);
  report.note(
      "General, by hand: written for one device and one kind of wall. With strings, the rival knows that there are two "
      "that "
      "only pull, and one wall; the loop tries the states of up to four motors with limits, before any wall. Closed "
      "forms "
      "for two motors and limits without roots gained nothing that could be measured.");
}

}  // namespace ghostforce::bench
