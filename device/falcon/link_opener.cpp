#include "device/falcon/link_opener.h"

#include <atomic>
#include <cassert>
#include <cstdint>
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

  explicit Worker(FalconLink& link) : link_(link), thread_(&Worker::run, this) {}
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker() {
    task_.store(Task::end, std::memory_order_release);
    asked_.release();
    thread_.join();
  }

  void ask(Task task) noexcept {
    assert(!is_busy());
    task_.store(task, std::memory_order_release);
    asked_.release();
  }
  bool is_busy() const noexcept { return task_.load(std::memory_order_acquire) != Task::none; }

 private:
  void run() noexcept {
    const AlternateStack alternate_stack;
    leave_process_signals();
    pthread_setname_np(pthread_self(), "falcon opener");
    for (;;) {
      asked_.acquire();
      Task task = task_.load(std::memory_order_acquire);
      if (task == Task::end) {
        if (link_.owes_stop()) link_.open();
        return link_.close();
      }
      if (task == Task::open) {
        link_.open();
      } else {
        link_.close();
      }
      // The link is the driver's again, unless the end has been asked for meanwhile.
      task_.compare_exchange_strong(task, Task::none, std::memory_order_acq_rel);
    }
  }

  FalconLink& link_;
  std::atomic<Task> task_{Task::none};
  std::counting_semaphore<> asked_{0};
  std::thread thread_;  // last: it uses what stands above
};

LinkOpener::LinkOpener(std::unique_ptr<FalconLink> link) : link_(std::move(link)) {
  if (link_->waits_to_open()) worker_ = std::make_unique<Worker>(*link_);
}

LinkOpener::~LinkOpener() {
  end();
}

void LinkOpener::open() noexcept {
  if (worker_) return worker_->ask(Worker::Task::open);
  link_->open();
}

void LinkOpener::close() noexcept {
  if (worker_) return worker_->ask(Worker::Task::close);
  link_->close();
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
