#include "app/workbench/equilibrium_curves.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/ghost_force.h"

namespace ghostforce {
namespace {

struct Point {
  double at;
  EquilibriumQuestion question;
};

template <typename PointAt>
EquilibriumCurves curves(std::size_t count, PointAt&& point_at) {
  EquilibriumCurves curves;
  for (std::size_t i = 0; i < count; ++i) {
    const Point point = point_at(static_cast<double>(i) / static_cast<double>(count - 1));
    curves.at.push_back(point.at);
    for (const Strategy& entry : strategy_catalog()) {
      curves.values[index_of(entry.id)].push_back(equilibrium_value(entry.id, point.question));
    }
  }
  return curves;
}

}  // namespace

EquilibriumQuestion equilibrium_question(const Settings& settings, const Snapshot& snapshot) noexcept {
  EquilibriumQuestion question{settings, snapshot.goal, snapshot.measured.has_value()};
  Stiffnesses& stiffnesses = question.settings.stiffnesses;
  if (question.goal_is_inferred) stiffnesses.k_u = believed_user_stiffness(stiffnesses);
  return question;
}

EquilibriumValue value_now(const Vector<2>& force, const Vector<2>& drift, const Settings& settings) noexcept {
  const Vector<2> normal = direction_at(settings.wall_normal_angle);
  return {glm::dot(force, direction_at(settings.actuated_angle)), glm::dot(drift, Vector<2>(-normal.y, normal.x))};
}

EquilibriumValue equilibrium_value(StrategyId id, const EquilibriumQuestion& question) noexcept {
  const Equilibrium<2> rest = equilibrium_of(id, question.settings, question.goal);
  EquilibriumValue value =
      value_now(rest.force, proxy_drift(wall_of(question.settings), rest.proxy, question.goal), question.settings);
  if (question.goal_is_inferred) value.drift = std::numeric_limits<double>::quiet_NaN();
  return value;
}

Vector<2> goal_turned_with_wall(const Settings& settings, const Vector<2>& goal, double wall_normal_angle) noexcept {
  const Vector<2> before = direction_at(settings.wall_normal_angle);
  const Vector<2> normal = direction_at(wall_normal_angle);
  const Vector<2> arm = goal - settings.wall_point;
  const double out = glm::dot(before, arm);
  const double beside = glm::dot(Vector<2>(-before.y, before.x), arm);
  return settings.wall_point + out * normal + beside * Vector<2>(-normal.y, normal.x);
}

EquilibriumCurves equilibria_over_wall_angle(const EquilibriumQuestion& question, std::size_t count) {
  return curves(count, [&](double share) {
    Point point{share * 2.0 * std::numbers::pi, question};
    point.question.settings.wall_normal_angle = point.at;
    point.question.goal = goal_turned_with_wall(question.settings, question.goal, point.at);
    return point;
  });
}

EquilibriumCurves equilibria_over_ratio(const EquilibriumQuestion& question, double least, double greatest,
                                        std::size_t count) {
  return curves(count, [&](double share) {
    Point point{least * std::pow(greatest / least, share), question};
    point.question.settings.stiffnesses.chosen_tracking_ratio = point.at;
    return point;
  });
}

}  // namespace ghostforce
