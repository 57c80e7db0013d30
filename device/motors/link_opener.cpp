#include "device/motors/link_opener.h"

#include <atomic>
#include <cassert>
#include <semaphore>
#include <thread>
#include <utility>

#include <pthread.h>

#include "device/input/monotonic_clock.h"
#include "device/input/thread_signals.h"

namespace ghostforce {

class LinkOpener::Worker {
 public:
  enum class Task : std::uint8_t { none, open, close, end };

  explicit Worker(DeviceLink& link) : link_(link), thread_(&Worker::run, this) {}
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker() {
    task_.store(Task::end, std::memory_order_release);
    asked_.release();
    thread_.join();
  }

  void open(const StopDebts& owed) noexcept {
    to_open_ = owed;
    ask(Task::open);
  }
  void close() noexcept { ask(Task::close); }
  bool is_busy() const noexcept { return task_.load(std::memory_order_acquire) != Task::none; }

  void look_for(const StopDebts& owed) noexcept {
    if (search_.load(std::memory_order_acquire) == Search::asked) return;
    to_find_ = owed;
    search_.store(Search::asked, std::memory_order_release);
    asked_.release();
  }
  bool has_found_one() noexcept {
    Search found = Search::found;
    return search_.compare_exchange_strong(found, Search::none, std::memory_order_acq_rel);
  }

 private:
  enum class Search : std::uint8_t { none, asked, found };

  void ask(Task task) noexcept {
    assert(!is_busy());
    task_.store(task, std::memory_order_release);
    asked_.release();
  }

  void run() noexcept {
    const AlternateStack alternate_stack;
    leave_process_signals();
    pthread_setname_np(pthread_self(), "device opener");
    for (;;) {
      asked_.acquire();
      Task task = task_.load(std::memory_order_acquire);
      if (task == Task::end) return link_.close();
      if (task == Task::open) link_.open_first(to_open_);
      if (task == Task::close) link_.close();
      // The link is the driver's again, unless the end has been asked for meanwhile.
      if (task != Task::none) task_.compare_exchange_strong(task, Task::none, std::memory_order_acq_rel);
      if (search_.load(std::memory_order_acquire) == Search::asked) {
        search_.store(link_.is_any_plugged_in(to_find_) ? Search::found : Search::none, std::memory_order_release);
      }
    }
  }

  DeviceLink& link_;
  std::atomic<Task> task_{Task::none};
  StopDebts to_open_;  // of a task to open
  std::atomic<Search> search_{Search::none};
  StopDebts to_find_;  // while it is asked for
  std::counting_semaphore<> asked_{0};
  std::thread thread_;  // last: it uses what stands above
};

LinkOpener::LinkOpener(std::unique_ptr<DeviceLink> link) : link_(std::move(link)) {
  if (link_->waits_to_open()) worker_ = std::make_unique<Worker>(*link_);
}

LinkOpener::~LinkOpener() {
  end();
}

void LinkOpener::open(const StopDebts& owed) noexcept {
  if (worker_) return worker_->open(owed);
  link_->open_first(owed);
}

void LinkOpener::close() noexcept {
  if (worker_) return worker_->close();
  link_->close();
}

void LinkOpener::look_for(const StopDebts& owed) noexcept {
  if (worker_) return worker_->look_for(owed);
  has_found_ = link_->is_any_plugged_in(owed);
}

bool LinkOpener::has_found_one() noexcept {
  return worker_ ? worker_->has_found_one() : std::exchange(has_found_, false);
}

void LinkOpener::end() noexcept {
  if (!worker_) return link_->close();
  worker_.reset();
}

bool LinkOpener::is_busy() const noexcept {
  return worker_ && worker_->is_busy();
}

void LinkOpener::wait_until(std::int64_t deadline_ns) noexcept {
  if (!is_busy()) return link_->wait_until(deadline_ns);
  sleep_until_monotonic(deadline_ns);
}

}  // namespace ghostforce
