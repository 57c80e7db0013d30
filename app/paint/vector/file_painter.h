// The painter of picture files that is Cairo's: SVG, PDF, and PNG without OpenGL. One thread at a time.
#pragma once

#include "app/paint/file_painter.h"

namespace ghostforce {

// See FilePainter. Throws what vector_painter.h and image_painter.h do.
std::string paint_file(const FilePicture& picture, std::string_view path);

FilePainter cairo_file_painter();

}  // namespace ghostforce
