#include <chrono>
#include <utility>

#include "app/base/worker.h"

namespace ghostforce {

struct Worker::Work {
  using Clock = std::chrono::steady_clock;

  Work(double period_s, std::function<bool()> step_function) : step(std::move(step_function)), period(period_s) {}

  std::function<bool()> step;
  std::chrono::duration<double> period;
  Clock::time_point last = Clock::now();
  bool is_running = true;
};

Worker::Worker(const std::string&, double period_s, std::function<bool()> step)
    : work_(std::make_unique<Work>(period_s, std::move(step))) {}

Worker::~Worker() = default;

void Worker::poll() {
  if (!work_->is_running || Work::Clock::now() - work_->last < work_->period) return;
  work_->is_running = work_->step();
  work_->last = Work::Clock::now();
}

void Worker::end() noexcept {
  work_->is_running = false;
}

bool Worker::is_running() const noexcept {
  return work_->is_running;
}

}  // namespace ghostforce
