#include "app/shell/web/touch_gestures.h"

#include <imgui.h>

#include <cfloat>
#include <utility>

#include "app/widgets/pointing.h"

namespace ghostforce {
namespace {

void point_at(const Vector<2>& place) {
  ImGuiIO& io = ImGui::GetIO();
  io.AddMouseSourceEvent(ImGuiMouseSource_TouchScreen);
  io.AddMousePosEvent(static_cast<float>(place.x), static_cast<float>(place.y));
}

}  // namespace

void TouchGestures::press(std::optional<int> button) {
  if (button == pressed_) return;
  ImGuiIO& io = ImGui::GetIO();
  if (pressed_) io.AddMouseButtonEvent(*pressed_, false);
  if (button) io.AddMouseButtonEvent(*button, true);
  pressed_ = button;
}

void TouchGestures::press_one(const Vector<2>& place) {
  landing_.reset();
  point_at(place);
  press(ImGuiMouseButton_Left);
}

void TouchGestures::follow(std::span<const Vector<2>> fingers, double now_s) {
  ImGuiIO& io = ImGui::GetIO();
  if (fingers.empty()) {
    if (landing_) press_one(landing_->place);
    press({});
    if (std::exchange(waits_for_lift_, false)) two_have_ended_ = true;
    io.AddMousePosEvent(-FLT_MAX, -FLT_MAX);  // no finger rests on anything
    io.AddMouseSourceEvent(ImGuiMouseSource_Mouse);
  } else if (fingers.size() == 1) {
    const Vector<2>& finger = fingers.front();
    if (waits_for_lift_) return press({});
    if (pressed_) return point_at(finger);
    if (!landing_) landing_ = Landing{finger, now_s};
    if (glm::distance(finger, landing_->place) < first_move) return advance(now_s);
    press_one(landing_->place);
    point_at(finger);
  } else {
    landing_.reset();
    const bool begins = pressed_ != ImGuiMouseButton_Right;
    if (begins) press({});
    point_at(0.5 * (fingers[0] + fingers[1]));
    press(ImGuiMouseButton_Right);
    const double before = std::exchange(distance_, glm::distance(fingers[0], fingers[1]));
    if (!begins && before > 0.0 && distance_ > 0.0) io.AddMouseWheelEvent(0.0F, wheel_of_zoom(distance_ / before));
    waits_for_lift_ = true;
  }
}

void TouchGestures::advance(double now_s) {
  if (landing_ && now_s - landing_->time_s >= longest_wait_s) press_one(landing_->place);
}

}  // namespace ghostforce
