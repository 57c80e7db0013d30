#include "device/spacemouse/spacemouse_input.h"

namespace ghostforce {

SpaceMouseInput::SpaceMouseInput(const SpaceMouseSettings& settings)
    : settings_(is_valid(settings) ? settings : SpaceMouseSettings{}) {}

bool SpaceMouseInput::set(const SpaceMouseSettings& settings) noexcept {
  if (!is_valid(settings)) return false;
  settings_.publish(settings);
  return true;
}

Vector<2> SpaceMouseInput::goal(std::int64_t /*tick*/, double rate) noexcept {
  return motion_.step(for_servo_.latest(), settings_.latest(), rate);
}

void SpaceMouseInput::publish(const SpaceMouseReading& reading) noexcept {
  for_servo_.publish(reading);
  for_window_.publish(reading);
}

}  // namespace ghostforce
