// HandFollowing: the belief about the hand, where it follows what is measured live. The servo alone changes it then, and
// the session shows what the servo has. Whoever types another belief, or turns ρ, wins. UI thread.
#pragma once

#include <optional>

#include "app/session/session.h"
#include "app/view/hand_history.h"
#include "device/servo/servo.h"

namespace ghostforce {

// What a sample tells of the hand. `is_simulated`: so is the one at a device, and somebody has given it its stiffness.
HandPoint hand_point(const Sample& sample, const Scene& scene, bool is_simulated) noexcept;

class HandFollowing {
 public:
  // What the session has now is as it shall be: after another scene, or a step taken back.
  void accept(Session& session) noexcept;

  // As often as something may have been changed: a belief that is no longer the one that was measured, or that is
  // followed, has been typed.
  void look(Session& session) noexcept;

  // What the servo believes by now, where `command` lets it follow and `report` is of the settings that stand there:
  // the same for session, command and the settings that were sent last, so that nothing is sent back.
  static bool has_news(const ServoCommand& command, const ServoReport& report) noexcept;
  void take(double believed_k_u, Session& session, ServoCommand& command, Settings& sent) noexcept;

  // Model time since the hand was last known, or since the belief began to follow it [s].
  void note(const HandReading& hand, bool follows) noexcept;
  double unknown_s() const noexcept { return unknown_s_; }

  // What `session` wants of the servo. Returns whether a belief that followed is the person's again: then the servo must
  // be told which.
  static bool ask(const Session& session, ServoCommand& command) noexcept;

 private:
  BeliefSource source_ = BeliefSource::typed;
  std::optional<double> believed_k_u_;  // [N/m]
  double known_at_s_ = 0.0;
  double unknown_s_ = 0.0;
};

}  // namespace ghostforce
