#include "app/paint/vector/vector_file_painter.h"

#include <cairo.h>
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>

#include "app/base/failure.h"
#include "app/files/png_writer.h"
#include "app/paint/vector/vector_painter.h"

namespace ghostforce {
namespace {

void require_painted(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw Failure(ExitCode::bug,
                fmt::format("Cairo cannot paint this picture ({}); try a smaller one", cairo_status_to_string(status)));
}

}  // namespace

Image paint_image(const std::vector<Pane>& panes, const Theme& theme, const Vector<2>& size, double text_scale,
                  double density) {
  const int width = static_cast<int>(std::lround(size.x * density));
  const int height = static_cast<int>(std::lround(size.y * density));
  const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), cairo_surface_destroy);
  require_painted(cairo_surface_status(surface.get()));
  {
    const std::unique_ptr<cairo_t, void (*)(cairo_t*)> target(cairo_create(surface.get()), cairo_destroy);
    cairo_scale(target.get(), density, density);
    paint_panes(panes, theme, size, text_scale, target.get());
    require_painted(cairo_status(target.get()));
  }
  cairo_surface_flush(surface.get());

  Image image{width, height, {}};
  const auto columns = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  image.rgb.reserve(3 * columns * rows);
  const unsigned char* const data = cairo_image_surface_get_data(surface.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      std::uint32_t pixel = 0;  // 0x__RRGGBB in the machine's order
      std::memcpy(&pixel, data + row * stride + 4 * column, sizeof pixel);
      for (const unsigned shift : {16U, 8U, 0U}) image.rgb.push_back(static_cast<std::uint8_t>(pixel >> shift));
    }
  }
  return image;
}

std::string paint_file(const FilePicture& picture, std::string_view path) {
  const auto& [panes, theme, size, text_scale, title, density] = picture;
  if (const auto format = vector_format_of(path)) return paint_vector(panes, theme, size, text_scale, *format, title);
  return png_bytes(paint_image(panes, theme, size, text_scale, density));
}

FilePainter cairo_file_painter() {
  const auto image = [](const FilePicture& picture) {
    return paint_image(picture.panes, picture.theme, picture.size, picture.text_scale, picture.density);
  };
  return {measure_vector_text, image, paint_file};
}

}  // namespace ghostforce
