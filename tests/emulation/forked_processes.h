// ForkedProcesses: copies of this process that each do one thing, until they are done or this ends. They have nothing
// open, so that no device file outlives its own end. For the thread that makes them.
#pragma once

#include <cerrno>
#include <climits>
#include <csignal>
#include <system_error>
#include <vector>

#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ghostforce {

class ForkedProcesses {
 public:
  ForkedProcesses() = default;
  ForkedProcesses(const ForkedProcesses&) = delete;
  ForkedProcesses& operator=(const ForkedProcesses&) = delete;
  ~ForkedProcesses() {
    for (const pid_t process : processes_) kill(process, SIGKILL);
    for (const pid_t process : processes_) waitpid(process, nullptr, 0);
  }

  template <typename Work>
  void add(Work work) {
    const pid_t process = fork();
    if (process < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (process > 0) {
      processes_.push_back(process);
      return;
    }
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    syscall(SYS_close_range, 0U, UINT_MAX, 0U);
    work();
    _exit(0);
  }

 private:
  std::vector<pid_t> processes_;
};

// What such a process does that only takes processor time.
[[noreturn]] inline void keep_busy() {
  for (volatile unsigned turns = 0;;) turns = turns + 1;
}

}  // namespace ghostforce
