#include "app/live/hand_following.h"

#include <utility>

#include "app/session/hand_burst_guide.h"

namespace ghostforce {

HandPoint hand_point(const Sample& sample, const Scene& scene, bool is_simulated) noexcept {
  const Stiffnesses stiffnesses = settings_at(scene, sample.settings, sample.snapshot.time_s).stiffnesses;
  const bool is_given = is_simulated || !sample.snapshot.measured;
  return {.time_s = sample.snapshot.time_s,
          .estimate = sample.hand.estimate,
          .believed_k_u = believed_user_stiffness(stiffnesses),
          .given_k_u = is_given ? std::optional(stiffnesses.k_u) : std::nullopt};
}

void HandFollowing::accept(Session& session) noexcept {
  source_ = session.belief_source;
  believed_k_u_ = session.settings.stiffnesses.believed_k_u;
  if (source_ == BeliefSource::measured) session.measured_k_u = believed_k_u_;
}

void HandFollowing::look(Session& session) noexcept {
  Stiffnesses& stiffnesses = session.settings.stiffnesses;
  const bool is_as_before = source_ == session.belief_source;
  if (session.belief_source == BeliefSource::measured) {
    if (stiffnesses.believed_k_u != session.measured_k_u) session.belief_source = BeliefSource::typed;
  } else if (session.belief_source == BeliefSource::live && is_as_before) {
    const bool is_typed = stiffnesses.believed_k_u != believed_k_u_ || stiffnesses.chosen_tracking_ratio;
    if (is_typed) session.belief_source = BeliefSource::typed;
  } else if (session.belief_source == BeliefSource::live) {
    stiffnesses.chosen_tracking_ratio.reset();
    stiffnesses.believed_k_u = believed_user_stiffness(stiffnesses);
  }
  accept(session);
}

bool HandFollowing::has_news(const ServoCommand& command, const ServoReport& report) noexcept {
  return command.belief_follows_hand && report.settings_generation == command.settings_generation &&
         report.hand.believed_k_u > 0.0;
}

void HandFollowing::take(double believed_k_u, Session& session, ServoCommand& command, Settings& sent) noexcept {
  if (session.belief_source != BeliefSource::live) return;
  believed_k_u_ = believed_k_u;
  session.settings.stiffnesses.believed_k_u = believed_k_u;
  command.settings.stiffnesses.believed_k_u = believed_k_u;
  sent.stiffnesses.believed_k_u = believed_k_u;
}

void HandFollowing::note(const HandReading& hand, bool follows) noexcept {
  // A run that begins anew begins at an earlier time.
  if (!follows || hand.estimate.is_known() || hand.at_s < known_at_s_) known_at_s_ = hand.at_s;
  unknown_s_ = hand.at_s - known_at_s_;
}

bool HandFollowing::ask(const Session& session, ServoCommand& command) noexcept {
  const bool follows = session.belief_source == BeliefSource::live;
  command.measures_hand = follows || wants_tones(session);
  return std::exchange(command.belief_follows_hand, follows) && !follows;
}

}  // namespace ghostforce
