#include "device/virtual_haply/arms_geometry.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace ghostforce {
namespace {

// Between a link of `near` at the shaft and the way to a place that the link of `far` just reaches.
std::optional<double> opening(double near, double far, double distance) noexcept {
  if (!(distance > 0.0)) return std::nullopt;
  const double cosine = (near * near + distance * distance - far * far) / (2.0 * near * distance);
  if (!(std::abs(cosine) <= 1.0)) return std::nullopt;
  return std::acos(cosine);
}

}  // namespace

std::optional<ArmsGeometry::Place> ArmsGeometry::place(const Vector<2>& angles) const noexcept {
  const Vector<2> way_1{std::cos(angles.x), std::sin(angles.x)};
  const Vector<2> way_2{std::cos(angles.y), std::sin(angles.y)};
  Place place;
  place.elbow_1 = driven * way_1;
  place.elbow_2 = Vector<2>{apart, 0.0} + driven * way_2;
  const Vector<2> between = place.elbow_2 - place.elbow_1;
  const double base = glm::length(between);
  const double height_squared = distal * distal - 0.25 * base * base;
  if (!(height_squared > 0.0) || !(base > 0.0)) return std::nullopt;
  const Vector<2> upwards = Vector<2>{-between.y, between.x} / base;
  place.handle = place.elbow_1 + 0.5 * between + std::sqrt(height_squared) * upwards;

  // Distal links keep their lengths: along each of them, its two ends move alike.
  const Vector<2> link_1 = place.handle - place.elbow_1;
  const Vector<2> link_2 = place.handle - place.elbow_2;
  const double determinant = link_1.x * link_2.y - link_1.y * link_2.x;
  const double along_1 = driven * (link_1.y * way_1.x - link_1.x * way_1.y);
  const double along_2 = driven * (link_2.y * way_2.x - link_2.x * way_2.y);
  place.jacobian[0] = along_1 / determinant * Vector<2>{link_2.y, -link_2.x};
  place.jacobian[1] = along_2 / determinant * Vector<2>{-link_1.y, link_1.x};
  return place;
}

std::optional<Vector<2>> ArmsGeometry::angles_at(const Vector<2>& handle) const noexcept {
  const Vector<2> from_2 = handle - Vector<2>{apart, 0.0};
  const auto opening_1 = opening(driven, distal, glm::length(handle));
  const auto opening_2 = opening(driven, distal, glm::length(from_2));
  if (!opening_1 || !opening_2) return std::nullopt;
  return Vector<2>{std::atan2(handle.y, handle.x) + *opening_1, std::atan2(from_2.y, from_2.x) - *opening_2};
}

}  // namespace ghostforce
