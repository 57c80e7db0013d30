#include "device/last_resort.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>

#include "device/falcon/falcon_link.h"
#include "device/falcon/frame.h"

namespace ghostforce::last_resort {
namespace {

std::atomic<FalconLink*> guarded{nullptr};
std::atomic<bool> taken{false};
static_assert(std::atomic<FalconLink*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

extern "C" void on_fatal_signal(int signal) {
  take();
  // SA_RESETHAND has put the default action back: this time it ends the process.
  std::raise(signal);
}

}  // namespace

void guard(FalconLink* link) noexcept {
  guarded.store(link);
}

void take() noexcept {
  if (taken.exchange(true)) return;
  FalconLink* const link = guarded.load();
  if (link == nullptr) return;
  // A frame that was cut short would swallow the beginning of the next one: the second is whole for certain.
  const FrameBytes zero = encode(CommandFrame{});
  for (int i = 0; i < 2; ++i) link->send_at_once(zero);
}

bool is_taken() noexcept {
  return taken.load(std::memory_order_relaxed);
}

void install() noexcept {
  struct sigaction action {};
  action.sa_handler = on_fatal_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
  sigemptyset(&action.sa_mask);
  for (const int signal : std::array{SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL}) sigaction(signal, &action, nullptr);
  // Jobs in the background have it ignored, and go on.
  struct sigaction before {};
  sigaction(SIGQUIT, nullptr, &before);
  if (before.sa_handler != SIG_IGN) sigaction(SIGQUIT, &action, nullptr);
  std::atexit(take);
}

}  // namespace ghostforce::last_resort
