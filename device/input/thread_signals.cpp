#include "device/input/thread_signals.h"

#include <sys/mman.h>
#include <unistd.h>

namespace ghostforce {
namespace {

// What the handlers themselves need, with a sanitizer's share.
constexpr std::size_t room = 64 << 10;

// The kernel puts all registers there first, and how large these are the processor decides.
std::size_t size_of_whole_pages(std::size_t page) noexcept {
  const long registers = sysconf(_SC_MINSIGSTKSZ);
  const std::size_t size = room + (registers > 0 ? static_cast<std::size_t>(registers) : 0);
  return (size + page - 1) / page * page;
}

}  // namespace

// The lowest page may not be touched: a handler that needs more than there is must not write into somebody's memory.
AlternateStack::AlternateStack() noexcept
    : page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))),
      size_(size_of_whole_pages(page_)),
      memory_(mmap(nullptr, page_ + size_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_STACK, -1, 0)) {
  if (memory_ == MAP_FAILED) return;
  char* const lowest = static_cast<char*>(memory_) + page_;
  const stack_t stack{.ss_sp = lowest, .ss_flags = 0, .ss_size = size_};
  if (mprotect(lowest, size_, PROT_READ | PROT_WRITE) == 0 && sigaltstack(&stack, &before_) == 0) return;
  munmap(memory_, page_ + size_);
  memory_ = MAP_FAILED;
}

AlternateStack::~AlternateStack() {
  if (memory_ == MAP_FAILED) return;
  sigaltstack(&before_, nullptr);
  munmap(memory_, page_ + size_);
}

void leave_process_signals() noexcept {
  sigset_t blocked;
  sigfillset(&blocked);
  for (const int fault : fault_signals) sigdelset(&blocked, fault);
  sigdelset(&blocked, SIGXCPU);
  pthread_sigmask(SIG_SETMASK, &blocked, nullptr);
}

}  // namespace ghostforce
