// The clock of everything here that happens in real time: CLOCK_MONOTONIC, in ns. Any thread, signal handlers too.
#pragma once

#include <cerrno>
#include <cstdint>
#include <ctime>

namespace ghostforce {

inline std::int64_t monotonic_ns() noexcept {
  std::timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

// Signals do not cut it short. Returns at once if the time has passed.
inline void sleep_until_monotonic(std::int64_t time_ns) noexcept {
  if (time_ns <= 0) return;
  std::timespec time{};
  time.tv_sec = static_cast<decltype(time.tv_sec)>(time_ns / 1'000'000'000);
  time.tv_nsec = static_cast<decltype(time.tv_nsec)>(time_ns % 1'000'000'000);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) == EINTR) {
  }
}

}  // namespace ghostforce
