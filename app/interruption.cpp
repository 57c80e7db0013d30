#include "app/interruption.h"

#include <signal.h>

#include <atomic>

#include "app/failure.h"

namespace ghostforce {
namespace {

std::atomic<bool> is_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch nothing else");

extern "C" void remember(int) {
  is_interrupted.store(true, std::memory_order_relaxed);
}

}  // namespace

void remember_interruptions() noexcept {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    sigaction(number, nullptr, &action);
    if (action.sa_handler == SIG_IGN) continue;
    action.sa_handler = remember;
    // No SA_RESTART: a write to a pipe that nobody reads must come back too.
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(number, &action, nullptr);
  }
}

bool interrupted() noexcept {
  return is_interrupted.load(std::memory_order_relaxed);
}

void stop_if_interrupted() {
  if (interrupted()) throw Failure(ExitCode::interrupted, "interrupted");
}

}  // namespace ghostforce
