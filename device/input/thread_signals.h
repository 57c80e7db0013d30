// What each thread of this program needs to be ready for signals: a separate stack for the handlers, and the process's
// signals left to other threads. Once per thread, at its start. Not while the servo ticks: both are system calls.
#pragma once

#include <array>
#include <csignal>
#include <cstddef>

namespace ghostforce {

// Signals that a thread causes itself. They end the process even if they are ignored or blocked.
inline constexpr std::array fault_signals{SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS};

// Leaves the signals that the process gets to other threads; the calling one keeps its own, which are faults and the
// end of its time as a real-time thread. If these were blocked, the kernel would end the process without asking.
void leave_process_signals() noexcept;

// A stack for signal handlers. If a thread has used up its own, a handler has no room anywhere else, and the process
// would end without an emergency stop (device/motors/emergency_stop.h). Threads that others make get none from the
// thread that made them.
//
// For the thread that makes it, which also must be the one to destroy it. If there is no memory for it, the thread
// continues without. Sizes in bytes.
class AlternateStack {
 public:
  AlternateStack() noexcept;
  ~AlternateStack();
  AlternateStack(const AlternateStack&) = delete;
  AlternateStack& operator=(const AlternateStack&) = delete;

 private:
  std::size_t page_;
  std::size_t size_;
  void* memory_;
  stack_t before_{};  // a sanitizer has one of its own, and wants it back
};

}  // namespace ghostforce
