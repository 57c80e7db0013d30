// HandFollowing: the belief about the hand, between the person, who may type it, and the servo, which alone changes it
// where it follows what is measured live. Whoever types another belief, or turns ρ, wins. UI thread.
#pragma once

#include <optional>

#include "app/picture/plot_history.h"
#include "app/state/session.h"
#include "device/servo/servo.h"

namespace ghostforce {

// What a sample tells of the hand. `is_simulated`: so is the one at a device, and somebody has given it its stiffness.
HandPoint hand_point(const Sample& sample, const Scene& scene, bool is_simulated) noexcept;

// What `session` wants of the servo. Returns whether the belief follows from now on, or no longer does: then the servo
// must be told the settings again.
bool command_hand(const Session& session, ServoCommand& command) noexcept;

class HandFollowing {
 public:
  // As often as something may have been changed: whose the belief is.
  void decide_source(Session& session) noexcept;

  // Once per frame. What the servo believes by now, where it follows the hand under these settings, the session and the
  // command believe too.
  void take_report(const ServoReport& report, Session& session, ServoCommand& command) noexcept;

  // As a step taken back has it; but a belief that followed, and follows then too, goes on.
  void restore(const Settings& settings, BeliefSource source, Session& session) noexcept;

  // Model time since the hand was last known, or since the belief began to follow it [s].
  double unknown_s() const noexcept { return unknown_s_; }

 private:
  // As they were decided last: a belief that is another one since then has been typed.
  BeliefSource source_ = BeliefSource::typed;
  std::optional<double> believed_k_u_;  // [N/m]
  double known_at_s_ = 0.0;
  double unknown_s_ = 0.0;
};

}  // namespace ghostforce
