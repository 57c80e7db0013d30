// Paints panes into an image in memory, through Cairo: pictures that need no window and no OpenGL, with the letters and
// the look of vector_painter.h. The same call gives the same image. One thread at a time.
#pragma once

#include <vector>

#include "app/files/image.h"
#include "app/view/panes.h"
#include "app/view/theme.h"

namespace ghostforce {

// `size` is the panes' rectangle [points], `density` pixels per point, `text_scale` turns a nominal text height into
// points. Throws Failure: file_trouble where the font cannot be read; bug where Cairo gives up, as at sizes beyond
// 32767 pixels.
Image paint_image(const std::vector<Pane>& panes, const Theme& theme, const Vector<2>& size, double text_scale,
                  double density);

}  // namespace ghostforce
