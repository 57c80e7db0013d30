#include "app/console/interruption.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>

#include <atomic>
#include <cerrno>

#include "app/console/failure.h"

namespace ghostforce {
namespace {

// How long a reader may take nothing once the program is to stop.
constexpr int patience_ms = 1000;

std::atomic<bool> is_interrupted{false};
void (*before_the_end)() noexcept = nullptr;  // set before any handler
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch nothing else");

extern "C" void remember(int number) {
  if (!is_interrupted.exchange(true, std::memory_order_relaxed)) return;
  // A second one does not wait, and nobody comes after it to turn motors off.
  before_the_end();
  signal(number, SIG_DFL);
  raise(number);
}

}  // namespace

void remember_interruptions(void (*stop_motors)() noexcept) noexcept {
  before_the_end = stop_motors;
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    sigaction(number, nullptr, &action);
    if (action.sa_handler == SIG_IGN) continue;
    action.sa_handler = remember;
    // No SA_RESTART: a write to a pipe that nobody reads must come back too.
    action.sa_flags = 0;
    sigaction(number, &action, nullptr);
  }
}

bool interrupted() noexcept {
  return is_interrupted.load(std::memory_order_relaxed);
}

void interrupt() noexcept {
  is_interrupted.store(true, std::memory_order_relaxed);
}

void stop_if_interrupted() {
  if (interrupted()) throw Failure(ExitCode::interrupted, "interrupted");
}

int open_unless_interrupted(const char* path, int flags) {
  for (;;) {
    stop_if_interrupted();
    const int descriptor = open(path, flags);
    if (descriptor >= 0 || errno != EINTR) return descriptor;
  }
}

void wait_for_reader_of(int descriptor) {
  pollfd wait{descriptor, POLLOUT, 0};
  if (poll(&wait, 1, patience_ms) == 0) stop_if_interrupted();
}

}  // namespace ghostforce
