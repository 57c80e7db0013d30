#include "app/base/worker.h"

#include <pthread.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <thread>
#include <utility>

#include "device/input/thread_signals.h"

namespace ghostforce {

struct Worker::Work {
  Work(double period_s, std::function<bool()> step_function) : step(std::move(step_function)), period(period_s) {}

  std::function<bool()> step;
  std::chrono::duration<double> period;
  std::atomic<bool> is_running{true};
  std::mutex mutex;
  std::condition_variable woken;
  bool is_ending = false;  // guarded by the mutex
  std::thread thread;

  // False: there is to be no further step.
  bool wait() {
    std::unique_lock lock(mutex);
    return !woken.wait_for(lock, period, [this] { return is_ending; });
  }

  void run(const std::string& name) {
    const AlternateStack alternate_stack;
    // These are the UI thread's matter.
    sigset_t others;
    sigemptyset(&others);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&others, number);
    pthread_sigmask(SIG_BLOCK, &others, nullptr);
    pthread_setname_np(pthread_self(), name.c_str());
    while (wait() && step()) {
    }
    is_running = false;
  }
};

Worker::Worker(const std::string& name, double period_s, std::function<bool()> step)
    : work_(std::make_unique<Work>(period_s, std::move(step))) {
  work_->thread = std::thread([work = work_.get(), name] { work->run(name); });
}

Worker::~Worker() {
  end();
}

void Worker::poll() {}

void Worker::end() noexcept {
  if (!work_->thread.joinable()) return;
  {
    const std::lock_guard lock(work_->mutex);
    work_->is_ending = true;
  }
  work_->woken.notify_one();
  work_->thread.join();
}

bool Worker::is_running() const noexcept {
  return work_->is_running;
}

}  // namespace ghostforce
