// SleepWatch: has the computer wait a moment before it sleeps. While that is wanted it holds a delay lock of logind
// (org.freedesktop.login1 on the system's D-Bus), and logind tells it before the computer sleeps and after. On a thread
// of its own. Where there is no such bus, no logind or no libsystemd to talk to them, nothing is delayed, and sleep is
// never said to be coming.
#pragma once

#include <atomic>
#include <thread>

#include "app/files/descriptor.h"

namespace ghostforce {

class SleepWatch {
 public:
  SleepWatch();
  ~SleepWatch();
  SleepWatch(const SleepWatch&) = delete;
  SleepWatch& operator=(const SleepWatch&) = delete;

  // The computer is about to sleep, or sleeps. Any thread.
  bool is_coming() const noexcept { return is_coming_; }

  // Whether the computer is to wait before it sleeps. It goes on as soon as this is false, at the latest when logind's
  // patience ends (5 s). Any one thread.
  void delay(bool is_wanted) noexcept;

 private:
  void watch() noexcept;

  Descriptor news_;  // something to read: one of these has changed
  std::atomic<bool> is_wanted_{false};
  std::atomic<bool> is_ending_{false};
  std::atomic<bool> is_coming_{false};
  std::thread thread_;  // last: it uses what stands above
};

}  // namespace ghostforce
