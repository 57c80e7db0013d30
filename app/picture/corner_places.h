// What stands beside the scene, legend and scale bars, takes the first of a few places that covers no mark. It stays there
// as long as it covers none, however good another place becomes while things move. Pure; one thread.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/picture/label_placer.h"
#include "app/picture/picture_memory.h"

namespace ghostforce {

struct CornerPlace {
  std::size_t place;  // which of them
  double strength;    // 1: all there
};

// `places`: best first; they come in forms, the next of which is only used where there is no room for the one before, and
// each has as many places. Empty: there is room in none. Where it stands is kept clear of labels.
std::optional<CornerPlace> place_in_corner(const std::vector<ScreenBox>& places, std::size_t places_of_form,
                                           LabelPlacer& labels, CornerMemory& memory);

enum class Corner : std::uint8_t { upper_left, upper_right, lower_left, lower_right };
ScreenBox box_in_corner(Corner corner, const Vector<2>& extent, const Vector<2>& size, double margin);

}  // namespace ghostforce
