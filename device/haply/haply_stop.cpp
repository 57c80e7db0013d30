// How a Haply's motors are told to stop, and what becomes of a board that does not answer.
#include <algorithm>
#include <limits>

#include "device/haply/haply.h"
#include "device/motors/driver_report.h"

namespace ghostforce {

// Also through a port that hears no more: it may still be heard, and closing it insists.
void Haply::stop_motors() noexcept {
  port_.write(hapi::zero_exchange());
  note_stop();
}

void Haply::close(double pause_s) noexcept {
  phase_ = Phase::closed;
  keeper_.let_go(pause_s);
}

void Haply::end(HaplyFault fault) noexcept {
  if (phase_ == Phase::exchanging || (phase_ != Phase::closed && keeper_.may_push())) stop_motors();
  close(MotorKeeper::try_again_s);
  report_fault(report_, fault);
  report_.exchange_hz = 0.0;
  report_.torques = command_ = {};
  forget_home();
}

// When zeros are due if no reply has come by then.
std::int64_t Haply::stop_ns() const noexcept {
  constexpr auto stop_after_ns = static_cast<std::int64_t>(stop_s * 1e9);
  // A packet that the port does not take is waited for like one that is not answered.
  const bool is_due = replies_.is_waiting() || (keeper_.may_push() && is_unwritten_);
  if (phase_ != Phase::exchanging || !is_due) return std::numeric_limits<std::int64_t>::max();
  // What the port has not taken is sent again at once, not when an answer to it would be late.
  constexpr auto again_after_ns = static_cast<std::int64_t>(refused_again_s * 1e9);
  // While it may push, time runs also where nobody asks.
  const std::int64_t since_ns = keeper_.may_push() ? heard_ns_ : awaited_ns_;
  return std::max(since_ns + stop_after_ns, zeros_ns_ + (is_unwritten_ ? again_after_ns : stop_after_ns));
}

// For want of a reply. The board may be waiting for the rest of a packet: then this is it.
void Haply::send_zeros() noexcept {
  zeros_ns_ = port_.now_ns();
  ++report_.lost_exchanges;
  window_.add_lost(since(awaited_ns_));
  command_ = {};
  reader_.reset();
  note_stop();
  send({});
}

// That the board has been told to stop, and may not have heard.
void Haply::note_stop() noexcept {
  report_.torques = {};
  keeper_.note_stop();
}

void Haply::note_zero_answered() noexcept {
  set_ups_ = 0;
  keeper_.zero_answered();
}

void Haply::shut_down() noexcept {
  if (keeper_.is_busy()) return;
  if (phase_ == Phase::exchanging) {
    say_goodbye();
    report_.state = HaplyState::absent;
    report_.torques = {};
  }
  close(MotorKeeper::try_again_s);
  forget_home();
  keeper_.tell(report_);
}

// The first zero does not wait for a reply.
void Haply::say_goodbye() noexcept {
  const bool is_waiting = replies_.is_waiting();
  command_ = {};
  send_command();
  // A board that has forgotten its address answers with it alone, and takes no zeros: once, it is set up for that.
  constexpr double short_s = 0.004;  // longer than the rest of a reply takes
  bool has_set_up = false;
  const auto exchange_zeros = [&](int heard, std::int64_t until_ns) {
    if (!has_set_up && reader_.holds_address_alone() && since(sent_ns_) >= short_s) {
      has_set_up = port_.write(hapi::encode(set_up_of(calibration_)));
      reader_.reset();
    }
    if (replies_.may_send(port_.now_ns()) || since(sent_ns_) >= stop_s) send_command();
    port_.wait_until(until_ns);
    return take_replies() ? heard + 1 : heard;
  };
  if (!keeper_.say_goodbye(goodbye_s, is_waiting, exchange_zeros)) stop_motors();
}

}  // namespace ghostforce
