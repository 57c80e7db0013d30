#include "app/figures/played_motion.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "app/failure.h"
#include "core/ghost_force.h"
#include "core/play.h"
#include "core/sound_state.h"

namespace ghostforce {
namespace {

constexpr std::int64_t ticks_between_moments = 5;  // 200 Hz of a loop at 1 kHz: 16 points of the fastest tremor
constexpr std::int64_t most_moments = 6000;        // more are finer than any picture

std::vector<CsvCell> row_of(const PlayedMotion& motion, StrategyId id, std::string source, double time_s,
                            const Vector<2>& goal, const Vector<2>& device, const Vector<2>& proxy,
                            const Vector<2>& force, const Vector<2>& ghost) {
  return {motion.name,
          std::string(strategy(id).name),
          std::move(source),
          time_s,
          goal.x,
          goal.y,
          device.x,
          device.y,
          proxy.x,
          proxy.y,
          force.x,
          force.y,
          ghost.x,
          ghost.y};
}

}  // namespace

PlayedMotion play_motion(std::string name, const Scene& scene) {
  PlayedMotion motion{.name = std::move(name), .scene = scene, .moments = {}};
  const std::int64_t last = last_tick(scene);
  const std::int64_t between = std::max(ticks_between_moments, last / most_moments);
  const TickState<2> state = play(scene, last, [&](const Snapshot& snapshot) {
    if (snapshot.tick % between == 0 || snapshot.tick == last) motion.moments.push_back(snapshot);
  });
  if (!is_sound(state)) {
    throw Failure(ExitCode::wrong_call, "with these settings the sampled loop is unstable and the device runs away");
  }
  const Vector<2> goal = motion.moments.back().goal;
  for (const Strategy& strategy : strategy_catalog()) {
    const std::size_t i = index_of(strategy.id);
    motion.rest[i] = rest_of(strategy.id, scene.settings, goal);
    motion.ghost_at_rest[i] =
        ghost_force(actuation_of(scene.settings), motion.rest[i].force, motion.rest[index_of(StrategyId::full)].force);
  }
  return motion;
}

CsvTable table_of(std::span<const PlayedMotion> motions) {
  CsvTable table;
  table.comments = {"One row per pane, strategy and moment as simulated, and one of the closed form at rest (t_s nan).",
                    "Units: s, m, N. The force is what the device puts on the hand."};
  table.columns = {
      "pane",       "strategy",  "source",    "t_s",       "goal_x_m",  "goal_y_m",        "device_x_m",
      "device_y_m", "proxy_x_m", "proxy_y_m", "force_x_N", "force_y_N", "ghost_force_x_N", "ghost_force_y_N"};
  for (const PlayedMotion& motion : motions) {
    for (const Strategy& strategy : strategy_catalog()) {
      const std::size_t i = index_of(strategy.id);
      for (const Snapshot& moment : motion.moments) {
        const StrategySnapshot<2>& now = moment.strategies[i];
        table.rows.push_back(row_of(motion, strategy.id, "simulated", moment.time_s, moment.goal, now.device, now.proxy,
                                    now.force, now.ghost_force));
      }
      const Equilibrium<2>& rest = motion.rest[i];
      table.rows.push_back(row_of(motion, strategy.id, "closed form", std::numeric_limits<double>::quiet_NaN(),
                                  rest.goal, rest.device, rest.proxy, rest.force, motion.ghost_at_rest[i]));
    }
  }
  return table;
}

}  // namespace ghostforce
