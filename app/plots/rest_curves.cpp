#include "app/plots/rest_curves.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/ghost_force.h"

namespace ghostforce {
namespace {

template <typename SettingsAt>
RestCurves curves(const Vector<2>& goal, std::size_t count, SettingsAt&& settings_at) {
  RestCurves curves;
  for (std::size_t i = 0; i < count; ++i) {
    const auto [at, settings] = settings_at(static_cast<double>(i) / static_cast<double>(count - 1));
    curves.at.push_back(at);
    for (const Strategy& entry : strategy_catalog()) {
      curves.values[index_of(entry.id)].push_back(rest_value(entry.id, settings, goal));
    }
  }
  return curves;
}

struct Point {
  double at;
  Settings settings;
};

}  // namespace

RestValue value_now(const Vector<2>& force, const Vector<2>& drift, const Settings& settings) noexcept {
  const Vector<2> normal = direction_at(settings.wall_normal_angle);
  return {glm::dot(force, direction_at(settings.actuated_angle)), glm::dot(drift, Vector<2>(-normal.y, normal.x))};
}

RestValue rest_value(StrategyId id, const Settings& settings, const Vector<2>& goal) noexcept {
  const Equilibrium<2> rest = rest_of(id, settings, goal);
  return value_now(rest.force, proxy_drift(wall_of(settings), rest.proxy, goal), settings);
}

RestCurves rest_over_wall_angle(const Settings& settings, const Vector<2>& goal, std::size_t count) {
  return curves(goal, count, [&](double share) {
    Point point{share * 2.0 * std::numbers::pi, settings};
    point.settings.wall_normal_angle = point.at;
    return point;
  });
}

RestCurves rest_over_ratio(const Settings& settings, const Vector<2>& goal, double least, double greatest,
                           std::size_t count) {
  return curves(goal, count, [&](double share) {
    Point point{least * std::pow(greatest / least, share), settings};
    point.settings.impedances.chosen_tracking_ratio = point.at;
    return point;
  });
}

}  // namespace ghostforce
