#include "app/paint/vector/raster_painter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

#include "app/paint/vector/letters.h"

namespace ghostforce {
namespace {

// Where a sample lies between the middles of two cells; beyond the outermost ones all is theirs.
struct Between {
  std::size_t before, after;
  double share;  // of the latter

  // `sample` of so many along a side of so many cells.
  Between(int sample, int samples, int cells) {
    const double place = std::clamp((sample + 0.5) / samples * cells - 0.5, 0.0, static_cast<double>(cells - 1));
    before = static_cast<std::size_t>(place);
    after = std::min(before + 1, static_cast<std::size_t>(cells - 1));
    share = place - std::floor(place);
  }
};

std::uint32_t colour_at(const Raster& raster, const Between& column, const Between& row) {
  const auto cell = [&](std::size_t x, std::size_t y) {
    return raster.cells[y * static_cast<std::size_t>(raster.columns) + x];
  };
  const auto blend = [&](auto channel) {
    const auto level = [&](std::size_t x, std::size_t y) { return static_cast<double>(cell(x, y).*channel); };
    const auto along = [&](std::size_t y) {
      return std::lerp(level(column.before, y), level(column.after, y), column.share);
    };
    return static_cast<std::uint32_t>(std::lerp(along(row.before), along(row.after), row.share) + 0.5);
  };
  return blend(&Colour::red) << 16U | blend(&Colour::green) << 8U | blend(&Colour::blue);
}

}  // namespace

void paint_raster(const Raster& raster, const Vector<2>& corner, cairo_t* target) {
  if (raster.cells.empty()) return;
  // One sample for a point. One more lies round them all, so that nothing shines through at the edge.
  const auto samples = [](double points) { return std::max(1, static_cast<int>(std::lround(points))); };
  const int across = samples(raster.size.x);
  const int down = samples(raster.size.y);
  std::vector<Between> columns;
  for (int x = -1; x <= across; ++x) columns.emplace_back(x, across, raster.columns);

  const std::unique_ptr<cairo_surface_t, Destroy<cairo_surface_destroy>> image(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, across + 2, down + 2));
  unsigned char* const data = cairo_image_surface_get_data(image.get());
  const int stride = cairo_image_surface_get_stride(image.get());
  for (int y = -1; data != nullptr && y <= down; ++y) {  // no memory: `target` will say so
    const Between row(y, down, raster.rows);
    unsigned char* pixel = data + (y + 1) * stride;
    for (const Between& column : columns) {
      const std::uint32_t colour = colour_at(raster, column, row);
      std::memcpy(pixel, &colour, sizeof colour);
      pixel += sizeof colour;
    }
  }
  cairo_surface_mark_dirty(image.get());

  cairo_save(target);
  cairo_rectangle(target, corner.x, corner.y, raster.size.x, raster.size.y);
  cairo_clip(target);
  cairo_translate(target, corner.x, corner.y);
  cairo_scale(target, raster.size.x / across, raster.size.y / down);
  cairo_set_source_surface(target, image.get(), -1.0, -1.0);
  cairo_pattern_set_filter(cairo_get_source(target), CAIRO_FILTER_BILINEAR);
  cairo_paint(target);
  cairo_restore(target);
}

}  // namespace ghostforce
