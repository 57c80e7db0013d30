// Paints panes into the window that is current: the marks with OpenGL, the words with the screen's font above them.
// Needs an ImGui frame and a current context.
#pragma once

#include <vector>

#include <imgui.h>

#include "app/paint/gl_painter.h"
#include "app/view/panes.h"
#include "app/view/theme.h"

namespace ghostforce {

class ScenePainter {
 public:
  // Throws gl::ShaderError.
  ScenePainter() = default;

  // Clears the whole target of `pixel_width` × `pixel_height`, then paints. `corner` is the upper left of the panes'
  // rectangle on the screen, `text_scale` turns a nominal text height into points.
  void paint(const std::vector<Pane>& panes, const Theme& theme, ImVec2 corner, double text_scale, int pixel_width,
             int pixel_height);

  GlPainter& gl() noexcept { return gl_; }

 private:
  GlPainter gl_;
};

}  // namespace ghostforce
