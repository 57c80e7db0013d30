#include "device/servo/servo.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "core/belief.h"
#include "core/divergence.h"
#include "core/proxy.h"
#include "core/scene.h"
#include "core/tick.h"

namespace ghostforce {
namespace {

bool is_usable_speed(double speed) noexcept {
  return std::isfinite(speed) && speed > 0.0;
}

// The inferred goal follows a device that tones shake with a low pass of 2 Hz, below the lower of them [1].
double goal_share_with_tones(double rate) noexcept {
  const double angle = 2.0 * std::numbers::pi * 2.0 / rate;
  return angle / (1.0 + angle);
}

bool is_usable_tone(double force) noexcept {
  return force >= 0.0 && force <= greatest_tone_force;
}

// A recording tells angles in degrees: with so few digits they come back to the bit.
double told_angle(double angle) noexcept {
  constexpr double steps_per_degree = 1e5;
  return std::round(angle * degrees_per_radian * steps_per_degree) / steps_per_degree / degrees_per_radian;
}

bool is_usable(const SafetyOptions& options) noexcept {
  return std::isfinite(options.force_limit) && options.greatest_k_r >= 0.0;
}

}  // namespace

Servo::Servo(std::unique_ptr<Input> input, const ServoCommand& initial)
    : input_(std::move(input)),
      device_(input_->haptic_device()),
      commands_(initial),
      settings_(without_idle_general(initial.settings)),
      paused_(initial.paused),
      seen_generation_(initial.settings_generation),
      seen_restarts_(initial.restarts_asked),
      recording_(initial.recording),
      measurement_(initial.settings.rate),
      safety_options_(initial.safety),
      has_focus_(initial.has_focus),
      seen_arms_(initial.arms_asked),
      seen_offs_(initial.offs_asked),
      seen_departures_(initial.departures),
      seen_acknowledgements_(initial.acknowledgements),
      seen_heartbeats_(initial.heartbeats) {
  if (!may_use(initial.settings) || !is_usable_speed(initial.speed) || !is_usable_tone(initial.tone_force) ||
      has_diverged(initial.restart_state)) {
    throw std::invalid_argument("a servo cannot start with settings, a speed, a tone or a state out of range");
  }
  wants_tones_ = initial.measures_hand || initial.belief_follows_hand;
  tone_force_ = initial.tone_force;
  if (initial.belief_follows_hand) begin_following();
  update_coefficients();
  if (device_ != nullptr) heartbeat_ns_ = updated_ns_ = device_->now_ns();
  report_.motors.has_motors = device_ != nullptr;
  report_.settings_generation = initial.settings_generation;
  end_measuring();
  restart_from(initial.restart_state, initial.restarts_asked);
  speed_ = std::clamp(initial.speed, slowest, fastest);
  steps_wanted_ = steps_taken_ = initial.steps_asked;
  report_.snapshot = snapshot_of(coefficients_, state_);
  reports_.publish(report_);
}

void Servo::begin(std::int64_t now_ns, const RealtimeStatus& realtime) noexcept {
  report_.realtime = realtime;
  pacer_ = Pacer(now_ns, period_s());
  now_ns_ = now_ns;
  paced_ns_ = 0;
}

Servo::Wake Servo::next_wake() const noexcept {
  constexpr auto command_ns = static_cast<std::int64_t>(command_period_s * 1e9);
  const std::int64_t deadline = pacer_.deadline_ns();
  const bool heeds_first = is_idle() || deadline > now_ns_ + command_ns;
  return {heeds_first ? now_ns_ + command_ns : deadline, !heeds_first};
}

std::optional<std::int64_t> Servo::wake(std::int64_t now_ns) noexcept {
  woken_ns_ = now_ns;
  return wake_at(now_ns);
}

std::optional<std::int64_t> Servo::wake_at(std::int64_t now_ns) noexcept {
  now_ns_ = now_ns;
  const std::int64_t late_ns = now_ns - pacer_.deadline_ns();
  if (is_idle()) {
    pacer_.align(now_ns);
    paced_ns_ = 0;
  }
  const bool tick_is_due = pacer_.is_due(now_ns);
  if (tick_is_due) count_period(late_ns >= pacer_.period_ns());
  if (tick_is_due && device_ != nullptr) pacer_.follow(now_ns);
  report_.loop.rate_hz = pacer_.rate_hz();
  report_.loop.late_ticks = pacer_.late_ticks();
  report_.loop.worst_late_s = pacer_.worst_late_s();
  update(tick_is_due);
  pacer_.set_period(period_s(), now_ns);
  return tick_is_due ? std::optional(late_ns) : std::nullopt;
}

void Servo::count_period(bool is_late) noexcept {
  const bool is_paced = (speed_ == 1.0 || safety_.is_armed()) && (device_ == nullptr || handle_.is_known);
  const std::int64_t before_ns = std::exchange(paced_ns_, is_paced ? woken_ns_ : 0);
  if (before_ns == 0 || paced_ns_ == 0) return;
  report_.loop.periods.add(static_cast<double>(paced_ns_ - before_ns) * 1e-9, is_late);
}

void Servo::shut_down() noexcept {
  is_stepped_to_ = false;
  if (device_ == nullptr) return;
  safety_.turn_off(OffReason::program_ending);
  device_->shut_down();
}

void Servo::step_to(std::int64_t now_ns) noexcept {
  if (!std::exchange(is_stepped_to_, true)) {
    begin(now_ns);
    device_lead_ns_ = device_ != nullptr ? device_->now_ns() - now_ns : 0;
  }
  constexpr auto longest_ns = static_cast<std::int64_t>(longest_catch_up_s * 1e9);
  if (const std::int64_t missing_ns = now_ns - now_ns_ - longest_ns; missing_ns > 0) {
    now_ns_ += missing_ns;
    pacer_.leave_out(missing_ns);
    device_lead_ns_ -= missing_ns;
  }
  bool has_woken = false;
  for (Wake next = next_wake(); next.time_ns <= now_ns; next = next_wake()) {
    std::int64_t woken_ns = next.time_ns;
    if (device_ != nullptr) {
      device_->wait_until(woken_ns + device_lead_ns_);
      // Its answer may have taken a little longer, and sets the rhythm, as it does for a thread.
      woken_ns = std::max(woken_ns, device_->now_ns() - device_lead_ns_);
    }
    wake_at(woken_ns);
    has_woken = true;
  }
  // A device has its own time, in which nothing has happened yet.
  if (!has_woken && device_ == nullptr) update(false);
}

void Servo::step() noexcept {
  if (device_ != nullptr) device_->wait_until(device_->now_ns() + std::llround(period_s() * 1e9));
  update(true);
}

void Servo::update(bool tick_is_due) noexcept {
  if (commands_.has_news()) apply_command(commands_.latest());
  if (device_ != nullptr) {
    watch_handle();
    limit_force(tick_is_due);
  }
  const bool is_new_state = std::exchange(is_at_start_, false) || (takes_tick(tick_is_due) && advance());
  if (device_ != nullptr) drive_motors();
  // New settings show with the next tick: the old state under new settings is a state that never was.
  if (is_new_state) {
    take_snapshot(coefficients_, state_, report_.snapshot);
    if (coefficients_.general) report_.contacts = contact_readings_of(state_);
    const bool has_estimate = measure_hand();
    publish_sample();
    // From the next tick on: this one's sample tells the belief that it was made with.
    if (has_estimate) follow_hand();
  }
  reports_.publish(report_);
}

void Servo::publish_sample() noexcept {
  const std::int64_t before_ns = std::exchange(sampled_ns_, woken_ns_);
  const double loop_s = before_ns != 0 ? static_cast<double>(woken_ns_ - before_ns) * 1e-9 : 0.0;
  if (!put_sample(loop_s, samples_)) ++report_.loop.dropped_samples;
  if (recording_ != 0 && !put_sample(loop_s, records_)) ++report_.loop.dropped_records;
  ++samples_made_;
}

bool Servo::put_sample(double loop_s, SampleRing& ring) const noexcept {
  Sample* const slot = ring.slot();
  if (slot == nullptr) return false;
  // All of them, by name: what the ring has there is an older sample.
  auto& [snapshot, velocity, serial, restarts, recording, since_before_s, sent, is_saturated, tone, hand, settings,
         contacts] = *slot;
  copy_whole(report_.snapshot, snapshot);
  for (std::size_t i = 0; i < strategy_count; ++i) velocity[i] = state_.strategies[i].motion.velocity;
  copy_settings(limited_settings_, settings);
  serial = samples_made_;
  restarts = report_.restarts;
  recording = recording_;
  since_before_s = loop_s;
  sent = report_.motors.sent;
  is_saturated = report_.motors.is_saturated;
  tone = tone_;
  hand = report_.hand;
  if (coefficients_.general) contacts = report_.contacts;
  ring.push();
  return true;
}

// What the active strategy's force would be with the device there, at the handle [N].
Vector<2> Servo::force_at(const Vector<2>& handle) const noexcept {
  const auto& active = coefficients_.paper.strategies[index_of(settings_.active)];
  const Vector<2> proxy = proxy_of(handle, coefficients_.paper.wall, active.proxy_gain).position;
  return device_->force_at_handle() * rendered_force<2>(active, proxy, handle);
}

void Servo::watch_handle() noexcept {
  const std::int64_t now = device_->now_ns();
  const auto since = [now](std::int64_t then) { return static_cast<double>(now - then) * 1e-9; };
  handle_ = device_->read();
  follow_motor_line();
  const bool is_outside = handle_.is_known && depth(coefficients_.paper.wall, handle_.position) <= 0.0;
  safety_.update({.trouble = handle_.trouble,
                  .device_is_ready = handle_.is_ready && handle_.is_known,
                  .loop_is_healthy = handle_.is_healthy,
                  .since_exchange_s = since(handle_.time_ns),
                  .since_window_s = since(heartbeat_ns_),
                  .has_focus = has_focus_,
                  .deadman_held = handle_.deadman_held,
                  .is_outside_wall = is_outside,
                  .speed = handle_.speed,
                  .wanted_force = glm::length(force_at(handle_.position)),
                  .is_still = handle_.is_still,
                  .motors_are_checked = handle_.is_checked},
                 safety_options_, since(updated_ns_));
  if (safety_.is_armed() != coefficients_are_for_motors_) update_coefficients();
  report_.motors.is_checking = safety_.state() == SafetyState::ramp && !handle_.is_checked;
  report_.motors.finding = handle_.finding;
  report_.motors.handle = handle_.position;
  report_.motors.is_handle_known = handle_.is_known;
  report_.motors.may_still_push = handle_.may_still_push;
  report_.motors.is_outside_wall = is_outside;
  report_.motors.is_ready = handle_.is_ready && handle_.is_known && handle_.is_healthy;
  report_.motors.handle_speed = handle_.speed;
  report_.motors.exchange_age_s = since(handle_.time_ns);
  report_.motors.heat = handle_.heat;
  report_.motors.line_turns = handle_.motor_angle.has_value();
  report_.motors.line_angle = handle_.motor_angle.value_or(0.0);
  report_.motors.pushing_motor = handle_.pushing_motor;
  report_.motors.motor_is_at_limit = safety_.is_armed() && handle_.is_saturated;
  report_.motors.linkage = handle_.linkage;
  report_.motors.waits_for_zero_pose = handle_.waits_for_zero_pose;
  report_.motors.zero_pose_moved = handle_.zero_pose_moved;
}

// A motor whose line turns with the handle pushes along where it is now.
void Servo::follow_motor_line() noexcept {
  if (!handle_.motor_angle) return;
  handle_.motor_angle = told_angle(*handle_.motor_angle);
  if (*handle_.motor_angle == settings_.actuated_angle) return;
  settings_.actuated_angle = *handle_.motor_angle;
  const bool is_other_motor = handle_.pushing_motor != report_.motors.pushing_motor;
  update_coefficients(is_other_motor ? Change::leads_over : Change::steps);
}

// The line has turned since the force was limited, or while it fades: the little that is left across it is no motor's.
// More than that leads over from another strategy.
void Servo::drop_what_lags(const Vector<2>& probe, Vector<2>& force) const noexcept {
  constexpr double least_across = 0.02;  // [N]
  const Vector<2> standing = force - probe;
  const Vector<2> across = standing - glm::dot(standing, motor_axis_) * motor_axis_;
  if (glm::dot(across, across) <= least_across * least_across) force -= across;
}

void Servo::limit_force(bool tick_is_due) noexcept {
  const std::int64_t now = device_->now_ns();
  const double elapsed_s = static_cast<double>(now - std::exchange(updated_ns_, now)) * 1e-9;
  MotorReport& motors = report_.motors;
  motors.limit = safety_options_.force_limit / device_->force_uncertainty();
  device_->set_force_limit(motors.limit);
  ForceLimiter::Result result;
  // A force for a place where the handle no longer is.
  if (safety_.is_armed() && !handle_.is_known) safety_.turn_off(OffReason::loop_late);
  if (safety_.is_armed()) {
    if (tick_is_due) tone_ = sound_tones(safety_.state() == SafetyState::on, !motors.is_outside_wall);
    // Whoever has turned motors off is not pushed by what checks them.
    const Vector<2> probe = safety_.state() == SafetyState::fade ? Vector<2>(0.0) : handle_.probe;
    result = limiter_.pass(force_at(handle_.position), safety_.gain(), motors.limit, elapsed_s, tone_, probe);
    if (handle_.motor_angle && !strategy_catalog()[index_of(settings_.active)].has_every_motor)
      drop_what_lags(probe, result.force);
    if (!result.was_finite) safety_.turn_off(OffReason::fault);
  }
  motors.sent = result.force;
  motors.is_saturated = result.was_saturated || (safety_.is_armed() && handle_.is_saturated);
}

void Servo::drive_motors() noexcept {
  MotorReport& motors = report_.motors;
  if (!safety_.is_armed()) {
    limiter_.reset();
    motors.sent = Vector<2>(0.0);
    motors.is_saturated = false;
  }
  motors.sent = device_->set_force(motors.sent, safety_.is_armed());
  motors.state = safety_.state();
  motors.reason = safety_.reason();
  motors.last_reason = safety_.last_reason();
  motors.obstacle = safety_.obstacle();
  motors.gain = safety_.gain();
  motors.held_k_r = settings_.stiffnesses.k_r > safety_options_.greatest_k_r ? safety_options_.greatest_k_r : 0.0;
}

// On motors the wall is no stiffer than a person has agreed to.
void Servo::update_coefficients(Change change) noexcept {
  // Motors that come on have no force to lead over from.
  const bool comes_on = safety_.is_armed() && !coefficients_are_for_motors_;
  coefficients_are_for_motors_ = safety_.is_armed();
  limited_settings_ = settings_;
  double& k_r = limited_settings_.stiffnesses.k_r;
  if (coefficients_are_for_motors_) k_r = std::min(k_r, safety_options_.greatest_k_r);
  coefficients_ = loop_coefficients_of(limited_settings_);
  motor_axis_ = direction_at(settings_.actuated_angle);
  if (comes_on) {
    limiter_.reset();
  } else if (change == Change::leads_over) {
    limiter_.cross_fade();
  }
}

// Forces of general scenes go to no motors.
bool Servo::may_use(const Settings& settings) const noexcept {
  return is_in_range(settings) && (device_ == nullptr || !is_general(settings));
}

void Servo::apply_command(const ServoCommand& command) noexcept {
  bool is_refused = false;
  // Does it if it may be done.
  const auto heed = [&is_refused](bool is_usable, const auto& act) {
    if (is_usable) act();
    is_refused |= !is_usable;
  };
  heed(is_usable_tone(command.tone_force), [&] {
    wants_tones_ = command.measures_hand || command.belief_follows_hand;
    tone_force_ = command.tone_force;
  });
  // Following ends before new settings are used, so that their belief counts, and begins after them, from their belief.
  if (!command.belief_follows_hand) follower_.reset();
  if (std::exchange(seen_generation_, command.settings_generation) != command.settings_generation) {
    heed(may_use(command.settings), [&] { use(command.settings, command.settings_generation); });
  }
  if (command.belief_follows_hand && !follower_) begin_following();
  if (std::exchange(seen_restarts_, command.restarts_asked) != command.restarts_asked) {
    heed(!has_diverged(command.restart_state), [&] { restart_from(command.restart_state, command.restarts_asked); });
  }
  heed(is_usable_speed(command.speed), [&] { speed_ = std::clamp(command.speed, slowest, fastest); });
  if (device_ != nullptr) apply_operator(command);
  recording_ = command.recording;
  paused_ = command.paused;
  steps_wanted_ = command.steps_asked;
  if (!paused_) steps_taken_ = steps_wanted_;
  if (is_refused) ++report_.refused_commands;
}

void Servo::apply_operator(const ServoCommand& command) noexcept {
  has_focus_ = command.has_focus;
  if (command.safety != safety_options_ && is_usable(command.safety)) {
    safety_options_ = command.safety;
    update_coefficients();
  }
  if (std::exchange(seen_heartbeats_, command.heartbeats) != command.heartbeats) heartbeat_ns_ = device_->now_ns();
  if (std::exchange(seen_acknowledgements_, command.acknowledgements) != command.acknowledgements) {
    safety_.acknowledge();
  }
  if (std::exchange(seen_arms_, command.arms_asked) != command.arms_asked) safety_.arm();
  if (std::exchange(seen_departures_, command.departures) != command.departures) {
    safety_.turn_off(OffReason::visitor_gone);
  }
  if (command.machine_sleeps) safety_.turn_off(OffReason::machine_sleeps);
  // Last: whoever asks for both at once gets motors that are off.
  if (std::exchange(seen_offs_, command.offs_asked) != command.offs_asked) safety_.turn_off(OffReason::key);
}

void Servo::restart_from(const TickState<2>& state, std::uint32_t restarts) noexcept {
  state_ = state;
  // Of the run before no tone is left.
  for (auto& strategy : state_.strategies) strategy.tone = Vector<2>(0.0);
  tone_ = Vector<2>(0.0);
  measurement_.restart();
  input_->restart(state.goal);
  is_at_start_ = true;
  report_.restarts = restarts;
  report_.diverged = false;
}

void Servo::use(const Settings& settings, std::uint32_t generation) noexcept {
  // Model time goes on: t_k is k/rate, so another rate is another k.
  if (coefficients_.rate() != settings.rate) {
    state_.tick = std::llround(time_of(state_.tick, coefficients_.rate()) * settings.rate);
    measurement_.use_rate(settings.rate);
  }
  const double believed = believed_user_stiffness(settings_.stiffnesses);
  settings_ = without_idle_general(settings);
  if (handle_.motor_angle) settings_.actuated_angle = *handle_.motor_angle;
  if (follower_) {
    settings_.stiffnesses.believed_k_u = believed;
    settings_.stiffnesses.chosen_tracking_ratio.reset();
  }
  update_coefficients();
  report_.settings_generation = generation;
  // Also while no tick tells it: readers of the report pair it with the generation.
  report_.hand.believed_k_u = believed_user_stiffness(settings_.stiffnesses);
  report_.diverged = false;
}

bool Servo::takes_tick(bool tick_is_due) noexcept {
  if (!paused_ || safety_.is_armed()) return tick_is_due;
  if (steps_taken_ == steps_wanted_) return false;
  ++steps_taken_;
  return true;
}

bool Servo::advance() noexcept {
  if (report_.diverged) return false;
  if (const auto k_u = input_->user_stiffness(state_.tick + 1, coefficients_.rate())) {
    set_user_stiffness(coefficients_, *k_u);
  }
  TickState<2> next = state_;
  if (safety_.is_armed()) {
    const std::int64_t gap_ns = handle_.time_ns - std::exchange(measured_ns_, handle_.time_ns);
    const double gap_s = static_cast<double>(gap_ns) * 1e-9;
    if (gap_s > Safety::longest_exchange_s) next.measured.reset();
    if (gap_s > longest_gap_periods / coefficients_.rate()) measurement_.interrupt(HandUnknown::damaged);
    // In front of the wall, where tones fade away, the goal is where the handle is. A probe is too short to move it.
    const Vector<2> added = handle_.probe + (report_.motors.is_outside_wall ? tone_ : Vector<2>(0.0));
    const Vector<2> force = report_.motors.sent - added;
    tick_with_device(coefficients_.paper, settings_.active, handle_.position, force / device_->force_at_handle(),
                     believed_user_stiffness(settings_.stiffnesses), next,
                     measurement_.is_sounding() ? goal_share_with_tones(coefficients_.rate()) : 1.0);
  } else {
    tick(coefficients_, input_->goal(state_.tick + 1, coefficients_.rate()), next);
    // Without its motors nothing measures the hand at a device, and the simulated one beside it is not meant.
    tone_ = sound_tones(device_ == nullptr && !coefficients_.general,
                        next.strategies[index_of(settings_.active)].in_contact);
  }
  for (std::size_t i = 0; i < strategy_count; ++i) {
    const bool is_shaken = !safety_.is_armed() && i == index_of(settings_.active);
    next.strategies[i].tone = is_shaken ? tone_ : Vector<2>(0.0);
  }
  report_.diverged = has_diverged(next);
  if (report_.diverged) safety_.turn_off(OffReason::fault);
  if (!report_.diverged) state_ = next;
  return !report_.diverged;
}

double Servo::period_s() const noexcept {
  const double speed = safety_.is_armed() ? 1.0 : speed_;
  return std::max(1.0 / (coefficients_.rate() * speed), shortest_period_s);
}

}  // namespace ghostforce
