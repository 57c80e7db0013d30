#include "app/stage/stage_pointer.h"

#include <algorithm>

#include <imgui.h>

#include "app/picture/screen_box.h"
#include "app/stage/landscape_layout.h"
#include "app/stage/lesson_layout.h"
#include "app/state/lesson_guide.h"
#include "app/state/lesson_quantities.h"
#include "app/state/permit.h"
#include "app/state/stage_action.h"
#include "app/widgets/controls.h"
#include "app/widgets/focus.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

constexpr double hand_room = 30.0;  // of a fist round the goal [points of the design]

// In the last degree, where nobody sees it, the share falls from its greatest to none.
LandscapePoint ring_point_under(const LandscapeLayout& layout, const Vector<2>& pointer) {
  constexpr double last_angle = 89.0 / degrees_per_radian;
  LandscapePoint point = landscape_point_under(layout, pointer);
  point.angle = std::min(point.angle, last_angle);
  return point;
}

void press(const StageAction& button, const ActionSink& apply, const MotorReport& motors) {
  if (const std::optional<Action> action = action_of_button(button, motors)) apply(*action);
}

// With the focus, arrows are the slider's.
void nudge_by_key(const ActionSink& apply) {
  for (const Nudge& nudge : take_nudges()) {
    constexpr double everything = 1000.0;
    const double ends = nudge.way == Nudge::Way::to_least ? -everything : everything;
    apply(NudgeSlider{nudge.way == Nudge::Way::step ? nudge.steps : ends});
  }
}

// Only while the step has one.
std::optional<Action> action_of_slider(const Session& session, const StagePicture& picture, const Vector<2>& pointer) {
  const StageAction slider{StageCommand::slider};
  const auto button = std::ranges::find(picture.buttons, slider, &StageButton::action);
  if (button == picture.buttons.end()) return std::nullopt;
  const SliderTrack track = slider_track(button->box, picture.unit);
  const double share = (pointer.x - track.from.x) / (track.to.x - track.from.x);
  return MoveSliderTo{slider_value_at(*lesson_step(*session.lesson).slider, share)};
}

std::optional<StageAction> button_at(const StagePicture& picture, const Vector<2>& pointer) {
  // The menu lies over all others.
  const bool is_in_menu = picture.menu && contains(*picture.menu, pointer);
  const auto button = std::ranges::find_if(picture.buttons, [&](const StageButton& entry) {
    return contains(entry.box, pointer) && (!is_in_menu || contains(*picture.menu, entry.box.least));
  });
  return button == picture.buttons.end() ? std::nullopt : std::optional(button->action);
}

}  // namespace

struct StagePointer::Scene {
  const StagePicture& picture;

  Vector<2> world(const Vector<2>& pointer) const { return to_world(picture.pane.camera, pointer); }
  Vector<2> screen(const Vector<2>& world) const { return to_screen(picture.pane.camera, world); }
  // The outer pieces of the motor's rail, with what is at their ends.
  bool is_at_rail_end(const Vector<2>& pointer) const {
    const double reach = 0.7 * stage_grip_reach * picture.unit;
    if (!picture.motor_grips) return false;
    const std::array<Vector<2>, 2>& ends = *picture.motor_grips;
    const Vector<2> middle = 0.5 * (ends[0] + ends[1]);
    return std::ranges::any_of(ends, [&](const Vector<2>& end) {
      const double half = glm::distance(middle, end);
      const Vector<2> out = half > 0.0 ? (end - middle) / half : Vector<2>(1.0, 0.0);
      const Vector<2> from = end - out * std::min(55.0 * picture.unit, 0.5 * half);
      ScreenPiece piece{from, end + out * (18.0 * picture.unit), 0.0};
      return clip({pointer - Vector<2>(reach), pointer + Vector<2>(reach)}, piece);
    });
  }
  bool is_near(const Vector<2>& pointer, const Vector<2>& place, double reach) const {
    return glm::distance(pointer, place) <= reach * picture.unit;
  }
};

// What lies there, whether it may be held or not.
StagePointer::Hold StagePointer::hold_at(const Session& session, const Scene& scene, const Vector<2>& pointer) {
  const StagePicture& picture = scene.picture;
  if (session.stage.mode == StageMode::landscape && picture.landscape) {
    switch (landscape_handle_under(*picture.landscape, pointer)) {
      case LandscapeHandle::ring:
        return Hold::landscape_ring;
      case LandscapeHandle::dial:
        return Hold::landscape_dial;
      case LandscapeHandle::none:
        return Hold::nothing;
    }
  }
  if (picture.ribbon && contains(picture.ribbon->box, pointer)) return Hold::ribbon;
  if (session.stage.guess_is_open && session.stage.guess &&
      scene.is_near(pointer, scene.screen(*session.stage.guess), 1.5 * stage_grip_reach)) {
    return Hold::guess;
  }
  if (session.stage.mode == StageMode::why) return Hold::nothing;
  const auto is_at = [&](const std::array<Vector<2>, 2>& ends) {
    return std::ranges::any_of(ends,
                               [&](const Vector<2>& end) { return scene.is_near(pointer, end, stage_grip_reach); });
  };
  if (scene.is_at_rail_end(pointer)) return Hold::motor;
  if (picture.wall_grips && is_at(*picture.wall_grips)) return Hold::wall;
  // The hand before what it may have been dragged over.
  if (scene.is_near(pointer, scene.screen(session.goal), hand_room)) return Hold::goal;
  for (const StagePart& part : picture.parts) {
    if (!scene.is_near(pointer, part.place, stage_grip_reach)) continue;
    part_ = part;
    return Hold::part;
  }
  // Who has missed a joint there does not mean the hand.
  if (picture.inset && contains(*picture.inset, pointer)) return Hold::nothing;
  // Nor does who guesses, but for a hand that is not in the wall yet.
  const bool guesses = session.stage.guess_is_open && depth_in_wall(session.settings, session.goal) > 0.0;
  return session.stage.guess && guesses ? Hold::guess : Hold::goal;
}

// Wherever it is dragged to.
bool StagePointer::may_hold(const Session& session, Hold hold) const {
  const auto may = [&](const Action& action) { return !permit(session, action); };
  switch (hold) {
    case Hold::nothing:
      return false;
    case Hold::goal:
      return may(MoveHandTo{});
    case Hold::motor:
      return may(TurnMotorTo{});
    case Hold::wall:
      return may(TurnWallTo{});
    case Hold::part:
      return may(MovePart{part_.placed.part, part_.placed.at}) || (part_.placed.may_have_motor && may(SwitchMotor{}));
    case Hold::picture:
      return may(MoveView{});
    case Hold::guess:
      return may(MoveGuessTo{});
    case Hold::landscape_ring:
      return may(GoToLandscapePoint{});
    case Hold::landscape_dial:
      return may(TurnLandscapeDial{});
    case Hold::ribbon:
      return may(LookBackTo{});
    case Hold::slider:
      return may(MoveSliderTo{});
  }
  return false;
}

void StagePointer::update(const Session& session, const ActionSink& apply, const StageFrame& frame,
                          const StagePicture& picture) {
  ImGui::SetCursorPos({0.0F, 0.0F});
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("stage", imgui_vector(frame.size),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  const ImGuiIO& io = ImGui::GetIO();
  const bool is_held = is_dragged();
  const bool is_hovered = ImGui::IsItemHovered();
  const Vector<2> pointer = vector_of(io.MousePos) - vector_of(corner);
  const Scene scene{picture};
  has_touched_ = is_held || (is_hovered && (pointer != last_ || io.MouseWheel != 0.0F));
  if (session.drags_goal) apply(LetGoOfHand{});

  if (!is_held) {
    if (hold_ == Hold::part && !has_moved_part_ && part_.placed.may_have_motor) apply(SwitchMotor{});
    hold_ = Hold::nothing;
    hovered_.reset();
    hovered_grip_ = StageGrip::none;
    if (is_hovered) hovered_ = button_at(picture, pointer);
    const Hold hold = is_hovered && !hovered_ && !picture.menu ? hold_at(session, scene, pointer) : Hold::nothing;
    if (may_hold(session, hold)) {
      if (hold == Hold::motor) hovered_grip_ = StageGrip::motor;
      if (hold == Hold::wall) hovered_grip_ = StageGrip::wall;
      if (hold == Hold::part) hovered_grip_ = StageGrip::part;
      if (hold != Hold::goal) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    }
  }
  if (is_hovered && io.MouseWheel != 0.0F) {
    apply(ZoomView{zoom_factor(io.MouseWheel), ZoomView::Place{scene.world(pointer), session.settings.active}});
  }
  if (ImGui::IsItemActivated()) begin(session, apply, frame, scene, pointer);
  if (is_held) {
    // A key may have ended the mode that what is held belongs to, and a step of a lesson may not allow it any more.
    if (!may_hold(session, hold_)) hold_ = Hold::nothing;
    if (const std::optional<Action> action = drag(session, scene, pointer)) apply(*action);
  }
  last_ = pointer;
  press_by_key(apply, frame, picture, corner);
}

void StagePointer::begin(const Session& session, const ActionSink& apply, const StageFrame& frame, const Scene& scene,
                         const Vector<2>& pointer) {
  last_ = pointer;
  hold_ = Hold::nothing;
  if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) {
    hold_ = Hold::picture;
  } else if (session.stage.is_black) {
    apply(ToggleBlank{});
  } else if (const auto button = button_at(scene.picture, pointer)) {
    // Where the pointer is now: who is quick comes and presses within one frame.
    hovered_ = button;
    if (button == StageAction(StageCommand::slider)) hold_ = Hold::slider;
    press(*button, apply, frame.loop.motors);
  } else if (const auto& menu = scene.picture.menu) {
    // Whoever wants to be rid of it does not mean to move the hand.
    if (!contains(*menu, pointer)) apply(ToggleMenu{});
  } else {
    hold_ = hold_at(session, scene, pointer);
    if (hold_ == Hold::motor) begin_to_turn_motor(session, scene, pointer);
    if (hold_ == Hold::wall) begin_to_turn_wall(session, pointer);
    pressed_at_ = pointer;
    has_moved_part_ = false;
  }
}

// What is held stays as far beside the pointer as it was when it was taken hold of, so that nothing jumps and the rail
// goes through there, however near to the pivot that was. The handle moves as its motor is turned: were the pivot to move
// with it, the rail would turn on by itself.
void StagePointer::begin_to_turn_motor(const Session& session, const Scene& scene, const Vector<2>& pointer) {
  pivot_ = scene.picture.pivot;
  const double angle = session.settings.actuated_angle;
  const Vector<2> along = to_screen_direction(direction_at(angle));
  const Vector<2> across{-along.y, along.x};
  const double reach = stage_grip_reach * scene.picture.unit;
  beside_rail_ = std::clamp(glm::dot(pointer - scene.screen(pivot_), across), -reach, reach) * across;
  held_angle_.begin(pointer - beside_rail_, angle);
}

void StagePointer::begin_to_turn_wall(const Session& session, const Vector<2>& pointer) {
  pivot_ = session.settings.wall_point;
  beside_rail_ = Vector<2>(0.0);
  held_angle_.begin(pointer, session.settings.wall_normal_angle);
}

// Each button once more, for the keyboard: the pointer belongs to the whole stage, which comes first.
void StagePointer::press_by_key(const ActionSink& apply, const StageFrame& frame, const StagePicture& picture,
                                ImVec2 corner) {
  for (auto each = picture.buttons.begin(); each != picture.buttons.end(); ++each) {
    const StageButton& button = *each;
    // What can be asked for in two places is one stop.
    if (std::ranges::find(picture.buttons, button.action, &StageButton::action) != each) continue;
    const Vector<2> least = vector_of(corner) + button.box.least;
    const Vector<2> size = glm::max(button.box.extent(), Vector<2>(1.0));
    ImGui::SetCursorScreenPos(imgui_vector(least));
    ImGui::PushID(static_cast<int>(button.action.index()));
    ImGui::PushID(std::visit([](auto action) { return static_cast<int>(action); }, button.action));
    if (ImGui::InvisibleButton("button", imgui_vector(size), ImGuiButtonFlags_EnableNav)) {
      press(button.action, apply, frame.loop.motors);
    }
    // What has the focus is explained as what is under the pointer is.
    if (ImGui::GetIO().NavVisible && ImGui::IsItemFocused()) hovered_ = button.action;
    if (button.action == StageAction(StageCommand::slider)) nudge_by_key(apply);
    ImGui::PopID();
    ImGui::PopID();
  }
}

std::optional<Action> StagePointer::drag(const Session& session, const Scene& scene, const Vector<2>& pointer) {
  const StagePicture& picture = scene.picture;
  // The hand stays where it can be seen.
  const ScreenBox box = picture.reach.grown(-hand_room * picture.unit);
  const Vector<2> inside = glm::clamp(pointer, box.least, glm::max(box.least, box.most));
  const auto turned = [&] {
    return held_angle_.turned(scene.screen(pivot_), pointer - beside_rail_, 1.0, ImGui::GetIO().KeyCtrl);
  };
  switch (hold_) {
    case Hold::nothing:
      break;
    case Hold::goal:
      return MoveHandTo{scene.world(inside)};
    case Hold::guess:
      return MoveGuessTo{scene.world(inside)};
    case Hold::motor:
      if (const auto angle = turned()) return TurnMotorTo{*angle};
      break;
    case Hold::wall:
      if (const auto angle = turned()) return TurnWallTo{*angle};
      break;
    case Hold::part:
      has_moved_part_ = has_moved_part_ || glm::distance(pointer, pressed_at_) > HeldAngle::first_turn * picture.unit;
      if (has_moved_part_ && !part_.placed.stays) {
        return MovePart{part_.placed.part,
                        part_.placed.at + to_screen_direction(pointer - pressed_at_) / part_.points_per_metre};
      }
      break;
    case Hold::picture:
      return MoveView{-to_screen_direction(pointer - last_) / picture.pane.camera.points_per_metre};
    case Hold::landscape_ring:
      if (picture.landscape) return GoToLandscapePoint{ring_point_under(*picture.landscape, pointer)};
      break;
    case Hold::landscape_dial:
      if (picture.landscape) return TurnLandscapeDial{dial_under(*picture.landscape, pointer)};
      break;
    case Hold::slider:
      return action_of_slider(session, picture, pointer);
    case Hold::ribbon:
      if (picture.ribbon) return LookBackTo{picture.ribbon->axis.time_at(pointer.x)};
      break;
  }
  return std::nullopt;
}

}  // namespace ghostforce
