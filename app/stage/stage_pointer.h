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

  std::optional<ScenePart> hovered_part() const noexcept {
    return hovered_grip_ == StageGrip::part ? std::optional(part_.placed.part) : std::nullopt;
  }
  StageGrip hovered_grip() const noexcept { return hovered_grip_; }
  const std::optional<StageAction>& hovered() const noexcept { return hovered_; }
  std::optional<HeldEnd> held_end() const noexcept {
    if (hold_ == Hold::motor) return HeldEnd{StageGrip::motor, last_ - beside_rail_};
    if (hold_ == Hold::wall) return HeldEnd{StageGrip::wall, last_};
    return hold_ == Hold::part ? std::optional(HeldEnd{StageGrip::part, last_}) : std::nullopt;
  }
  bool is_holding() const noexcept { return hold_ != Hold::nothing; }
  bool has_touched() const noexcept { return has_touched_; }  // in this frame

 private:
  enum class Hold : std::uint8_t {
    nothing,
    goal,
    motor,
    wall,
    part,
    picture,
    guess,
    landscape_ring,
    landscape_dial,
    ribbon,
    slider
  };
  struct Scene;

  Hold hold_at(const Session& session, const Scene& scene, const Vector<2>& pointer);
  bool may_hold(const Session& session, Hold hold) const;
  void press_by_key(const ActionSink& apply, const StageFrame& frame, const StagePicture& picture, ImVec2 corner);
  void begin(const Session& session, const ActionSink& apply, const StageFrame& frame, const Scene& scene,
             const Vector<2>& pointer);
  void begin_to_turn_motor(const Session& session, const Scene& scene, const Vector<2>& pointer);
  void begin_to_turn_wall(const Session& session, const Vector<2>& pointer);
  // What a drag to there does; empty: nothing.
  std::optional<Action> drag(const Session& session, const Scene& scene, const Vector<2>& pointer);

  Hold hold_ = Hold::nothing;
  StageGrip hovered_grip_ = StageGrip::none;
  std::optional<StageAction> hovered_;
  bool has_touched_ = false;
  HeldAngle held_angle_;
  StagePart part_{};             // under the pointer, or held
  Vector<2> pressed_at_{0.0};    // where it was taken hold of [points]
  bool has_moved_part_ = false;  // since then
  Vector<2> pivot_{0.0};         // that what is held turns about, where it was when it was taken hold of [m]
  Vector<2> beside_rail_{0.0};   // from what is held to the pointer [points]
  Vector<2> last_{0.0};          // a frame ago [points]
};

}  // namespace ghostforce
