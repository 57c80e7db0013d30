#include "device/haply/haply.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "device/motors/driver_report.h"

namespace ghostforce {
namespace {

// The second answer in a row that is the address alone cannot be a reply that was cut short.
constexpr int short_replies_to_believe = 2;
// An encoder that has gone so far is connected and counting.
constexpr double moved_rad = 3.0 * radians_per_degree;
// In a row without an answer. The published firmwares allocate at each and free nothing.
constexpr int most_set_ups = 2;
// In a row, answered by more than a reply.
constexpr int most_unclear_probes = 2;
// No answer was ever seen to come later [s].
constexpr double quiet_s = 0.2;
// Replies so late, so many in a row, make a wall that shakes the hand.
constexpr double slow_s = 0.004;
constexpr int most_slow_replies = 10;
// Below a thousandth of a step of any board's duty: what rounding leaves of a motor that is not used [N·m].
constexpr double no_torque = 1e-7;

bool are_near(const std::array<double, 2>& a, const std::array<double, 2>& b, double reach) noexcept {
  return std::abs(a[0] - b[0]) <= reach && std::abs(a[1] - b[1]) <= reach;
}

}  // namespace

Haply::Haply(std::unique_ptr<SerialPort> port, HaplyOptions options)
    : port_(*port),
      keeper_(std::move(port), keeper_options(options)),
      options_(std::move(options)),
      calibration_(options_.usual) {
  report_.is_virtual = options_.is_virtual;
  report_.variant = calibration_.variant;
  keeper_.tell(report_);  // what is owed since an earlier driver
}

Haply::~Haply() {
  keeper_.end(*this);
}

void Haply::enter(Phase phase) noexcept {
  phase_ = phase;
  phase_began_ns_ = port_.now_ns();
}

void Haply::update() noexcept {
  advance();
  keeper_.tell(report_);
}

void Haply::advance() noexcept {
  switch (keeper_.update()) {
    case MotorKeeper::Event::away:
      return;
    case MotorKeeper::Event::absent:
      return report_absent(report_);
    case MotorKeeper::Event::opened:
      return opened();
    case MotorKeeper::Event::failed:
      return end(fault_of_link<HaplyFault>(port_.fault()));
    case MotorKeeper::Event::overtaken:
      return end(HaplyFault::stop_owed);
    case MotorKeeper::Event::open:
      break;
  }
  switch (phase_) {
    case Phase::closed:
      return;
    case Phase::settling:
      if (since(phase_began_ns_) >= settle_s) ask();
      return;
    case Phase::probing:
      return probe();
    case Phase::setting_up:
      if (since(phase_began_ns_) >= set_up_s) begin_exchanging();
      return;
    case Phase::exchanging:
      return exchange();
  }
}

void Haply::wait_until(std::int64_t deadline_ns) noexcept {
  keeper_.wait_until(std::min(deadline_ns, stop_ns()));
}

void Haply::opened() noexcept {
  if (keeper_.is_another()) has_answered_ = false;
  report_.is_guarded = port_.is_guarded();
  calibration_ = calibration_of(keeper_.serial(), options_.calibrations, options_.usual);
  report_.variant = calibration_.variant;
  report_.exchanges = report_.lost_exchanges = 0;
  report_.state = HaplyState::opening;
  forget_home();
  set_ups_ = unclear_probes_ = 0;
  // Somebody else's torque may stand: zeros do no harm before the board is known.
  if (keeper_.may_push()) port_.write(hapi::zero_exchange());
  enter(Phase::settling);
}

// Every exchange sets torques, so that the question is one with zeros. A board that is set up for this address answers
// with its angles; one that is not answers with the address alone, and takes the zeros for resets.
void Haply::ask() noexcept {
  port_.discard_input();
  reader_.reset();
  replies_.reset();
  short_replies_ = 0;
  if (!port_.write(hapi::zero_exchange())) {
    if (since(phase_began_ns_) >= give_up_s) end(HaplyFault::broken);
    return;
  }
  sent_ns_ = port_.now_ns();
  enter(Phase::probing);
}

// What sends back what it is sent holds a reply, too, but after the command's first byte. A board may do so once, with
// what it was asked before.
void Haply::probe() noexcept {
  std::array<std::uint8_t, 64> bytes;
  const std::uint64_t discarded_before = reader_.discarded_bytes();
  while (const std::size_t count = port_.read(bytes)) {
    const bool is_reply = reader_.take(std::span(bytes).first(count)).has_value();
    if (reader_.discarded_bytes() != discarded_before) {
      return ++unclear_probes_ < most_unclear_probes ? ask() : end(HaplyFault::no_board);
    }
    if (!is_reply) continue;
    report_.was_set_up = true;
    note_zero_answered();
    return keeper_.has_paid() ? close(0.0) : begin_exchanging();
  }
  // The rest of a reply comes in the same packet or in the next.
  if (reader_.holds_address_alone() && since(phase_began_ns_) >= set_up_s) {
    report_.was_set_up = false;
    return send_set_up();
  }
  if (since(phase_began_ns_) >= probe_s) end(has_answered_ ? HaplyFault::no_replies : HaplyFault::no_board);
}

// Stops the motors too, whoever has them pushing under whatever address.
void Haply::send_set_up() noexcept {
  report_.torques = command_ = {};
  is_command_new_ = false;
  port_.discard_input();
  reader_.reset();
  position_times_.reset();
  if (++set_ups_ > most_set_ups) return end(HaplyFault::restarted);
  if (!port_.write(hapi::encode(set_up_of(calibration_)))) return end(HaplyFault::broken);
  keeper_.sent(false, port_.now_ns());
  enter(Phase::setting_up);
}

void Haply::begin_exchanging() noexcept {
  port_.discard_input();
  reader_.reset();
  replies_.reset();
  short_replies_ = 0;
  command_ = {};
  is_command_new_ = false;
  in_flight_ = in_flight_before_zero_ = 0;
  leap_filter_.reset();
  position_times_.reset();
  still_ns_ = 0;
  sent_ns_ = heard_ns_ = awaited_ns_ = port_.now_ns();
  zeros_ns_ = 0;
  has_answered_ = true;
  if (!keeper_.is_only_owed() && (report_.state == HaplyState::opening || report_.state == HaplyState::fault)) {
    report_.state = HaplyState::zero_pose;
    report_.fault = HaplyFault::none;
  }
  is_unwritten_ = false;
  window_.begin(sent_ns_);
  enter(Phase::exchanging);
}

void Haply::forget_home() noexcept {
  has_leapt_ = false;
  report_.zero_pose = ZeroPose::not_confirmed;
  report_.has_moved = {};
  report_.workspace_share = 1.0;
  wants_zero_pose_ = false;
  pose_.reset();
  position_times_.reset();
}

void Haply::exchange() noexcept {
  take_replies();
  if (phase_ != Phase::exchanging) return;
  if (keeper_.has_paid()) return close(0.0);
  if (since(awaited_ns_) >= give_up_s && replies_.is_waiting()) return end(HaplyFault::no_replies);
  if (is_unwritten_ && since(unwritten_ns_) >= give_up_s) return end(HaplyFault::broken);
  const std::int64_t now_ns = port_.now_ns();
  const bool is_stop_due = now_ns >= stop_ns();
  const bool may_ask_again = replies_.may_ask_again(now_ns);
  // A board that answers with something else than replies does not take zeros for zeros. A set up stops it all the same.
  const bool is_out_of_step = is_stop_due && keeper_.may_push() && reader_.holds_bytes();
  // What there is of a reply belongs to the question that is given up.
  const bool has_forgotten =
      may_ask_again && reader_.holds_address_alone() && ++short_replies_ >= short_replies_to_believe;
  if (is_out_of_step || has_forgotten) {
    ++report_.faults;
    report_.fault = HaplyFault::restarted;
    report_.state = HaplyState::zero_pose;
    forget_home();
    note_stop();
    return send_set_up();
  }
  if (is_stop_due) return send_zeros();
  // What was heard last says where the arms are now.
  if (wants_zero_pose_ && !keeper_.may_push() && since(heard_ns_) <= stop_s) {
    wants_zero_pose_ = false;
    if (still_ns_ == 0 || since(still_ns_) < still_s) {
      report_.zero_pose = ZeroPose::moving;
    } else {
      report_.zero_pose = ZeroPose::setting;
      return send_set_up();
    }
  }
  if (may_ask_again) {
    if (short_replies_ > 0) command_ = {};
    reader_.reset();
    if (send_command()) ++report_.lost_exchanges;
  } else if ((is_command_new_ || since(heard_ns_) >= keep_alive_s) && replies_.may_send(now_ns)) {
    send_command();
  }
}

bool Haply::take_replies() noexcept {
  std::array<std::uint8_t, 64> bytes;
  bool has_come = false;
  while (const std::size_t count = port_.read(bytes)) {
    auto angles = reader_.take(std::span(bytes).first(count));
    for (; angles; angles = reader_.take({})) {
      has_come = true;
      take(*angles);
    }
  }
  report_.discarded_bytes = reader_.discarded_bytes();
  return has_come;
}

void Haply::take(const hapi::PerPort<double>& degrees) noexcept {
  const auto asked_ns = replies_.replied(port_.now_ns());
  if (!asked_ns) return;  // a reply that came twice is no news
  heard_ns_ = awaited_ns_ = port_.now_ns();
  short_replies_ = 0;
  if (in_flight_ > 0) --in_flight_;
  // Replies may be late, and be taken for those to newer commands.
  if (keeper_.zero_ns() && in_flight_before_zero_ > 0) {
    --in_flight_before_zero_;
  } else if (keeper_.answers_zero(*asked_ns)) {
    note_zero_answered();
  }
  // What is still missing a while after the last silence never comes.
  if (replies_.is_clear() && since(zeros_ns_) > quiet_s) in_flight_ = 0;
  ++report_.exchanges;
  const double exchange_s = since(*asked_ns);
  slow_replies_ = exchange_s > slow_s ? slow_replies_ + 1 : 0;
  report_.is_lagging = slow_replies_ >= most_slow_replies;
  window_.add(exchange_s);
  measure_rate();
  std::array<double, 2> angles{};
  for (std::size_t arm = 0; arm < 2; ++arm) {
    angles[arm] = degrees[calibration_.arms[arm].encoder_port - 1U] * radians_per_degree;
  }
  using Verdict = LeapFilter<std::array<double, 2>>::Verdict;
  // By when they were asked for: late replies come together, and are not of one moment.
  const Verdict verdict = leap_filter_.add(angles, *asked_ns);
  if (verdict == Verdict::odd) return;
  // An encoder that leaps farther than a hand can move an arm has lost its count. While replies are late nobody knows
  // what moment they are of: what leapt then is believed no more once they are in time again.
  has_leapt_ |= verdict == Verdict::leapt;
  if (has_leapt_ && !report_.is_lagging) lose_count();
  report_.angles = angles;
  follow_stillness();
  if (report_.zero_pose == ZeroPose::setting) judge_zero_pose();
  if (report_.zero_pose == ZeroPose::confirmed) locate(*asked_ns);
}

void Haply::follow_stillness() noexcept {
  const std::array<double, 2>& angles = report_.angles;
  bool is_still = still_ns_ != 0;
  for (std::size_t arm = 0; arm < 2 && is_still; ++arm) {
    still_least_[arm] = std::min(still_least_[arm], angles[arm]);
    still_greatest_[arm] = std::max(still_greatest_[arm], angles[arm]);
    is_still = still_greatest_[arm] - still_least_[arm] <= still_deg * radians_per_degree;
  }
  if (is_still) return;
  still_least_ = still_greatest_ = angles;
  still_ns_ = heard_ns_;
}

// Right after a set up the counters tell the angles that it has given them. An answer that comes late is older.
void Haply::judge_zero_pose() noexcept {
  if (!are_near(report_.angles, zero_pose_of(calibration_), zero_pose_deg * radians_per_degree)) {
    if (since(phase_began_ns_) < quiet_s) return;
    report_.zero_pose = ZeroPose::refused;
    report_.state = HaplyState::zero_pose;
    return;
  }
  report_.zero_pose = ZeroPose::confirmed;
  report_idle(report_);
  report_.has_moved = {};
  least_ = greatest_ = report_.angles;
}

// `asked_ns`: when the board was asked, for it has not looked at its encoders before.
void Haply::locate(std::int64_t asked_ns) noexcept {
  for (std::size_t arm = 0; arm < 2; ++arm) {
    least_[arm] = std::min(least_[arm], report_.angles[arm]);
    greatest_[arm] = std::max(greatest_[arm], report_.angles[arm]);
    if (greatest_[arm] - least_[arm] >= moved_rad) report_.has_moved[arm] = true;
  }
  pose_ = pose_at(calibration_.geometry, report_.angles);
  if (pose_) {
    const double share = (margin_of(*pose_, report_.angles) - least_margin) / (full_margin - least_margin);
    report_.workspace_share = std::clamp(share, 0.0, 1.0);
    report_.position = pose_->handle;
    position_times_.found(asked_ns, heard_ns_);
    if (report_.is_readable()) return;
    report_idle(report_);
    set_force(Vector<2>(0.0), false);
  } else if (position_times_.not_found(port_.now_ns()) && report_.is_readable()) {
    // The board itself is well: it is listened to until its angles make sense again.
    report_fault(report_, HaplyFault::kinematics);
    command_ = {};
    is_command_new_ = true;
  }
}

void Haply::lose_count() noexcept {
  has_leapt_ = false;
  if (report_.zero_pose != ZeroPose::confirmed) return;
  forget_home();
  report_.state = HaplyState::zero_pose;
  report_.fault = HaplyFault::lost_count;
  ++report_.faults;
  command_ = {};
  is_command_new_ = true;
  // A force for a place where the handle is not: that does not wait for a reply.
  if (phase_ == Phase::exchanging && report_.torques != std::array<double, 2>{}) send_command();
}

void Haply::confirm_zero_pose() noexcept {
  if (phase_ == Phase::exchanging && report_.state != HaplyState::active) wants_zero_pose_ = true;
}

Vector<2> Haply::set_force(const Vector<2>& force, bool is_armed) noexcept {
  if (phase_ != Phase::exchanging) return Vector<2>(0.0);
  if (!report_.is_readable()) {
    is_command_new_ = true;  // the board is asked as often as it would be with a force
    return Vector<2>(0.0);
  }
  report_.state = is_armed ? HaplyState::active : HaplyState::idle;
  command_ = {};
  report_.is_saturated = false;
  Vector<2> asked(0.0);
  if (is_armed && pose_ && std::isfinite(force.x) && std::isfinite(force.y)) {
    asked = report_.workspace_share * force;
    std::array<double, 2> torques = torques_for(*pose_, asked);
    double excess = 1.0;
    for (std::size_t arm = 0; arm < 2; ++arm) {
      const HaplyArm& known = calibration_.arms[arm];
      torques[arm] *= (known.is_motor_reversed ? -1.0 : 1.0) / known.torque_scale;
      if (!(std::abs(torques[arm]) > no_torque)) torques[arm] = 0.0;
      const double of_force = greatest_motor_force * lever_of_motor(*pose_, arm) / known.torque_scale;
      excess = std::max(excess, std::abs(torques[arm]) / std::min(hapi::greatest_torque, of_force));
    }
    // Both by the same share: one alone would turn the force.
    report_.is_saturated = excess > 1.0;
    for (double& torque : torques) torque /= excess;
    asked /= excess;
    command_ = torques;
  }
  is_command_new_ = true;
  const bool ends_force = !is_armed && report_.torques != std::array<double, 2>{};
  if (replies_.may_send(port_.now_ns(), ends_force)) send_command();
  return asked;
}

bool Haply::send_command() noexcept {
  if (keeper_.must_stop(heard_ns_)) command_ = {};
  hapi::PerPort<double> torques{};
  for (std::size_t arm = 0; arm < 2; ++arm) torques[calibration_.arms[arm].motor_port - 1U] = command_[arm];
  if (!send(torques)) return false;
  report_.torques = command_;
  is_command_new_ = false;
  return true;
}

bool Haply::send(const hapi::PerPort<double>& torques) noexcept {
  const bool pushes = torques != hapi::PerPort<double>{};
  if (pushes) keeper_.will_push();
  const bool is_written = port_.write(hapi::exchange(torques));
  if (!is_written && !is_unwritten_) unwritten_ns_ = port_.now_ns();
  is_unwritten_ = !is_written;
  if (!is_written) return false;
  sent_ns_ = port_.now_ns();
  if (!replies_.is_waiting()) awaited_ns_ = std::max(awaited_ns_, sent_ns_);
  if (keeper_.sent(pushes, sent_ns_)) in_flight_before_zero_ = in_flight_;
  ++in_flight_;
  replies_.sent(sent_ns_);
  return true;
}

void Haply::measure_rate() noexcept {
  if (window_.tell(report_, port_.now_ns())) report_.is_guarded = port_.is_guarded();
}

}  // namespace ghostforce
