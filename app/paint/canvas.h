// Canvas: pixels in memory that are drawn on in place of a window's own. On the thread that holds the context.
#pragma once

#include "app/files/image.h"
#include "app/paint/handle.h"

namespace ghostforce::gl {

class Canvas {
 public:
  // What is drawn and read from here on is its pixels, transparent black at first. Throws Failure(wrong_call) where the
  // driver cannot draw that large.
  Canvas(int width, int height);

  int width() const noexcept { return width_; }  // [px]
  int height() const noexcept { return height_; }
  // What is drawn and read is its pixels again.
  void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name()); }

 private:
  int width_;
  int height_;
  Framebuffer framebuffer_;
  Renderbuffer colours_;
};

// What was drawn on the framebuffer that is bound, from its lower left corner [px].
Image pixels_drawn(int width, int height);

}  // namespace ghostforce::gl
