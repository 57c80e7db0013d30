// Whether tests may take hours: .ci/long says so. Else what is tried ten million times is tried a million times, and a
// sanitizer sees ten of the stored pictures.
#pragma once

#include <cstdlib>

namespace ghostforce {

inline bool is_long_run() {
  return std::getenv("GHOSTFORCE_LONG") != nullptr;
}

}  // namespace ghostforce
