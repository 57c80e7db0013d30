#include "device/input/thread_signals.h"

#include <csignal>
#include <cstdint>
#include <thread>

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

namespace ghostforce::thread_signals_test {
namespace {

stack_t stack_in_use() {
  stack_t stack{};
  sigaltstack(nullptr, &stack);
  return stack;
}

std::uintptr_t address_in_handler = 0;

TEST(AlternateStack, IsWhereHandlersRunWhileItLasts) {
  std::thread([] {
    const stack_t before = stack_in_use();
    {
      const AlternateStack alternate_stack;
      const stack_t now = stack_in_use();
      ASSERT_EQ(now.ss_flags & SS_DISABLE, 0);
      EXPECT_GT(now.ss_size, static_cast<std::size_t>(sysconf(_SC_MINSIGSTKSZ)));
      struct sigaction action {};
      struct sigaction old {};
      action.sa_handler = [](int) {
        address_in_handler = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
      };
      action.sa_flags = SA_ONSTACK;
      sigaction(SIGURG, &action, &old);
      pthread_kill(pthread_self(), SIGURG);
      sigaction(SIGURG, &old, nullptr);
      const auto lowest = reinterpret_cast<std::uintptr_t>(now.ss_sp);
      EXPECT_GT(address_in_handler, lowest);
      EXPECT_LT(address_in_handler, lowest + now.ss_size);
    }
    EXPECT_EQ(stack_in_use().ss_flags, before.ss_flags);
    EXPECT_EQ(stack_in_use().ss_sp, before.ss_sp);
  }).join();
}

// A handler that needs more than there is ends the process, rather than write into somebody's memory.
TEST(AlternateStack, HasAPageBelowThatNobodyMayTouch) {
  const auto touch = [] {
    std::signal(SIGSEGV, SIG_DFL);  // not a sanitizer's
    const AlternateStack alternate_stack;
    *(static_cast<volatile char*>(stack_in_use().ss_sp) - 1) = 1;
  };
  EXPECT_EXIT(touch(), testing::KilledBySignal(SIGSEGV), "");
}

}  // namespace
}  // namespace ghostforce::thread_signals_test
