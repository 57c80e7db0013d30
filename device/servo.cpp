#include "device/servo.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <stdexcept>
#include <utility>

#include <pthread.h>

#include "core/scene.h"
#include "core/sound_state.h"
#include "device/pacer.h"

namespace ghostforce {
namespace {

bool is_usable_speed(double speed) noexcept {
  return std::isfinite(speed) && speed > 0.0;
}

std::int64_t now_ns() noexcept {
  std::timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

void sleep_until(std::int64_t time_ns) noexcept {
  const std::timespec time{time_ns / 1'000'000'000, time_ns % 1'000'000'000};
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr);  // waking too soon does no harm
}

}  // namespace

Servo::Servo(std::unique_ptr<Input> input, const ServoCommand& initial)
    : input_(std::move(input)),
      commands_(initial),
      paused_(initial.paused),
      seen_generation_(initial.settings_generation),
      seen_restarts_(initial.restarts_asked) {
  if (!is_in_range(initial.settings) || !is_usable_speed(initial.speed) || !is_sound(initial.restart_state)) {
    throw std::invalid_argument("a servo cannot start with settings, a speed or a state out of range");
  }
  plan_ = plan_of(initial.settings);
  report_.settings_generation = initial.settings_generation;
  restart_from(initial.restart_state, initial.restarts_asked);
  speed_ = std::clamp(initial.speed, slowest, fastest);
  steps_wanted_ = steps_taken_ = initial.steps_asked;
  report_.snapshot = snapshot_of(plan_, state_);
  reports_.publish(report_);
}

Servo::~Servo() {
  stop();
}

void Servo::start() {
  if (thread_.joinable()) return;
  stopping_.store(false, std::memory_order_relaxed);
  thread_ = std::thread(&Servo::run, this);
}

void Servo::stop() noexcept {
  if (!thread_.joinable()) return;
  stopping_.store(true, std::memory_order_relaxed);
  thread_.join();
}

void Servo::run() noexcept {
  // Signals are the UI thread's matter.
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
  pthread_setname_np(pthread_self(), "servo");
  report_.realtime = request_realtime();

  constexpr auto attention_ns = static_cast<std::int64_t>(attention_period_s * 1e9);
  std::int64_t now = now_ns();
  Pacer pacer(now, period_s());
  while (!stopping_.load(std::memory_order_relaxed)) {
    sleep_until(is_idle() ? now + attention_ns : std::min(pacer.deadline_ns(), now + attention_ns));
    now = now_ns();
    if (is_idle()) pacer.align(now);
    const bool tick_is_due = pacer.is_due(now);
    report_.loop.rate_hz = pacer.rate_hz();
    report_.loop.late_ticks = pacer.late_ticks();
    report_.loop.worst_late_s = pacer.worst_late_s();
    attend(tick_is_due);
    pacer.set_period(period_s(), now);
  }
}

void Servo::attend(bool tick_is_due) noexcept {
  if (commands_.has_news()) take_command(commands_.latest());
  const bool is_new_state = std::exchange(is_at_start_, false) || (takes_tick(tick_is_due) && advance());
  // New settings show with the next tick: the old state under new settings is a state that never was.
  if (is_new_state) {
    report_.snapshot = snapshot_of(plan_, state_);
    if (!samples_.try_enqueue({report_.snapshot, report_.restarts})) ++report_.loop.dropped_samples;
  }
  reports_.publish(report_);
}

void Servo::take_command(const ServoCommand& command) noexcept {
  bool is_refused = false;
  if (command.settings_generation != seen_generation_) {
    seen_generation_ = command.settings_generation;
    if (is_in_range(command.settings)) {
      use(command.settings, command.settings_generation);
    } else {
      is_refused = true;
    }
  }
  if (command.restarts_asked != seen_restarts_) {
    seen_restarts_ = command.restarts_asked;
    if (is_sound(command.restart_state)) {
      restart_from(command.restart_state, command.restarts_asked);
    } else {
      is_refused = true;
    }
  }
  if (is_usable_speed(command.speed)) {
    speed_ = std::clamp(command.speed, slowest, fastest);
  } else {
    is_refused = true;
  }
  paused_ = command.paused;
  steps_wanted_ = command.steps_asked;
  if (!paused_) steps_taken_ = steps_wanted_;
  if (is_refused) ++report_.refused_commands;
}

void Servo::restart_from(const TickState<2>& state, std::uint32_t restarts) noexcept {
  state_ = state;
  input_->restart(state.goal);
  is_at_start_ = true;
  report_.restarts = restarts;
  report_.diverged = false;
}

void Servo::use(const Settings& settings, std::uint32_t generation) noexcept {
  // Model time goes on: t_k is k/rate, so another rate is another k.
  if (plan_.rate != settings.rate) state_.tick = std::llround(time_of(state_.tick, plan_.rate) * settings.rate);
  plan_ = plan_of(settings);
  report_.settings_generation = generation;
  report_.diverged = false;
}

bool Servo::takes_tick(bool tick_is_due) noexcept {
  if (!paused_) return tick_is_due;
  if (steps_taken_ == steps_wanted_) return false;
  ++steps_taken_;
  return true;
}

bool Servo::advance() noexcept {
  if (report_.diverged) return false;
  TickState<2> next = state_;
  tick(plan_, input_->goal(state_.tick + 1, plan_.rate), next);
  report_.diverged = !is_sound(next);
  if (!report_.diverged) state_ = next;
  return !report_.diverged;
}

double Servo::period_s() const noexcept {
  return std::max(1.0 / (plan_.rate * speed_), shortest_period_s);
}

}  // namespace ghostforce
