// FalconPlane: the plane of the wall in a Falcon's workspace. Two of the device's axes span it; along the third the
// handle is held by nothing. The middle of the workspace is the middle of the scene's view. [m], [N]; a plain value.
#pragma once

#include <glm/geometric.hpp>

#include "device/falcon/calibration.h"

namespace ghostforce {

// How far the handle reaches from the middle of the workspace in every direction [m].
inline constexpr double workspace_radius = 0.05;

class FalconPlane {
 public:
  // `view_center` in the scene [m].
  FalconPlane(const FalconCalibration& calibration, const Vector<2>& view_center) noexcept
      : right_(direction_of(calibration.right_axis)),
        up_(direction_of(calibration.up_axis)),
        center_(calibration.center),
        view_center_(view_center),
        scale_(calibration.scale) {}

  // Where a place of the handle is in the scene.
  Vector<2> in_scene(const Vector<3>& handle) const noexcept {
    const Vector<3> from_center = handle - center_;
    return view_center_ + scale_ * Vector<2>(glm::dot(right_, from_center), glm::dot(up_, from_center));
  }

  // Where the handle is, in the plane through the middle of the workspace, when it is there in the scene.
  Vector<3> in_workspace(const Vector<2>& place) const noexcept {
    const Vector<2> from_center = (place - view_center_) / scale_;
    return center_ + from_center.x * right_ + from_center.y * up_;
  }

  // A force in the plane as the handle's.
  Vector<3> on_handle(const Vector<2>& force) const noexcept { return force.x * right_ + force.y * up_; }

  // The part of a vector at the handle that lies in the plane.
  Vector<2> along(const Vector<3>& at_handle) const noexcept {
    return {glm::dot(right_, at_handle), glm::dot(up_, at_handle)};
  }

  // The smallest scale with which the handle reaches a place in the scene [1].
  double scale_to_reach(const Vector<2>& place) const noexcept {
    return glm::length(place - view_center_) / workspace_radius;
  }

 private:
  Vector<3> right_;
  Vector<3> up_;
  Vector<3> center_;
  Vector<2> view_center_;
  double scale_;
};

}  // namespace ghostforce
