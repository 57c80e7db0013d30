// What can move the goal, as a person chooses it. Immutable, any thread.
#pragma once

#include <array>
#include <string_view>

namespace ghostforce {

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

}  // namespace ghostforce
