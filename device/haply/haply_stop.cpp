// How a Haply's motors are told to stop, and what becomes of a board that does not answer.
#include <algorithm>
#include <limits>

#include "device/haply/haply.h"

namespace ghostforce {

void Haply::end(HaplyFault fault) noexcept {
  // Also through a port that hears no more: it may still be heard.
  if (phase_ == Phase::exchanging || may_push_) {
    port_.write(hapi::zero_exchange());
    note_stop();
  }
  opener_.close();
  report_.state = HaplyState::fault;
  report_.fault = fault;
  ++report_.faults;
  report_.exchange_hz = 0.0;
  report_.torques = command_ = {};
  forget_home();
  phase_ = Phase::pausing;
  phase_began_ns_ = port_.now_ns();
  pause_s_ = fault == HaplyFault::unplugged || !debts_.empty() ? soon_s : try_again_s;
}

// When zeros are due if no reply has come by then.
std::int64_t Haply::stop_ns() const noexcept {
  constexpr auto stop_after_ns = static_cast<std::int64_t>(stop_s * 1e9);
  // A packet that the port does not take is waited for like one that is not answered.
  const bool is_due = replies_.is_waiting() || (may_push_ && is_unwritten_);
  if (phase_ != Phase::exchanging || !is_due) return std::numeric_limits<std::int64_t>::max();
  // While it may push, time runs also where nobody asks.
  return std::max(may_push_ ? heard_ns_ : awaited_ns_, zeros_ns_) + stop_after_ns;
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
  if (may_push_) debts_.add(report_.serial);
  note_debts();
}

void Haply::note_zero_answered() noexcept {
  if (may_push_) port_.set_may_push(false);
  may_push_ = false;
  set_ups_ = 0;
  debts_.remove(report_.serial);
  note_debts();
}

void Haply::note_debts() noexcept {
  report_.may_still_push = !debts_.empty();
  report_.owed_serial = debts_.empty() ? DeviceSerial() : debts_.serials().front();
}

// One that is owed a stop is plugged in again, while another one is in use.
bool Haply::has_owed_returned() noexcept {
  if (debts_.empty() || debts_.has(report_.serial)) return false;
  if (since(looked_ns_) >= soon_s) {
    looked_ns_ = port_.now_ns();
    opener_.look_for(debts_);
  }
  return opener_.has_found_one();
}

// It has stopped, and the one that is to be used is next.
void Haply::leave_owed() noexcept {
  opener_.close();
  phase_ = Phase::pausing;
  pause_s_ = 0.0;
}

void Haply::shut_down() noexcept {
  if (opener_.is_busy()) return;
  if (phase_ == Phase::exchanging) {
    say_goodbye();
    report_.state = HaplyState::absent;
    report_.torques = {};
  }
  opener_.close();
  forget_home();
  phase_ = Phase::pausing;
  phase_began_ns_ = port_.now_ns();
  pause_s_ = debts_.empty() ? try_again_s : soon_s;
}

// Until three zeros have been answered: a board hears each of them.
void Haply::say_goodbye() noexcept {
  is_leaving_ = true;
  const std::int64_t deadline_ns = port_.now_ns() + static_cast<std::int64_t>(goodbye_s * 1e9);
  int heard = replies_.is_waiting() ? -1 : 0;
  send_command();
  while ((heard < 3 || may_push_) && port_.fault() == LinkFault::none && port_.now_ns() < deadline_ns) {
    if (replies_.may_send(port_.now_ns()) || since(sent_ns_) >= stop_s) send_command();
    port_.wait_until(std::min(deadline_ns, port_.now_ns() + 5'000'000));
    if (take_replies()) ++heard;
  }
  note_stop();
  is_leaving_ = false;
}

// There is no later. A board that is just being plugged in may not be there yet, or may have been found a moment ago: the
// time counts from the last sign of it.
void Haply::pay_debts() noexcept {
  const std::int64_t began_ns = port_.now_ns();
  std::int64_t seen_ns = began_ns;
  pause_s_ = 0.0;
  while (!debts_.empty() && since(began_ns) < last_stops_s) {
    const bool was_busy = opener_.is_busy();  // what it has found is known after the next update()
    update();
    if (is_paying()) seen_ns = port_.now_ns();
    const bool is_looking = was_busy || opener_.is_busy() || phase_ == Phase::opening;
    if (!is_looking && since(seen_ns) >= last_look_s) break;
    opener_.wait_until(port_.now_ns() + 1'000'000);
  }
  shut_down();
  if (options_.when_left_pushing == nullptr || options_.is_virtual) return;
  for (const DeviceSerial& serial : debts_.serials()) options_.when_left_pushing(serial);
}

// Whether one that is owed a stop is open; or some board is there and could not be opened, perhaps that one.
bool Haply::is_paying() const noexcept {
  const bool is_open = phase_ != Phase::pausing && phase_ != Phase::opening;
  if (is_open) return debts_.has(report_.serial);
  return report_.fault != HaplyFault::none && report_.fault != HaplyFault::unplugged;
}

}  // namespace ghostforce
