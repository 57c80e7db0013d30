// What panels show of inputs: what can move the goal, as a person chooses it, and how far a device is from pushing.
// Plain values, any thread.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace ghostforce {

// Something that can move the goal.
struct InputChoice {
  std::string_view name;      // on the command line
  std::string_view title;     // on screen
  std::string_view sentence;  // what it does, for a person who hovers over it
};

// Those that the window asks for by itself, or must not leave a lesson to, and the hand of every picture that is made
// without a person.
inline constexpr InputChoice mouse_hand{"mouse", "Mouse", "Drag in the scene: the goal follows the pointer."};
inline constexpr InputChoice circling_hand{"circle", "Circle",
                                           "The goal moves in a circle inside the wall, as in the circle test."};
inline constexpr InputChoice scripted_hand{"script", "Scripted hand",
                                           "The goal follows the scene's path, the same way every time."};
inline constexpr InputChoice replayed_hand{"replay", "Replay",
                                           "The goal follows the hand of a recording, the same way every time."};

// They wait for nobody: no lesson can be done with them, and no visitor has a part in them.
inline constexpr std::array hands_moving_by_themselves{scripted_hand, circling_hand, replayed_hand};

// What lies between a device in its box and one that pushes, in the order in which the steps are reached.
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

// How a step stands, as app/tools/doctor/readiness.h finds it out.
struct ReadinessStepState {
  ReadinessStep step = ReadinessStep::seen;
  std::string_view name;   // in JSON
  std::string_view title;  // on screen: what is so, or is still to come
  bool is_reached = false;
  bool is_current = false;  // the first that is not reached
  std::string words;        // whole sentences: what is so, and what to do; empty: its turn has not come
};

}  // namespace ghostforce
