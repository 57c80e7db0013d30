// What each thread of this program needs so that a signal finds it ready: a stack for the handlers, beside its own, and
// the process's signals left to others. Once per thread, at its beginning. Not while the servo ticks: both ask the
// system.
#pragma once

#include <array>
#include <csignal>
#include <cstddef>

namespace ghostforce {

// Of a thread's own doing. The process ends of them even where they are ignored or blocked.
inline constexpr std::array fault_signals{SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS};

// Leaves the signals that the process gets to other threads; the calling one keeps its own, which are faults and the
// end of its time as a real-time thread. Were these blocked, the kernel would end the process without asking.
void leave_process_signals() noexcept;

// A stack for signal handlers. Where a thread has used up its own, a handler has room nowhere else, and the process
// would end without an emergency stop (device/falcon/emergency_stop.h). Threads that others make get none from the
// thread that made them.
//
// For the thread that makes it, which also must be the one to destroy it. Where there is no memory for it the thread
// goes on without. Sizes in bytes.
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
