// The painter of picture files that is Cairo's: SVG, PDF, and PNG without OpenGL, with the letters and the look of
// vector_painter.h. The same call gives the same bytes. One thread at a time.
#pragma once

#include "app/files/image.h"
#include "app/paint/file_painter.h"

namespace ghostforce {

// The panes as pixels in memory. `size` is the panes' rectangle [points], `density` pixels per point, `text_scale`
// turns a nominal text height into points. Throws Failure: file_trouble where the font cannot be read; bug where Cairo
// gives up, as at sizes beyond 32767 pixels.
Image paint_image(const std::vector<Pane>& panes, const Theme& theme, const Vector<2>& size, double text_scale,
                  double density);

// See FilePainter. Throws what paint_image() and vector_painter.h do.
std::string paint_file(const FilePicture& picture, std::string_view path);

FilePainter cairo_file_painter();

}  // namespace ghostforce
