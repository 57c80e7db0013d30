// BeliefSource: where the k_u comes from that the renderer believes in. Part of the session.
#pragma once

#include <cstdint>

#include "core/settings.h"

namespace ghostforce {

enum class BeliefSource : std::uint8_t {
  typed,     // a person has set it, or it is the same as the hand's
  measured,  // by the guided measurement, or once on the stage
  live,      // tones on the motor measure the hand, and the belief follows: the servo alone changes it
};

// Which part of it is the person's own choice: a belief that follows the hand, and so changes by itself, is none.
inline Settings chosen_settings(Settings settings, BeliefSource source) noexcept {
  if (source == BeliefSource::live) settings.stiffnesses.believed_k_u.reset();
  return settings;
}

}  // namespace ghostforce
