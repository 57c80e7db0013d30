#include "app/state/stiffness_probe_guide.h"

#include <algorithm>

#include "app/state/user_measurement_guide.h"

namespace ghostforce {
namespace {

bool can_push(const MotorReport& motors) {
  return !motors.has_motors || motors.state == SafetyState::ramp || motors.state == SafetyState::on;
}

// Since the last look; a run that was started anew has a time of its own.
double time_since_look(StiffnessProbe& probe, double now_s) {
  const double since_s = probe.seen_s && now_s > *probe.seen_s ? now_s - *probe.seen_s : 0.0;
  probe.seen_s = now_s;
  return since_s;
}

// The window of the newest estimate lies within what was measured since then.
bool is_of_this_probe(const HandReading& hand, double pressing_s) {
  return hand.at_s - pressing_s >= HandEstimator::usual_window_s;
}

void finish(StiffnessProbe& probe, HandUnknown why, const HandEstimate& estimate) {
  probe.stage = StiffnessProbe::Stage::done;
  probe.why = why;
  probe.estimate = estimate;
  probe.filled = why == HandUnknown::none ? 1.0 : 0.0;
}

}  // namespace

void start_stiffness_probe(Session& session) {
  StiffnessProbe& probe = session.stiffness_probe;
  probe = {.stage = StiffnessProbe::Stage::running,
           .before = probe.is_known() ? std::optional(probe.estimate) : probe.before};
}

void end_stiffness_probe(Session& session) noexcept {
  StiffnessProbe& probe = session.stiffness_probe;
  probe = {.before = probe.is_known() ? std::optional(probe.estimate) : probe.before};
}

void follow_stiffness_probe(Session& session, const Snapshot& snapshot, const MotorReport& motors,
                            const HandReading& hand) {
  StiffnessProbe& probe = session.stiffness_probe;
  const double given_k_u = session.settings.stiffnesses.k_u;
  // A hand that grips otherwise is not the one that was measured.
  if (probe.stage == StiffnessProbe::Stage::done && probe.given_k_u != given_k_u) end_stiffness_probe(session);
  probe.given_k_u = given_k_u;
  if (!probe.is_running()) return;
  const double since_s = time_since_look(probe, snapshot.time_s);
  const bool is_in_wall = snapshot.strategies[index_of(session.settings.active)].in_contact;
  probe.why = !can_push(motors) ? HandUnknown::no_tones : is_in_wall ? HandUnknown::none : HandUnknown::no_contact;
  if (probe.why != HandUnknown::none) {
    probe.has_left_wall |= probe.pressing_s && probe.why == HandUnknown::no_contact;
    probe.pressing_s.reset();
    probe.filled = 0.0;
    return;
  }
  probe.tried_s += since_s;
  if (!probe.pressing_s || *probe.pressing_s > snapshot.time_s) probe.pressing_s = snapshot.time_s;
  probe.filled = std::min(hand.filled, (snapshot.time_s - *probe.pressing_s) / HandEstimator::usual_window_s);
  if (is_of_this_probe(hand, *probe.pressing_s) && hand.estimate.is_known()) {
    finish(probe, HandUnknown::none, hand.estimate);
  } else if (probe.tried_s >= StiffnessProbe::gives_up_after_s) {
    // A window that is still not full was cut short again and again.
    const HandUnknown why = hand.estimate.why;
    const bool is_reason = why != HandUnknown::none && why != HandUnknown::collecting;
    finish(probe, is_reason ? why : probe.has_left_wall ? HandUnknown::no_contact : HandUnknown::damaged, {});
  }
}

void show_stiffness_probe(Session& session, const HandEstimate& estimate) noexcept {
  StiffnessProbe& probe = session.stiffness_probe;
  probe.given_k_u = session.settings.stiffnesses.k_u;
  if (estimate.why == HandUnknown::no_contact) {
    probe.why = estimate.why;
  } else {
    finish(probe, estimate.why, estimate);
  }
}

void believe_stiffness_probe(Session& session) {
  const StiffnessProbe& probe = session.stiffness_probe;
  if (!probe.is_known()) return;
  believe_measured(session, probe.estimate.k_u);
  // A ratio that was chosen would go before it.
  session.settings.stiffnesses.chosen_tracking_ratio.reset();
}

bool stiffness_probe_is_believed(const Session& session) noexcept {
  const Stiffnesses& stiffnesses = session.settings.stiffnesses;
  return session.stiffness_probe.is_known() && session.belief_source == BeliefSource::measured &&
         stiffnesses.believed_k_u == session.stiffness_probe.estimate.k_u && !stiffnesses.chosen_tracking_ratio;
}

void press_stiffness_probe(Session& session) {
  const StiffnessProbe& probe = session.stiffness_probe;
  if (probe.is_running()) return;
  const bool can_be_used = probe.is_known() && !stiffness_probe_is_believed(session) && !session.lesson;
  can_be_used ? believe_stiffness_probe(session) : start_stiffness_probe(session);
}

bool wants_tones(const Session& session) noexcept {
  return session.stiffness_probe.is_running();
}

}  // namespace ghostforce
