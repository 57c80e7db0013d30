#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "app/picture/layers.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

constexpr double hatch_spacing = 11.0;  // along the wall [points]
constexpr double hatch_length = 14.0;   // [points]
constexpr double grid_metres = 0.010;
constexpr double closest_grid = 26.0;  // [points]; closer lines are a texture, not a grid

void add_grid(const View& view, Marks& marks) {
  double spacing = grid_metres;
  while (spacing * view.camera.points_per_metre < closest_grid) spacing *= 10.0;
  const Vector<2> least = to_world(view.camera, {0.0, view.camera.size.y});
  const Vector<2> most = to_world(view.camera, {view.camera.size.x, 0.0});
  const auto line = [&](const Vector<2>& from, const Vector<2>& to) {
    marks.push_back({Role::grid, std::nullopt, Line{from, to, view.points(1.0), view.theme.grid}});
  };
  for (double i = std::ceil(least.x / spacing); i * spacing <= most.x; i += 1.0) {
    line({i * spacing, least.y}, {i * spacing, most.y});
  }
  for (double i = std::ceil(least.y / spacing); i * spacing <= most.y; i += 1.0) {
    line({least.x, i * spacing}, {most.x, i * spacing});
  }
}

// A corner, or a round wall, without strokes beside its edge.
void add_shaped_wall(const View& view, Marks& marks) {
  const Constraint constraint = constraint_of(view.settings);
  const Outline edge = outline(constraint, reach_of(view.camera, view.settings.wall_point));
  if (const auto* const corner = std::get_if<CornerWall>(&constraint)) {
    for (const Vector<2>& normal : corner->normals) {
      marks.push_back({Role::wall, std::nullopt, HalfPlane{corner->point, normal, view.theme.wall}});
    }
  } else if (const auto* const wall = std::get_if<RoundWall>(&constraint)) {
    if (wall->is_free_inside) {
      const Colour& all = view.theme.wall;
      marks.push_back(
          {Role::wall, std::nullopt, Box{to_world(view.camera, Vector<2>(0.0)), view.camera.size, 0.0, all, all, 0.0}});
    }
    std::vector<Vector<2>> corners(edge.points.begin(), edge.points.begin() + edge.count);
    marks.push_back({Role::wall, std::nullopt,
                     Area{std::move(corners), wall->is_free_inside ? view.theme.background : view.theme.wall}});
  }
  const std::size_t pieces = edge.is_closed ? edge.count : edge.count - 1;
  for (std::size_t i = 0; i < pieces; ++i) {
    marks.push_back({Role::wall, std::nullopt,
                     Line{edge.points[i], edge.points[(i + 1) % edge.count], view.points(2.4), view.theme.wall_edge}});
  }
}

}  // namespace

void add_mechanism(const View& view, Marks& marks) {
  if (!view.linkage && view.settings.general.mechanism == MechanismKind::axes) return;
  const Vector<2>& handle = view.snapshot.strategies[index_of(view.settings.active)].device;
  const LinkagePose pose = view.linkage ? *view.linkage : nearest_pose(mechanism_of(view.settings), handle);
  const Colour grey = mix(view.theme.wall, view.theme.wall_edge, 0.5);
  for (std::size_t i = 0; i < pose.link_count; ++i) {
    const LinkagePose::Link& link = pose.links[i];
    marks.push_back(
        {Role::linkage, std::nullopt,
         Line{pose.joints[link.from], pose.joints[link.to], view.points(link.is_string ? 2.0 : 5.0), grey}});
  }
  for (std::size_t i = 0; i + 1 < pose.joint_count; ++i) {
    const bool has_motor = i < pose.motor_count;
    marks.push_back(
        {Role::joint, std::nullopt,
         Marker{pose.joints[i], Shape::disc, view.points(6.0), has_motor ? view.theme.wall_edge : view.theme.background,
                view.theme.wall_edge, view.points(2.0)}});
  }
}

void add_wall(const View& view, Marks& marks) {
  add_grid(view, marks);
  if (view.settings.general.constraint != ConstraintKind::plane) return add_shaped_wall(view, marks);

  const Wall<2> wall = wall_of(view.settings);
  const Vector<2> tangent{-wall.normal.y, wall.normal.x};
  marks.push_back({Role::wall, std::nullopt, HalfPlane{wall.point, wall.normal, view.theme.wall}});

  // The visible piece of the wall lies within half a diagonal of the middle of the picture. Counting from the wall's
  // own point keeps the hatching in place when the picture is moved.
  const double reach = 0.5 * glm::length(view.camera.size) / view.camera.points_per_metre;
  const double middle = glm::dot(tangent, view.camera.center - wall.point);
  const double off_middle = std::abs(glm::dot(wall.normal, view.camera.center - wall.point));
  if (off_middle > reach + view.metres(hatch_length)) return;

  const double spacing = view.metres(hatch_spacing);
  const Vector<2> stroke = (tangent - wall.normal) * (view.metres(hatch_length) / std::sqrt(2.0));
  for (double i = std::floor((middle - reach) / spacing) - 1.0; i * spacing <= middle + reach; i += 1.0) {
    const Vector<2> foot = wall.point + tangent * (i * spacing);
    marks.push_back({Role::hatching, std::nullopt, Line{foot, foot + stroke, view.points(1.2), view.theme.hatch}});
  }
  marks.push_back({Role::wall, std::nullopt,
                   Line{wall.point + tangent * (middle - reach), wall.point + tangent * (middle + reach),
                        view.points(2.4), view.theme.wall_edge}});
}

}  // namespace ghostforce
