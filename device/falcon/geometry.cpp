#include "device/falcon/geometry.h"

#include <numbers>

namespace ghostforce {
namespace {

// A revision of the default's joints, years older. No source gives it gears or a zero of its own; it has the default's.
constexpr FalconGeometry libnifalcon_2008 = [] {
  FalconGeometry geometry;
  geometry.effector_radial = 0.014;
  geometry.base_radial = 0.037233758;
  geometry.base_tangential = -0.027330909;
  return geometry;
}();

// Known at second hand only. The source writes the tangential offsets with the opposite sign, for a tangential axis
// that points the opposite way; the legs' azimuths come out as everyone else's. It lists one more offset, of 27.9 mm,
// that its equations never use. The zero is what one user saw; the paper itself is said to have 50°.
constexpr FalconGeometry martin_hillier = [] {
  FalconGeometry geometry;
  geometry.effector_radial = 0.0157;
  geometry.near_link = 0.0115;
  geometry.far_link = 0.0115;
  geometry.effector_tangential = -0.0262;
  geometry.base_radial = 0.0366;
  geometry.base_tangential = -0.0272;
  geometry.gear_ratio = 7.62;
  geometry.angle_at_zero_count = 40.0 * radians_per_degree;
  return geometry;
}();

constexpr std::array<GeometryPreset, 3> catalog{{
    {"libnifalcon", "As in libnifalcon since 2009: the set that most programs use.", FalconGeometry{}},
    {"libnifalcon-2008", "As in the first libnifalcon, from a model of the disassembled device.", libnifalcon_2008},
    {"martin-hillier", "As measured by Martin & Hillier in 2009, taken from a program that cites them.",
     martin_hillier},
}};

}  // namespace

std::span<const GeometryPreset> geometry_catalog() noexcept {
  return catalog;
}

double radians_per_count(const FalconGeometry& geometry) noexcept {
  return 2.0 * std::numbers::pi / (geometry.counts_per_motor_turn * geometry.gear_ratio);
}

Vector<3> angles_of_counts(const Vector<3>& counts, const FalconGeometry& geometry) noexcept {
  return counts * radians_per_count(geometry) + geometry.angle_at_zero_count;
}

Vector<3> counts_of_angles(const Vector<3>& angles, const FalconGeometry& geometry) noexcept {
  return (angles - geometry.angle_at_zero_count) / radians_per_count(geometry);
}

}  // namespace ghostforce
