// Small pictures of the scenes that the program brings along, each at rest at the end of its path, to choose one by: drawn
// once for each theme and size by the program's own layers and painter. On the thread that holds the context.
#pragma once

#include <string>
#include <vector>

#include "app/paint/gl_painter.h"
#include "app/view/theme.h"
#include "core/scene.h"

namespace ghostforce {

struct ShippedScene {
  std::string name;
  Scene scene;
};

// By name, and where names end in numbers by these.
const std::vector<ShippedScene>& shipped_scenes();

class SceneGallery {
 public:
  explicit SceneGallery(GlPainter& painter) noexcept : painter_(painter) {}

  // OpenGL's name for the picture of a scene of shipped_scenes(), lowest row first; it stays good until another theme or
  // size is asked for. `scale`: of lines and marks, in pixels.
  unsigned int picture(std::size_t number, const Theme& theme, int width, int height, double scale);

 private:
  GlPainter& painter_;
  const Theme* theme_ = nullptr;  // of the pictures
  int width_ = 0;
  int height_ = 0;
  std::vector<gl::Texture> pictures_;  // as many as shipped_scenes(), or none yet
};

}  // namespace ghostforce
