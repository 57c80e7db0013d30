// What of a general scene a person can take hold of: the ends of its device and its walls. Pure, any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/settings.h"

namespace ghostforce {

enum class ScenePart : std::uint8_t {
  left_base,  // the arm's only one, too
  right_base,
  elbow,
  first_anchor,
  second_anchor,
  third_anchor,
  fourth_anchor,
  corner,  // where two walls meet
  first_wall,
  second_wall,
  circle_middle,
  circle_edge,
};

struct ScenePartEntry {
  ScenePart id;
  std::string_view name;  // in the lines of a session
  bool is_of_wall;        // else of the device
};
inline constexpr std::array scene_part_catalog{
    ScenePartEntry{ScenePart::left_base, "left-base", false},
    ScenePartEntry{ScenePart::right_base, "right-base", false},
    ScenePartEntry{ScenePart::elbow, "elbow", false},
    ScenePartEntry{ScenePart::first_anchor, "first-anchor", false},
    ScenePartEntry{ScenePart::second_anchor, "second-anchor", false},
    ScenePartEntry{ScenePart::third_anchor, "third-anchor", false},
    ScenePartEntry{ScenePart::fourth_anchor, "fourth-anchor", false},
    ScenePartEntry{ScenePart::corner, "corner", true},
    ScenePartEntry{ScenePart::first_wall, "first-wall", true},
    ScenePartEntry{ScenePart::second_wall, "second-wall", true},
    ScenePartEntry{ScenePart::circle_middle, "circle-middle", true},
    ScenePartEntry{ScenePart::circle_edge, "circle-edge", true},
};

constexpr bool is_of_wall(ScenePart part) noexcept {
  return scene_part_catalog[static_cast<std::size_t>(part)].is_of_wall;
}

struct PlacedPart {
  ScenePart part;
  Vector<2> at;         // [m]
  bool may_have_motor;  // a press puts the motor there, or takes it away
  bool stays = false;   // it follows the handle, and is moved with it alone
};

// Those that the scene has, with the handle there. Walls are held so far from their corner [m].
std::vector<PlacedPart> scene_parts(const Settings& settings, const Vector<2>& handle, double wall_reach);

// As near to there as a scene may have it, and a base no farther from the hand's `goal` than its links reach. Parts that it does not have, or that stay, change nothing.
Settings with_part_at(Settings settings, ScenePart part, const Vector<2>& to, const Vector<2>& goal) noexcept;

}  // namespace ghostforce
