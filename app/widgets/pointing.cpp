#include "app/widgets/pointing.h"

#include <cmath>
#include <numbers>

#include "app/picture/screen_box.h"

namespace ghostforce {
namespace {

constexpr double zoom_per_notch = 1.15;
constexpr double turning_step = 5.0 * radians_per_degree;

// Counter-clockwise, of a direction on the screen [rad].
double angle_on_screen(const Vector<2>& direction) noexcept {
  return std::atan2(-direction.y, direction.x);
}

}  // namespace

double zoom_factor(float wheel) noexcept {
  return std::pow(zoom_per_notch, static_cast<double>(wheel));
}

float wheel_of_zoom(double zoom_factor) noexcept {
  return static_cast<float>(std::log(zoom_factor) / std::log(zoom_per_notch));
}

void HeldAngle::begin(const Vector<2>& pointer, double angle) noexcept {
  began_at_ = pointer;
  began_angle_ = angle;
  has_turned_ = false;
}

std::optional<double> HeldAngle::turned(const Vector<2>& pivot, const Vector<2>& pointer, double unit,
                                        bool is_free) noexcept {
  has_turned_ = has_turned_ || glm::distance(pointer, began_at_) >= first_turn * unit;
  if (!has_turned_ || glm::distance(pointer, pivot) < first_turn * unit) return std::nullopt;
  double angle = began_angle_ + angle_on_screen(pointer - pivot) - angle_on_screen(began_at_ - pivot);
  if (!is_free) angle = std::round(angle / turning_step) * turning_step;
  return std::remainder(angle, 2.0 * std::numbers::pi);
}

}  // namespace ghostforce
