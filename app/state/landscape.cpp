#include "app/state/landscape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ghostforce {
namespace {

constexpr double right_angle = 0.5 * std::numbers::pi;
// Of numbers that a scene may hold none goes beyond these; they keep products of three of them finite.
constexpr NumberRange softnesses{0.0, 1e9};
constexpr NumberRange beliefs{1e-7, 1e7};
constexpr NumberRange kappas{0.0, 1e9};
// Of a wall that is turned to 0° or 90°, so that one can still tell on which side it is [rad].
constexpr double side_margin = 1e-6;

// In the range; `otherwise` where it is no number.
double tamed(double number, const NumberRange& range, double otherwise) noexcept {
  return std::isnan(number) ? otherwise : range.nearest_to(number);
}

// The turn from the motor to the wall's normal, from −π to π [rad].
double turn_of(const Settings& settings) noexcept {
  const double turn = std::remainder(settings.wall_normal_angle - settings.actuated_angle, 2.0 * std::numbers::pi);
  return std::isfinite(turn) ? turn : 0.0;
}

// The motor pushes both ways: a normal behind it is as good as one before it.
bool is_behind(double turn) noexcept {
  return std::abs(turn) > right_angle;
}

double folded(double turn) noexcept {
  return std::clamp(is_behind(turn) ? std::numbers::pi - std::abs(turn) : std::abs(turn), 0.0, right_angle);
}

double kappa_of(const Stiffnesses& stiffnesses) noexcept {
  return tamed(stiffnesses.k_r / stiffnesses.k_u, kappas, shown_kappas.least);
}

}  // namespace

Landscape landscape_without_ghost(const Settings& settings) noexcept {
  Landscape landscape = landscape_of(settings, 1.0);
  landscape.true_over_believed = 1.0;
  landscape.chosen_ratio.reset();
  return landscape;
}

Landscape landscape_of(const Settings& settings, double dial) noexcept {
  const Stiffnesses& stiffnesses = settings.stiffnesses;
  Landscape landscape;
  landscape.dial = tamed(dial, {0.0, 1.0}, 0.0);
  landscape.true_over_believed = tamed(stiffnesses.k_u / believed_user_stiffness(stiffnesses), beliefs, 1.0);
  if (stiffnesses.chosen_tracking_ratio) {
    landscape.chosen_ratio = tamed(*stiffnesses.chosen_tracking_ratio, tracking_ratio_range, 1.0);
  }
  landscape.softness = tamed(stiffnesses.k_t / stiffnesses.k_c, softnesses, 0.0);
  return landscape;
}

double landscape_ratio(const Landscape& landscape, double kappa) noexcept {
  // (17) with the k_u that is believed in.
  const double anisotropic = landscape.chosen_ratio.value_or(1.0 + kappa * landscape.true_over_believed);
  return std::pow(anisotropic, landscape.dial);
}

double ghost_share(double cosine, double optimal_ratio, double ratio, double softness) noexcept {
  const double along = cosine * cosine;
  const double across = 1.0 - along;
  return cosine * across * (optimal_ratio - ratio) / (optimal_ratio * along + ratio * across + softness);
}

double ghost_share(const Landscape& landscape, const LandscapePoint& point) noexcept {
  const double angle = tamed(point.angle, {0.0, right_angle}, 0.0);
  const double kappa = tamed(point.kappa, kappas, shown_kappas.least);
  return ghost_share(std::cos(angle), 1.0 + kappa, landscape_ratio(landscape, kappa), landscape.softness);
}

NumberRange ghost_share_range(const Landscape& landscape) noexcept {
  constexpr int columns = 90;
  constexpr int rows = 20;
  NumberRange range{0.0, 0.0};
  for (int row = 0; row <= rows; ++row) {
    const double kappa =
        shown_kappas.least * std::pow(shown_kappas.greatest / shown_kappas.least, static_cast<double>(row) / rows);
    const double ratio = landscape_ratio(landscape, kappa);
    for (int column = 0; column <= columns; ++column) {
      const double share =
          ghost_share(std::cos(right_angle * column / columns), 1.0 + kappa, ratio, landscape.softness);
      range.least = std::min(range.least, share);
      range.greatest = std::max(range.greatest, share);
    }
  }
  return range;
}

LandscapePoint landscape_point(const Settings& settings) noexcept {
  return {folded(turn_of(settings)), kappa_of(settings.stiffnesses)};
}

Settings with_landscape_point(Settings settings, const LandscapePoint& point) noexcept {
  const double turn = turn_of(settings);
  const double now = folded(turn);
  const double asked = tamed(point.angle, {0.0, right_angle}, now);
  if (std::abs(asked - now) > side_margin) {
    const double angle = std::clamp(asked, side_margin, right_angle - side_margin);
    const double from_motor = is_behind(turn) ? std::numbers::pi - angle : angle;
    // By as much as it has to: whoever wrote 495° finds it near there.
    settings.wall_normal_angle += std::copysign(from_motor, turn) - turn;
  }
  Stiffnesses& stiffnesses = settings.stiffnesses;
  if (point.kappa != kappa_of(stiffnesses) && std::isfinite(point.kappa * stiffnesses.k_u)) {
    stiffnesses.k_r = rendering_stiffness_range.nearest_to(point.kappa * stiffnesses.k_u);
  }
  return settings;
}

}  // namespace ghostforce
