#include "device/input/scripted_input.h"

#include "core/tick.h"

namespace ghostforce {

Vector<2> ScriptedInput::goal(std::int64_t tick, double rate) noexcept {
  return goal_at(path_, time_of(tick, rate));
}

}  // namespace ghostforce
