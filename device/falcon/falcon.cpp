#include "device/falcon/falcon.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "device/falcon/link_setup.h"
#include "device/motors/emergency_stop.h"

namespace ghostforce {
namespace {

// A motor's encoder that has gone so far is connected and counting [counts].
constexpr int moved_counts = 20;
// One odd reply is no loss of the zero, and no proof of it.
constexpr int replies_to_believe = 3;
// The encoders must tell a position again within this time [s]: sooner than an old one ends the force anyway.
constexpr double longest_lost_s = 0.010;
// What no hand does: an arm turns by less. At 1 m/s, where motors go off, it is 63 counts per millisecond where the
// geometry is worst. After a gap more would be possible than can be told from a mistake; then three replies tell.
constexpr double greatest_leap_per_s = 65e3;
constexpr double least_reach = 40.0;      // [counts]
constexpr double greatest_reach = 250.0;  // less than what a wrong digit of the third place makes [counts]

// In the order of LinkFault: a device that is not there is no fault.
constexpr std::array link_faults{FalconFault::none,   FalconFault::none,        FalconFault::not_allowed,
                                 FalconFault::busy,   FalconFault::unsupported, FalconFault::unplugged,
                                 FalconFault::broken, FalconFault::overruled,   FalconFault::unguarded};
static_assert(link_faults.size() == static_cast<std::size_t>(LinkFault::unguarded) + 1);

// In the order of BootFault.
constexpr std::array boot_faults{FalconFault::none, FalconFault::no_handshake, FalconFault::no_baud_answer,
                                 FalconFault::echo_missing, FalconFault::echo_differs};
static_assert(boot_faults.size() == static_cast<std::size_t>(BootFault::echo_differs) + 1);

FalconFault fault_of(LinkFault fault) noexcept {
  return link_faults[static_cast<std::size_t>(fault)];
}

FalconFault fault_of(BootFault fault) noexcept {
  return boot_faults[static_cast<std::size_t>(fault)];
}

FalconOptions with_debts(FalconOptions options) {
  if (!options.debts) options.debts = std::make_shared<StopDebts>();
  return options;
}

bool is_near(const MotorNumbers& a, const MotorNumbers& b, double counts) noexcept {
  return std::ranges::equal(a, b, [counts](int one, int other) { return std::abs(one - other) <= counts; });
}

}  // namespace

Falcon::Falcon(std::unique_ptr<FalconLink> link, FalconOptions options)
    : link_(*link),
      opener_(std::move(link)),
      options_(with_debts(std::move(options))),
      debts_(*options_.debts),
      kinematics_(calibration_.geometry),
      // What is looked for is looked for at once.
      phase_began_ns_(opener_.link().now_ns()) {
  report_.is_virtual = options_.is_virtual;
  report_.has_firmware_file = !options_.firmware.empty();
  report_.firmware_size = static_cast<std::uint32_t>(options_.firmware.size());
  report_.attempts = attempts;
  note_debts();  // those of an earlier driver
}

Falcon::~Falcon() {
  shut_down();
  pay_debts();
  opener_.end();  // until then an emergency still finds the link
  emergency_stop::watch(nullptr);
}

double Falcon::since(std::int64_t then_ns) const noexcept {
  return static_cast<double>(link().now_ns() - then_ns) * 1e-9;
}

void Falcon::update() noexcept {
  if (opener_.is_busy()) return;
  if (phase_ == Phase::pausing) {
    if (since(phase_began_ns_) < pause_s_) return;
    poll();
    if (opener_.is_busy()) return;
  }
  if (phase_ == Phase::opening) return opened(link().fault());
  link().wait_until(link().now_ns());  // lets transfers make progress
  if (link().fault() != LinkFault::none) return end(fault_of(link().fault()));
  if (has_owed_returned()) return end(FalconFault::stop_owed);
  switch (phase_) {
    case Phase::pausing:
    case Phase::opening:
      return;
    case Phase::configuring:
      return configure();
    case Phase::asking:
      return ask();
    case Phase::loading:
      return load();
    case Phase::exchanging:
      return exchange();
  }
}

void Falcon::wait_until(std::int64_t deadline_ns) noexcept {
  opener_.wait_until(std::min(deadline_ns, stop_ns()));
}

void Falcon::poll() noexcept {
  opener_.open(debts_);
  phase_ = Phase::opening;
}

void Falcon::opened(LinkFault fault) noexcept {
  opener_.has_found_one();  // whatever it was, it has been looked for again
  report_.has_looked = true;
  note_debts();  // an earlier driver has ended meanwhile
  phase_began_ns_ = link().now_ns();
  if (fault == LinkFault::absent) {
    phase_ = Phase::pausing;
    pause_s_ = debts_.empty() ? look_again_s : soon_s;
    has_answered_ = false;
    // That it was there and has gone stays on screen until it is back.
    if (report_.fault != FalconFault::none) report_.fault = FalconFault::unplugged;
    report_.state = report_.fault == FalconFault::none ? FalconState::absent : FalconState::fault;
    attempt_ = 0;
    return;
  }
  if (fault != LinkFault::none) return end(fault_of(fault));
  emergency_stop::watch(&link());
  report_.is_guarded = link().is_guarded();
  const DeviceSerial before = std::exchange(report_.serial, device_serial_of(link().serial()));
  if (before != report_.serial) {
    attempt_ = 0;
    has_answered_ = false;
  }
  may_push_ = debts_.has(report_.serial);
  link().set_may_push(may_push_);
  is_only_owed_ = may_push_ && report_.serial != in_use_;
  if (!is_only_owed_) in_use_ = report_.serial;
  calibration_ = calibration_of(report_.serial, options_.calibrations);
  kinematics_ = FalconKinematics(calibration_.geometry);
  report_.exchanges = 0;
  report_.lost_exchanges = 0;
  report_.state = attempt_ == 0 ? FalconState::opening : FalconState::loading_firmware;
  may_have_firmware_ = attempt_ == 0;
  begin_asking();
  if (!may_have_firmware_) {
    boot_loader_ = BootLoader(options_.firmware);
    phase_ = Phase::loading;
  }
}

void Falcon::begin_asking() noexcept {
  questions_left_ = has_answered_ || may_push_ ? patient_questions : first_questions;
  set_up_chip();
}

void Falcon::set_up_chip() noexcept {
  link_script_ = LinkScript(set_up_link);
  phase_ = Phase::configuring;
}

void Falcon::configure() noexcept {
  const LinkProgress progress = link_script_.update(link());
  if (progress == LinkProgress::running) return;
  if (progress == LinkProgress::failed) return end(FalconFault::broken);
  packets_before_ = link().counters().packets_in;
  begin_exchanging();
  phase_ = Phase::asking;
}

// A device that has firmware answers; one that has none is silent, and its chip alone speaks. What cannot be told is
// never taken for silence: loading firmware makes a device forget its home.
void Falcon::ask() noexcept {
  if (take_replies()) {
    if (is_only_owed_) {
      if (may_push_) return;
      // The one that is to be used is next.
      opener_.close();
      phase_ = Phase::pausing;
      pause_s_ = 0.0;
      return;
    }
    report_.has_firmware = has_answered_ = true;
    attempt_ = 0;
    phase_ = Phase::exchanging;
    report_.state = FalconState::homing;
    return;
  }
  if (replies_.is_waiting() && since(sent_ns_) < first_reply_s) return;
  if (link().is_sending()) {
    // A question that nobody takes is none.
    if (since(sent_ns_) >= give_up_s) end(FalconFault::no_replies);
    return;
  }
  if (questions_left_ > 0) {
    // The chip of one that may push can have been reset again, and have lost its rate.
    if (may_push_ && replies_.is_waiting()) return set_up_chip();
    if (send_command()) --questions_left_;
    return;
  }
  if (!may_have_firmware_) return try_loading_again(FalconFault::firmware_silent);
  if (link_script_.was_refused()) return end(FalconFault::broken);
  if (link().counters().packets_in == packets_before_) return end(FalconFault::no_replies);
  has_answered_ = false;
  report_.has_firmware = false;
  if (options_.firmware.empty()) return end(FalconFault::no_firmware);
  attempt_ = 1;
  may_have_firmware_ = false;
  report_.attempt = attempt_;
  report_.bytes_echoed = 0;
  report_.state = FalconState::loading_firmware;
  boot_loader_ = BootLoader(options_.firmware);
  phase_ = Phase::loading;
}

void Falcon::load() noexcept {
  const LinkProgress progress = boot_loader_.update(link());
  report_.bytes_echoed = static_cast<std::uint32_t>(boot_loader_.bytes_echoed());
  if (progress == LinkProgress::failed) return try_loading_again(fault_of(boot_loader_.fault()));
  if (progress == LinkProgress::running) return;
  begin_asking();
}

// What helps most often is to begin anew with the device closed and opened.
void Falcon::try_loading_again(FalconFault fault) noexcept {
  const int next = attempt_ + 1;
  end(fault);
  if (next > attempts) return;  // and after the pause from the beginning
  attempt_ = next;
  report_.attempt = next;
  report_.state = FalconState::loading_firmware;
  pause_s_ = 0.1;
}

void Falcon::begin_exchanging() noexcept {
  reader_.reset();
  replies_.reset();
  command_ = {.motors = {}, .info = CommandFrame::homing | CommandFrame::red};
  is_command_new_ = false;
  is_purging_ = false;
  has_home_ = false;
  lost_position_ns_ = 0;
  sent_ns_ = heard_ns_ = awaited_ns_ = link().now_ns();
  unanswered_ns_.reset();
  window_.begin(sent_ns_);
  report_.exchange_hz = 0.0;
  report_.has_homed = {};
  report_.has_moved = {};
  unhomed_replies_ = homed_replies_ = 0;
}

void Falcon::end(FalconFault fault) noexcept {
  // Also through a link that hears no more: it may still be heard, and closing it insists.
  if (phase_ == Phase::exchanging || (phase_ == Phase::asking && may_push_)) stop_motors();
  opener_.close();
  if (fault == FalconFault::unplugged) has_answered_ = false;
  report_.state = FalconState::fault;
  report_.fault = fault;
  ++report_.faults;
  report_.has_firmware = false;
  report_.has_homed = {};
  report_.has_moved = {};
  report_.exchange_hz = 0.0;
  report_.motors = {};
  report_.buttons = 0;
  position_time_ns_ = 0;
  attempt_ = 0;
  phase_ = Phase::pausing;
  phase_began_ns_ = link().now_ns();
  // Somebody who plugs a device in again is not made to wait.
  pause_s_ = fault == FalconFault::unplugged || !debts_.empty() ? soon_s : try_again_s;
}

void Falcon::exchange() noexcept {
  if (!is_purging_) take_replies();
  // A program that did not run for a while has asked nothing meanwhile.
  if (unanswered_ns_ && since(*unanswered_ns_) >= give_up_s) return end(FalconFault::no_replies);
  if (recover()) return;
  const std::int64_t now_ns = link().now_ns();
  if (wants_latency_ && !replies_.is_waiting() && report_.motors == MotorNumbers{}) {
    wants_latency_ = !link().request(ftdi::latency(1));
  } else if (replies_.may_ask_again(now_ns)) {
    if (send_command()) ++report_.lost_exchanges;
  } else if ((is_command_new_ || since(heard_ns_) >= keep_alive_s) && replies_.may_send(now_ns)) {
    send_command();
  }
}

bool Falcon::take_replies() noexcept {
  std::array<std::uint8_t, 64> bytes;
  bool has_come = false;
  while (const std::size_t count = link().read(bytes)) {
    const auto frame = reader_.take(std::span(bytes).first(count));
    if (!frame) continue;
    has_come = true;
    take(*frame);
  }
  report_.discarded_bytes = reader_.discarded_bytes();
  return has_come;
}

void Falcon::take(const ReplyFrame& frame) noexcept {
  const auto asked_ns = replies_.replied(link().now_ns());
  if (!asked_ns) return;  // a reply that came twice is no news
  heard_ns_ = awaited_ns_ = link().now_ns();
  // It may have been the answer to an older command.
  unanswered_ns_ = replies_.is_waiting() ? std::optional(heard_ns_) : std::nullopt;
  // A reply to an older command, one with force, says nothing about a zero that was sent beside it.
  const bool has_heard_zero = zero_ns_ && *asked_ns >= *zero_ns_;
  if (!replies_.is_waiting() && has_heard_zero) {
    if (may_push_) link().set_may_push(false);
    may_push_ = false;
    debts_.remove(report_.serial);
    note_debts();
  }
  ++report_.exchanges;
  const double exchange_s = since(*asked_ns);
  window_.add(exchange_s);
  measure_rate();
  report_.encoders = frame.encoders;
  report_.buttons = frame.status & 0x0F;
  follow_homing(frame.status);
  if (has_home_ && believes(frame.encoders)) {
    follow_encoders(frame.encoders);
    locate(frame.encoders, *asked_ns);
  }
}

void Falcon::follow_homing(std::uint8_t status) noexcept {
  for (std::size_t i = 0; i < 3; ++i) report_.has_homed[i] = (status & (0x10U << i)) != 0;
  const bool is_homed = report_.is_homed();
  unhomed_replies_ = is_homed ? 0 : unhomed_replies_ + 1;
  homed_replies_ = is_homed ? homed_replies_ + 1 : 0;
  if (!has_home_ && homed_replies_ >= replies_to_believe) {
    has_home_ = true;
    report_.state = FalconState::idle;
    report_.fault = FalconFault::none;
    report_.has_moved = {};
    least_ = greatest_ = report_.encoders;
    report_.position = cold_start;
    position_time_ns_ = 0;
    lost_position_ns_ = 0;
    believed_ns_ = 0;
    set_force(Vector<3>(0.0), false);
  } else if (has_home_ && unhomed_replies_ >= replies_to_believe) {
    has_home_ = false;
    report_.state = FalconState::homing;
    report_.has_moved = {};
    command_ = {.motors = {}, .info = CommandFrame::homing | CommandFrame::red};
    is_command_new_ = true;
  }
}

bool Falcon::believes(const MotorNumbers& encoders) noexcept {
  const double reach = std::min(least_reach + greatest_leap_per_s * since(believed_ns_), greatest_reach);
  if (believed_ns_ != 0 && !is_near(encoders, believed_, reach)) {
    odd_replies_ = odd_replies_ > 0 && is_near(encoders, odd_, greatest_reach) ? odd_replies_ + 1 : 1;
    odd_ = encoders;
    if (odd_replies_ < replies_to_believe) return false;
  }
  odd_replies_ = 0;
  believed_ = encoders;
  believed_ns_ = heard_ns_;
  return true;
}

void Falcon::follow_encoders(const MotorNumbers& encoders) noexcept {
  for (std::size_t i = 0; i < 3; ++i) {
    least_[i] = std::min(least_[i], encoders[i]);
    greatest_[i] = std::max(greatest_[i], encoders[i]);
    if (greatest_[i] - least_[i] >= moved_counts) report_.has_moved[i] = true;
  }
}

// `asked_ns`: when the device was asked, for it has not looked at its encoders before.
void Falcon::locate(const MotorNumbers& encoders, std::int64_t asked_ns) noexcept {
  const ForwardKinematics found = kinematics_.position(joint_angles(encoders, calibration_), report_.position);
  if (found.has_converged) {
    report_.position = found.position;
    position_time_ns_ = asked_ns;
    position_heard_ns_ = heard_ns_;
    lost_position_ns_ = 0;
    if (report_.is_readable()) return;
    report_.state = FalconState::idle;
    report_.fault = FalconFault::none;
    set_force(Vector<3>(0.0), false);
  } else if (lost_position_ns_ == 0) {
    lost_position_ns_ = link().now_ns();
  } else if (report_.is_readable() && since(lost_position_ns_) >= longest_lost_s) {
    // The device itself is well: it is listened to until its encoders make sense again.
    report_.state = FalconState::fault;
    report_.fault = FalconFault::kinematics;
    ++report_.faults;
    command_ = {.motors = {}, .info = CommandFrame::red};
    is_command_new_ = true;
  }
}

void Falcon::set_force(const Vector<3>& force, bool is_armed) noexcept {
  if (!report_.is_readable()) return;
  report_.state = is_armed ? FalconState::active : FalconState::idle;
  command_ = {.motors = {}, .info = is_armed ? CommandFrame::blue : CommandFrame::green};
  if (is_armed) {
    const auto jacobian = kinematics_.jacobian(report_.position);
    if (jacobian) command_.motors = motor_numbers(force, *jacobian, calibration_);
  }
  is_command_new_ = true;
  if (is_purging_) return;
  // Off does not wait for a reply.
  const bool is_off_now = !is_armed && report_.motors != MotorNumbers{};
  if (replies_.may_send(link().now_ns()) || is_off_now) send_command();
}

bool Falcon::send_command() noexcept {
  if (is_leaving_) command_ = {};
  // Whoever waits too long for a reply does not go on pushing.
  if (since(heard_ns_) > stop_s || emergency_stop::is_ordered()) command_.motors = {};
  const bool begins_to_push = command_.motors != MotorNumbers{} && !may_push_;
  if (begins_to_push) {
    may_push_ = true;
    link().set_may_push(true);
  }
  if (!link().write(encode(command_))) return false;
  report_.motors = command_.motors;
  is_command_new_ = false;
  sent_ns_ = link().now_ns();
  if (command_.motors != MotorNumbers{}) {
    zero_ns_.reset();
  } else if (!zero_ns_) {
    zero_ns_ = sent_ns_;
  }
  if (!replies_.is_waiting()) asked_ns_ = sent_ns_;
  if (!unanswered_ns_) unanswered_ns_ = sent_ns_;
  replies_.sent(sent_ns_);
  return true;
}

void Falcon::measure_rate() noexcept {
  const auto measured = window_.next(link().now_ns());
  if (!measured) return;
  report_.exchange_hz = measured->exchange_hz;
  report_.exchange_s = measured->exchange_s;
  report_.worst_exchange_s = measured->worst_exchange_s;
  report_.line_errors = link().counters().line_errors;
  report_.is_guarded = link().is_guarded();
  // By the time of one answer: a device that is not homed yet is asked less often than it could be.
  wants_latency_ = report_.exchange_s * FalconReport::fast_enough_hz > 1.0;
}

}  // namespace ghostforce
