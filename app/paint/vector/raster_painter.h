// Paints a raster with Cairo: finely enough that it looks smooth in any program that shows the file, whatever that does
// between the pixels of a picture. One thread at a time.
#pragma once

#include <cairo.h>

#include "app/picture/marks.h"

namespace ghostforce {

// `corner` is its upper left [points].
void paint_raster(const Raster& raster, const Vector<2>& corner, cairo_t* target);

}  // namespace ghostforce
