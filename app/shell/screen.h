// Screen: one frame of the whole picture, from a session and what the loop published: scene, panels and bars. The same
// in the window, in a PNG and in a test; it knows neither servo nor file.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/paint/gl_painter.h"
#include "app/paint/scene_gallery.h"
#include "app/picture/label_placer.h"
#include "app/picture/moment_history.h"
#include "app/picture/panes.h"
#include "app/picture/trail_history.h"
#include "app/shell/audience_window.h"
#include "app/shell/keyboard.h"
#include "app/shell/window.h"
#include "app/shell/workbench.h"
#include "app/stage/hints.h"
#include "app/stage/stage_face.h"
#include "app/state/action.h"
#include "app/widgets/panel_context.h"

namespace ghostforce {

class Screen {
 public:
  // Throws gl::ShaderError. The window must outlive the screen.
  Screen(Window& window, Part part);

  // What was pressed since the last time. `apply` does it at once.
  void take_keys(const Session& session, const ActionSink& apply);

  // Draws and shows one frame, `interval_s` after the one before; what the person does goes to `apply`. Nothing is
  // drawn while the window has no pixels. `moment` is what the frame shows: at present, the session's own settings, so
  // that a change shows at once; while somebody looks back, those of that time.
  void draw(Session& session, const ActionSink& apply, const ShownMoment& moment, const History& history,
            const LoopReading& loop, double interval_s);

  // Time goes on, whether a frame is drawn or not.
  void advance(const Session& session, double interval_s) noexcept;
  // The next frame would show something else, though nothing that draw() is given has changed.
  bool is_moving(const Session& session) const noexcept;

  // From now on each frame shows the stage in that window, too; null: in none.
  void show_to(std::unique_ptr<AudienceWindow> audience);
  // Somebody has closed it.
  const AudienceWindow* audience() const noexcept { return audience_ ? audience_->window.get() : nullptr; }
  bool has_audience_left() const { return audience_ && audience_->window->should_close(); }

  // In the window's new OpenGL context; the one before has gone with all that was in it.
  void restart_drawing();

  // The same frame as a picture, `density` times as fine, without pointer, hints and dialogs. Throws Failure where the
  // graphics driver cannot make one that large.
  Image picture(const Session& session, const ShownMoment& moment, const History& history, const LoopReading& loop,
                Part part, int density);

  // What the last frame showed, for the JSON painter and for tests.
  const std::vector<Pane>& panes() const noexcept { return panes_; }
  // Upper left corner of the scene in the window [points].
  ImVec2 scene_corner() const noexcept { return scene_corner_; }
  // Of the scene in the window [points].
  Vector<2> scene_size() const noexcept { return scene_size_; }
  GlPainter& painter() noexcept { return drawing_->painter; }
  const StageFace& stage() const noexcept { return stage_; }

  // What the stage says of the moment, or would say if it were there instead of the workbench.
  StageReading stage_reading(const Session& session, const ShownMoment& moment, const History& history,
                             const LoopReading& loop) const;

  // The scene, or the stage, for a painter of files.
  std::vector<Pane> panes_for_file(const Session& session, const ShownMoment& moment, const History& history,
                                   const LoopReading& loop, const MeasureText& measure) const;

 private:
  // A frame that is not live is one for a file: without pointer and without anything that is for a person.
  struct Frame {
    Part part;
    bool is_live;
    double interval_s;
  };
  // What holds on to OpenGL.
  struct Drawing {
    explicit Drawing(const Fonts& fonts) : painter(fonts), gallery(painter), lessons(painter) {}

    GlPainter painter;
    SceneGallery gallery;
    PictureGallery lessons;
  };
  void draw_everything(Session& session, const ActionSink& apply, const ShownMoment& moment, const History& history,
                       const LoopReading& loop, const Frame& frame);
  struct Audience {
    std::unique_ptr<AudienceWindow> window;
    LabelMemory labels{};
  };
  void prepare_for_audience(const Session& session, const ShownMoment& moment, const History& history,
                            const LoopReading& loop, double interval_s);
  void draw_stage(Session& session, const PanelContext& context, const ShownMoment& moment, const History& history,
                  const Frame& frame);
  void apply_appearance(const Session& session);

  Window& window_;
  Part part_;
  Keyboard keyboard_;
  std::unique_ptr<Drawing> drawing_;
  MeasureText measure_;
  Workbench workbench_;
  Hints hints_;
  StageFace stage_;
  std::unique_ptr<Audience> audience_;  // null: there is none
  Theme styled_theme_{};
  double scale_ = 1.0;         // UI scale, with the display's
  float styled_scale_ = 0.0F;  // of Dear ImGui; over the stage it grows with the window
  std::vector<Pane> panes_;
  ImVec2 scene_corner_{0.0F, 0.0F};
  Vector<2> scene_size_{1.0};
};

}  // namespace ghostforce
