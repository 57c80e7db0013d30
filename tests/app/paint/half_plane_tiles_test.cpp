// Where in a picture a half plane is all there, where its edge runs, and where there is nothing of it.
#include "app/paint/area_coverage.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace ghostforce::half_plane_tiles_test {
namespace {

constexpr int width = 205;
constexpr int height = 131;

// How many tiles hold each pixel.
std::vector<int> counts(const std::vector<PixelTile>& tiles) {
  std::vector<int> of(static_cast<std::size_t>(width) * height);
  for (const PixelTile& tile : tiles) {
    EXPECT_GE(tile.left, 0);
    EXPECT_LE(tile.left + tile.width, width);
    EXPECT_GE(tile.top, 0);
    EXPECT_LE(tile.top + tile.height, height);
    for (int y = tile.top; y < tile.top + tile.height; ++y) {
      for (int x = tile.left; x < tile.left + tile.width; ++x) ++of[static_cast<std::size_t>(y * width + x)];
    }
  }
  return of;
}

TEST(HalfPlaneTiles, HoldEachPixelInItsPlace) {
  std::vector<Vector<2>> normals{{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}, {1e-7, 1.0}, {-1e-12, -1.0}};
  for (double angle = 0.0; angle < 6.3; angle += 0.13) normals.emplace_back(std::cos(angle), std::sin(angle));
  for (const Vector<2>& point : {Vector<2>(100.0, 60.0), Vector<2>(32.0, 64.0), Vector<2>(-300.0, 500.0)}) {
    for (const Vector<2>& normal : normals) {
      const HalfPlaneTiles tiles = half_plane_tiles(point, normal, width, height);
      const std::vector<int> whole = counts(tiles.whole);
      const std::vector<int> edge = counts(tiles.edge);
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const std::size_t i = static_cast<std::size_t>(y * width + x);
          ASSERT_LE(whole[i] + edge[i], 1);
          const double distance = glm::dot(Vector<2>(x + 0.5, y + 0.5) - point, normal);
          if (whole[i] == 1) {
            ASSERT_LE(distance, -1.0);
          }
          if (whole[i] + edge[i] == 0) {
            ASSERT_GE(distance, 1.0);
          }
        }
      }
    }
  }
}

TEST(HalfPlaneTiles, AreFewAndTheEdgeIsASmallPart) {
  const HalfPlaneTiles tiles = half_plane_tiles({640.0, 360.0}, {std::sqrt(0.5), -std::sqrt(0.5)}, 1280, 720);
  EXPECT_LE(tiles.whole.size() + tiles.edge.size(), 24U);
  int pixels = 0;
  for (const PixelTile& tile : tiles.edge) pixels += tile.width * tile.height;
  EXPECT_LT(pixels, 1280 * 720 / 8);
}

TEST(HalfPlaneTiles, OfAnEmptyPictureThereAreNone) {
  const HalfPlaneTiles tiles = half_plane_tiles({0.0, 0.0}, {1.0, 0.0}, 0, 0);
  EXPECT_TRUE(tiles.whole.empty());
  EXPECT_TRUE(tiles.edge.empty());
}

}  // namespace
}  // namespace ghostforce::half_plane_tiles_test
