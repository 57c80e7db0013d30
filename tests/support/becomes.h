// Waits for what another thread or process does. Machines that run tests may be slow and busy; a good run never waits that
// long.
#pragma once

#include <chrono>
#include <functional>
#include <thread>

namespace ghostforce {

// False: it takes too long. `meanwhile` is called again and again.
inline bool becomes(const std::function<bool()>& as_wanted, const std::function<void()>& meanwhile = {}) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::minutes(4);
  while (!as_wanted()) {
    if (std::chrono::steady_clock::now() > until) return false;
    if (meanwhile) meanwhile();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

}  // namespace ghostforce
