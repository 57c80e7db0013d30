#include "core/workspace_map.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "core/rest_stability.h"

namespace ghostforce {
namespace {

Wall<2> wall_before(const Vector<2>& handle, const Vector<2>& normal, double pushed_by) noexcept {
  return {handle + normal * pushed_by, normal};
}

}  // namespace

WallAtPose wall_at_pose(const GeneralScene& scene, StrategyId id, const Vector<2>& handle, const Vector<2>& normal,
                        double depth) noexcept {
  const GeneralStrategy& strategy = scene.strategies[index_of(id)];
  WallAtPose found;
  GeneralScene there = scene;
  // Any push tells how the force grows with it.
  constexpr double tried = 1e-3;  // [m]
  there.constraint = wall_before(handle, normal, tried);
  const std::optional<ActuationMatrix<2>> actuation = actuation_at(scene.mechanism, handle);
  if (!actuation) return found;
  const Contact<2> contact = contact_at(there, strategy, handle, handle);
  if (contact.status != ContactStatus::contact) return found;
  Vector<2> force = contact.force;
  found.motor = glm::normalize(actuation->columns[0]);
  found.rest = WallAtPose::Rest::runs_away;
  const double tried_depth = tried + glm::dot(normal, scene.user_compliance * force);
  if (!(tried_depth > 0.0)) return found;
  const double grown = depth / tried_depth;
  force *= grown;

  const Compliances<2>& compliances = scene.compliances;
  const Matrix<2> response = compliances.force_share * scene.user_compliance + compliances.tracking;
  const double push = depth / (glm::dot(normal, response * normal) + compliances.constraint);
  const Vector<2> full = normal * (compliances.force_share * push);
  const double length = glm::length(full);
  const Vector<2> ghost = strategy.has_every_motor ? Vector<2>(0.0) : general_ghost_force(scene, handle, force, full);
  found.ghost_share = length > 0.0 ? glm::length(ghost) / length : 0.0;

  there.constraint = wall_before(handle, normal, tried * grown);
  if (leads_back(there, strategy, handle, handle)) found.rest = WallAtPose::Rest::stays;
  return found;
}

}  // namespace ghostforce
