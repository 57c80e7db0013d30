#include "app/picture/workspace_layer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/picture/share_colour.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

Colour colour_of(const Theme& theme, const WallAtPose& pose) {
  switch (pose.rest) {
    case WallAtPose::Rest::unreachable:
      return theme.wall;
    case WallAtPose::Rest::stays:
      return colour_of_share(theme, pose.ghost_share);
    case WallAtPose::Rest::runs_away:
      break;
  }
  return colour_of_share(theme, deepest_share);
}

// visit(place) for the middles of squares that fill the box.
template <typename Visit>
void for_each_place(const ScreenBox& box, double spacing, Visit&& visit) {
  for (double y = box.least.y + 0.5 * spacing; y < box.most.y; y += spacing) {
    for (double x = box.least.x + 0.5 * spacing; x < box.most.x; x += spacing) visit(Vector<2>(x, y));
  }
}

}  // namespace

bool WorkspaceMap::is_without_ghost() const noexcept {
  const GeneralStrategy& strategy = scene.strategies[index_of(id)];
  return strategy.has_every_motor || (strategy.share == 1.0 && scene.compliances.user == scene.user_compliance);
}

WorkspaceMap workspace_map(const Settings& settings, const Vector<2>& goal) noexcept {
  constexpr double least_depth = 0.005;  // [m]
  return {general_scene_of(settings), settings.active, wall_near(settings, goal).normal,
          std::max(least_depth, depth_in_wall(settings, goal))};
}

void add_workspace_cells(const WorkspaceMap& map, const Camera& camera, const ScreenBox& box, const Camera& seen,
                         double side, const Theme& theme, Marks& marks) {
  const auto count = [side](double length) { return std::max(1, static_cast<int>(std::lround(length / side))); };
  const Vector<2> extent = box.extent();
  Raster raster{to_world(camera, box.least), extent, count(extent.x), count(extent.y), {}};
  for (int row = 0; row < raster.rows; ++row) {
    for (int column = 0; column < raster.columns; ++column) {
      const Vector<2> share((column + 0.5) / raster.columns, (row + 0.5) / raster.rows);
      raster.cells.push_back(colour_of(theme, map.at(to_world(seen, share * seen.size))));
    }
  }
  marks.push_back({Role::map, {}, std::move(raster)});
}

void add_workspace_strokes(const WorkspaceMap& map, const Camera& camera, const ScreenBox& box, double unit,
                           const Theme& theme, Marks& marks) {
  const auto add = [&](const Vector<2>& middle, const Vector<2>& half, double width, Colour colour) {
    const Line line{to_world(camera, middle - half), to_world(camera, middle + half), width * unit * theme.thickness,
                    colour};
    marks.push_back({Role::map, {}, line});
  };
  const double stripe = 14.0 * unit;
  for_each_place(box, stripe, [&](const Vector<2>& place) {
    if (map.at(to_world(camera, place)).rest != WallAtPose::Rest::runs_away) return;
    add(place, {0.5 * stripe, -0.5 * stripe}, 2.5, theme.background);
  });
  constexpr std::uint8_t faint = 110;
  for_each_place(box, 44.0 * unit, [&](const Vector<2>& place) {
    const WallAtPose pose = map.at(to_world(camera, place));
    if (pose.rest == WallAtPose::Rest::unreachable) return;
    add(place, to_screen_direction(pose.motor) * (9.0 * unit), 2.0, theme.text.with_alpha(faint));
  });
}

}  // namespace ghostforce
