// The clock of everything here that happens in real time: CLOCK_MONOTONIC, in ns. Any thread, signal handlers too.
#pragma once

#include <cstdint>
#include <ctime>

namespace ghostforce {

inline std::int64_t monotonic_ns() noexcept {
  std::timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

}  // namespace ghostforce
