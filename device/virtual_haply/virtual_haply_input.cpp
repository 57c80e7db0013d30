#include "device/virtual_haply/virtual_haply_input.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ghostforce {
namespace {

// As quick as a hand is that holds a handle: a press far away is no leap of the encoders [m/s].
constexpr double hand_speed = 0.5;

HaplyOptions completed(HaplyOptions options) {
  options.is_virtual = true;
  options.debts.reset();  // of real ones
  return options;
}

}  // namespace

VirtualHaplyInput::VirtualHaplyInput(std::unique_ptr<PtyBoard> made, std::unique_ptr<SerialPort> port,
                                     HaplyOptions options, const Scene& scene)
    : HeldPtyBoard{std::move(made)},
      HaplyInput(std::move(port), completed(options), scene.view.center),
      usual_(options.usual),
      plane_(options.usual, scene.view.center),
      goal_(scene.view.center),
      k_u_(scene.settings.stiffnesses.k_u) {}

void VirtualHaplyInput::move_to(const Vector<2>& goal, double duration_s) noexcept {
  if (!std::isfinite(goal.x) || !std::isfinite(goal.y)) {
    ++ignored_moves_;
    return;
  }
  goal_ = goal;
  move_s_ = std::isfinite(duration_s) ? std::clamp(duration_s, 0.0, 1.0) : 0.0;
  lead();
}

void VirtualHaplyInput::set_user_stiffness(double k_u) noexcept {
  if (!(k_u >= 0.0) || k_u == k_u_) return;
  k_u_ = k_u;
  lead();
}

void VirtualHaplyInput::lead() noexcept {
  const Vector<2> reached = nearest_within_reach(usual_.geometry, usual_.center, plane_.in_workspace(goal_));
  HaplyHandPlan plan = haply_hand_at(reached, move_s_);
  plan.stiffness = k_u_;
  plan.greatest_speed = hand_speed;
  board->lead_hand(plan);
}

}  // namespace ghostforce
