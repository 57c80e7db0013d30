#include "core/workspace_map.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace ghostforce {
namespace {

// What a strategy pushes a handle with, at one wall; false: the handle cannot be there.
bool find_force(const GeneralScene& scene, const GeneralStrategy& strategy, const Planes<2>& planes,
                const Vector<2>& handle, ActuationMatrix<2>& actuation, Vector<2>& force) noexcept {
  if (!find_actuation(scene.mechanism, handle, actuation)) return false;
  const Contact<2> contact = strategy.has_every_motor
                                 ? solve_full_contact(handle, planes, actuation, scene.compliances)
                                 : solve_contact(handle, planes, actuation, scene.compliances, strategy.share);
  force = contact.force;
  return contact.status == ContactStatus::contact;
}

Planes<2> wall_before(const Vector<2>& handle, const Vector<2>& normal, double pushed_by) noexcept {
  Planes<2> planes;
  planes.walls[0] = {handle + normal * pushed_by, normal};
  planes.count = 1;
  return planes;
}

}  // namespace

WallAtPose wall_at_pose(const GeneralScene& scene, StrategyId id, const Vector<2>& handle, const Vector<2>& normal,
                        double depth) noexcept {
  const GeneralStrategy& strategy = scene.strategies[index_of(id)];
  WallAtPose found;
  ActuationMatrix<2> actuation;
  Vector<2> force(0.0);
  // Any push tells how the force grows with it.
  constexpr double tried = 1e-3;  // [m]
  if (!find_force(scene, strategy, wall_before(handle, normal, tried), handle, actuation, force)) return found;
  found.motor = glm::normalize(actuation.columns[0]);
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

  const Planes<2> planes = wall_before(handle, normal, tried * grown);
  constexpr double step = 1e-7;  // of differences [m]
  Matrix<2> jacobian(-1.0);
  for (glm::length_t k = 0; k < 2; ++k) {
    Vector<2> beside = handle;
    beside[k] += step;
    ActuationMatrix<2> turned;
    Vector<2> moved(0.0);
    if (!find_force(scene, strategy, planes, beside, turned, moved)) return found;
    jacobian[k] += scene.user_compliance * (moved - force) / step;
  }
  const bool leads_back = jacobian[0][0] + jacobian[1][1] < 0.0 && glm::determinant(jacobian) > 0.0;
  if (leads_back) found.rest = WallAtPose::Rest::stays;
  return found;
}

}  // namespace ghostforce
