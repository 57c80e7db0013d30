// A stack for signal handlers, beside the one of the thread: where a thread has used up its own, a handler has room
// nowhere else, and the process would end without emergency measures (device/falcon/emergency_stop.h). Each thread
// needs one itself; threads that others make get none from the thread that made them.
#pragma once

#include <csignal>
#include <cstddef>

namespace ghostforce {

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
