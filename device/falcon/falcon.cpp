#include "device/falcon/falcon.h"

#include <algorithm>
#include <utility>

#include "device/falcon/ftdi_requests.h"
#include "device/last_resort.h"

namespace ghostforce {
namespace {

// A motor's encoder that has gone so far is connected and counting [counts].
constexpr int moved_counts = 20;
// One odd reply is no loss of the zero, and no proof of it.
constexpr int replies_to_believe = 3;
// The encoders must tell a position again within this time [s].
constexpr double longest_lost_s = 0.020;
constexpr double rate_window_s = 0.5;

using Step = ConversationStep;

// DTR and RTS are left as they are: a device that runs may take their edge for a reset.
constexpr std::array run_time{
    ask(ftdi::latency(1)),
    ask(ftdi::running_rate),
    ask(ftdi::eight_bits_no_parity_one_stop),
    ask(ftdi::no_flow_control),
    ask(ftdi::forget_received),
    ask(ftdi::forget_unsent),
    Step{.kind = Step::Kind::forget},
};

constexpr std::array purge{
    Step{.kind = Step::Kind::settle, .duration_ms = Falcon::forget_ms},
    ask(ftdi::forget_received),
    ask(ftdi::forget_unsent),
    Step{.kind = Step::Kind::forget},
};

FalconFault fault_of(LinkFault fault) noexcept {
  switch (fault) {
    case LinkFault::none:
    case LinkFault::absent:
      return FalconFault::none;
    case LinkFault::not_allowed:
      return FalconFault::not_allowed;
    case LinkFault::busy:
      return FalconFault::busy;
    case LinkFault::unsupported:
      return FalconFault::unsupported;
    case LinkFault::unplugged:
      return FalconFault::unplugged;
    case LinkFault::broken:
      return FalconFault::broken;
  }
  return FalconFault::broken;
}

FalconFault fault_of(BootFault fault) noexcept {
  switch (fault) {
    case BootFault::none:
      return FalconFault::none;
    case BootFault::no_handshake:
      return FalconFault::no_handshake;
    case BootFault::no_baud_answer:
      return FalconFault::no_baud_answer;
    case BootFault::echo_missing:
      return FalconFault::echo_missing;
    case BootFault::echo_differs:
      return FalconFault::echo_differs;
  }
  return FalconFault::broken;
}

}  // namespace

Falcon::Falcon(std::unique_ptr<FalconLink> link, FalconOptions options)
    : link_(std::move(link)),
      options_(std::move(options)),
      kinematics_(calibration_.geometry),
      // What is looked for is looked for at once.
      phase_began_ns_(link_->now_ns()) {
  report_.is_virtual = options_.is_virtual;
  report_.has_firmware_file = !options_.firmware.empty();
  report_.firmware_size = static_cast<std::uint32_t>(options_.firmware.size());
  report_.attempts = attempts;
}

Falcon::~Falcon() {
  finish();
  last_resort::guard(nullptr);
}

double Falcon::since(std::int64_t then_ns) const noexcept {
  return static_cast<double>(link_->now_ns() - then_ns) * 1e-9;
}

void Falcon::attend() noexcept {
  if (phase_ != Phase::absent && phase_ != Phase::pausing) {
    link_->wait_until(link_->now_ns());  // lets transfers make progress
    if (link_->fault() != LinkFault::none) return end(fault_of(link_->fault()));
  }
  switch (phase_) {
    case Phase::absent:
    case Phase::pausing:
      if (since(phase_began_ns_) >= pause_s_) open();
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

void Falcon::open() noexcept {
  const LinkFault fault = link_->open();
  phase_began_ns_ = link_->now_ns();
  if (fault == LinkFault::absent) {
    phase_ = Phase::absent;
    pause_s_ = look_again_s;
    // That it was there and has gone stays on screen until it is back.
    if (report_.fault != FalconFault::none) report_.fault = FalconFault::unplugged;
    report_.state = report_.fault == FalconFault::none ? FalconState::absent : FalconState::fault;
    attempt_ = 0;
    return;
  }
  if (fault != LinkFault::none) return end(fault_of(fault));
  last_resort::guard(link_.get());
  const std::string_view serial = link_->serial();
  report_.serial = FalconSerial::from(serial).value_or(FalconSerial());
  const auto known = std::ranges::find(options_.calibrations, report_.serial, &FalconCalibration::serial);
  calibration_ = known == options_.calibrations.end() ? FalconCalibration{} : *known;
  kinematics_ = FalconKinematics(calibration_.geometry);
  report_.exchanges = 0;
  report_.lost_exchanges = 0;
  report_.state = attempt_ == 0 ? FalconState::opening : FalconState::loading_firmware;
  may_have_firmware_ = attempt_ == 0;
  conversation_ = Conversation(run_time);
  phase_ = Phase::configuring;
  if (!may_have_firmware_) {
    boot_loader_ = BootLoader(options_.firmware);
    phase_ = Phase::loading;
  }
}

void Falcon::configure() noexcept {
  if (conversation_.attend(*link_) == Progress::running) return;
  questions_left_ = first_questions;
  begin_exchanging();
  phase_ = Phase::asking;
}

// A device that has firmware answers; one that has none is silent.
void Falcon::ask() noexcept {
  if (take_replies()) {
    report_.has_firmware = true;
    attempt_ = 0;
    phase_ = Phase::exchanging;
    report_.state = FalconState::homing;
    return;
  }
  if (is_reply_due_ && since(sent_ns_) < first_reply_s) return;
  if (questions_left_-- > 0) return send_command();
  if (!may_have_firmware_) return try_loading_again(FalconFault::firmware_silent);
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
  const Progress progress = boot_loader_.attend(*link_);
  report_.bytes_echoed = static_cast<std::uint32_t>(boot_loader_.bytes_echoed());
  if (progress == Progress::failed) return try_loading_again(fault_of(boot_loader_.fault()));
  if (progress == Progress::running) return;
  conversation_ = Conversation(run_time);
  phase_ = Phase::configuring;
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
  command_ = {.motors = {}, .info = CommandFrame::homing | CommandFrame::red};
  is_command_new_ = false;
  is_reply_due_ = false;
  is_purging_ = false;
  sent_ns_ = heard_ns_ = window_began_ns_ = link_->now_ns();
  window_exchanges_ = 0;
  window_sum_s_ = window_worst_s_ = 0.0;
  report_.exchange_hz = 0.0;
  report_.has_homed = {};
  report_.has_moved = {};
  unhomed_replies_ = homed_replies_ = 0;
}

void Falcon::end(FalconFault fault) noexcept {
  link_->close();
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
  phase_began_ns_ = link_->now_ns();
  // Somebody who plugs a device in again is not made to wait.
  pause_s_ = fault == FalconFault::unplugged ? 0.1 : try_again_s;
}

void Falcon::exchange() noexcept {
  if (is_purging_) {
    is_purging_ = conversation_.attend(*link_) == Progress::running;
    if (is_purging_) return;
    reader_.reset();
    is_reply_due_ = false;
    send_command();
  }
  take_replies();
  const double silence_s = since(heard_ns_);
  if (silence_s >= give_up_s) return end(FalconFault::no_replies);
  if (lost_position_ns_ != 0 && since(lost_position_ns_) >= give_up_s) return end(FalconFault::kinematics);
  if (is_reply_due_) {
    if (since(sent_ns_) < ask_again_s) return;
    ++report_.lost_exchanges;
    window_worst_s_ = std::max(window_worst_s_, since(asked_ns_));
    // It may hear and only not be heard.
    command_.motors = {};
    send_command();
    conversation_ = Conversation(purge);
    is_purging_ = true;
    return;
  }
  if (is_command_new_ || silence_s >= keep_alive_s) send_command();
}

bool Falcon::take_replies() noexcept {
  std::array<std::uint8_t, 64> bytes;
  bool has_come = false;
  while (const std::size_t count = link_->read(bytes)) {
    const auto frame = reader_.take(std::span(bytes).first(count));
    if (!frame) continue;
    has_come = true;
    take(*frame);
  }
  report_.discarded_bytes = reader_.discarded_bytes();
  return has_come;
}

void Falcon::take(const ReplyFrame& frame) noexcept {
  heard_ns_ = link_->now_ns();
  ++report_.exchanges;
  ++window_exchanges_;
  if (is_reply_due_) {
    const double exchange_s = since(asked_ns_);
    window_sum_s_ += exchange_s;
    window_worst_s_ = std::max(window_worst_s_, exchange_s);
  }
  is_reply_due_ = false;
  measure_rate();
  report_.encoders = frame.encoders;
  report_.buttons = frame.status & 0x0F;
  follow_homing(frame.status);
  if (report_.is_readable()) {
    follow_encoders(frame);
    locate(frame);
  }
}

void Falcon::follow_homing(std::uint8_t status) noexcept {
  for (std::size_t i = 0; i < 3; ++i) report_.has_homed[i] = (status & (0x10U << i)) != 0;
  const bool is_homed = report_.is_homed();
  unhomed_replies_ = is_homed ? 0 : unhomed_replies_ + 1;
  homed_replies_ = is_homed ? homed_replies_ + 1 : 0;
  if (!report_.is_readable() && homed_replies_ >= replies_to_believe) {
    report_.state = FalconState::idle;
    report_.fault = FalconFault::none;
    report_.has_moved = {};
    least_ = greatest_ = report_.encoders;
    report_.position = cold_start;
    position_time_ns_ = 0;
    lost_position_ns_ = 0;
    push(Vector<3>(0.0), false);
  } else if (report_.is_readable() && unhomed_replies_ >= replies_to_believe) {
    report_.state = FalconState::homing;
    report_.has_moved = {};
    command_ = {.motors = {}, .info = CommandFrame::homing | CommandFrame::red};
    is_command_new_ = true;
  }
}

void Falcon::follow_encoders(const ReplyFrame& frame) noexcept {
  for (std::size_t i = 0; i < 3; ++i) {
    least_[i] = std::min(least_[i], frame.encoders[i]);
    greatest_[i] = std::max(greatest_[i], frame.encoders[i]);
    if (greatest_[i] - least_[i] >= moved_counts) report_.has_moved[i] = true;
  }
}

void Falcon::locate(const ReplyFrame& frame) noexcept {
  const ForwardKinematics found = kinematics_.position(joint_angles(frame.encoders, calibration_), report_.position);
  if (found.has_converged) {
    report_.position = found.position;
    // When it was asked for: the device has not looked at its encoders before.
    position_time_ns_ = asked_ns_;
    lost_position_ns_ = 0;
  } else if (lost_position_ns_ == 0) {
    lost_position_ns_ = link_->now_ns();
  }
}

void Falcon::push(const Vector<3>& force, bool is_armed) noexcept {
  if (!report_.is_readable()) return;
  report_.state = is_armed ? FalconState::active : FalconState::idle;
  command_ = {.motors = {}, .info = is_armed ? CommandFrame::blue : CommandFrame::green};
  if (is_armed) {
    const auto jacobian = kinematics_.jacobian(report_.position);
    if (jacobian) command_.motors = motor_numbers(force, *jacobian, calibration_);
  }
  is_command_new_ = true;
  if (!is_reply_due_ && !is_purging_) send_command();
}

void Falcon::send_command() noexcept {
  // Whoever waits too long for a reply does not go on pushing.
  if (since(heard_ns_) > longest_lost_s || last_resort::is_taken()) command_.motors = {};
  if (!link_->write(encode(command_))) return;
  report_.motors = command_.motors;
  is_command_new_ = false;
  sent_ns_ = link_->now_ns();
  if (!is_reply_due_) asked_ns_ = sent_ns_;
  is_reply_due_ = true;
}

void Falcon::measure_rate() noexcept {
  const double window_s = since(window_began_ns_);
  if (window_s < rate_window_s) return;
  report_.exchange_hz = window_exchanges_ / window_s;
  report_.exchange_s = window_exchanges_ > 0 ? window_sum_s_ / window_exchanges_ : 0.0;
  report_.worst_exchange_s = window_worst_s_;
  report_.line_errors = link_->counters().line_errors;
  window_began_ns_ = link_->now_ns();
  window_exchanges_ = 0;
  window_sum_s_ = window_worst_s_ = 0.0;
}

void Falcon::finish() noexcept {
  if (!is_exchanging()) return link_->close();
  // Three answers: the device has heard it, and not only the chip before it.
  command_ = {};
  const std::int64_t deadline_ns = link_->now_ns() + 100'000'000;
  const int on_its_way = is_reply_due_ ? 1 : 0;  // the answer to what was said before
  for (int heard = -on_its_way; heard < 3 && link_->fault() == LinkFault::none && link_->now_ns() < deadline_ns;) {
    if (!is_reply_due_ || since(sent_ns_) >= ask_again_s) send_command();
    link_->wait_until(std::min(deadline_ns, link_->now_ns() + 5'000'000));
    if (take_replies()) {
      ++heard;
      command_ = {};
    }
  }
  link_->close();
  last_resort::guard(nullptr);
  phase_ = Phase::pausing;
  phase_began_ns_ = link_->now_ns();
  pause_s_ = try_again_s;
  report_.state = FalconState::absent;
  report_.motors = {};
}

}  // namespace ghostforce
