#include "app/tools/doctor/ruler.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/conventions.h"
#include "device/falcon/kinematics.h"

namespace ghostforce {
namespace {

constexpr double deviation = 0.5 * ruler_uncertainty;

// Beyond these, in standard deviations, no honest ruler reads: per distance on average for one fit, and in all for a
// fit that is better than another by chance.
constexpr double worst_per_reading = 9.0;
constexpr double better_by_chance = 9.0;

FalconGeometry geometry_with(const GeometryPreset& preset, double angle, double gear) noexcept {
  FalconGeometry geometry = preset.geometry;
  geometry.angle_at_zero_count = angle;
  geometry.gear_ratio = gear;
  return geometry;
}

double badness_of(std::span<const RulerReading> readings, const FalconGeometry& geometry) noexcept {
  double sum = 0.0;
  for (const RulerReading& reading : readings) {
    const double distance = distance_of(reading, geometry);
    if (distance == 0.0) return std::numeric_limits<double>::infinity();
    const double off = (distance - reading.distance) / deviation;
    sum += off * off;
  }
  return sum;
}

// The matrix times a step of angle and gear is the right side.
struct NormalEquations {
  Matrix<2> matrix{0.0};
  Vector<2> right{0.0};
};

NormalEquations normal_equations(std::span<const RulerReading> readings, const RulerFit& at) noexcept {
  constexpr double step = 1e-4;  // of the angle, and of the gear
  const Vector<2> place(at.angle_at_zero_count, at.gear_ratio);
  NormalEquations normal;
  for (const RulerReading& reading : readings) {
    const auto distance = [&](const Vector<2>& there) {
      return distance_of(reading, geometry_with(*at.preset, there.x, there.y)) / deviation;
    };
    const auto slope = [&](const Vector<2>& way) {
      return (distance(place + step * way) - distance(place - step * way)) / (2 * step);
    };
    const Vector<2> slopes(slope({1.0, 0.0}), at.has_gear ? slope({0.0, 1.0}) : 0.0);
    normal.matrix += glm::outerProduct(slopes, slopes);
    normal.right += slopes * (reading.distance / deviation - distance(place));
  }
  // Without one, the equation of the gear is "nothing changes".
  if (!at.has_gear) normal.matrix[1][1] = 1.0;
  return normal;
}

// Gauss and Newton's method from one angle; not found where it leaves what the legs can do.
RulerFit descend(std::span<const RulerReading> readings, RulerFit fit) noexcept {
  constexpr int most_steps = 30;
  constexpr int most_halvings = 12;
  fit.badness = badness_of(readings, geometry_with(*fit.preset, fit.angle_at_zero_count, fit.gear_ratio));
  if (!std::isfinite(fit.badness)) return fit;
  for (int step = 0; step < most_steps; ++step) {
    const auto [matrix, right] = normal_equations(readings, fit);
    const double determinant = glm::determinant(matrix);
    if (!(determinant > 0.0)) return fit;
    fit.angle_uncertainty = 2.0 * std::sqrt(matrix[1][1] / determinant);
    fit.gear_uncertainty = fit.has_gear ? 2.0 * std::sqrt(matrix[0][0] / determinant) : 0.0;
    Vector<2> change = glm::inverse(matrix) * right;
    if (glm::length(change) < 1e-9) break;
    bool is_better = false;
    for (int halvings = 0; !is_better && halvings <= most_halvings; ++halvings, change *= 0.5) {
      RulerFit next = fit;
      next.angle_at_zero_count += change.x;
      next.gear_ratio += change.y;
      next.badness = badness_of(readings, geometry_with(*fit.preset, next.angle_at_zero_count, next.gear_ratio));
      if (!(next.badness < fit.badness)) continue;
      is_better = true;
      fit = next;
    }
    if (!is_better) break;
  }
  fit.is_found = true;
  fit.misfit = deviation * std::sqrt(fit.badness / static_cast<double>(readings.size()));
  return fit;
}

bool is_consistent(const RulerFit& fit, std::size_t readings) noexcept {
  return fit.is_found && fit.badness <= worst_per_reading * static_cast<double>(readings);
}

}  // namespace

double distance_of(const RulerReading& reading, const FalconGeometry& geometry) noexcept {
  const FalconKinematics kinematics(geometry);
  const ForwardKinematics from = kinematics.position(angles_of_counts(reading.from, geometry));
  const ForwardKinematics to = kinematics.position(angles_of_counts(reading.to, geometry), from.position);
  return from.has_converged && to.has_converged ? glm::distance(from.position, to.position) : 0.0;
}

RulerFit fit_ruler(std::span<const RulerReading> readings, const GeometryPreset& preset, bool with_gear) noexcept {
  RulerFit best;
  best.preset = &preset;
  best.badness = std::numeric_limits<double>::infinity();
  // Encoders that all count the other way begin far from where others do.
  for (int degrees = -85; degrees <= 85; degrees += 5) {
    RulerFit start;
    start.preset = &preset;
    start.has_gear = with_gear;
    start.angle_at_zero_count = degrees * radians_per_degree;
    start.gear_ratio = preset.geometry.gear_ratio;
    const RulerFit fit = descend(readings, start);
    if (fit.is_found && fit.badness < best.badness) best = fit;
  }
  return best;
}

RulerVerdict judge_rulers(std::span<const RulerReading> readings, const GeometryPreset& assumed) {
  RulerVerdict verdict;
  for (const GeometryPreset& preset : geometry_catalog()) verdict.others.push_back(fit_ruler(readings, preset, true));
  const auto index = static_cast<std::size_t>(&assumed - geometry_catalog().data());
  const auto best = std::ranges::min_element(verdict.others, {}, &RulerFit::badness);
  RulerFit fit = verdict.others[index];
  if (best->badness + better_by_chance < fit.badness) fit = *best;
  verdict.is_consistent = is_consistent(fit, readings.size());
  for (const RulerFit& other : verdict.others) {
    if (other.preset != fit.preset && other.badness <= fit.badness + better_by_chance) {
      verdict.rivals.push_back(other.preset->name);
    }
  }
  if (fit.is_found && std::abs(fit.gear_ratio - fit.preset->geometry.gear_ratio) <= fit.gear_uncertainty) {
    const double uncertainty = fit.gear_uncertainty;
    fit = fit_ruler(readings, *fit.preset, false);
    fit.gear_uncertainty = uncertainty;
  }
  verdict.fit = fit;
  return verdict;
}

}  // namespace ghostforce
