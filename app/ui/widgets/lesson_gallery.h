// Small pictures of the lessons that the program brings along, each of the stage in one of its steps. On the thread that
// holds the context.
#pragma once

#include "app/paint/picture_gallery.h"

namespace ghostforce {

class LessonGallery {
 public:
  explicit LessonGallery(GlPainter& painter) noexcept : pictures_(painter) {}

  // OpenGL's name for the picture of a lesson of shipped_lessons(), as PictureGallery has it. `scale`: of lines and marks,
  // in pixels.
  unsigned int picture(std::size_t number, const Theme& theme, int width, int height, double scale);

 private:
  PictureGallery pictures_;
};

}  // namespace ghostforce
