// With GHOSTFORCE_LONG in the environment (.ci/long) some tests run in full: ten million ticks instead of one million, and
// under a sanitizer all stored pictures instead of ten, and monkeys for as long as without one.
#pragma once

#include <cstdlib>

namespace ghostforce {

inline bool is_long_run() {
  return std::getenv("GHOSTFORCE_LONG") != nullptr;
}

}  // namespace ghostforce
