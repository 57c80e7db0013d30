// How a Falcon's motors are told to stop, and what becomes of those that do not answer.
#include <algorithm>
#include <limits>

#include "device/falcon/falcon.h"
#include "device/falcon/falcon_link.h"
#include "device/falcon/frame.h"
#include "device/falcon/link_setup.h"

namespace ghostforce {

void FalconLink::stop_at_once() noexcept {
  send_at_once(encode(CommandFrame{}));
}

void Falcon::stop_motors() noexcept {
  link().stop(stop_frames());
  note_stop();
}

// When the motors are to be told to stop if no reply has come by then.
std::int64_t Falcon::stop_ns() const noexcept {
  const bool is_waiting = phase_ == Phase::exchanging && !is_purging_ && replies_.is_waiting();
  if (!is_waiting) return std::numeric_limits<std::int64_t>::max();
  // While it may push, time runs also where nobody asks.
  const std::int64_t since_ns = may_push_ ? awaited_ns_ : std::max(asked_ns_, awaited_ns_);
  return since_ns + static_cast<std::int64_t>(stop_s * 1e9);
}

// That the device has been told to stop, and may not have heard.
void Falcon::note_stop() noexcept {
  report_.motors = {};
  if (may_push_) debts_.add(report_.serial);
  note_debts();
}

void Falcon::note_debts() noexcept {
  report_.may_still_push = !debts_.empty();
  report_.owed_serial = debts_.empty() ? DeviceSerial() : debts_.serials().front();
}

// One that is owed a stop is plugged in again, while another one is in use.
bool Falcon::has_owed_returned() noexcept {
  if (debts_.empty() || debts_.has(report_.serial)) return false;
  if (since(looked_ns_) >= soon_s) {
    looked_ns_ = link().now_ns();
    opener_.look_for(debts_);
  }
  return opener_.has_found_one();
}

void Falcon::shut_down() noexcept {
  if (opener_.is_busy()) return;
  if (is_exchanging()) {
    say_goodbye();
    report_.state = FalconState::absent;
    report_.motors = {};
  }
  opener_.close();
  phase_ = Phase::pausing;
  phase_began_ns_ = link().now_ns();
  pause_s_ = debts_.empty() ? try_again_s : soon_s;
}

// There is no later. A device that is silent is not given firmware now. One that is just being plugged in may not be
// listed yet, or may have been found a moment ago: the time counts from the last sign of it.
void Falcon::pay_debts() noexcept {
  const std::int64_t began_ns = link().now_ns();
  std::int64_t seen_ns = began_ns;
  options_.firmware.clear();
  attempt_ = 0;
  pause_s_ = 0.0;
  while (!debts_.empty() && since(began_ns) < last_stops_s) {
    const bool was_busy = opener_.is_busy();  // what it has found is known after the next update()
    update();
    if (is_paying()) seen_ns = link().now_ns();
    const bool is_looking = was_busy || opener_.is_busy() || phase_ == Phase::opening;
    if (!is_looking && since(seen_ns) >= last_look_s) break;
    opener_.wait_until(link().now_ns() + 1'000'000);
  }
  shut_down();
  if (options_.when_left_pushing == nullptr || options_.is_virtual) return;
  for (const DeviceSerial& serial : debts_.serials()) options_.when_left_pushing(serial);
}

// Whether one that is owed a stop is open; or some device is there and could not be opened, perhaps that one.
bool Falcon::is_paying() const noexcept {
  const bool is_open = phase_ != Phase::pausing && phase_ != Phase::opening;
  if (is_open) return debts_.has(report_.serial);
  return report_.fault != FalconFault::none && report_.fault != FalconFault::unplugged;
}

// A silent device gets the stop, and its chip is set up anew. True: the link is busy with that, and nothing else goes out.
bool Falcon::recover() noexcept {
  if (is_purging_) {
    if (link().owes_stop() && !link().is_sending()) stop_motors();
    is_purging_ = link_script_.update(link()) == LinkProgress::running;
    if (is_purging_) return true;
    reader_.reset();
    replies_.reset();
    awaited_ns_ = link().now_ns();
    send_command();
    return true;
  }
  if (link().now_ns() < stop_ns()) return false;
  ++report_.lost_exchanges;
  window_.add_lost(since(asked_ns_));
  command_.motors = {};
  note_stop();
  link_script_ = LinkScript(stop_and_set_up_link_again);
  link_script_.update(link());
  is_purging_ = true;
  return true;
}

// Until three answers have come, one of them to a zero: the device has heard it, and not only the chip before it.
void Falcon::say_goodbye() noexcept {
  is_leaving_ = true;
  const std::int64_t deadline_ns = link().now_ns() + static_cast<std::int64_t>(goodbye_s * 1e9);
  const int on_its_way = replies_.is_waiting() ? 1 : 0;  // the answer to what was said before
  int heard = -on_its_way;
  const auto has_heard = [&] { return heard >= 3 && !may_push_; };
  while (!has_heard() && link().fault() == LinkFault::none && link().now_ns() < deadline_ns) {
    if (recover()) {
      heard = 0;
    } else if (replies_.may_send(link().now_ns()) || since(sent_ns_) >= stop_s) {
      send_command();
    }
    link().wait_until(std::min({deadline_ns, stop_ns(), link().now_ns() + 5'000'000}));
    if (!is_purging_ && take_replies()) ++heard;
  }
  is_leaving_ = false;
  if (!has_heard()) stop_motors();
}

}  // namespace ghostforce
