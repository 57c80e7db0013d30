// HaplyInput: a Haply 2DIY in the hand, and the plane of its workspace that the scene lies in. Not armed, its handle is
// the user's goal and the device is simulated. Armed, it is the device (servo.h).
//
// Fully actuated, both motors push. The underactuated strategies push with one of them alone, whose line turns with the
// handle: HandleReading::motor_angle.
//
// The person sits opposite the base: the scene is the device turned by 180°, as seen from above.
//
// Made on the UI thread, then the servo thread's, but for report(), confirm_zero_pose() and choose_motor(). SI units, in
// the plane of the scene.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "core/latest_value.h"
#include "core/motor_heat.h"
#include "device/haply/haply.h"
#include "device/input/input.h"
#include "device/motors/direction_test.h"
#include "device/motors/encoder_watch.h"
#include "device/motors/handle_motion.h"
#include "device/motors/motor_check.h"

namespace ghostforce {

// The plane of the wall in the workspace of a pantograph. A plain value.
class HaplyPlane {
 public:
  // `view_center` in the scene, where the middle of the workspace is [m].
  HaplyPlane(const HaplyCalibration& calibration, const Vector<2>& view_center) noexcept
      : center_(calibration.center), view_center_(view_center), scale_(calibration.scale) {}

  // Where a place of the device is in the scene.
  Vector<2> in_scene(const Vector<2>& place) const noexcept { return view_center_ - scale_ * (place - center_); }
  // Where the handle is when it is there in the scene.
  Vector<2> in_workspace(const Vector<2>& place) const noexcept { return center_ - (place - view_center_) / scale_; }
  // A direction or a force at the handle as one in the scene, and the other way round.
  static Vector<2> turned(const Vector<2>& direction) noexcept { return -direction; }

 private:
  Vector<2> center_;
  Vector<2> view_center_;
  double scale_;
};

class HaplyInput : public Input, public HapticDevice {
 public:
  // `view_center`: what lies in the middle of the workspace [m].
  HaplyInput(std::unique_ptr<SerialPort> port, HaplyOptions options, const Vector<2>& view_center);

  void restart(const Vector<2>& goal) noexcept override { goal_.restart(goal); }
  Vector<2> goal(std::int64_t tick, double rate) noexcept override;
  HapticDevice* haptic_device() noexcept override { return this; }

  std::int64_t now_ns() const noexcept override { return haply_.port().now_ns(); }
  void wait_until(std::int64_t deadline_ns) noexcept override;
  HandleReading read() noexcept override;
  double force_at_handle() const noexcept override { return 1.0 / haply_.calibration().scale; }
  void set_force_limit(double limit) noexcept override { force_limit_ = limit; }
  Vector<2> set_force(const Vector<2>& force, bool is_armed) noexcept override;
  double force_uncertainty() const noexcept override;
  void shut_down() noexcept override;

  // UI thread: the newest. The reference stays valid until the next call.
  const HaplyReport& report() noexcept { return reports_.latest(); }
  // UI thread: a person says that the arms are in the zero pose.
  void confirm_zero_pose() noexcept { ++confirmations_; }
  // UI thread: the motor that pushes alone, 0 or 1.
  void choose_motor(std::size_t motor) noexcept { motor_ = motor == 0 ? 0 : 1; }

 protected:
  const Haply& haply() const noexcept { return haply_; }

 private:
  HaplyPlane plane() const noexcept { return {haply_.calibration(), view_center_}; }
  LinkagePose linkage_of(const PantographPose& pose, std::size_t pushing) const noexcept;
  void check() noexcept;
  void probe() noexcept;
  double step_of(std::size_t arm) noexcept;
  void watch_encoders(bool has_reply) noexcept;
  void estimate_heat(std::int64_t now_ns) noexcept;

  Haply haply_;
  Vector<2> view_center_;
  std::atomic<std::uint32_t> confirmations_{0};
  std::atomic<std::uint8_t> motor_{0};
  LatestValue<HaplyReport> reports_{haply_.report()};

  // The servo thread's.
  std::uint32_t seen_confirmations_ = 0;
  HandleReading reading_;
  HandleSpeed<2> speed_;
  HandleGoal goal_;
  DirectionTest direction_test_{2};
  MotorCheck motor_check_{2};  // when that is done
  bool has_begun_check_ = false;
  struct ArmWatch {
    EncoderWatch watch;
    double sign = 1.0;  // of the force that stands, along its motor's line
    // How far the other arm has gone since this one's encoder told something new [rad].
    double angle = 0.0;
    double other_least = 0.0;
    double other_greatest = 0.0;
    double angle_before = 0.0;
    double least_step = 0.0;  // 0: not known yet [rad]
  };
  std::array<ArmWatch, 2> arm_watches_{};
  std::int64_t checked_ns_ = 0;  // the newest reply that they have seen
  std::array<MotorHeat, 2> heat_{};
  std::int64_t heat_ns_ = 0;       // up to when; 0: not begun
  std::int64_t saturated_ns_ = 0;  // a motor was at its limit; 0: never
  double force_limit_ = 0.0;
  bool is_armed_ = false;
  Vector<2> standing_{0.0};  // sent last, without the probe [N]
};

}  // namespace ghostforce
