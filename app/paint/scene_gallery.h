// Small pictures of the scenes that the program brings along, each at rest at the end of its path, to choose one by: drawn
// once for each theme and size by the program's own layers and painter. On the thread that holds the context.
#pragma once

#include <string>
#include <vector>

#include "app/paint/picture_gallery.h"
#include "app/picture/theme.h"
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
  explicit SceneGallery(GlPainter& painter) noexcept : pictures_(painter) {}

  // OpenGL's name for the picture of a scene of shipped_scenes(), as PictureGallery has it. `scale`: of lines and marks, in pixels.
  unsigned int picture(std::size_t number, const Theme& theme, int width, int height, double scale);

 private:
  PictureGallery pictures_;
};

}  // namespace ghostforce
