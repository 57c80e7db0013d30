// Canvas: pixels in memory that are drawn on in place of a window's own. On the thread that holds the context.
#pragma once

#include "app/paint/handle.h"

namespace ghostforce::gl {

class Canvas {
 public:
  // What is drawn and read from here on is its pixels, transparent black at first. Throws Failure(wrong_call) where the
  // driver cannot draw that large.
  Canvas(int width, int height);

  int width() const noexcept { return width_; }  // [px]
  int height() const noexcept { return height_; }

 private:
  int width_;
  int height_;
  Framebuffer framebuffer_;
  Renderbuffer colours_;
};

}  // namespace ghostforce::gl
