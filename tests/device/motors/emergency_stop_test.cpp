#include "device/motors/emergency_stop.h"

#include <csignal>

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ghostforce::emergency_stop_test {
namespace {

// Asked of the system itself: what becomes of a process that gets this signal and has never heard of it.
bool ends_a_process(int signal) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    std::signal(signal, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    raise(signal);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, WUNTRACED);
  if (WIFSTOPPED(status)) {
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    return false;
  }
  return WIFSIGNALED(status);
}

struct sigaction handler_of(int signal) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  return action;
}

TEST(EmergencyStop, ComesBeforeEverySignalThatEndsAProcess) {
  for (int signal = 1; signal <= SIGRTMAX; ++signal) {
    if (signal == SIGKILL || (signal > 31 && signal < SIGRTMIN)) continue;  // nobody's, and the C library's
    const bool is_deadly = ends_a_process(signal);
    const auto look = [&] {
      std::signal(signal, SIG_DFL);
      emergency_stop::install_handlers();
      const struct sigaction now = handler_of(signal);
      _exit((now.sa_handler != SIG_DFL) == is_deadly && (!is_deadly || (now.sa_flags & SA_ONSTACK) != 0) ? 0 : 1);
    };
    EXPECT_EXIT(look(), testing::ExitedWithCode(0), "") << "signal " << signal;
  }
}

// nohup, jobs in the background; and whoever handles a signal better.
TEST(EmergencyStop, LeavesSignalsAloneThatAreIgnoredOrHandled) {
  const auto look = [] {
    const auto handler = [](int) {};
    std::signal(SIGUSR1, SIG_IGN);
    std::signal(SIGUSR2, handler);
    emergency_stop::install_handlers();
    _exit(handler_of(SIGUSR1).sa_handler == SIG_IGN && handler_of(SIGUSR2).sa_handler == +handler ? 0 : 1);
  };
  EXPECT_EXIT(look(), testing::ExitedWithCode(0), "");
}

// A fault that is ignored or blocked ends a process all the same, only without asking it.
TEST(EmergencyStop, FaultsAreNeitherIgnoredNorBlocked) {
  const auto look = [] {
    std::signal(SIGSEGV, SIG_IGN);
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, nullptr);
    emergency_stop::install_handlers();
    sigset_t blocked;
    pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
    _exit(handler_of(SIGSEGV).sa_handler != SIG_IGN && sigismember(&blocked, SIGSEGV) == 0 &&
                  sigismember(&blocked, SIGUSR1) == 1
              ? 0
              : 1);
  };
  EXPECT_EXIT(look(), testing::ExitedWithCode(0), "");
}

TEST(EmergencyStop, TheProcessEndsAsItWouldHave) {
  const auto end = [] {
    emergency_stop::install_handlers();
    std::raise(SIGUSR1);
  };
  EXPECT_EXIT(end(), testing::KilledBySignal(SIGUSR1), "");
}

}  // namespace
}  // namespace ghostforce::emergency_stop_test
