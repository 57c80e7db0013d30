#include "app/picture/camera.h"

#include "app/picture/screen_box.h"

namespace ghostforce {
namespace {

// On the screen, y down, from the world's origin [points].
ScreenBox box_of(std::span<const FitPoint> points, double points_per_metre) {
  const auto place = [&](const FitPoint& point) {
    return to_screen_direction(point.world) * points_per_metre + point.offset;
  };
  ScreenBox box{place(points.front()), place(points.front())};
  for (const FitPoint& point : points) box.include(place(point));
  return box;
}

}  // namespace

double fitting_scale(std::span<const FitPoint> points, const Vector<2>& room, double greatest) noexcept {
  const auto fits = [&](double scale) {
    const Vector<2> extent = box_of(points, scale).extent();
    return extent.x <= room.x && extent.y <= room.y;
  };
  if (points.empty() || fits(greatest)) return greatest;
  if (!fits(0.0)) {
    // What is as long at any distance is too long: the rest shall be seen at least.
    ScreenBox world{points.front().world, points.front().world};
    for (const FitPoint& point : points) world.include(point.world);
    const Vector<2> scale = room / glm::max(world.extent(), Vector<2>(1e-12));
    return std::min({scale.x, scale.y, greatest});
  }
  // The extent is a convex function of the scale: what fits is one interval, and 0 is in it.
  double least = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (least + greatest);
    (fits(middle) ? least : greatest) = middle;
  }
  return least;
}

Vector<2> fitting_center(std::span<const FitPoint> points, double points_per_metre) noexcept {
  const ScreenBox box = box_of(points, points_per_metre);
  return to_screen_direction(0.5 * (box.least + box.most)) / points_per_metre;
}

}  // namespace ghostforce
