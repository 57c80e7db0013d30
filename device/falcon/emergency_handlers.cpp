#include "device/falcon/emergency_handlers.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>

#include "device/falcon/emergency_stop.h"
#include "device/input/thread_signals.h"

namespace ghostforce::emergency_stop {
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
