#include "app/picture/handles.h"

#include <algorithm>
#include <cmath>

namespace ghostforce {
namespace {

constexpr double dial_radius = 40.0;   // [points]
constexpr double dial_margin = 32.0;   // to the right and lower edge [points]
constexpr double caption_room = 17.0;  // below the dial [points]
constexpr double grip_inset = 74.0;    // from the picture's edge: scale bars and legend stand closer to it [points]
constexpr double shortest_wall = 60.0;
constexpr double grip_reach = 15.0;  // of the pointer round a grip [points]

}  // namespace

MotorDial motor_dial(const Camera& camera, double unit) {
  const double radius = std::min(dial_radius * unit, 0.1 * std::min(camera.size.x, camera.size.y));
  return {camera.size - Vector<2>(radius + dial_margin * unit, radius + (dial_margin + caption_room - 8.0) * unit),
          radius};
}

bool has_motor_dial(const Settings& settings) noexcept {
  return settings.general.mechanism == MechanismKind::axes;
}

std::optional<std::array<Vector<2>, 2>> wall_grips(const Settings& settings, const Camera& camera, double unit) {
  if (settings.general.constraint != ConstraintKind::plane) return std::nullopt;
  const Wall<2> wall = wall_of(settings);
  // The line at + t along, cut to the picture without its margin, one axis after the other.
  const Vector<2> at = to_screen(camera, wall.point);
  const Vector<2> along = to_screen_direction({-wall.normal.y, wall.normal.x});
  const double inset = std::min(grip_inset * unit, 0.2 * std::min(camera.size.x, camera.size.y));
  double first = -1e9;
  double last = 1e9;
  for (int axis = 0; axis < 2; ++axis) {
    const double least = inset;
    const double most = camera.size[axis] - inset;
    if (std::abs(along[axis]) < 1e-9) {
      if (at[axis] < least || at[axis] > most) return std::nullopt;
      continue;
    }
    const double a = (least - at[axis]) / along[axis];
    const double b = (most - at[axis]) / along[axis];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (last - first < shortest_wall * unit) return std::nullopt;
  return std::array{at + along * first, at + along * last};
}

Handle handle_at(const Settings& settings, const Camera& camera, double unit, const Vector<2>& pointer) {
  const MotorDial dial = motor_dial(camera, unit);
  const bool is_on_dial = glm::distance(pointer, dial.middle) <= dial.radius + 6.0 * unit;
  if (is_on_dial && has_motor_dial(settings)) return Handle::motor_axis;
  if (const auto grips = wall_grips(settings, camera, unit)) {
    for (const Vector<2>& grip : *grips) {
      if (glm::distance(pointer, grip) <= grip_reach * unit) return Handle::wall;
    }
  }
  return Handle::none;
}

Vector<2> pivot_of(Handle handle, const Settings& settings, const Camera& camera, double unit) {
  return handle == Handle::motor_axis ? motor_dial(camera, unit).middle : to_screen(camera, settings.wall_point);
}

}  // namespace ghostforce
