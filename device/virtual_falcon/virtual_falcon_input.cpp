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

VirtualFalconInput::VirtualFalconInput(FalconOptions options, const InjectedFault& injected_fault,
                                       const Vector<2>& view_center, double k_u, Clock clock)
    : VirtualFalconInput(make_link(injected_fault, k_u, clock), completed(std::move(options)), view_center, k_u) {}

VirtualFalconInput::VirtualFalconInput(std::unique_ptr<VirtualLink> link, const FalconOptions& options,
                                       const Vector<2>& view_center, double k_u)
    : FalconInput(std::move(link), options, view_center),
      link_(static_cast<VirtualLink&>(falcon().link())),
      plane_(calibration_of(FalconSerial::from(VirtualLink::serial_number).value(), options.calibrations), view_center),
      goal_(view_center),
      k_u_(k_u) {}

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
