#include "app/state/hand_burst_guide.h"

#include <algorithm>

#include "app/state/measurement_guide.h"

namespace ghostforce {
namespace {

bool can_push(const MotorReport& motors) {
  return !motors.has_motors || motors.state == SafetyState::ramp || motors.state == SafetyState::on;
}

// Since the last look; a run that was started anew has a time of its own.
double time_since_look(HandBurst& burst, double now_s) {
  const double since_s = burst.seen_s && now_s > *burst.seen_s ? now_s - *burst.seen_s : 0.0;
  burst.seen_s = now_s;
  return since_s;
}

// The window of the newest estimate lies within what was measured since then.
bool is_of_this_burst(const HandReading& hand, double pressing_s) {
  return hand.at_s - pressing_s >= HandEstimator::usual_window_s;
}

void finish(HandBurst& burst, HandUnknown why, const HandEstimate& estimate) {
  burst.stage = HandBurst::Stage::done;
  burst.why = why;
  burst.estimate = estimate;
  burst.filled = why == HandUnknown::none ? 1.0 : 0.0;
}

}  // namespace

void start_hand_burst(Session& session) {
  HandBurst& burst = session.hand_burst;
  burst = {.stage = HandBurst::Stage::running,
           .before = burst.is_known() ? std::optional(burst.estimate) : burst.before};
}

void end_hand_burst(Session& session) noexcept {
  HandBurst& burst = session.hand_burst;
  burst = {.before = burst.is_known() ? std::optional(burst.estimate) : burst.before};
}

void follow_hand_burst(Session& session, const Snapshot& snapshot, const MotorReport& motors, const HandReading& hand) {
  HandBurst& burst = session.hand_burst;
  const double given_k_u = session.settings.stiffnesses.k_u;
  // A hand that grips otherwise is not the one that was measured.
  if (burst.stage == HandBurst::Stage::done && burst.given_k_u != given_k_u) end_hand_burst(session);
  burst.given_k_u = given_k_u;
  if (!burst.is_running()) return;
  const double since_s = time_since_look(burst, snapshot.time_s);
  const bool is_in_wall = snapshot.strategies[index_of(session.settings.active)].in_contact;
  burst.why = !can_push(motors) ? HandUnknown::no_tones : is_in_wall ? HandUnknown::none : HandUnknown::no_contact;
  if (burst.why != HandUnknown::none) {
    burst.has_left_wall |= burst.pressing_s && burst.why == HandUnknown::no_contact;
    burst.pressing_s.reset();
    burst.filled = 0.0;
    return;
  }
  burst.tried_s += since_s;
  if (!burst.pressing_s || *burst.pressing_s > snapshot.time_s) burst.pressing_s = snapshot.time_s;
  burst.filled = std::min(hand.filled, (snapshot.time_s - *burst.pressing_s) / HandEstimator::usual_window_s);
  if (is_of_this_burst(hand, *burst.pressing_s) && hand.estimate.is_known()) {
    finish(burst, HandUnknown::none, hand.estimate);
  } else if (burst.tried_s >= HandBurst::gives_up_after_s) {
    // A window that is still not full was cut short again and again.
    const HandUnknown why = hand.estimate.why;
    const bool is_reason = why != HandUnknown::none && why != HandUnknown::collecting;
    finish(burst, is_reason ? why : burst.has_left_wall ? HandUnknown::no_contact : HandUnknown::damaged, {});
  }
}

void show_hand_burst(Session& session, const HandEstimate& estimate) noexcept {
  HandBurst& burst = session.hand_burst;
  burst.given_k_u = session.settings.stiffnesses.k_u;
  if (estimate.why == HandUnknown::no_contact) {
    burst.why = estimate.why;
  } else {
    finish(burst, estimate.why, estimate);
  }
}

void believe_hand_burst(Session& session) {
  const HandBurst& burst = session.hand_burst;
  if (!burst.is_known()) return;
  believe_measured(session, burst.estimate.k_u);
  // A ratio that was chosen would go before it.
  session.settings.stiffnesses.chosen_tracking_ratio.reset();
}

bool hand_burst_is_believed(const Session& session) noexcept {
  const Stiffnesses& stiffnesses = session.settings.stiffnesses;
  return session.hand_burst.is_known() && session.belief_source == BeliefSource::measured &&
         stiffnesses.believed_k_u == session.hand_burst.estimate.k_u && !stiffnesses.chosen_tracking_ratio;
}

void press_hand_burst(Session& session) {
  const HandBurst& burst = session.hand_burst;
  if (burst.is_running()) return;
  const bool can_be_used = burst.is_known() && !hand_burst_is_believed(session) && !session.lesson;
  can_be_used ? believe_hand_burst(session) : start_hand_burst(session);
}

bool wants_tones(const Session& session) noexcept {
  return session.hand_burst.is_running();
}

}  // namespace ghostforce
