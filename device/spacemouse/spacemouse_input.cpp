#include "device/spacemouse/spacemouse_input.h"

#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ghostforce {

SpaceMouseInput::SpaceMouseInput(const SpaceMouseSettings& settings)
    : settings_(is_valid(settings) ? settings : SpaceMouseSettings{}) {}

bool SpaceMouseInput::set(const SpaceMouseSettings& settings) noexcept {
  if (!is_valid(settings)) return false;
  settings_.publish(settings);
  return true;
}

Vector<2> SpaceMouseInput::goal(std::int64_t /*tick*/, double rate) noexcept {
  return motion_.step(for_servo_.latest(), settings_.latest(), rate);
}

void SpaceMouseInput::publish(const SpaceMouseReading& reading) noexcept {
  for_servo_.publish(reading);
  for_window_.publish(reading);
}

bool is_valid(const SpaceMouseSettings& settings) noexcept {
  const auto is_amount = [](double value) { return std::isfinite(value) && value >= 0.0; };
  return is_amount(settings.dead_zone) && settings.dead_zone < 1.0 && is_amount(settings.reach_m) &&
         is_amount(settings.speed_m_s);
}

Vector<2> deflection(const std::array<double, 6>& axes, const SpaceMouseSettings& settings) noexcept {
  // The device counts z down and y towards the user.
  const Vector<2> raw{axes[0], settings.up == SpaceMouseSettings::Up::lift ? -axes[2] : -axes[1]};
  const double length = glm::length(raw);
  if (!(length > settings.dead_zone)) return Vector<2>{0.0};
  const double wanted = std::fmin((length - settings.dead_zone) / (1.0 - settings.dead_zone), 1.0);
  return raw * (wanted / length);
}

void SpaceMouseMotion::restart(const Vector<2>& goal) noexcept {
  goal_ = goal;
  rest_ = goal;
  first_ = second_ = Vector<2>{0.0};
}

Vector<2> SpaceMouseMotion::step(const SpaceMouseReading& reading, const SpaceMouseSettings& settings,
                                 double rate_hz) noexcept {
  if (reading.connection != connection_) {  // what was known of the cap was another time's
    connection_ = reading.connection;
    first_ = second_ = Vector<2>{0.0};
    rest_ = goal_;
  }
  if (settings.mode != mode_) {
    mode_ = settings.mode;
    rest_ = goal_ - settings.reach_m * second_;
  }
  const double step_s = 1.0 / rate_hz;
  if (mode_ == SpaceMouseSettings::Mode::rate) since_report_s_ += step_s;
  if (std::exchange(reports_, reading.reports) != reading.reports) since_report_s_ = 0.0;
  if (connection_ == 0) return goal_;

  const Vector<2> deflected = since_report_s_ > longest_silence_s ? Vector<2>{0.0} : deflection(reading.axes, settings);
  const double share = 1.0 - std::exp(-step_s / lag_s);
  first_ += share * (deflected - first_);
  second_ += share * (first_ - second_);
  Vector<2> move = settings.mode == SpaceMouseSettings::Mode::rate ? settings.speed_m_s * step_s * second_
                                                                   : rest_ + settings.reach_m * second_ - goal_;
  const double length = glm::length(move);
  const double longest = fastest_m_s * step_s;
  if (length > longest) move *= longest / length;
  goal_ = glm::clamp(goal_ + move, -farthest_m, farthest_m);
  return goal_;
}

}  // namespace ghostforce
