#include "device/virtual_falcon/virtual_falcon_input.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "device/virtual_falcon/practice_firmware.h"

namespace ghostforce {
namespace {

// As long as a real one: its upload can be watched.
constexpr unsigned practice_words = 4000;

FalconOptions completed(FalconOptions options) {
  options.is_virtual = true;
  options.debts.reset();  // of real ones
  if (options.firmware.empty()) options.firmware = practice_firmware(practice_words);
  return options;
}

std::unique_ptr<VirtualLink> make_link(const InjectedFault& injected_fault, double k_u, VirtualLink::Clock clock) {
  VirtualLink::Options options{.clock = clock, .injected_fault = injected_fault};
  options.hand.homes_when_asked = true;
  options.hand.stiffness = k_u;
  return std::make_unique<VirtualLink>(options);
}

}  // namespace

VirtualFalconInput::VirtualFalconInput(FalconOptions options, const InjectedFault& injected_fault, const Scene& scene,
                                       Clock clock)
    : VirtualFalconInput(make_link(injected_fault, scene.settings.stiffnesses.k_u, clock),
                         completed(std::move(options)), scene) {}

VirtualFalconInput::VirtualFalconInput(std::unique_ptr<VirtualLink> link, const FalconOptions& options,
                                       const Scene& scene)
    : FalconInput(std::move(link), options, scene.view.center),
      link_(static_cast<VirtualLink&>(falcon().link())),
      plane_(calibration_of(DeviceSerial::from(VirtualLink::serial_number).value(), options.calibrations),
             scene.view.center),
      goal_(scene.view.center),
      k_u_(scene.settings.stiffnesses.k_u),
      stiffness_(scene.stiffness_path),
      tremor_and_drift_(scene.tremor_and_drift) {}

std::optional<double> VirtualFalconInput::user_stiffness(std::int64_t tick, double rate) noexcept {
  const double time_s = time_of(tick, rate);
  std::optional<double> stiffness;
  if (!stiffness_.is_empty()) stiffness = stiffness_at(stiffness_, time_s);
  const Vector<3> way = tremor_and_drift_.is_still()
                            ? Vector<3>(0.0)
                            : plane_.in_workspace(tremor_and_drift_.at(time_s)) - plane_.in_workspace(Vector<2>(0.0));
  link_.shake_hand(way, stiffness);
  return stiffness;
}

void VirtualFalconInput::move_to(const Vector<2>& goal, double duration_s) noexcept {
  if (!std::isfinite(goal.x) || !std::isfinite(goal.y)) {
    ++ignored_moves_;
    return;
  }
  goal_ = goal;
  move_s_ = std::isfinite(duration_s) ? std::clamp(duration_s, 0.0, 1.0) : 0.0;
  lead();
}

void VirtualFalconInput::set_user_stiffness(double k_u) noexcept {
  if (!(k_u >= 0.0) || k_u == k_u_) return;
  k_u_ = k_u;
  lead();
}

void VirtualFalconInput::press(std::uint8_t buttons) noexcept {
  if (buttons == buttons_) return;
  buttons_ = buttons;
  move_s_ = 0.0;  // a plan's buttons come with its waypoints: now
  lead();
}

void VirtualFalconInput::lead() noexcept {
  HandPlan plan = hand_at(plane_.in_workspace(goal_), move_s_);
  plan.stiffness = k_u_;
  plan.homes_when_asked = true;
  for (HandPlan::Waypoint& waypoint : std::span(plan.waypoints).first(plan.count)) waypoint.buttons = buttons_;
  link_.lead_hand(plan);
}

}  // namespace ghostforce
