// StagePointer: what the mouse does on the stage. Drag: the hand follows; the ends of the motor's rail and the wall's
// grips turn them (in steps of 5°, with Ctrl without steps); buttons; the wheel zooms, a right drag moves the picture;
// and what the mode has to take hold of. Between ImGui's NewFrame and Render, UI thread.
#pragma once

#include <optional>

#include <imgui.h>

#include "app/stage/stage.h"
#include "app/stage/stage_content.h"
#include "app/state/action.h"
#include "app/widgets/pointing.h"

namespace ghostforce {

class StagePointer {
 public:
  // `picture`: what the person sees, of the frame before.
  void update(const Session& session, const ActionSink& apply, const StageFrame& frame, const StagePicture& picture);

  StageGrip hovered_grip() const noexcept { return hovered_grip_; }
  const std::optional<StageAction>& hovered() const noexcept { return hovered_; }
  bool is_holding() const noexcept { return hold_ != Hold::nothing; }
  bool has_touched() const noexcept { return has_touched_; }  // in this frame

 private:
  enum class Hold : std::uint8_t {
    nothing,
    goal,
    motor,
    wall,
    picture,
    guess,
    landscape_ring,
    landscape_dial,
    ribbon,
    slider
  };
  struct Scene;

  static Hold hold_at(const Session& session, const Scene& scene, const Vector<2>& pointer);
  static bool may_hold(const Session& session, Hold hold);
  void press_by_key(const ActionSink& apply, const StageFrame& frame, const StagePicture& picture, ImVec2 corner);
  void begin(const Session& session, const ActionSink& apply, const StageFrame& frame, const Scene& scene,
             const Vector<2>& pointer);
  // What a drag to there does; empty: nothing.
  std::optional<Action> drag(const Session& session, const Scene& scene, const Vector<2>& pointer);

  Hold hold_ = Hold::nothing;
  StageGrip hovered_grip_ = StageGrip::none;
  std::optional<StageAction> hovered_;
  bool has_touched_ = false;
  HeldAngle held_angle_;
  Vector<2> last_{0.0};  // a frame ago [points]
};

}  // namespace ghostforce
