#include "app/state/stage_view.h"

#include <algorithm>

#include "app/picture/screen_box.h"
#include "core/prediction.h"

namespace ghostforce {

SceneView stage_view_of(const Settings& settings, std::span<const Vector<2>> goals) {
  // Shares of the picture's width, and of three quarters of it.
  constexpr double across = 0.50;
  constexpr double upwards = 0.32;
  constexpr double least_width = 0.03;          // [m]
  constexpr double arrow = 0.20;                // share of the width that the naïve device's is long
  ScreenBox box{goals.front(), goals.front()};  // of the world
  const auto width = [&] { return std::max({least_width, box.extent().x / across, box.extent().y / upwards}); };
  for (const Vector<2>& goal : goals) {
    box.include(goal);
    box.include(projection(wall_of(settings), goal));
    for (const PredictedEquilibrium& rest : predicted_equilibria(settings, goal)) {
      box.include(rest.at.device);
      box.include(rest.at.proxy);
    }
  }
  // Arrows are as long as the picture has it.
  const double length = arrow * width();
  for (const Vector<2>& goal : goals) {
    const auto equilibria = predicted_equilibria(settings, goal);
    const double usual = glm::length(equilibria[index_of(StrategyId::naive)].at.force);
    if (!(usual > 0.0)) continue;
    for (const PredictedEquilibrium& rest : equilibria) {
      const double longest = std::max(1.0, glm::length(rest.at.force) / usual);
      box.include(rest.at.device + rest.at.force / usual * (length / longest));
    }
  }
  return within_scene_limits({.center = 0.5 * (box.least + box.most), .width = width()});
}

SceneView stage_view_of(const Settings& settings, const Vector<2>& goal) {
  return stage_view_of(settings, std::span(&goal, 1));
}

double reference_force_of(const Settings& settings, const Vector<2>& goal) {
  constexpr double least = 0.1;  // [N]
  return std::max(least, glm::length(equilibrium_of(StrategyId::naive, settings, goal).force));
}

}  // namespace ghostforce
