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

constexpr int row_height = 64;
constexpr double edge_reach = 1.0;  // a smooth edge is half of this wide to either side [px]

// Below the one before, where both are as wide and in the same place.
void add_tile(const PixelTile& tile, std::vector<PixelTile>& tiles) {
  if (tile.width <= 0) return;
  if (!tiles.empty() && tiles.back().left == tile.left && tiles.back().width == tile.width &&
      tiles.back().top + tiles.back().height == tile.top) {
    tiles.back().height += tile.height;
  } else {
    tiles.push_back(tile);
  }
}

}  // namespace

HalfPlaneTiles half_plane_tiles(const Vector<2>& point, const Vector<2>& normal, int width, int height) {
  HalfPlaneTiles tiles;
  if (!std::isfinite(point.x + point.y + normal.x + normal.y)) return tiles;
  // An edge along the rows is taken for one that falls by a millionth of a pixel in a thousand.
  constexpr double least_slope = 1e-9;
  const double slope = std::abs(normal.x) < least_slope ? least_slope : normal.x;
  for (int top = 0; top < height; top += row_height) {
    const int bottom = std::min(top + row_height, height);
    const auto [nearest, farthest] = std::minmax({(top - point.y) * normal.y, (bottom - point.y) * normal.y});
    const double whole_at = point.x + (-edge_reach - farthest) / slope;
    const double outside_at = point.x + (edge_reach - nearest) / slope;
    const auto column = [width](double x) { return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(width))); };
    const auto add = [&](int first, int end, std::vector<PixelTile>& to) {
      add_tile({first, top, end - first, bottom - top}, to);
    };
    if (slope > 0.0) {
      const int whole_end = column(std::floor(whole_at));
      add(0, whole_end, tiles.whole);
      add(whole_end, column(std::ceil(outside_at)), tiles.edge);
    } else {
      const int whole_begin = column(std::ceil(whole_at));
      add(whole_begin, width, tiles.whole);
      add(column(std::floor(outside_at)), whole_begin, tiles.edge);
    }
  }
  return tiles;
}

}  // namespace ghostforce
