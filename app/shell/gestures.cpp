#include "app/shell/gestures.h"

#include <algorithm>
#include <optional>
#include <variant>

#include <imgui.h>

#include "app/picture/camera.h"
#include "app/picture/handles.h"
#include "app/picture/screen_box.h"
#include "app/widgets/controls.h"
#include "app/widgets/tooltips.h"
#include "core/scene.h"

namespace ghostforce {
namespace {

double angle_of(Handle handle, const Settings& settings) {
  return handle == Handle::motor_axis ? settings.actuated_angle : settings.wall_normal_angle;
}

// Where the force ends, seen from the device.
std::optional<FitPoint> tip_of_force(const Pane& pane) {
  std::optional<Vector<2>> device;
  std::optional<Vector<2>> tip;
  for (const Mark& mark : pane.marks) {
    if (mark.strategy != pane.active) continue;
    const auto* marker = std::get_if<Marker>(&mark.form);
    const auto* arrow = std::get_if<Arrow>(&mark.form);
    if (marker != nullptr && mark.role == Role::device) device = marker->center;
    if (arrow != nullptr && (mark.role == Role::force || mark.role == Role::ghost_force)) tip = arrow->tip;
  }
  if (!device || !tip) return std::nullopt;
  return FitPoint{*device, to_screen_direction(*tip - *device) * pane.camera.points_per_metre};
}

const Pane& pane_of(const std::vector<Pane>& panes, StrategyId id) {
  const auto found = std::ranges::find(panes, id, &Pane::active);
  return found == panes.end() ? panes.front() : *found;
}

}  // namespace

void Gestures::take(const Session& session, const ActionSink& apply, const std::vector<Pane>& panes,
                    const Vector<2>& size, double unit, const ShownMoment& moment) {
  ImGui::SetCursorPos({0.0F, 0.0F});
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("scene", imgui_vector(size),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  if (session.drags_goal) apply(LetGoOfHand{});
  if (panes.empty()) return;
  const bool is_held = is_dragged();
  const bool is_hovered = ImGui::IsItemHovered();
  const Vector<2> pointer = vector_of(ImGui::GetIO().MousePos) - vector_of(corner);

  if (!is_held) {
    grip_ = Grip::nothing;
    held_ = Handle::none;
    hovered_ = Handle::none;
  }
  if (is_hovered && !is_held) {
    const Pane& pane = pane_at(panes, pointer);
    const Vector<2> inside = pointer - pane.corner;
    hovered_ = handle_at(moment.settings, pane.camera, unit, inside);
    if (hovered_ != Handle::none) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (session.dialog == Dialog::none) mark_tooltip(pane, fonts_, inside, unit, moment.snapshot.measured.has_value());
  }
  if (const float wheel = ImGui::GetIO().MouseWheel; is_hovered && wheel != 0.0F) {
    const Pane& pane = pane_at(panes, pointer);
    const Vector<2> at = to_world(pane.camera, pointer - pane.corner);
    apply(ZoomView{zoom_factor(wheel), ZoomView::Place{at, pane.active}});
  }
  if (ImGui::IsItemActivated()) {
    const Pane& pane = pane_at(panes, pointer);
    pane_ = pane.active;
    begin(session, apply, moment.settings, pane, pointer - pane.corner, unit);
  }
  if (is_held) {
    // The active strategy may change during a drag; where there is one pane, it is the one.
    const Pane& pane = pane_of(panes, pane_);
    go_on(session, apply, moment.settings, pane, pointer - pane.corner, unit);
  }
}

void Gestures::begin(const Session& session, const ActionSink& apply, const Settings& shown, const Pane& pane,
                     const Vector<2>& pointer, double unit) {
  began_at_ = pointer;
  last_ = pointer;
  if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) {
    grip_ = Grip::picture;
    return;
  }
  // The legend is no place for a goal: its entries choose the strategy that they name.
  if (const Mark* const mark = mark_at(pane, fonts_, pointer, unit); mark != nullptr && mark->role == Role::legend) {
    grip_ = Grip::nothing;
    if (mark->strategy) apply(ChooseStrategy{*mark->strategy});
    return;
  }
  held_ = handle_at(shown, pane.camera, unit, pointer);
  hovered_ = held_;
  if (held_ != Handle::none) {
    grip_ = Grip::handle;
    held_angle_.begin(pointer, angle_of(held_, shown));
  } else {
    grip_ = session.pointer_moves_goal ? Grip::goal : session.circle_test.is_on ? Grip::circle : Grip::nothing;
  }
}

void Gestures::go_on(const Session& session, const ActionSink& apply, const Settings& shown, const Pane& pane,
                     const Vector<2>& pointer, double unit) {
  switch (grip_) {
    case Grip::nothing:
      break;
    case Grip::goal:
      // A pointer dragged out of the scene leaves the goal at its edge.
      apply(MoveHandTo{to_world(pane.camera, glm::clamp(pointer, Vector<2>(0.0), pane.camera.size))});
      break;
    case Grip::circle:
      // Whoever drags wants the goal back; a click is no drag.
      if (glm::distance(pointer, began_at_) < HeldAngle::first_turn * unit) break;
      apply(ChooseInput{session.circle_test.input_before});
      grip_ = Grip::goal;
      break;
    case Grip::handle:
      ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
      if (const auto angle =
              held_angle_.turned(pivot_of(held_, shown, pane.camera, unit), pointer, unit, ImGui::GetIO().KeyCtrl)) {
        apply(held_ == Handle::motor_axis ? Action(TurnMotorTo{*angle}) : TurnWallTo{*angle});
      }
      break;
    case Grip::picture:
      ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
      apply(MoveView{-to_screen_direction(pointer - last_) / pane.camera.points_per_metre});
      break;
  }
  last_ = pointer;
}

SceneView view_of_everything(const Session& session, const std::vector<Pane>& panes, const Vector<2>& size,
                             double unit) {
  std::vector<FitPoint> points{{session.goal}, {session.settings.wall_point}};
  for (const Pane& pane : panes) {
    for (const Mark& mark : pane.marks) {
      const bool belongs = mark.role == Role::device || mark.role == Role::proxy || mark.role == Role::trail;
      if (const auto* marker = std::get_if<Marker>(&mark.form); marker != nullptr && belongs) {
        points.push_back({marker->center});
      } else if (const auto* line = std::get_if<Line>(&mark.form); line != nullptr && belongs) {
        points.push_back({line->from});
        points.push_back({line->to});
      }
    }
    // Arrows are as long at any distance.
    if (const auto tip = tip_of_force(pane)) points.push_back({tip->world, tip->offset});
  }
  const Vector<2> room = panes.empty() ? size : panes.front().camera.size;
  const Vector<2> margin = glm::min(Vector<2>(90.0 * unit), 0.25 * room);
  constexpr double least_extent = 1e-3;  // [m]
  const double closest = std::min(room.x, room.y) / least_extent;
  double points_per_metre = fitting_scale(points, room - 2.0 * margin, closest);
  // The dial in the corner would cover what is there.
  constexpr double marker_reach = 20.0;  // [points]
  constexpr double smaller = 0.97;
  const auto is_under_dial = [&] {
    const Camera camera{fitting_center(points, points_per_metre), points_per_metre, room};
    const MotorDial dial = motor_dial(camera, unit);
    return std::ranges::any_of(points, [&](const FitPoint& point) {
      const Vector<2> place = to_screen(camera, point.world) + point.offset;
      return glm::distance(place, dial.middle) < dial.radius + marker_reach * unit;
    });
  };
  for (int step = 0; step < 20 && is_under_dial(); ++step) points_per_metre *= smaller;
  const double width = std::min(room.x, room.y / 0.75) / points_per_metre;
  return within_scene_limits({fitting_center(points, points_per_metre), width});
}

}  // namespace ghostforce
