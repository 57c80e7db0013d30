// FalconInputLink: to a Falcon, real or virtual: how far it is, and whether the handle reaches what the scene is about.
// VirtualFalconInputLink: a rehearsal, in which the pointer leads the hand at the device, and a person may ask the
// device to do something wrong. UI thread.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/live/input_link.h"
#include "app/live/pointer_link.h"
#include "device/falcon/falcon_input.h"
#include "device/virtual_falcon/virtual_falcon_input.h"

namespace ghostforce {

// How far a Falcon is, found out by who knows what to do about it; may be empty.
using ReadinessOf =
    std::function<std::vector<ReadinessStepState>(const FalconReport& report, const MotorReport& motors)>;

class FalconInputLink : public InputLink {
 public:
  FalconInputLink(FalconInput& input, const Scene& scene, const InputOptions& options, ReadinessOf readiness_of);

  void look() override { report_ = input_.report(); }
  void fill(LoopReading& reading) const override;
  // What a haptic device reports changes all the time.
  bool is_idle() const noexcept override { return false; }

 private:
  // Empty: the handle reaches all of the scene's path.
  std::string remark() const;

  FalconInput& input_;
  ReadinessOf readiness_of_;
  std::vector<FalconCalibration> calibrations_;
  GoalPath path_;
  Vector<2> view_center_;
  FalconReport report_;
};

class VirtualFalconInputLink final : public FalconInputLink {
 public:
  VirtualFalconInputLink(VirtualFalconInput& input, const Scene& scene, const InputOptions& options,
                         const ReadinessOf& readiness_of);

  void begin(Session& session) override;
  void fill(LoopReading& reading) const override;
  void send(Session& session, double interval_s) override;

 private:
  VirtualFalconInput& input_;
  PointerLink pointer_;
  std::vector<InputChoice> injected_faults_;
};

}  // namespace ghostforce
