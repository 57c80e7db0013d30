#include "app/paint/half_plane_tiles.h"

#include <algorithm>
#include <cmath>

namespace ghostforce {
namespace {

constexpr int tile_side = 32;
constexpr double edge_reach = 1.0;  // a smooth edge is half of this wide to either side [px]

// Beside the one before, where that is of the same kind and in the same row.
void add_tile(const PixelTile& tile, std::vector<PixelTile>& tiles) {
  if (!tiles.empty() && tiles.back().top == tile.top && tiles.back().left + tiles.back().width == tile.left) {
    tiles.back().width += tile.width;
  } else {
    tiles.push_back(tile);
  }
}

}  // namespace

HalfPlaneTiles half_plane_tiles(const Vector<2>& point, const Vector<2>& normal, int width, int height) {
  HalfPlaneTiles tiles;
  for (int top = 0; top < height; top += tile_side) {
    for (int left = 0; left < width; left += tile_side) {
      const PixelTile tile{left, top, std::min(tile_side, width - left), std::min(tile_side, height - top)};
      const Vector<2> half = 0.5 * Vector<2>(tile.width, tile.height);
      const double distance = glm::dot(Vector<2>(left, top) + half - point, normal);
      const double reach = std::abs(normal.x) * half.x + std::abs(normal.y) * half.y + edge_reach;
      if (distance <= -reach) {
        add_tile(tile, tiles.whole);
      } else if (distance < reach) {
        add_tile(tile, tiles.edge);
      }
    }
  }
  return tiles;
}

}  // namespace ghostforce
