#include "tests/support/call_guard.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

namespace ghostforce {
namespace {

constexpr std::size_t most_calls = 1024;
std::array<std::atomic<bool>, most_calls> tried{};

extern "C" void remember_call(int /*signal*/, siginfo_t* info, void* /*context*/) {
  const auto number = static_cast<std::size_t>(info->si_syscall);
  tried[number < most_calls ? number : 0] = true;
}

}  // namespace

bool forbid_calls_but(std::span<const int> allowed) noexcept {
  struct sigaction action {};
  action.sa_sigaction = remember_call;
  action.sa_flags = static_cast<int>(SA_SIGINFO | SA_ONSTACK | SA_NODEFER);
  sigaction(SIGSYS, &action, nullptr);
  sigset_t trapped;
  sigemptyset(&trapped);
  sigaddset(&trapped, SIGSYS);
  pthread_sigmask(SIG_UNBLOCK, &trapped, nullptr);
  std::vector<sock_filter> filter{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
  for (const int call : allowed) {
    filter.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(call), 0, 1));
    filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  }
  // The way back from the handler.
  filter.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_rt_sigreturn, 0, 1));
  filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP));
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

std::vector<int> forbidden_calls() {
  std::vector<int> numbers;
  for (std::size_t i = 0; i < most_calls; ++i) {
    if (tried[i]) numbers.push_back(static_cast<int>(i));
  }
  return numbers;
}

}  // namespace ghostforce
