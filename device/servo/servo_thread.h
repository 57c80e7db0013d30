// ServoThread: the 1 kHz thread. It asks for real-time conditions first (ServoReport::realtime); with real-time priority
// it spins through what is left before a deadline (hybrid_sleep.h); a device paces it instead. On it our code never
// allocates, locks, logs, throws, opens files or frees. UI thread, but for what runs on the thread itself.
#pragma once

#include <atomic>
#include <thread>

#include "device/servo/latency_histogram.h"
#include "device/servo/servo_driver.h"

namespace ghostforce {

class ServoThread final : public ServoDriver {
 public:
  ServoThread() = default;
  ~ServoThread() override { ServoThread::stop(); }

  // Changes nothing while it runs. Throws std::system_error.
  void start(Servo& servo) override;
  // Returns when the thread has ended: within Servo::command_period_s, and what its device takes to be let go.
  void stop() noexcept override;

  // How late the ticks came since start(). While the thread is stopped.
  const LatencyHistogram& latency_histogram() const noexcept { return latency_histogram_; }

 private:
  void run(Servo& servo) noexcept;

  std::thread thread_;
  std::atomic<bool> stopping_{false};
  LatencyHistogram latency_histogram_;  // the thread's
};

}  // namespace ghostforce
