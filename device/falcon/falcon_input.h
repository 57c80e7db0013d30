// FalconInput: a Falcon in the hand, and the plane of its workspace that the scene lies in. Not armed, its handle is
// the user's goal and the device is simulated: the safe way to start, and the way the mouse works. Armed, it is the
// device (servo.h).
//
// Made on the UI thread, then the servo thread's, but for report(). SI units, in the plane of the scene.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include <glm/geometric.hpp>

#include "core/latest_value.h"
#include "core/motor_heat.h"
#include "device/falcon/calibration.h"
#include "device/falcon/falcon.h"
#include "device/input/input.h"
#include "device/motors/encoder_watch.h"
#include "device/motors/handle_motion.h"
#include "device/motors/motor_check.h"

namespace ghostforce {

// How far the handle reaches from the middle of the workspace in every direction [m].
inline constexpr double workspace_radius = 0.05;

// The plane of the wall in a Falcon's workspace. Two of the device's axes span it; along the third the handle is held
// by nothing. The middle of the workspace is the middle of the scene's view. A plain value.
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

class FalconInput : public Input, public HapticDevice {
 public:
  // `view_center`: what lies in the middle of the workspace [m].
  FalconInput(std::unique_ptr<FalconLink> link, FalconOptions options, const Vector<2>& view_center);

  void restart(const Vector<2>& goal) noexcept override;
  Vector<2> goal(std::int64_t tick, double rate) noexcept override;
  HapticDevice* haptic_device() noexcept override { return this; }

  std::int64_t now_ns() const noexcept override { return falcon_.link().now_ns(); }
  void wait_until(std::int64_t deadline_ns) noexcept override;
  HandleReading read() noexcept override;
  double force_at_handle() const noexcept override { return 1.0 / falcon_.calibration().scale; }
  void set_force_limit(double limit) noexcept override { motor_check_.set_force_limit(limit); }
  Vector<2> set_force(const Vector<2>& force, bool is_armed) noexcept override;
  double force_uncertainty() const noexcept override;
  void shut_down() noexcept override;

  // UI thread: the newest. The reference stays valid until the next call.
  const FalconReport& report() noexcept { return reports_.latest(); }

 protected:
  const Falcon& falcon() const noexcept { return falcon_; }
  FalconPlane plane() const noexcept { return {falcon_.calibration(), view_center_}; }

 private:
  void check() noexcept;
  void probe() noexcept;
  void estimate_heat(std::int64_t now_ns) noexcept;
  std::optional<Vector<3>> way_of_leg(std::size_t leg) const noexcept;

  Falcon falcon_;
  Vector<2> view_center_;
  LatestValue<FalconReport> reports_{falcon_.report()};
  HandleReading reading_;
  HandleSpeed<3> speed_;
  MotorCheck motor_check_;
  EncoderWatch encoder_watch_;
  std::int64_t checked_ns_ = 0;      // the newest reply that they have seen
  std::array<MotorHeat, 3> heat_{};  // in a frame's order
  std::int64_t heat_ns_ = 0;         // up to when; 0: not begun
  bool is_armed_ = false;
  Vector<2> standing_{0.0};    // sent last, without the probe [N]
  Vector<2> asked_way_{0.0};   // that of the force that stood when encoders were asked [1]
  Vector<3> pushed_way_{0.0};  // of the leg whose motor is checked [1]
  HandleGoal goal_;
};

}  // namespace ghostforce
