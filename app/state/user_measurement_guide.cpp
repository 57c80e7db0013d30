#include "app/state/user_measurement_guide.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "app/state/target.h"

namespace ghostforce {
namespace {

using Stage = UserMeasurement::Stage;

// Where ρ starts, beside the value that is expected: never the same way twice, and from both sides.
constexpr std::array<double, readings_wanted> first_ratios{2.0, 0.5, 1.6, 0.6, 1.35};

constexpr double simulated_reach = 0.00002;  // [m]
constexpr double hand_reach = 0.0015;        // a held hand trembles within this [m]
constexpr double hold_s = 0.3;
constexpr double hand_average_s = 0.3;  // over which the drift of a trembling hand is averaged

// In the order of MeasuringStep.
constexpr std::array<std::string_view, 13> step_words{
    "Time is paused: press Space.",
    "The hand must come to rest: stop going round.",
    "Arm the motors with the button at the top right.",
    "Press 3: only anisotropic rendering uses the ratio ρ.",
    "Turn the wall or the actuated direction: the proxy never drifts here.",
    "Raise k_r: nothing is rendered.",
    "Drag the goal into the hatched side and let go.",
    "The motors are at their limit: do not press so deep.",
    "Raise ρ until the drift is gone.",
    "Lower ρ until the drift is gone.",
    "The drift is gone: hold still.",
    "A ratio of 1 or less fits no hand: press deeper or raise k_r.",
    "The drift is gone: take the reading.",
};
static_assert(step_words.size() == static_cast<std::size_t>(MeasuringStep::take) + 1);

// All that a reading depends on: not ρ, which is what is turned, and not what is believed or shown.
Settings basis_of(Settings settings) {
  settings.active = StrategyId::anisotropic;
  settings.stiffnesses.chosen_tracking_ratio.reset();
  settings.stiffnesses.believed_k_u.reset();
  return settings;
}

// From 0 to 1, another one for each number, and the same one every time.
double scattered(double number) {
  std::uint64_t bits = std::bit_cast<std::uint64_t>(number) * 0x9e3779b97f4a7c15U;
  bits = (bits ^ (bits >> 31)) * 0xbf58476d1ce4e5b9U;
  return static_cast<double>((bits ^ (bits >> 29)) >> 11) * 0x1p-53;
}

// Nobody can tell from where the first reading starts what is believed, which may be the answer.
double expected_ratio(const Session& session) {
  const UserMeasurement& measurement = session.measurement;
  const Stiffnesses& stiffnesses = session.settings.stiffnesses;
  if (measurement.readings.empty()) {
    const double believed = optimal_tracking_ratio(stiffnesses.k_r, believed_user_stiffness(stiffnesses));
    return believed * (0.8 + 0.7 * scattered(believed));
  }
  std::vector<double> ratios;
  for (const TakenReading& reading : measurement.readings) ratios.push_back(reading.tracking_ratio);
  return spread_of(ratios).median;
}

void set_next_ratio(Session& session) {
  const std::size_t next = session.measurement.readings.size();
  const double ratio = tracking_ratio_range.nearest_to(expected_ratio(session) * first_ratios[next]);
  session.measurement.first_ratio = ratio;
  session.settings.stiffnesses.chosen_tracking_ratio = ratio;
}

void restore(Session& session) {
  session.settings.active = session.measurement.active_before;
  session.settings.stiffnesses.chosen_tracking_ratio = session.measurement.ratio_before;
  session.belief_source = session.measurement.belief_source_before;
}

void begin_anew(Session& session) {
  UserMeasurement& measurement = session.measurement;
  measurement.readings.clear();
  measurement.settings = basis_of(session.settings);
  measurement.input = session.input;
  set_next_ratio(session);
}

void watch_rest(UserMeasurement& measurement, const Settings& settings, const Snapshot& snapshot) {
  const bool is_hand = snapshot.measured.has_value();
  const double reach = is_hand ? hand_reach : simulated_reach;
  if (measurement.seen_settings != settings) {
    measurement.device_rest = measurement.goal_rest = RestWatch<2>(reach);
    measurement.seen_settings = settings;
  }
  measurement.device_rest.see(snapshot.time_s, snapshot.strategies[index_of(StrategyId::anisotropic)].device);
  // An inferred goal is no second thing that could rest.
  measurement.goal_rest.see(snapshot.time_s, is_hand ? Vector<2>(0.0) : snapshot.goal);
}

void see_drift(UserMeasurement& measurement, const Vector<2>& direction, const Snapshot& snapshot) {
  const StrategySnapshot<2>& now = snapshot.strategies[index_of(StrategyId::anisotropic)];
  const double elapsed_s = std::max(0.0, snapshot.time_s - measurement.seen_s);
  measurement.seen_s = snapshot.time_s;
  const bool is_known = now.in_contact && (!measurement.target || snapshot.measured == StrategyId::anisotropic);
  if (!is_known || direction == Vector<2>(0.0)) {
    measurement.drift.reset();
    return;
  }
  const double seen = glm::dot(direction, now.proxy - measurement.target.value_or(snapshot.goal));
  const bool averages = measurement.target && measurement.drift;
  const double share = averages ? 1.0 - std::exp(-elapsed_s / hand_average_s) : 1.0;
  measurement.drift = std::lerp(measurement.drift.value_or(seen), seen, share);
}

MeasuringStep next_step(const Session& session, const Snapshot& snapshot, const MotorReport& motors, bool shows_drift) {
  const UserMeasurement& measurement = session.measurement;
  if (session.paused) return MeasuringStep::go_on;
  if (session.circle_test.is_on) return MeasuringStep::leave_circle;
  if (session.settings.active != StrategyId::anisotropic) return MeasuringStep::choose_a;
  if (!shows_drift) return MeasuringStep::turn_wall;
  if (!(session.settings.stiffnesses.k_r > 0.0)) return MeasuringStep::render;
  if (measurement.target && !snapshot.measured) return MeasuringStep::arm;
  if (!measurement.drift) return MeasuringStep::press;
  if (measurement.target && motors.is_saturated) return MeasuringStep::press_less;
  if (std::abs(*measurement.drift) > null_drift(measurement)) {
    return *measurement.drift > 0.0 ? MeasuringStep::raise_ratio : MeasuringStep::lower_ratio;
  }
  if (measurement.device_rest.held_s() < hold_s || measurement.goal_rest.held_s() < hold_s) {
    return MeasuringStep::hold_still;
  }
  return tracking_ratio(session.settings.stiffnesses) > 1.0 ? MeasuringStep::take : MeasuringStep::stiffen;
}

}  // namespace

bool is_measuring(const Session& session) noexcept {
  return session.measurement.stage == Stage::nulling;
}

bool hides_answer(const Session& session) noexcept {
  const UserMeasurement& measurement = session.measurement;
  const bool has_answer = is_measuring(session) || (measurement.stage == Stage::done && measurement.given_k_u);
  return has_answer && !measurement.is_revealed;
}

bool hides_curves(const Session& session) noexcept {
  return session.plots.tab != PlotTab::time && (hides_answer(session) || is_measuring(session));
}

void reveal_hand(Session& session) noexcept {
  session.measurement.is_revealed = true;
  if (is_measuring(session) && session.measurement.given_k_u) session.measurement.was_blind = false;
}

void start_measuring(Session& session) {
  const Settings settings = session.settings;
  session.measurement = {};
  UserMeasurement& measurement = session.measurement;
  measurement.stage = Stage::nulling;
  measurement.has_news = true;
  measurement.active_before = settings.active;
  measurement.ratio_before = settings.stiffnesses.chosen_tracking_ratio;
  measurement.belief_source_before = session.belief_source;
  measurement.scene = session.scene.get();
  session.belief_source = BeliefSource::typed;
  session.settings.active = StrategyId::anisotropic;
  begin_anew(session);
}

void follow_measurement(Session& session, const Snapshot& snapshot, const MotorReport& motors) {
  UserMeasurement& measurement = session.measurement;
  if (!is_measuring(session)) return;
  if (measurement.scene != session.scene.get()) {
    measurement = {};  // the settings are the other scene's: there is nothing to go back to
    return;
  }
  if (measurement.settings != basis_of(session.settings) || measurement.input != session.input) {
    // A drag changes something in every frame: after the first there is nothing left to clear.
    measurement.has_begun_anew |= !measurement.readings.empty();
    begin_anew(session);
  }
  const Wall<2> wall = wall_of(session.settings);
  measurement.target = target_of(session, motors);
  // The hand at a virtual device is as simulated as the one that the mouse leads.
  const bool is_simulated = !motors.has_motors || session.hand_is_simulated;
  measurement.given_k_u = is_simulated ? std::optional(session.settings.stiffnesses.k_u) : std::nullopt;
  const bool is_held = snapshot.measured && motors.held_k_r > 0.0;
  measurement.k_r = is_held ? motors.held_k_r : session.settings.stiffnesses.k_r;

  const Vector<2> direction = drift_direction(wall, actuation_of(session.settings));
  watch_rest(measurement, session.settings, snapshot);
  see_drift(measurement, direction, snapshot);
  const MeasuringStep before = measurement.step;
  measurement.step = next_step(session, snapshot, motors, direction != Vector<2>(0.0));
  if (measurement.step != before) measurement.was_refused = false;
}

void take_reading(Session& session) {
  UserMeasurement& measurement = session.measurement;
  if (!is_measuring(session)) return;
  if (measurement.step != MeasuringStep::take) {
    measurement.was_refused = true;
    return;
  }
  const double ratio = tracking_ratio(session.settings.stiffnesses);
  measurement.readings.push_back({ratio, user_stiffness_of(measurement.k_r, ratio)});
  measurement.has_begun_anew = false;
  if (measurement.readings.size() < readings_wanted) {
    set_next_ratio(session);
    // The next rest is not this one.
    measurement.step = MeasuringStep::hold_still;
    return;
  }
  restore(session);
  measurement.stage = Stage::done;
  measurement.has_news = true;
}

void cancel_measurement(Session& session) {
  if (is_measuring(session)) restore(session);
  session.measurement = {};
}

void believe_measured(Session& session, double k_u) noexcept {
  session.measured_k_u = user_stiffness_range.nearest_to(k_u);
  session.settings.stiffnesses.believed_k_u = session.measured_k_u;
  session.belief_source = BeliefSource::measured;
}

void believe_measurement(Session& session) {
  believe_measured(session, spread_of(session.measurement).median);
  session.measurement = {};
}

Spread spread_of(const UserMeasurement& measurement) {
  std::vector<double> readings;
  for (const TakenReading& reading : measurement.readings) readings.push_back(reading.k_u);
  return spread_of(std::span<const double>(readings));
}

double null_drift(const UserMeasurement& measurement) noexcept {
  return measurement.target ? 0.001 : 0.0002;
}

std::string_view words_for(MeasuringStep step, bool has_target) noexcept {
  if (step == MeasuringStep::press && has_target) return "Push straight into the wall at the target and hold.";
  return step_words[static_cast<std::size_t>(step)];
}

void turn_ratio(Session& session, double factor) noexcept {
  Stiffnesses& stiffnesses = session.settings.stiffnesses;
  stiffnesses.chosen_tracking_ratio = tracking_ratio_range.nearest_to(tracking_ratio(stiffnesses) * factor);
}

}  // namespace ghostforce
