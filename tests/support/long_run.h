// With GHOSTFORCE_LONG in the environment (.ci/long) some tests run in full: ten million ticks instead of one million, and
// all stored pictures under a sanitizer instead of ten.
#pragma once

#include <cstdlib>

namespace ghostforce {

inline bool is_long_run() {
  return std::getenv("GHOSTFORCE_LONG") != nullptr;
}

}  // namespace ghostforce
