#include "device/falcon/emergency_stop.h"

#include <poll.h>
#include <unistd.h>

#include <atomic>

#include "device/falcon/falcon_link.h"
#include "device/falcon/frame.h"

namespace ghostforce::emergency_stop {
namespace {

// Another thread's sending takes no longer, unless it hangs for good.
constexpr int patience_ms = 200;

std::atomic<FalconLink*> watched{nullptr};
std::atomic<pid_t> stopper{0};  // the thread that ordered it first; 0: none has
std::atomic<bool> is_sent{false};
static_assert(std::atomic<FalconLink*>::is_always_lock_free && std::atomic<pid_t>::is_always_lock_free &&
              std::atomic<bool>::is_always_lock_free);

void wait_ms(int duration) noexcept {
  poll(nullptr, 0, duration);
}

}  // namespace

void watch(FalconLink* link) noexcept {
  watched.store(link);
}

void stop_motors() noexcept {
  const pid_t self = gettid();
  pid_t first = 0;
  if (!stopper.compare_exchange_strong(first, self)) {
    // Whoever returns from here may end the process.
    if (first == self) return;
    for (int waited_ms = 0; !is_sent.load() && waited_ms < patience_ms; ++waited_ms) wait_ms(1);
    return;
  }
  if (FalconLink* const link = watched.load()) {
    // A frame that was cut short would swallow the beginning of the next one, and a driver may be just about to send
    // one that it made before this: the second is whole and the last for certain.
    const FrameBytes zero = encode(CommandFrame{});
    link->send_at_once(zero);
    wait_ms(1);
    link->send_at_once(zero);
  }
  is_sent.store(true);
}

bool is_ordered() noexcept {
  return stopper.load(std::memory_order_relaxed) != 0;
}

}  // namespace ghostforce::emergency_stop
