#include "app/paint/area_coverage.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ghostforce {
namespace {

// Exact along a row, and by so many lines of it across.
constexpr int lines_per_row = 16;

// The least and greatest whole pixel from `least` to `greatest`, within the picture.
struct PixelRange {
  int first, end;

  PixelRange(double least, double greatest, int size)
      : first(static_cast<int>(std::clamp(std::floor(least), 0.0, static_cast<double>(size)))),
        end(static_cast<int>(std::clamp(std::ceil(greatest), 0.0, static_cast<double>(size)))) {}
  int count() const { return std::max(0, end - first); }
};

// Adds what a span covers of a row's pixels, as the change from pixel to pixel.
void add_span(double from, double to, std::vector<double>& changes) {
  const auto add_from = [&](double x, double sign) {
    const double pixel = std::floor(x);
    const auto i = static_cast<std::size_t>(pixel);
    changes[i] += sign * (1.0 - (x - pixel));
    changes[i + 1] += sign * (x - pixel);
  };
  add_from(from, 1.0);
  add_from(to, -1.0);
}

}  // namespace

AreaCoverage area_coverage(std::span<const Vector<2>> corners, int width, int height) {
  if (corners.empty()) return {};
  Vector<2> least = corners.front();
  Vector<2> most = corners.front();
  for (const Vector<2>& corner : corners) {
    least = glm::min(least, corner);
    most = glm::max(most, corner);
  }
  const PixelRange columns(least.x, most.x, width);
  const PixelRange rows(least.y, most.y, height);
  AreaCoverage result{columns.first, rows.first, columns.count(), rows.count(), {}};
  if (result.width == 0 || result.height == 0) return {};

  // Where the curve crosses each line.
  const int lines = result.height * lines_per_row;
  const auto height_of = [&](int line) { return rows.first + (line + 0.5) / lines_per_row; };
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(lines));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Vector<2> upper = corners[i];
    Vector<2> lower = corners[(i + 1) % corners.size()];
    if (upper.y > lower.y) std::swap(upper, lower);
    const auto line_below = [&](double y) {
      return static_cast<int>(
          std::clamp(std::ceil((y - rows.first) * lines_per_row - 0.5), 0.0, static_cast<double>(lines)));
    };
    for (int line = line_below(upper.y); line < line_below(lower.y); ++line) {
      const double x = upper.x + (lower.x - upper.x) * (height_of(line) - upper.y) / (lower.y - upper.y);
      crossings[static_cast<std::size_t>(line)].push_back(
          std::clamp(x - columns.first, 0.0, static_cast<double>(result.width)));
    }
  }

  result.shares.reserve(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height));
  std::vector<double> changes;
  for (int row = 0; row < result.height; ++row) {
    changes.assign(static_cast<std::size_t>(result.width) + 2, 0.0);
    for (int line = row * lines_per_row; line < (row + 1) * lines_per_row; ++line) {
      std::vector<double>& places = crossings[static_cast<std::size_t>(line)];
      std::ranges::sort(places);
      for (std::size_t i = 0; i + 1 < places.size(); i += 2) add_span(places[i], places[i + 1], changes);
    }
    double covered = 0.0;
    for (int column = 0; column < result.width; ++column) {
      covered += changes[static_cast<std::size_t>(column)];
      result.shares.push_back(static_cast<std::uint8_t>(std::clamp(covered * 255.0 / lines_per_row, 0.0, 255.0) + 0.5));
    }
  }
  return result;
}

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
