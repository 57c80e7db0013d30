// To a Haply 2DIY, real or virtual: how far it is, which of its motors pushes alone, and the person's word that its arms
// are in the zero pose. The virtual one is a rehearsal: the pointer leads the hand at the device, and a person may ask the
// device to do something wrong.
#include "app/shell/haply_input_link.h"

#include <utility>

#include <fmt/format.h>

#include "app/files/haply_calibration_file.h"
#include "device/virtual_haply/virtual_haply_input.h"

namespace ghostforce {
namespace {

class HaplyInputLink : public InputLink {
 public:
  HaplyInputLink(HaplyInput& input, const Scene&, const InputOptions& options, HaplyReadinessOf readiness_of)
      : input_(input), readiness_of_(std::move(readiness_of)), haply_(options.haply) {}

  void begin(Session& session) override { confirmed_ = session.zero_poses_confirmed; }

  void poll() override { report_ = input_.report(); }

  void fill(LoopReading& reading) const override {
    if (readiness_of_) reading.readiness = readiness_of_(report_, reading.motors);
    reading.device = fmt::format("{} {}", reading.input_title, report_.serial.text());
    reading.device_remark = remark();
  }

  void send(Session& session, double /*interval_s*/) override {
    input_.choose_motor(session.device_motor);
    if (std::exchange(confirmed_, session.zero_poses_confirmed) != session.zero_poses_confirmed)
      input_.confirm_zero_pose();
  }

  std::optional<DeviceFacts> device() const override {
    HaplyCalibration calibration = calibration_of(report_.serial, haply_.calibrations, haply_.usual);
    const bool is_its_own = calibration.serial == report_.serial && !calibration.serial.text().empty();
    calibration.serial = report_.serial;
    return DeviceFacts{.name = std::string(report_.is_virtual ? "Virtual Haply" : "Haply"),
                       .serial = std::string(report_.serial.text()),
                       .is_simulated = report_.is_virtual,
                       .has_own_calibration = is_its_own,
                       .calibration = haply_calibration_text(calibration),
                       .exchanges = report_.exchanges,
                       .lost_exchanges = report_.lost_exchanges,
                       .discarded_bytes = report_.discarded_bytes};
  }
  std::string_view fault() const noexcept override {
    return report_.fault == HaplyFault::none ? std::string_view() : entry_of(report_.fault).name;
  }

  // Nobody else would stop it when it is back. One that is simulated ends with its input.
  std::string why_not_leave() override {
    poll();
    if (!report_.may_still_push || report_.is_virtual) return {};
    return "The Haply's motors may still push, and only its own input can stop them. F2 says what to do. If the board "
           "will not come back, end the program and start it again.";
  }

  // What a haptic device reports changes all the time.
  bool is_idle() const noexcept override { return false; }

  bool is_opening() const noexcept override {
    return report_.state < HaplyState::zero_pose || report_.state == HaplyState::fault;
  }

 private:
  // Where one motor cannot give what is asked for, the ghost force would be larger than the one that is felt.
  std::string remark() const {
    if (report_.is_saturated)
      return "A motor is at its limit: it cannot give the force that is asked for. Press less deep, or lower k_r.";
    if (report_.is_readable() && report_.workspace_share < 1.0)
      return "The arms are almost in line here, where a motor cannot be trusted: the force is reduced.";
    return {};
  }

  HaplyInput& input_;
  HaplyReadinessOf readiness_of_;
  HaplyOptions haply_;
  HaplyReport report_;
  std::uint32_t confirmed_ = 0;

 protected:
  const HaplyReport& report() const noexcept { return report_; }
};

class VirtualHaplyInputLink final : public HaplyInputLink {
 public:
  VirtualHaplyInputLink(VirtualHaplyInput& input, const Scene& scene, const InputOptions& options,
                        const HaplyReadinessOf& readiness_of)
      : HaplyInputLink(input, scene, options, readiness_of), input_(input), pointer_(input, scene, options) {
    for (const InjectedHaplyFaultKind& kind : injected_haply_fault_catalog()) {
      injected_faults_.push_back({kind.name, kind.name, kind.sentence});
    }
  }

  void begin(Session& session) override {
    HaplyInputLink::begin(session);
    pointer_.begin(session);
    input_.move_to(session.goal, 1.0);
  }

  // The hand holds the zero pose as long as the driver waits for it, as a person would.
  void poll() override {
    HaplyInputLink::poll();
    input_.hold_zero_pose(report().state == HaplyState::zero_pose);
  }

  void fill(LoopReading& reading) const override {
    HaplyInputLink::fill(reading);
    pointer_.fill(reading);
    reading.injected_faults = injected_faults_;
  }

  void send(Session& session, double interval_s) override {
    HaplyInputLink::send(session, interval_s);
    if (!session.injected_fault.empty()) {
      InjectedHaplyFault wrong;
      if (const auto* const kind = find_injected_haply_fault(session.injected_fault)) kind->add(wrong);
      input_.inject(wrong);
    }
    pointer_.send(session, interval_s);
  }

 private:
  VirtualHaplyInput& input_;
  PointerLink pointer_;
  std::vector<InputChoice> injected_faults_{{"none", "none", "The virtual Haply works as it should."}};
};

}  // namespace

InputEntry haply_entry(const InputMaker<HaplyInput>& maker, const HaplyReadinessOf& readiness_of) {
  return linked<HaplyInputLink>(maker, readiness_of);
}

InputEntry virtual_haply_entry(const InputMaker<VirtualHaplyInput>& maker, const HaplyReadinessOf& readiness_of) {
  return linked<VirtualHaplyInputLink>(maker, readiness_of);
}

}  // namespace ghostforce
