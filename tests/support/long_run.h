// With GHOSTFORCE_LONG in the environment (.ci/long) some tests run in full: ten million ticks instead of one million, a
// thousand random set-ups instead of a quarter of that, and under a sanitizer all stored pictures instead of ten, and as
// many trials as without one.
#pragma once

#include <cstdlib>

#include "tests/support/sanitized.h"

namespace ghostforce {

inline bool is_long_run() {
  return std::getenv("GHOSTFORCE_LONG") != nullptr;
}

// How many of `all` alike trials a test makes: a fifth under a sanitizer, which takes some five times as long for each,
// except in a long run.
inline int trials(int all) {
#ifdef GHOSTFORCE_SANITIZED
  if (!is_long_run()) return all / 5;
#endif
  return all;
}

}  // namespace ghostforce
