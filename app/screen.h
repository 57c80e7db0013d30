// Screen: one frame of the whole picture, from a session and what the loop published: scene, panels and bars. The same
// in the window, in a PNG and in a test; it knows neither servo nor file.
#pragma once

#include <cstdint>

#include "app/paint/gl_painter.h"
#include "app/panels/panel.h"
#include "app/session.h"
#include "app/view/compose.h"
#include "app/view/history.h"
#include "app/window.h"

namespace ghostforce {

enum class Part : std::uint8_t {
  window,  // scene, panels and bars
  scene,   // the scene alone
};

struct ScreenOptions {
  Part part = Part::window;
  const Theme* theme = nullptr;
  float scale = 1.0F;  // UI scale on top of the display's own
};

class Screen {
 public:
  // Throws gl::ShaderError. The window must outlive the screen.
  Screen(Window& window, const ScreenOptions& options);

  // Draws and shows one frame; the panels edit the session. Nothing is drawn while the window has no pixels.
  void draw(Session& session, const Snapshot& snapshot, const History& history, const LoopReading& loop);

  // What the last frame showed, for the JSON painter and for tests.
  const Marks& marks() const noexcept { return marks_; }
  const Camera& camera() const noexcept { return camera_; }
  // Upper left corner of the scene in the window [points].
  ImVec2 scene_corner() const noexcept { return scene_corner_; }

 private:
  struct Layout;
  void draw_scene(Session& session, const Snapshot& snapshot, const History& history);
  void take_pointer(Session& session) const;

  Window& window_;
  ScreenOptions options_;
  GlPainter painter_;
  MeasureText measure_;
  float styled_scale_ = 0.0F;
  Marks marks_;
  Camera camera_;
  ImVec2 scene_corner_{0.0F, 0.0F};
};

}  // namespace ghostforce
