// Small pictures to choose something by, drawn once for each theme and size. On the thread that holds the context.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "app/paint/gl_painter.h"
#include "app/picture/panes.h"
#include "app/picture/theme.h"

namespace ghostforce {

class PictureGallery {
 public:
  explicit PictureGallery(GlPainter& painter) noexcept : painter_(painter) {}

  // OpenGL's name for one of `count` pictures, lowest row first; it stays good until another theme or size [px] is asked
  // for. `pane_of` makes each of them.
  unsigned int picture(std::size_t number, std::size_t count, const Theme& theme, int width, int height,
                       const std::function<Pane(std::size_t)>& pane_of);

 private:
  GlPainter& painter_;
  const Theme* theme_ = nullptr;  // of the pictures
  int width_ = 0;
  int height_ = 0;
  std::vector<gl::Texture> pictures_;  // all of them, or none yet
};

}  // namespace ghostforce
