#include "device/falcon/link_opener.h"

#include <cassert>
#include <utility>

#include <pthread.h>

#include "device/input/monotonic_clock.h"
#include "device/input/thread_signals.h"

namespace ghostforce {

LinkOpener::LinkOpener(std::unique_ptr<FalconLink> link) : link_(std::move(link)) {
  if (link_->waits_to_open()) thread_ = std::thread(&LinkOpener::run, this);
}

void LinkOpener::end() noexcept {
  if (!thread_.joinable()) return link_->close();
  task_.store(Task::end, std::memory_order_release);
  asked_.release();
  thread_.join();
  task_.store(Task::none, std::memory_order_release);
}

void LinkOpener::ask(Task task) noexcept {
  assert(!is_busy());
  if (!thread_.joinable()) return carry_out(task);
  task_.store(task, std::memory_order_release);
  asked_.release();
}

void LinkOpener::run() noexcept {
  const AlternateStack alternate_stack;
  leave_process_signals();
  pthread_setname_np(pthread_self(), "falcon opener");
  for (;;) {
    asked_.acquire();
    Task task = task_.load(std::memory_order_acquire);
    if (task == Task::end) {
      if (link_->owes_stop()) link_->open();
      return link_->close();
    }
    carry_out(task);
    // The link is the driver's again, unless the end has been asked for meanwhile.
    task_.compare_exchange_strong(task, Task::none, std::memory_order_acq_rel);
  }
}

void LinkOpener::carry_out(Task task) noexcept {
  if (task == Task::open) {
    link_->open();
  } else {
    link_->close();
  }
}

void LinkOpener::wait_until(std::int64_t deadline_ns) noexcept {
  if (!is_busy()) return link_->wait_until(deadline_ns);
  sleep_until_monotonic(deadline_ns);
}

}  // namespace ghostforce
