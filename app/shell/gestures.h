// Gestures: what the mouse does in the scene. Drag: the goal follows, or the handle that was grabbed turns (in steps of
// 5°, with Ctrl without steps); during a circle test it ends that; wheel: zoom at the pointer; right drag: move the
// picture. Between ImGui's NewFrame and Render, UI thread.
#pragma once

#include <vector>

#include "app/paint/label_painter.h"
#include "app/picture/moment_history.h"
#include "app/picture/panes.h"
#include "app/state/action.h"
#include "app/widgets/pointing.h"

namespace ghostforce {

class Gestures {
 public:
  // Of the words in the scene.
  explicit Gestures(const LabelFonts& fonts) : fonts_(fonts) {}

  // To be called inside an ImGui window that covers the scene. `panes` are the ones that the person sees: those of the
  // last frame; none yet: nothing happens. `unit` is the size of a point in the scene. `moment`: what they show.
  void take(const Session& session, const ActionSink& apply, const std::vector<Pane>& panes, const Vector<2>& size,
            double unit, const ShownMoment& moment);

  // The handle under the pointer or in the hand.
  Handle hovered() const noexcept { return hovered_; }

 private:
  enum class Grip : std::uint8_t { nothing, goal, circle, handle, picture };

  void begin(const Session& session, const ActionSink& apply, const Settings& shown, const Pane& pane,
             const Vector<2>& pointer, double unit);
  void go_on(const Session& session, const ActionSink& apply, const Settings& shown, const Pane& pane,
             const Vector<2>& pointer, double unit);

  LabelFonts fonts_;
  Grip grip_ = Grip::nothing;
  Handle hovered_ = Handle::none;
  Handle held_ = Handle::none;
  StrategyId pane_ = StrategyId::full;  // in which the drag began
  Vector<2> began_at_{0.0};             // pointer in its pane [points]
  HeldAngle held_angle_;
  Vector<2> last_{0.0};  // pointer in its pane, a frame ago [points]
};

// Shows all that there is: goal, devices, proxies, trails and forces.
SceneView view_of_everything(const Session& session, const std::vector<Pane>& panes, const Vector<2>& size,
                             double unit);

}  // namespace ghostforce
