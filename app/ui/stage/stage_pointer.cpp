#include "app/ui/stage/stage_pointer.h"

#include <algorithm>

#include <imgui.h>

#include "app/lessons/lesson_slider.h"
#include "app/session/lesson_guide.h"
#include "app/session/scene_view_limits.h"
#include "app/session/stage_buttons.h"
#include "app/ui/widgets/focus.h"
#include "app/view/screen_box.h"
#include "app/view/stage/landscape_layout.h"
#include "app/view/stage/lesson_layout.h"

namespace ghostforce {
namespace {

constexpr double hand_room = 30.0;  // of a fist round the goal [points of the design]

// The ring is at a wall and at a stiffness.
bool may_change_landscape(const Session& session) {
  return is_allowed(session, LessonControl::wall);
}

void press(const StageAction& button, const ActionSink& apply, const MotorReport& motors) {
  if (const std::optional<Action> action = action_of_button(button, motors)) apply(*action);
}

std::optional<StageAction> button_at(const StagePicture& picture, const Vector<2>& pointer) {
  const auto button =
      std::ranges::find_if(picture.buttons, [&](const StageButton& entry) { return contains(entry.box, pointer); });
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

StagePointer::Hold StagePointer::hold_at(const Session& session, const Scene& scene, const Vector<2>& pointer) const {
  const StagePicture& picture = scene.picture;
  if (session.stage.mode == StageMode::landscape && picture.landscape) {
    switch (landscape_handle_under(*picture.landscape, pointer)) {
      case LandscapeHandle::ring:
        return may_change_landscape(session) ? Hold::landscape_ring : Hold::nothing;
      case LandscapeHandle::dial:
        // With every motor there is none.
        return session.settings.active == StrategyId::full || !is_allowed(session, LessonControl::strategies)
                   ? Hold::nothing
                   : Hold::landscape_dial;
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
  const bool may_drag = session.pointer_moves_goal && is_allowed(session, LessonControl::hand);
  return may_drag ? Hold::goal : Hold::nothing;
}

void StagePointer::update(Session& session, const ActionSink& apply, const StageFrame& frame,
                          const StagePicture& picture) {
  ImGui::SetCursorPos({0.0F, 0.0F});
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("stage", {static_cast<float>(frame.size.x), static_cast<float>(frame.size.y)},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  const ImGuiIO& io = ImGui::GetIO();
  const bool is_held = ImGui::IsItemActive();
  const bool is_hovered = ImGui::IsItemHovered();
  const Vector<2> pointer = vector_of(io.MousePos) - vector_of(corner);
  const Scene scene{picture};
  has_touched_ = is_held || (is_hovered && (pointer != last_ || io.MouseWheel != 0.0F));
  session.drags_goal = false;

  if (!is_held) {
    hold_ = Hold::nothing;
    hovered_.reset();
    hovered_grip_ = StageGrip::none;
    if (is_hovered) {
      hovered_ = button_at(picture, pointer);
      if (!hovered_) {
        const Hold hold = hold_at(session, scene, pointer);
        if (hold == Hold::motor) hovered_grip_ = StageGrip::motor;
        if (hold == Hold::wall) hovered_grip_ = StageGrip::wall;
        if (hold != Hold::nothing && hold != Hold::goal) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
      }
    }
  }
  // What a visitor has moved away would be lost for the next one.
  const bool has_own_view =
      session.stage.mode == StageMode::landscape || session.stage.mode == StageMode::round || session.visit;
  if (is_hovered && io.MouseWheel != 0.0F && !has_own_view) {
    session.stage_shown = zoomed(session.stage_shown, zoom_factor(io.MouseWheel), scene.world(pointer));
  }
  if (ImGui::IsItemActivated()) {
    last_ = pointer;
    hold_ = Hold::nothing;
    if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) {
      if (!has_own_view) hold_ = Hold::picture;
    } else if (session.stage.is_black) {
      session.stage.is_black = false;
    } else if (const auto action = button_at(picture, pointer)) {
      // Where the pointer is now: who is quick comes and presses within one frame.
      hovered_ = action;
      if (action == StageAction(StageCommand::slider)) hold_ = Hold::slider;
      press(*action, apply, frame.loop.motors);
    } else {
      hold_ = hold_at(session, scene, pointer);
      if (hold_ == Hold::motor) held_angle_.begin(pointer, session.settings.actuated_angle);
      if (hold_ == Hold::wall) held_angle_.begin(pointer, session.settings.wall_normal_angle);
    }
  }
  if (is_held) drag(session, scene, pointer);
  last_ = pointer;
  press_by_key(session, apply, frame, picture, corner);
}

// With the focus, arrows are the slider's.
void StagePointer::nudge_by_key(Session& session) {
  for (const Nudge& nudge : take_nudges()) {
    constexpr double everything = 1000.0;
    const double ends = nudge.way == Nudge::Way::to_least ? -everything : everything;
    nudge_lesson_slider(session, nudge.way == Nudge::Way::step ? nudge.steps : ends);
  }
}

// Each button once more, for the keyboard: the pointer belongs to the whole stage, which comes first.
void StagePointer::press_by_key(Session& session, const ActionSink& apply, const StageFrame& frame,
                                const StagePicture& picture, ImVec2 corner) {
  for (auto each = picture.buttons.begin(); each != picture.buttons.end(); ++each) {
    const StageButton& button = *each;
    // What can be asked for in two places is one stop.
    if (std::ranges::find(picture.buttons, button.action, &StageButton::action) != each) continue;
    const Vector<2> least = vector_of(corner) + button.box.least;
    const Vector<2> size = glm::max(button.box.extent(), Vector<2>(1.0));
    ImGui::SetCursorScreenPos({static_cast<float>(least.x), static_cast<float>(least.y)});
    ImGui::PushID(static_cast<int>(button.action.index()));
    ImGui::PushID(std::visit([](auto action) { return static_cast<int>(action); }, button.action));
    if (ImGui::InvisibleButton("button", {static_cast<float>(size.x), static_cast<float>(size.y)},
                               ImGuiButtonFlags_EnableNav)) {
      press(button.action, apply, frame.loop.motors);
    }
    if (button.action == StageAction(StageCommand::slider)) nudge_by_key(session);
    ImGui::PopID();
    ImGui::PopID();
  }
}

void StagePointer::drag(Session& session, const Scene& scene, const Vector<2>& pointer) {
  // The hand stays where it can be seen.
  const ScreenBox box = scene.picture.scene.grown(-hand_room * scene.picture.unit);
  const Vector<2> inside = glm::clamp(pointer, box.least, glm::max(box.least, box.most));
  // A key may have ended the mode that what is held belongs to.
  const bool holds_map = hold_ == Hold::landscape_ring || hold_ == Hold::landscape_dial;
  if (holds_map && (!scene.picture.landscape || session.stage.mode != StageMode::landscape)) hold_ = Hold::nothing;
  if (hold_ == Hold::guess && !(session.stage.guess && session.stage.guess_is_open)) hold_ = Hold::nothing;
  // So may a step of a lesson that does not allow it any more.
  if (hold_ == Hold::goal && !is_allowed(session, LessonControl::hand)) hold_ = Hold::nothing;
  if (hold_ == Hold::motor && !is_allowed(session, LessonControl::motor)) hold_ = Hold::nothing;
  if (hold_ == Hold::wall && !is_allowed(session, LessonControl::wall)) hold_ = Hold::nothing;
  if (hold_ == Hold::landscape_ring && !may_change_landscape(session)) hold_ = Hold::nothing;
  if (hold_ == Hold::landscape_dial && !is_allowed(session, LessonControl::strategies)) hold_ = Hold::nothing;
  switch (hold_) {
    case Hold::nothing:
      return;
    case Hold::goal:
      if (!session.pointer_moves_goal) return;
      session.goal = nearest_in_scene(scene.world(inside));
      session.drags_goal = true;
      return;
    case Hold::guess:
      session.stage.guess = nearest_in_scene(scene.world(inside));
      return;
    case Hold::motor:
      return turn(session.settings.actuated_angle, scene.screen(scene.picture.pivot), pointer);
    case Hold::wall:
      return turn(session.settings.wall_normal_angle, scene.screen(session.settings.wall_point), pointer);
    case Hold::picture: {
      const Vector<2> moved = pointer - last_;
      session.stage_shown = within_scene_limits(
          {session.stage_shown.center - Vector<2>(moved.x, -moved.y) / scene.picture.pane.camera.points_per_metre,
           session.stage_shown.width});
      return;
    }
    case Hold::landscape_ring:
      session.settings =
          with_landscape_point(session.settings, landscape_point_under(*scene.picture.landscape, pointer));
      return;
    case Hold::landscape_dial:
      session.stage.landscape_dial = dial_under(*scene.picture.landscape, pointer);
      // The lit button is the nearer end's.
      session.settings.active = *session.stage.landscape_dial < 0.5 ? StrategyId::naive : StrategyId::anisotropic;
      return;
    case Hold::slider:
      return drag_slider(session, scene.picture, pointer);
    case Hold::ribbon:
      if (scene.picture.ribbon) session.stage.looks_back_to_s = scene.picture.ribbon->axis.time_at(pointer.x);
      return;
  }
}

void StagePointer::drag_slider(Session& session, const StagePicture& picture, const Vector<2>& pointer) {
  const StageAction slider{StageCommand::slider};
  const auto button = std::ranges::find(picture.buttons, slider, &StageButton::action);
  if (button == picture.buttons.end() || !session.lesson || !lesson_step(*session.lesson).slider) return;
  const SliderTrack track = slider_track(button->box, picture.unit);
  const double share = (pointer.x - track.from.x) / (track.to.x - track.from.x);
  move_lesson_slider(session, slider_value_at(*lesson_step(*session.lesson).slider, share));
}

void StagePointer::turn(double& angle, const Vector<2>& pivot, const Vector<2>& pointer) {
  angle = held_angle_.turned(pivot, pointer, 1.0, ImGui::GetIO().KeyCtrl).value_or(angle);
}

}  // namespace ghostforce
