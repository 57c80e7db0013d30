// MotorGuard: a small process beside a program with motors, which sends zero force in its place when it cannot: killed,
// stopped, held by a debugger, starved of processor time, or hanging. The guard has the device's file open too, its memory
// locked and, where the system grants it, a real-time priority above the servo's; it shares a page of memory with the
// program (guard_memory.h).
//
// It is a program of its own, ghostforce-guard, beside the program that starts it or in ../libexec/ghostforce. Signals do
// not reach it through the terminal. What it cannot end: a force behind a dead wire, or on a machine that stands still.
//
// start() and end() allocate and wait; one thread. All else is a few loads and stores, on the thread that drives motors.
#pragma once

#include <cstdint>
#include <string>

#include "device/motors/guard_memory.h"

namespace ghostforce {

class MotorGuard {
 public:
  MotorGuard() = default;
  MotorGuard(const MotorGuard&) = delete;
  MotorGuard& operator=(const MotorGuard&) = delete;
  ~MotorGuard() { end(); }

  // Over the device of this file, which is open as `descriptor` and, on USB, has its interface claimed. Returns once the
  // guard watches. `may_push`: the device may push already. False: there is none, and motors must stay off.
  bool start(int descriptor, const std::string& node, const GuardOrders& orders, bool may_push) noexcept;
  // Returns when the guard has closed the device's file. `are_stopped`: the motors, as far as this program knows; else the
  // guard stops them first, as it would for a program that is gone.
  void end(bool are_stopped = true) noexcept;

  // The driver lives.
  void beat(std::int64_t now_ns) noexcept {
    if (page_ != nullptr) page_->beat_ns.store(now_ns, std::memory_order_release);
  }
  // Before the first force is sent, and once the device has answered a zero.
  void set_may_push(bool may_push, std::int64_t now_ns) noexcept {
    beat(now_ns);
    if (page_ != nullptr) page_->may_push.store(may_push, std::memory_order_release);
  }

  // Can be read once the guard's process has ended, for whoever polls; -1: there is none, or the system has no such thing.
  int descriptor() const noexcept { return has_gone_ ? -1 : process_file_; }
  // That can be read.
  void note_gone() noexcept { has_gone_ = true; }

  // There is a guard, and it has looked lately.
  bool is_watching(std::int64_t now_ns) const noexcept {
    return state() == GuardState::watching && !has_gone_ &&
           now_ns - page_->guard_beat_ns.load(std::memory_order_acquire) <= stale_ns;
  }
  GuardState state() const noexcept {
    return page_ == nullptr ? GuardState::none : page_->state.load(std::memory_order_acquire);
  }

 private:
  // An ordinary process beside many busy ones may have to wait for its turn [ns].
  static constexpr std::int64_t stale_ns = 250'000'000;

  bool spawn(int descriptor, const std::string& node, int page_descriptor) noexcept;
  bool wait_until_it_watches() noexcept;

  GuardMemory* page_ = nullptr;
  int lifeline_ = -1;  // a pipe that is never written to: its end tells the guard that this process has gone
  int process_ = -1;
  int process_file_ = -1;
  bool has_gone_ = false;
};

}  // namespace ghostforce
