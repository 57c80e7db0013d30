#include "app/live/falcon_input_link.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace ghostforce {

FalconInputLink::FalconInputLink(FalconInput& input, const Scene& scene, const InputOptions& options,
                                 ReadinessOf readiness_of)
    : input_(input),
      readiness_of_(std::move(readiness_of)),
      calibrations_(options.falcon.calibrations),
      path_(scene.goal),
      view_center_(scene.view.center) {}

void FalconInputLink::fill(LoopReading& reading) const {
  if (readiness_of_) reading.readiness = readiness_of_(report_, reading.motors);
  reading.device = fmt::format("{} {}", reading.input_title, report_.serial.text());
  reading.device_remark = remark();
}

std::string FalconInputLink::remark() const {
  const auto known = std::ranges::find(calibrations_, report_.serial, &FalconCalibration::serial);
  const FalconCalibration calibration = known == calibrations_.end() ? FalconCalibration{} : *known;
  const FalconPlane plane(calibration, view_center_);
  double needed = 0.0;
  for (const Vector<2>& point : path_.points) needed = std::max(needed, plane.scale_to_reach(point));
  if (needed <= calibration.scale) return {};
  return fmt::format(
      "This scene reaches {:.0f} mm from the middle of the view, and the handle {:.0f} mm: set scale = {:.1f} or more "
      "in the device's calibration file.",
      1000.0 * workspace_radius * needed, 1000.0 * workspace_radius * calibration.scale,
      std::ceil(10.0 * needed) / 10.0);
}

VirtualFalconInputLink::VirtualFalconInputLink(VirtualFalconInput& input, const Scene& scene,
                                               const InputOptions& options, const ReadinessOf& readiness_of)
    : FalconInputLink(input, scene, options, readiness_of),
      input_(input),
      pointer_(input, scene, options),
      injected_faults_{{"none", "none", "It does what a Falcon should."}} {
  for (const InjectedFaultKind& kind : injected_fault_catalog()) {
    injected_faults_.push_back({kind.name, kind.name, kind.sentence});
  }
}

void VirtualFalconInputLink::begin(Session& session) {
  pointer_.begin(session);
  input_.move_to(session.goal, 1.0);
}

void VirtualFalconInputLink::fill(LoopReading& reading) const {
  FalconInputLink::fill(reading);
  pointer_.fill(reading);
  reading.injected_faults = injected_faults_;
}

void VirtualFalconInputLink::send(Session& session, double interval_s) {
  // Whoever drags a virtual handle holds its grip.
  input_.press(session.drags_goal ? ReplyFrame::button_centre : 0);
  if (!session.injected_fault.empty()) {
    InjectedFault wrong;
    if (const InjectedFaultKind* const kind = find_injected_fault(session.injected_fault)) kind->add(wrong);
    input_.inject(wrong);
  }
  pointer_.send(session, interval_s);
}

}  // namespace ghostforce
