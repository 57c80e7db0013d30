#include "app/paint/vector/file_painter.h"

#include "app/files/png_file.h"
#include "app/paint/vector/image_painter.h"
#include "app/paint/vector/vector_painter.h"

namespace ghostforce {

std::string paint_file(const FilePicture& picture, std::string_view path) {
  const auto& [panes, theme, size, text_scale, title, density] = picture;
  if (const auto format = vector_format_of(path)) return paint_vector(panes, theme, size, text_scale, *format, title);
  return png_bytes(paint_image(panes, theme, size, text_scale, density));
}

FilePainter cairo_file_painter() {
  return {measure_vector_text, paint_file};
}

}  // namespace ghostforce
