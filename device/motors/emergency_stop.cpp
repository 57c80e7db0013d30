#include "device/motors/emergency_stop.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>

#include <poll.h>
#include <unistd.h>

#include "device/input/thread_signals.h"
#include "device/motors/device_link.h"

namespace ghostforce::emergency_stop {
namespace {

// Another thread's sending takes no longer, unless it hangs for good.
constexpr int patience_ms = 200;

std::atomic<DeviceLink*> watched{nullptr};
std::atomic<pid_t> stopper{0};  // the thread that ordered it first; 0: none has
std::atomic<bool> is_sent{false};
static_assert(std::atomic<DeviceLink*>::is_always_lock_free && std::atomic<pid_t>::is_always_lock_free &&
              std::atomic<bool>::is_always_lock_free);

void wait_ms(int duration) noexcept {
  poll(nullptr, 0, duration);
}

}  // namespace

void watch(DeviceLink* link) noexcept {
  watched.store(link);
}

void stop_motors() noexcept {
  const pid_t self = gettid();
  pid_t first = 0;
  if (!stopper.compare_exchange_strong(first, self)) {
    // Whoever returns from here may end the process.
    if (first == self) return;
    for (int waited_ms = 0; !is_sent.load() && waited_ms < patience_ms; ++waited_ms) wait_ms(1);
    return;
  }
  if (DeviceLink* const link = watched.load()) {
    // A frame that was cut short would swallow the beginning of the next one, and a driver may be just about to send
    // one that it made before this: the second is whole and the last for certain.
    link->stop_at_once();
    wait_ms(1);
    link->stop_at_once();
  }
  is_sent.store(true);
}

bool is_ordered() noexcept {
  return stopper.load(std::memory_order_relaxed) != 0;
}

namespace {

// Of these the process does not end (refuse_to_be_stopped() is for some), or nobody can do anything about it.
constexpr std::array others{SIGCHLD, SIGCONT, SIGTSTP, SIGTTIN, SIGTTOU, SIGURG, SIGWINCH, SIGSTOP, SIGKILL};

extern "C" void on_deadly_signal(int signal) {
  const int error_before = errno;
  stop_motors();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
  // It has been blocked while it is handled. This ends the process, unless that is the system's first, which no signal
  // of its own ends.
  sigset_t own;
  sigemptyset(&own);
  sigaddset(&own, signal);
  pthread_sigmask(SIG_UNBLOCK, &own, nullptr);
  errno = error_before;
}

}  // namespace

void install_handlers() noexcept {
  static const AlternateStack of_this_thread;
  struct sigaction action {};
  action.sa_handler = on_deadly_signal;
  action.sa_flags = SA_ONSTACK;
  // A second signal waits until the first has been dealt with.
  sigfillset(&action.sa_mask);
  for (int signal = 1; signal <= SIGRTMAX; ++signal) {
    struct sigaction before {};
    // The C library keeps two for itself.
    if (std::ranges::count(others, signal) != 0 || sigaction(signal, nullptr, &before) != 0) continue;
    const bool ends_process = before.sa_handler == SIG_DFL || std::ranges::count(fault_signals, signal) != 0;
    if (ends_process) sigaction(signal, &action, nullptr);
  }
  // Whoever started this program may have had them blocked.
  sigset_t own;
  sigemptyset(&own);
  for (const int fault : fault_signals) sigaddset(&own, fault);
  pthread_sigmask(SIG_UNBLOCK, &own, nullptr);
  std::atexit(stop_motors);
}

void refuse_to_be_stopped() noexcept {
  for (const int signal : {SIGTSTP, SIGTTIN, SIGTTOU}) std::signal(signal, SIG_IGN);
}

}  // namespace ghostforce::emergency_stop
