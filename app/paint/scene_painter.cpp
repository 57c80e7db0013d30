#include "app/paint/scene_painter.h"

#include <cmath>

#include "app/paint/label_painter.h"

namespace ghostforce {

void ScenePainter::paint(const std::vector<Pane>& panes, const Theme& theme, ImVec2 corner, double text_scale,
                         int pixel_width, int pixel_height) {
  const bool has_gaps = panes.size() > 1;
  // Between panes the target shows through.
  gl_.fill(has_gaps ? theme.panel_border : theme.background, {0, 0, pixel_width, pixel_height});
  const double density = static_cast<double>(ImGui::GetIO().DisplayFramebufferScale.x);
  const auto pixels = [density](double points) { return static_cast<int>(std::lround(points * density)); };
  for (const Pane& pane : panes) {
    const Vector<2> at = Vector<2>(static_cast<double>(corner.x), static_cast<double>(corner.y)) + pane.corner;
    const int left = pixels(at.x);
    const int top = pixels(at.y);
    const int right = pixels(at.x + pane.camera.size.x);
    const int bottom = pixels(at.y + pane.camera.size.y);
    const PixelRect rect{left, pixel_height - bottom, right - left, bottom - top};
    if (has_gaps) gl_.fill(theme.background, rect);
    gl_.paint(pane.marks, pane.camera, rect, density);
    paint_labels(pane.marks, pane.camera, {static_cast<float>(at.x), static_cast<float>(at.y)}, text_scale,
                 *ImGui::GetBackgroundDrawList());
  }
}

}  // namespace ghostforce
