// Readiness: what lies between a device in its box and one that pushes, step by step in the order in which they are
// reached. Plain values, so that a panel may show them; app/tools/doctor/readiness.h finds them out.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ghostforce {

enum class ReadinessStep : std::uint8_t {
  seen,
  allowed,
  free,
  firmware,
  homed,
  encoders_move,
  fast_enough,
  outside_wall,
  armed,
};

struct ReadinessStepState {
  ReadinessStep step = ReadinessStep::seen;
  std::string_view name;   // in JSON
  std::string_view title;  // on screen: what is so, or is still to come
  bool is_reached = false;
  bool is_current = false;  // the first that is not reached
  std::string words;        // whole sentences: what is so, and what to do; empty: its turn has not come
};

}  // namespace ghostforce
