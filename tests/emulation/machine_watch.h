// MachineWatch: whether this machine does so much else that no motor can come on. A device is armed once it has answered
// every millisecond or two for seconds. Where threads wait for a processor several times a second, a test of armed motors
// has nothing to test: it says so and is skipped. On any other machine it fails.
// Made, asked and destroyed on the test's thread; watches on one of its own.
#pragma once

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace ghostforce {

// Motors did not come on, or not for long enough, and this machine is why.
class MachineTooBusy : public std::runtime_error {
 public:
  MachineTooBusy() : std::runtime_error("the motors did not come on, or went off: this machine is too busy") {}
};

class MachineWatch {
 public:
  MachineWatch() = default;
  MachineWatch(const MachineWatch&) = delete;
  MachineWatch& operator=(const MachineWatch&) = delete;
  ~MachineWatch() {
    is_over_ = true;
    thread_.join();
  }

  // A thread has waited for a processor, once at least.
  bool was_late() const { return late_ > 0; }
  // And more often than twice a second, for so long that the motors should have come on several times: an idle machine
  // is late once in some seconds.
  bool is_too_busy() const {
    const Clock::duration passed = Clock::now() - start_;
    return passed > std::chrono::seconds(15) && late_.load() * std::chrono::milliseconds(500) > passed;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds late_by{3};

  void watch() {
    while (!is_over_) {
      const Clock::time_point before = Clock::now();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      if (Clock::now() - before > late_by) ++late_;
    }
  }

  const Clock::time_point start_ = Clock::now();
  std::atomic<int> late_{0};
  std::atomic<bool> is_over_{false};
  std::thread thread_{[this] { watch(); }};
};

}  // namespace ghostforce
