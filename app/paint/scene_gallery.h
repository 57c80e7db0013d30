// Small pictures to choose something by, and those of the scenes that the program brings along. They are drawn once for
// each theme and size, by the program's own layers and painter. On the thread that holds the context.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/paint/gl_painter.h"
#include "app/picture/panes.h"
#include "app/picture/theme.h"
#include "core/scene.h"

namespace ghostforce {

// Pictures of anything that a pane can show.
class PictureGallery {
 public:
  explicit PictureGallery(GlPainter& painter) noexcept : painter_(painter) {}

  // OpenGL's name for one of `count` pictures, lowest row first; it stays good until another theme or size [px] is
  // asked for. `pane_of` makes each of them.
  unsigned int picture(std::size_t number, std::size_t count, const Theme& theme, int width, int height,
                       const std::function<Pane(std::size_t)>& pane_of);

 private:
  GlPainter& painter_;
  std::optional<Theme> theme_;  // of the pictures
  int width_ = 0;
  int height_ = 0;
  std::vector<gl::Texture> pictures_;  // all of them, or none yet
};

// Each scene at rest at the end of its path.
class SceneGallery {
 public:
  explicit SceneGallery(GlPainter& painter) noexcept : pictures_(painter) {}

  // OpenGL's name for the picture of a scene of shipped_scenes(), as PictureGallery has it. `scale`: of lines and
  // marks, in pixels.
  unsigned int picture(std::size_t number, const Theme& theme, int width, int height, double scale);

 private:
  PictureGallery pictures_;
};

}  // namespace ghostforce
