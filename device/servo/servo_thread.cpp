#include "device/servo/servo_thread.h"

#include <cstdint>
#include <functional>

#include <pthread.h>

#include "device/input/monotonic_clock.h"
#include "device/input/thread_signals.h"
#include "device/servo/realtime.h"
#include "device/servo/servo.h"

namespace ghostforce {
namespace {

struct SystemClock {
  static std::int64_t now_ns() noexcept { return monotonic_ns(); }
  static void sleep_until(std::int64_t time_ns) noexcept { sleep_until_monotonic(time_ns); }
};

}  // namespace

void ServoThread::start(Servo& servo) {
  if (thread_.joinable()) return;
  stopping_.store(false, std::memory_order_relaxed);
  thread_ = std::thread(&ServoThread::run, this, std::ref(servo));
}

void ServoThread::stop() noexcept {
  if (!thread_.joinable()) return;
  stopping_.store(true, std::memory_order_relaxed);
  thread_.join();
}

void ServoThread::run(Servo& servo) noexcept {
  const AlternateStack alternate_stack;
  leave_process_signals();
  pthread_setname_np(pthread_self(), "servo");
  const RealtimeStatus realtime = request_realtime();
  HapticDevice* const device = servo.input().haptic_device();

  servo.begin(monotonic_ns(), realtime);
  HybridSleep sleep(servo.period_ns());
  latency_histogram_ = {};
  while (!stopping_.load(std::memory_order_relaxed)) {
    const auto [until, is_deadline] = servo.next_wake();
    std::int64_t now = 0;
    if (device != nullptr) {
      device->wait_until(until);
      now = monotonic_ns();
    } else if (!is_deadline || realtime.priority_error != 0) {
      SystemClock::sleep_until(until);
      now = monotonic_ns();
    } else {
      now = sleep.until(until, SystemClock{});
    }
    if (const auto late_ns = servo.wake(now)) latency_histogram_.add(*late_ns);
    sleep.set_period(servo.period_ns());
  }
  servo.shut_down();
}

}  // namespace ghostforce
