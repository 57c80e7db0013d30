// To a Falcon, real or virtual: how far it is, and whether the handle reaches what the scene is about. The virtual one
// is a rehearsal: the pointer leads the hand at the device, and a person may ask the device to do something wrong.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "app/files/falcon_calibration_file.h"
#include "app/shell/input_link.h"
#include "core/conventions.h"
#include "device/virtual_falcon/virtual_falcon_input.h"

namespace ghostforce {
namespace {

class FalconInputLink : public InputLink {
 public:
  FalconInputLink(FalconInput& input, const Scene& scene, const InputOptions& options, ReadinessOf readiness_of)
      : input_(input),
        readiness_of_(std::move(readiness_of)),
        calibrations_(options.falcon.calibrations),
        path_(scene.goal),
        view_center_(scene.view.center) {}

  void poll() override { report_ = input_.report(); }

  void fill(LoopReading& reading) const override {
    if (readiness_of_) reading.readiness = readiness_of_(report_, reading.motors);
    reading.device = fmt::format("{} {}", reading.input_title, report_.serial.text());
    reading.device_remark = remark();
  }

  std::optional<DeviceFacts> device() const override {
    FalconCalibration calibration = calibration_of(report_.serial, calibrations_);
    const bool is_its_own = calibration.serial == report_.serial && !calibration.serial.text().empty();
    calibration.serial = report_.serial;
    return DeviceFacts{.name = std::string(report_.is_virtual ? "Virtual Falcon" : "Falcon"),
                       .serial = std::string(report_.serial.text()),
                       .is_simulated = report_.is_virtual,
                       .has_own_calibration = is_its_own,
                       .calibration = falcon_calibration_text(calibration),
                       .exchanges = report_.exchanges,
                       .lost_exchanges = report_.lost_exchanges,
                       .discarded_bytes = report_.discarded_bytes,
                       .line_errors = report_.line_errors};
  }
  std::string_view fault() const noexcept override {
    return report_.fault == FalconFault::none ? std::string_view() : entry_of(report_.fault).name;
  }

  // Nobody else would stop it when it is back. One that is simulated ends with its input.
  std::string why_not_leave() override {
    poll();
    if (!report_.may_still_push || report_.is_virtual) return {};
    return "The Falcon's motors may still push, and only its own input can stop them. F2 says what to do. If the "
           "device will not come back, end the program and start it again.";
  }

  // What a haptic device reports changes all the time.
  bool is_idle() const noexcept override { return false; }

  bool is_opening() const noexcept override {
    return report_.state < FalconState::homing || report_.state == FalconState::fault;
  }

 private:
  // Empty: the handle reaches all of the scene's path.
  std::string remark() const {
    const FalconCalibration calibration = calibration_of(report_.serial, calibrations_);
    const FalconPlane plane(calibration, view_center_);
    double needed = 0.0;
    for (const Vector<2>& point : path_.points) needed = std::max(needed, plane.scale_to_reach(point));
    if (needed <= calibration.scale) return {};
    return fmt::format(
        "This scene reaches {:.0f} mm from the middle of the view, but the handle reaches only {:.0f} mm. Set scale = "
        "{:.1f} or more in the device's calibration file.",
        mm_per_m * workspace_radius * needed, mm_per_m * workspace_radius * calibration.scale,
        std::ceil(10.0 * needed) / 10.0);
  }

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
                         const ReadinessOf& readiness_of)
      : FalconInputLink(input, scene, options, readiness_of), input_(input), pointer_(input, scene, options) {
    for (const InjectedFaultKind& kind : injected_fault_catalog()) {
      injected_faults_.push_back({kind.name, kind.name, kind.sentence});
    }
  }

  void begin(Session& session) override {
    pointer_.begin(session);
    input_.move_to(session.goal, 1.0);
  }

  void fill(LoopReading& reading) const override {
    FalconInputLink::fill(reading);
    pointer_.fill(reading);
    reading.injected_faults = injected_faults_;
  }

  void send(Session& session, double interval_s) override {
    // Whoever drags a virtual handle holds its grip.
    input_.press(session.drags_goal ? ReplyFrame::button_centre : 0);
    if (!session.injected_fault.empty()) {
      InjectedFault wrong;
      if (const InjectedFaultKind* const kind = find_injected_fault(session.injected_fault)) kind->add(wrong);
      input_.inject(wrong);
    }
    pointer_.send(session, interval_s);
  }

 private:
  VirtualFalconInput& input_;
  PointerLink pointer_;
  std::vector<InputChoice> injected_faults_{{"none", "none", "The virtual Falcon works as it should."}};
};

}  // namespace

const InputMaker<VirtualFalconInput> virtual_falcon_kind{
    {{"virtual-falcon", "Virtual Falcon",
      "The Falcon's driver with a simulated device and hand behind it; drag in the scene to guide that hand."},
     /*is_scripted=*/false,
     /*needs_recording=*/false,
     /*hand_is_simulated=*/true},
    [](const Scene& scene, const InputOptions& options) {
      return std::make_unique<VirtualFalconInput>(options.falcon, options.injected_fault, scene,
                                                  options.virtual_falcon_clock);
    }};

InputEntry falcon_entry(const InputMaker<FalconInput>& maker, const ReadinessOf& readiness_of) {
  return linked<FalconInputLink>(maker, readiness_of);
}

InputEntry virtual_falcon_entry(const ReadinessOf& readiness_of) {
  return linked<VirtualFalconInputLink>(virtual_falcon_kind, readiness_of);
}

}  // namespace ghostforce
