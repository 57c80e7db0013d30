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
  const std::int64_t since_ns = keeper_.may_push() ? awaited_ns_ : std::max(asked_ns_, awaited_ns_);
  return since_ns + static_cast<std::int64_t>(stop_s * 1e9);
}

// That the device has been told to stop, and may not have heard.
void Falcon::note_stop() noexcept {
  report_.motors = {};
  keeper_.note_stop();
}

void Falcon::shut_down() noexcept {
  if (keeper_.is_busy()) return;
  if (is_exchanging()) {
    say_goodbye();
    report_.state = FalconState::absent;
    report_.motors = {};
  }
  close(MotorKeeper::try_again_s);
  keeper_.tell(report_);
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

void Falcon::say_goodbye() noexcept {
  const auto exchange_zeros = [this](int heard, std::int64_t until_ns) {
    if (recover()) {
      heard = 0;
    } else if (replies_.may_send(link().now_ns()) || since(sent_ns_) >= stop_s) {
      send_command();
    }
    link().wait_until(std::min(until_ns, stop_ns()));
    return !is_purging_ && take_replies() ? heard + 1 : heard;
  };
  if (!keeper_.say_goodbye(goodbye_s, replies_.is_waiting(), exchange_zeros)) stop_motors();
}

}  // namespace ghostforce
