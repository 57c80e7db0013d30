// AwakeProcessors: while one stands, no processor of this machine sleeps. A virtual machine gives an idle processor away
// and gets it back some milliseconds late, so a device that is emulated by threads answers too late for motors to come
// on, and the more so the less else there is to do.
// Costs nobody time: its threads run where nothing else wants to.
#pragma once

#include <atomic>
#include <thread>
#include <vector>

#include <pthread.h>
#include <sched.h>

namespace ghostforce {

class AwakeProcessors {
 public:
  AwakeProcessors() {
    for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i) threads_.emplace_back([this] { stay_awake(); });
  }
  AwakeProcessors(const AwakeProcessors&) = delete;
  AwakeProcessors& operator=(const AwakeProcessors&) = delete;
  ~AwakeProcessors() {
    is_over_ = true;
    for (std::thread& thread : threads_) thread.join();
  }

 private:
  void stay_awake() const {
    const sched_param lowest{};
    // Where that is not allowed, this would take time from others.
    if (pthread_setschedparam(pthread_self(), SCHED_IDLE, &lowest) != 0) return;
    while (!is_over_) {
    }
  }

  std::atomic<bool> is_over_{false};
  std::vector<std::thread> threads_;
};

}  // namespace ghostforce
