#include "device/falcon/falcon.h"

#include <algorithm>
#include <utility>

#include "device/falcon/link_setup.h"
#include "device/motors/driver_report.h"

namespace ghostforce {
namespace {

// A motor's encoder that has gone so far is connected and counting [counts].
constexpr int moved_counts = 20;
// One odd reply is no loss of the zero, and no proof of it.
constexpr int replies_to_believe = 3;

// In the order of BootFault.
constexpr std::array boot_faults{FalconFault::none, FalconFault::no_handshake, FalconFault::no_baud_answer,
                                 FalconFault::echo_missing, FalconFault::echo_differs};
static_assert(boot_faults.size() == static_cast<std::size_t>(BootFault::echo_differs) + 1);

FalconFault fault_of(BootFault fault) noexcept {
  return boot_faults[static_cast<std::size_t>(fault)];
}

}  // namespace

Falcon::Falcon(std::unique_ptr<FalconLink> link, FalconOptions options)
    : link_(*link),
      keeper_(std::move(link), keeper_options(options)),
      options_(std::move(options)),
      kinematics_(calibration_.geometry) {
  report_.is_virtual = options_.is_virtual;
  report_.has_firmware_file = !options_.firmware.empty();
  report_.firmware_size = static_cast<std::uint32_t>(options_.firmware.size());
  report_.attempts = attempts;
  keeper_.tell(report_);  // what is owed since an earlier driver
}

// A device that is silent at the end is not given firmware.
Falcon::~Falcon() {
  options_.firmware.clear();
  attempt_ = 0;
  keeper_.end(*this);
}

void Falcon::update() noexcept {
  advance();
  keeper_.tell(report_);
}

void Falcon::advance() noexcept {
  switch (keeper_.update()) {
    case MotorKeeper::Event::away:
      return;
    case MotorKeeper::Event::absent:
      return note_absence();
    case MotorKeeper::Event::opened:
      return opened();
    case MotorKeeper::Event::failed:
      return end(fault_of_link<FalconFault>(link().fault()));
    case MotorKeeper::Event::overtaken:
      return end(FalconFault::stop_owed);
    case MotorKeeper::Event::open:
      break;
  }
  switch (phase_) {
    case Phase::closed:
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
  keeper_.wait_until(std::min(deadline_ns, stop_ns()));
}

void Falcon::note_absence() noexcept {
  report_absent(report_);
  has_answered_ = false;
  attempt_ = 0;
}

void Falcon::opened() noexcept {
  if (keeper_.is_another()) {
    attempt_ = 0;
    has_answered_ = false;
  }
  report_.is_guarded = link().is_guarded();
  calibration_ = calibration_of(keeper_.serial(), options_.calibrations);
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
  questions_left_ = has_answered_ || keeper_.may_push() ? patient_questions : first_questions;
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
    if (keeper_.has_paid()) return close(0.0);
    if (keeper_.is_only_owed()) return;
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
    if (keeper_.may_push() && replies_.is_waiting()) return set_up_chip();
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
  if (next > attempts) return end(fault);  // and after the pause from the beginning
  end(fault, load_again_s);
  attempt_ = next;
  report_.attempt = next;
  report_.state = FalconState::loading_firmware;
}

void Falcon::begin_exchanging() noexcept {
  reader_.reset();
  replies_.reset();
  command_ = {.motors = {}, .info = CommandFrame::homing | CommandFrame::red};
  is_command_new_ = false;
  is_purging_ = false;
  has_home_ = false;
  position_times_.reset();
  sent_ns_ = heard_ns_ = awaited_ns_ = link().now_ns();
  unanswered_ns_.reset();
  window_.begin(sent_ns_);
  report_.exchange_hz = 0.0;
  report_.has_homed = {};
  report_.has_moved = {};
  unhomed_replies_ = homed_replies_ = 0;
}

void Falcon::close(double pause_s) noexcept {
  phase_ = Phase::closed;
  keeper_.let_go(pause_s);
}

void Falcon::end(FalconFault fault, double pause_s) noexcept {
  // Also through a link that hears no more: it may still be heard, and closing it insists.
  if (phase_ == Phase::exchanging || (phase_ == Phase::asking && keeper_.may_push())) stop_motors();
  close(pause_s);
  if (fault == FalconFault::unplugged) has_answered_ = false;
  report_fault(report_, fault);
  report_.has_firmware = false;
  report_.has_homed = {};
  report_.has_moved = {};
  report_.exchange_hz = 0.0;
  report_.motors = {};
  report_.buttons = 0;
  position_times_.reset();
  attempt_ = 0;
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
  if (!replies_.is_waiting() && keeper_.answers_zero(*asked_ns)) keeper_.zero_answered();
  ++report_.exchanges;
  const double exchange_s = since(*asked_ns);
  window_.add(exchange_s);
  measure_rate();
  report_.encoders = frame.encoders;
  report_.buttons = frame.status & 0x0F;
  follow_homing(frame.status);
  if (has_home_ && leap_filter_.add(frame.encoders, heard_ns_) != LeapFilter<MotorNumbers>::Verdict::odd) {
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
    report_idle(report_);
    report_.has_moved = {};
    least_ = greatest_ = report_.encoders;
    report_.position = cold_start;
    position_times_.reset();
    leap_filter_.reset();
    set_force(Vector<3>(0.0), false);
  } else if (has_home_ && unhomed_replies_ >= replies_to_believe) {
    has_home_ = false;
    report_.state = FalconState::homing;
    report_.has_moved = {};
    command_ = {.motors = {}, .info = CommandFrame::homing | CommandFrame::red};
    is_command_new_ = true;
  }
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
    position_times_.found(asked_ns, heard_ns_);
    if (report_.is_readable()) return;
    report_idle(report_);
    set_force(Vector<3>(0.0), false);
  } else if (position_times_.not_found(link().now_ns()) && report_.is_readable()) {
    // The device itself is well: it is listened to until its encoders make sense again.
    report_fault(report_, FalconFault::kinematics);
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
  const bool ends_force = !is_armed && report_.motors != MotorNumbers{};
  if (replies_.may_send(link().now_ns(), ends_force)) send_command();
}

bool Falcon::send_command() noexcept {
  // A device that is let go gets no light and is not homed either, whatever its answers tell.
  if (keeper_.is_leaving()) command_ = {};
  if (keeper_.must_stop(heard_ns_)) command_.motors = {};
  const bool pushes = command_.motors != MotorNumbers{};
  if (pushes) keeper_.will_push();
  if (!link().write(encode(command_))) return false;
  report_.motors = command_.motors;
  is_command_new_ = false;
  sent_ns_ = link().now_ns();
  keeper_.sent(pushes, sent_ns_);
  if (!replies_.is_waiting()) asked_ns_ = sent_ns_;
  if (!unanswered_ns_) unanswered_ns_ = sent_ns_;
  replies_.sent(sent_ns_);
  return true;
}

void Falcon::measure_rate() noexcept {
  if (!window_.tell(report_, link().now_ns())) return;
  report_.line_errors = link().counters().line_errors;
  report_.is_guarded = link().is_guarded();
  // By the time of one answer: a device that is not homed yet is asked less often than it could be.
  wants_latency_ = report_.exchange_s * FalconReport::fast_enough_hz > 1.0;
}

}  // namespace ghostforce
