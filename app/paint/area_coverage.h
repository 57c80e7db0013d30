// How much of each pixel a closed curve encloses: what an area needs to be painted in one go, with smooth edges and
// without seams. Pure, any thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/conventions.h"

namespace ghostforce {

// A rectangle of pixels, no larger than the curve's part in the picture.
struct AreaCoverage {
  int left = 0, top = 0, width = 0, height = 0;
  std::vector<std::uint8_t> shares;  // row by row from the upper left; 255 is all of the pixel
};

// `corners` in pixels from the picture's upper left corner, y down. Inside is what the curve encloses an odd number of
// times. Of a picture of `width` × `height`.
AreaCoverage area_coverage(std::span<const Vector<2>> corners, int width, int height);

}  // namespace ghostforce
