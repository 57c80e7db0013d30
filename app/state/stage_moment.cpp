#include "app/state/stage_moment.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/general_tick.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

// What does not depend on the strategy's own state.
StageMoment moment_of_goal(const Settings& settings, const Vector<2>& goal) noexcept {
  const bool has_every_motor = strategy(settings.active).has_every_motor;
  StageMoment moment;
  moment.weights[index_of(settings.active)] = 1.0;
  moment.goal = goal;
  moment.expected_contact = foot_on_edge(settings, goal);
  if (!is_general(settings)) {
    moment.expected_rest = has_every_motor ? equilibrium_of(settings.active, settings, goal).device
                                           : rest_without_ghost(settings, goal)->device;
    return moment;
  }
  // Where a wall is not flat it holds with every motor where they let the handle rest, not at the goal's foot.
  const auto full = rest_of(StrategyId::full, settings, goal);
  const auto cured = has_every_motor ? std::nullopt : rest_without_ghost(settings, goal);
  if (full && full->at.in_contact) moment.expected_contact = full->at.contact;
  moment.expected_rest = cured ? cured->device : full ? full->at.device : goal;
  return moment;
}

}  // namespace

void keep_within_links(const Settings& settings, StageMoment& moment) noexcept {
  moment.is_outside = is_general(settings) && motor_reach(settings, moment.handle).count == 0;
  if (!moment.is_outside || moment.is_measured) return;
  const LinkagePose pose = nearest_pose(mechanism_of(settings), moment.handle);
  if (pose.joint_count > 0) moment.handle = handle_of(pose);
}

StageMoment stage_moment(const Settings& settings, const Snapshot& snapshot, const Vector<2>& goal) noexcept {
  const StrategySnapshot<2>& now = snapshot.strategies[index_of(settings.active)];
  StageMoment moment = moment_of_goal(settings, goal);
  moment.handle = now.device;
  moment.proxy = now.proxy;
  moment.in_contact = now.in_contact;
  moment.is_measured = snapshot.measured.has_value();
  // Without contact there is none.
  moment.knows_ghost_force =
      !moment.is_measured || !moment.in_contact || (snapshot.has_target && !std::isnan(now.ghost_force.x));
  if (moment.knows_ghost_force) moment.ghost_force = now.ghost_force;
  // In free space the sampled loop has a force of its own, which is no wall's.
  if (now.in_contact) moment.wall_share = now.force - moment.ghost_force;
  moment.slide = now.proxy_drift;
  keep_within_links(settings, moment);
  moment.has_rest = !is_general(settings) || rest_of(settings.active, settings, goal).has_value();
  return moment;
}

StageMoment with_target(const StageMoment& moment, const Wall<2>& wall, const Vector<2>& target) noexcept {
  if (!moment.is_measured) return moment;
  StageMoment aimed = moment;
  aimed.has_target = true;
  aimed.expected_contact = projection(wall, target);
  aimed.slide = moment.in_contact ? along(wall, moment.proxy - target) : Vector<2>(0.0);
  return aimed;
}

StageMoment stage_moment_at_rest(const Settings& settings, const Vector<2>& goal) noexcept {
  StageMoment moment = moment_of_goal(settings, goal);
  const auto found = rest_of(settings.active, settings, goal);
  if (!found) {
    moment.has_rest = false;
    moment.handle = moment.expected_rest;
    moment.proxy = moment.expected_contact;
    keep_within_links(settings, moment);
    return moment;
  }
  const PredictedEquilibrium& rest = *found;
  moment.handle = rest.at.device;
  moment.proxy = rest.at.proxy;
  moment.in_contact = rest.at.in_contact;
  moment.wall_share = rest.at.force - rest.ghost_force;
  moment.ghost_force = rest.ghost_force;
  moment.slide = rest.proxy_drift;
  keep_within_links(settings, moment);
  return moment;
}

double signed_ghost_force(const StageMoment& moment) noexcept {
  const double size = glm::length(moment.ghost_force);
  return glm::dot(moment.ghost_force, moment.wall_share) < 0.0 ? -size : size;
}

Vector<2> neutral_guess(const Settings& settings, const Vector<2>& goal) noexcept {
  return glm::mix(goal, foot_on_edge(settings, goal), 0.45);
}

}  // namespace ghostforce
