// What a pointer does to a picture, on the stage and on the workbench alike: it turns what it holds, and zooms. Screen
// points, y down; UI thread.
#pragma once

#include <optional>

#include <imgui.h>

#include "core/conventions.h"

namespace ghostforce {

// From Dear ImGui and back.
inline Vector<2> vector_of(ImVec2 point) noexcept {
  return {static_cast<double>(point.x), static_cast<double>(point.y)};
}
inline ImVec2 imgui_vector(const Vector<2>& vector) noexcept {
  return {static_cast<float>(vector.x), static_cast<float>(vector.y)};
}

// Above 1: closer.
double zoom_factor(float wheel) noexcept;
// The wheel that zooms by so much.
float wheel_of_zoom(double zoom_factor) noexcept;

// An angle in the hand. It turns by as much as the pointer has gone round the pivot since it was taken hold of, and
// never jumps to the pointer; in steps, unless it is to turn freely.
class HeldAngle {
 public:
  static constexpr double first_turn = 2.0;  // a click is no turn yet [points]

  void begin(const Vector<2>& pointer, double angle) noexcept;
  // Empty: it has not been turned yet, or the pointer is on the pivot, where it has no direction. `unit`: a point.
  std::optional<double> turned(const Vector<2>& pivot, const Vector<2>& pointer, double unit, bool is_free) noexcept;

 private:
  Vector<2> began_at_{0.0};
  double began_angle_ = 0.0;  // [rad]
  bool has_turned_ = false;
};

}  // namespace ghostforce
