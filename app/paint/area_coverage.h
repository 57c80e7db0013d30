// Which pixels of a picture a shape covers: an area within a closed curve, so that it can be painted in one go, with
// smooth edges and without seams, and a half plane. Pure, any thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/conventions.h"

namespace ghostforce {

// How much of each pixel a closed curve encloses, in a rectangle no larger than the curve's part in the picture.
struct AreaCoverage {
  int left = 0, top = 0, width = 0, height = 0;
  std::vector<std::uint8_t> shares;  // row by row from the upper left; 255 is all of the pixel
};

// `corners` in pixels from the picture's upper left corner, y down. Inside is what the curve encloses an odd number of
// times. Of a picture of `width` × `height`.
AreaCoverage area_coverage(std::span<const Vector<2>> corners, int width, int height);

// Pixels from the picture's upper left corner, y down.
struct PixelTile {
  int left = 0, top = 0, width = 0, height = 0;
};

// Where in a picture a half plane is all there, and where its edge runs: in software, to shade each pixel of a wall
// costs more than all that stands before it.
struct HalfPlaneTiles {
  std::vector<PixelTile> whole;
  std::vector<PixelTile> edge;
};

// `point` of the edge in pixels; the half plane is where its normal points away from [1]. Tiles do not overlap; what is
// in none is outside, a pixel at least from the edge.
HalfPlaneTiles half_plane_tiles(const Vector<2>& point, const Vector<2>& normal, int width, int height);

}  // namespace ghostforce
