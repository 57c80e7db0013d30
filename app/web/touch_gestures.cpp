#include "app/web/touch_gestures.h"

#include <imgui.h>

#include <cfloat>

#include "app/ui/widgets/pointing.h"

namespace ghostforce {
namespace {

void point_at(const Vector<2>& place) {
  ImGui::GetIO().AddMousePosEvent(static_cast<float>(place.x), static_cast<float>(place.y));
}

}  // namespace

void TouchGestures::hold(std::optional<int> button) {
  if (button == held_) return;
  ImGuiIO& io = ImGui::GetIO();
  if (held_) io.AddMouseButtonEvent(*held_, false);
  if (button) io.AddMouseButtonEvent(*button, true);
  held_ = button;
}

void TouchGestures::follow(std::span<const Vector<2>> fingers) {
  ImGuiIO& io = ImGui::GetIO();
  io.AddMouseSourceEvent(ImGuiMouseSource_TouchScreen);
  if (fingers.empty()) {
    hold({});
    waits_for_lift_ = false;
    io.AddMousePosEvent(-FLT_MAX, -FLT_MAX);  // no finger rests on anything
    io.AddMouseSourceEvent(ImGuiMouseSource_Mouse);
  } else if (fingers.size() == 1) {
    if (waits_for_lift_) return hold({});
    point_at(fingers.front());
    hold(ImGuiMouseButton_Left);
  } else {
    const Vector<2> between = 0.5 * (fingers[0] + fingers[1]);
    const double distance = glm::distance(fingers[0], fingers[1]);
    const bool begins = held_ != ImGuiMouseButton_Right;
    if (begins) hold({});
    point_at(between);
    hold(ImGuiMouseButton_Right);
    if (!begins && distance > 0.0 && distance_ > 0.0) io.AddMouseWheelEvent(0.0F, wheel_for(distance / distance_));
    distance_ = distance;
    waits_for_lift_ = true;
  }
}

}  // namespace ghostforce
