// A set-up value by value, so that two can be compared bit for bit; without the scene's title and about, which no line
// holds.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/state/set_up.h"
#include "tests/support/scene_values.h"

namespace ghostforce {

inline std::vector<std::string> set_up_values(SetUp set_up) {
  set_up.scene.title.clear();
  set_up.scene.about.clear();
  std::vector<std::string> values = scene_values(std::move(set_up.scene));
  values.push_back(fmt::format("goal: {:x} {:x}", std::bit_cast<std::uint64_t>(set_up.goal.x),
                               std::bit_cast<std::uint64_t>(set_up.goal.y)));
  values.emplace_back(face_name(set_up.face));
  values.emplace_back(stage_mode_name(set_up.mode));
  return values;
}

}  // namespace ghostforce
