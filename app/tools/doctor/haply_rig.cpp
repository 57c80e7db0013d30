#include "app/tools/doctor/haply_rig.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/tools/doctor/readiness.h"
#include "device/motors/emergency_stop.h"

namespace ghostforce {
namespace {

// Arms that somebody holds still stay within this, for so long, the last part of which is what is read; and so long it is
// waited for.
constexpr double haply_still_deg = 0.4;
constexpr double haply_still_s = 0.7;
constexpr double haply_reading_s = 0.3;
constexpr double haply_patience_s = 15.0;

// What "in the middle" and "still" mean before motors go on [m], [m], [s].
constexpr double haply_near = 0.025;
constexpr double haply_steady = 0.002;
constexpr double haply_ready_s = 0.4;

constexpr double haply_quiet_s = 0.03;   // no answer was ever seen to come later
constexpr double haply_give_up_s = 1.2;  // longer than a board waits for the rest of a packet
constexpr std::string_view haply_may_push =
    "Its motors may still push, and the program cannot stop them: unplug its power supply now. ";

// In the order of HaplyStop.
constexpr std::array<std::string_view, 4> haply_stop_words{
    "The handle moved faster than 0.5 m/s, so the motors are off.",
    "The handle went more than 40 mm, so the motors are off.",
    "The encoders told angles that the arms cannot have, so the motors are off.",
    "The board did not answer for 20 ms, so the motors are off.",
};

constexpr std::int64_t haply_ns(double seconds) noexcept {
  return static_cast<std::int64_t>(seconds * 1e9);
}

}  // namespace

HaplyRig::HaplyRig(HaplyOperator& person, Haply& haply, const HaplyCalibration& calibration, StopDebts* debts)
    : person_(person), port_(haply.port()), calibration_(calibration), found_(haply.report()), debts_(debts) {
  forget_replies();
  next_ns_ = watched_ns_ = port_.now_ns();
}

HaplyRig::~HaplyRig() {
  stop();
  if (may_push_ && debts_ != nullptr) debts_->add(found_.serial);
}

// --- The board ---

void HaplyRig::wait_until(std::int64_t deadline_ns) {
  while (port_.now_ns() < deadline_ns && port_.fault() == LinkFault::none) port_.wait_until(deadline_ns);
}

void HaplyRig::forget_replies() {
  wait_until(port_.now_ns() + haply_ns(haply_quiet_s));
  port_.discard_input();
  reader_.reset();
}

// Torques by port, as they are sent. Empty: no reply in time, or the port is gone.
std::optional<hapi::PerPort<double>> HaplyRig::ask_board(const hapi::PerPort<double>& torques) {
  const bool is_zero = emergency_stop::is_ordered() || torques == hapi::PerPort<double>{};
  const std::int64_t began_ns = port_.now_ns();
  const std::int64_t deadline_ns = began_ns + haply_ns(longest_exchange_s);
  if (!is_zero) port_.set_may_push(true);
  bool has_sent = false;
  std::optional<hapi::PerPort<double>> reply;
  std::array<std::uint8_t, 64> heard;
  while (!reply && port_.fault() == LinkFault::none) {
    if (!has_sent) {
      has_sent = port_.write(is_zero ? hapi::zero_exchange() : hapi::exchange(torques));
      may_push_ |= has_sent && !is_zero;
    }
    while (const std::size_t count = port_.read(heard)) {
      if (const auto angles = reader_.take(std::span(heard).first(count)); angles && has_sent) reply = angles;
    }
    if (reply || port_.now_ns() >= deadline_ns) break;
    port_.wait_until(deadline_ns);
  }
  // By the clock as it is now: where this process did not run for a while, a reply has waited and is old.
  const std::int64_t now_ns = port_.now_ns();
  last_exchange_s_ = static_cast<double>(now_ns - began_ns) * 1e-9;
  if (!reply || now_ns > deadline_ns) return std::nullopt;
  if (is_zero) port_.set_may_push(may_push_ = false);
  watched_ns_ = now_ns;
  return reply;
}

// The board may be waiting for the rest of a packet: then zeros are it. Afterwards none of its answers is left over.
void HaplyRig::recover() {
  const bool has_forgotten = reader_.holds_address_alone();
  port_.write(hapi::zero_exchange());
  // That stops motors where zeros no longer reach them, if the board takes it.
  const bool is_set_up = has_forgotten && set_up() && ask_board({}).has_value();
  forget_replies();
  next_ns_ = watched_ns_ = port_.now_ns();
  if (has_forgotten) {
    throw Failure(ExitCode::device_failed,
                  fmt::format("The board has forgotten how it was set up, for example after a power loss. {} Check its "
                              "power supply and cable, and start again.",
                              is_set_up ? "Its motors were stopped."
                                        : "Its motors may still push: pull the plug of their power supply."));
  }
}

bool HaplyRig::stop() {
  constexpr int most = 6;
  constexpr int enough = 3;
  int heard = 0;
  for (int i = 0; i < most && heard < enough; ++i) {
    if (ask_board({})) {
      ++heard;
    } else {
      port_.write(hapi::zero_exchange());
      forget_replies();
    }
  }
  next_ns_ = port_.now_ns();
  return heard == enough;
}

void HaplyRig::fail(LinkFault fault) {
  const std::string_view danger = may_push_ ? haply_may_push : "";
  if (fault == LinkFault::unplugged || fault == LinkFault::absent) {
    throw Failure(ExitCode::device_absent,
                  fmt::format("The board is gone: its USB cable was unplugged. {}Plug it in and start again.", danger));
  }
  if (fault == LinkFault::overruled || fault == LinkFault::unguarded) {
    const HaplyFault why = fault == LinkFault::overruled ? HaplyFault::overruled : HaplyFault::unguarded;
    throw Failure(ExitCode::device_failed, fmt::format("{} Start again.", sentence_of(why)));
  }
  throw Failure(ExitCode::device_failed,
                fmt::format("The board stopped answering. {}Unplug its power supply first, then its USB cable, plug "
                            "both in again, and start again.",
                            danger));
}

// Torques by arm, positive to increase the angle.
hapi::PerPort<double> HaplyRig::exchange(const Vector<2>& torques, bool is_paced) {
  hapi::PerPort<double> by_port{};
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const HaplyArm& known = calibration_.arms[arm];
    by_port[known.motor_port - 1U] = torques[static_cast<glm::length_t>(arm)] * (known.is_motor_reversed ? -1.0 : 1.0);
  }
  const std::int64_t began_ns = port_.now_ns();
  for (;; by_port = {}) {
    stop_if_interrupted();
    const bool were_left_alone = may_push_ && port_.now_ns() - watched_ns_ > haply_ns(longest_exchange_s);
    const auto reply = were_left_alone ? std::nullopt : ask_board(by_port);
    if (reply) {
      next_ns_ = is_paced ? std::max(next_ns_ + haply_ns(period_s), port_.now_ns()) : port_.now_ns();
      wait_until(next_ns_);
      return *reply;
    }
    sent_ = Vector<2>(0.0);
    was_lost_ = true;
    recover();
    if (port_.fault() != LinkFault::none || port_.now_ns() - began_ns > haply_ns(haply_give_up_s)) fail(port_.fault());
  }
}

hapi::PerPort<double> HaplyRig::poll(bool is_paced) {
  sent_ = Vector<2>(0.0);
  return exchange(sent_, is_paced);
}

void HaplyRig::rest(double seconds) {
  for (const double end_s = now_s() + seconds; now_s() < end_s;) poll();
}

bool HaplyRig::set_up() {
  const bool is_written = port_.write(hapi::encode(set_up_of(calibration_)));
  forget_replies();
  return is_written;
}

// --- The person ---

hapi::PerPort<double> HaplyRig::read_still_at(const HaplyAction& action, std::string_view words) {
  for (;;) {
    ask(action, words);
    hapi::PerPort<double> least{};
    hapi::PerPort<double> greatest{};
    hapi::PerPort<double> sum{};
    int count = 0;
    double since_s = -1.0;
    for (const double deadline_s = now_s() + haply_patience_s; now_s() < deadline_s;) {
      const hapi::PerPort<double> now = poll();
      bool is_still = since_s >= 0.0;
      for (std::size_t port = 0; port < 2; ++port) {
        least[port] = std::min(least[port], now[port]);
        greatest[port] = std::max(greatest[port], now[port]);
        is_still = is_still && greatest[port] - least[port] <= haply_still_deg;
      }
      if (!is_still) {
        least = greatest = now;
        sum = {};
        count = 0;
        since_s = now_s();
      }
      const double held_s = now_s() - since_s;
      if (held_s < haply_still_s - haply_reading_s) continue;
      for (std::size_t port = 0; port < 2; ++port) sum[port] += now[port];
      ++count;
      if (held_s >= haply_still_s) return {sum[0] / count, sum[1] / count};
    }
    person_.tell("The arms did not stay still. Rest your hands on the table and hold them there.");
  }
}

std::string HaplyRig::with_motors(const HaplyAction& action, std::string_view words,
                                  const std::function<void()>& what) {
  std::string why;
  for (int i = 0; i < tries; ++i) {
    ask(action, words);
    if (await_ready()) {
      try {
        start_.reset();
        what();
        turn_off();
        return {};
      } catch (const HaplyStop& stop) {
        why = haply_stop_words[static_cast<std::size_t>(stop)];
      }
      turn_off();
    } else {
      why = "For 15 s the handle was not still near the middle of its workspace.";
    }
    person_.tell(why);
  }
  return why;
}

// The handle has been near the middle, and still, for a moment.
bool HaplyRig::await_ready() {
  double since_s = now_s();
  std::optional<Vector<2>> still;
  for (const double end_s = since_s + haply_patience_s; now_s() < end_s;) {
    place_count_ = 0;  // how it came there does not matter
    HaplySample sample;
    const bool is_there = !see(poll(), sample) && glm::distance(sample.pose.handle, middle()) <= haply_near;
    start_.reset();
    if (!is_there || !still || glm::distance(sample.pose.handle, *still) > haply_steady) {
      still = is_there ? std::optional(sample.pose.handle) : std::nullopt;
      since_s = now_s();
    }
    if (still && now_s() - since_s >= haply_ready_s) return true;
  }
  return false;
}

// --- Motors ---

std::optional<HaplyStop> HaplyRig::see(const hapi::PerPort<double>& degrees, HaplySample& sample) {
  std::array<double, 2> angles{};
  for (std::size_t arm = 0; arm < 2; ++arm) {
    angles[arm] = degrees[calibration_.arms[arm].encoder_port - 1U] * radians_per_degree;
  }
  const auto pose = pose_at(calibration_.geometry, angles);
  if (!pose) return HaplyStop::no_place;
  sample.pose = *pose;
  sample.angles = {angles[0], angles[1]};
  sample.torques = sent_;
  Place& oldest = places_[place_count_ % places_.size()];
  if (place_count_ >= places_.size()) {
    sample.velocity = (pose->handle - oldest.place) / std::max(now_s() - oldest.time_s, period_s);
  }
  oldest = {now_s(), pose->handle};
  ++place_count_;
  if (!start_) start_ = pose->handle;
  if (glm::length(sample.velocity) > fastest) return HaplyStop::too_fast;
  return glm::distance(pose->handle, *start_) > farthest ? std::optional(HaplyStop::too_far) : std::nullopt;
}

Vector<2> HaplyRig::torques_of(const Vector<2>& force, const PantographPose& pose) const noexcept {
  const std::array<double, 2> torques = torques_for(pose, force);
  return {torques[0] / calibration_.arms[0].torque_scale, torques[1] / calibration_.arms[1].torque_scale};
}

// Never more than a motor of the firmware's strength, or of the calibration's if that is more, turns into what is allowed.
Vector<2> HaplyRig::within_limits(Vector<2> torques, const PantographPose& pose) const noexcept {
  const auto force = force_of(pose, {torques.x * std::max(1.0, calibration_.arms[0].torque_scale),
                                     torques.y * std::max(1.0, calibration_.arms[1].torque_scale)});
  const double size = force ? glm::length(*force) : 0.0;
  if (!force || !std::isfinite(size)) return Vector<2>(0.0);
  return size > greatest_force ? torques * (greatest_force / size) : torques;
}

void HaplyRig::drive(double seconds, const Law& law, const Watch& watch, double steepest) {
  const double began_s = now_s();
  double before_s = began_s;
  for (;;) {
    was_lost_ = false;
    const hapi::PerPort<double> reply = exchange(sent_);
    HaplySample sample;
    if (const auto stop = was_lost_ ? HaplyStop::no_reply : see(reply, sample)) {
      turn_off();
      throw *stop;
    }
    const double now = now_s();
    sample.time_s = now - began_s;
    if (watch) watch(sample);
    if (sample.time_s >= seconds) return;
    const double most = steepest * std::clamp(now - before_s, period_s, 5.0 * period_s);
    before_s = now;
    const Vector<2> wanted = within_limits(law(sample), sample.pose);
    for (glm::length_t arm = 0; arm < 2; ++arm) sent_[arm] += std::clamp(wanted[arm] - sent_[arm], -most, most);
    sent_ = within_limits(sent_, sample.pose);
  }
}

void HaplyRig::let_go(double seconds) {
  const Vector<2> from = sent_;
  drive(seconds, [&](const HaplySample& sample) { return from * std::max(0.0, 1.0 - sample.time_s / seconds); });
}

void HaplyRig::be_silent(double seconds, const Watch& after) {
  const std::int64_t end_ns = port_.now_ns() + haply_ns(seconds);
  // In small pieces, so that an interruption is heard.
  while (port_.now_ns() < end_ns && port_.fault() == LinkFault::none) {
    wait_until(std::min(end_ns, port_.now_ns() + haply_ns(0.005)));
    stop_if_interrupted();
  }
  const bool is_as_asked = port_.now_ns() - end_ns <= haply_ns(longest_exchange_s);
  watched_ns_ = next_ns_ = port_.now_ns();
  sent_ = Vector<2>(0.0);
  place_count_ = 0;  // a speed across the silence would be none
  if (!is_as_asked) {
    turn_off();
    throw HaplyStop::no_reply;
  }
  drive(0.0, no_torques, after);
}

void HaplyRig::turn_off() {
  sent_ = Vector<2>(0.0);
  place_count_ = 0;
  start_.reset();
  // A single reply may be one that came twice.
  if (!stop()) poll();
}

}  // namespace ghostforce
