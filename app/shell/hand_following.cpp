#include "app/shell/hand_following.h"

#include <utility>

#include "app/state/stiffness_probe_guide.h"

namespace ghostforce {

HandPoint hand_point(const Sample& sample, const Scene& scene, bool is_simulated) noexcept {
  const Stiffnesses stiffnesses = settings_at(scene, sample.settings, sample.snapshot.time_s).stiffnesses;
  const bool is_given = is_simulated || !sample.snapshot.measured;
  return {.time_s = sample.snapshot.time_s,
          .estimate = sample.hand.estimate,
          .believed_k_u = believed_user_stiffness(stiffnesses),
          .given_k_u = is_given ? std::optional(stiffnesses.k_u) : std::nullopt};
}

bool command_hand(const Session& session, ServoCommand& command) noexcept {
  const bool follows = session.belief_source == BeliefSource::live;
  command.measures_hand = follows || wants_tones(session);
  return std::exchange(command.belief_follows_hand, follows) != follows;
}

void HandFollowing::decide_source(Session& session) noexcept {
  Stiffnesses& stiffnesses = session.settings.stiffnesses;
  const bool goes_on = source_ == BeliefSource::live && session.belief_source == BeliefSource::live;
  const bool is_typed =
      session.belief_source == BeliefSource::measured
          ? stiffnesses.believed_k_u != session.measured_k_u
          : goes_on && (stiffnesses.believed_k_u != believed_k_u_ || stiffnesses.chosen_tracking_ratio);
  if (is_typed) session.belief_source = BeliefSource::typed;
  if (session.belief_source == BeliefSource::live) {
    // It goes on from what was believed, however that was chosen.
    stiffnesses.believed_k_u = believed_user_stiffness(stiffnesses);
    stiffnesses.chosen_tracking_ratio.reset();
  }
  source_ = session.belief_source;
  believed_k_u_ = stiffnesses.believed_k_u;
}

void HandFollowing::take_report(const ServoReport& report, Session& session, ServoCommand& command) noexcept {
  decide_source(session);
  const HandReading& hand = report.hand;
  const bool follows = command.belief_follows_hand;
  // A run that begins anew begins at an earlier time.
  if (!follows || hand.estimate.is_known() || hand.at_s < known_at_s_) known_at_s_ = hand.at_s;
  unknown_s_ = hand.at_s - known_at_s_;
  if (!follows || source_ != BeliefSource::live || report.settings_generation != command.settings_generation) return;
  believed_k_u_ = hand.believed_k_u;
  session.settings.stiffnesses.believed_k_u = hand.believed_k_u;
  command.settings.stiffnesses.believed_k_u = hand.believed_k_u;
}

void HandFollowing::restore(const Settings& settings, BeliefSource source, Session& session) noexcept {
  const bool goes_on = session.belief_source == BeliefSource::live && source == BeliefSource::live;
  const std::optional<double> believed_k_u = (goes_on ? session.settings : settings).stiffnesses.believed_k_u;
  session.settings = settings;
  session.settings.stiffnesses.believed_k_u = believed_k_u;
  session.belief_source = source_ = source;
  believed_k_u_ = believed_k_u;
  if (source == BeliefSource::measured) session.measured_k_u = believed_k_u;
}

}  // namespace ghostforce
