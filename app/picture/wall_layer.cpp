#include <cmath>

#include "app/picture/layers.h"

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

}  // namespace

void add_wall(const View& view, Marks& marks) {
  add_grid(view, marks);

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
