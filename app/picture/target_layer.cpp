// What the hand at a device is told to aim at: a target on the wall, and the line straight into the wall at it.
#include "app/picture/layers.h"

namespace ghostforce {
namespace {

constexpr double target_radius = 12.0;  // [points]
constexpr double line_length = 60.0;    // into the wall [points]

}  // namespace

void add_target(const View& view, Marks& marks) {
  if (!view.target) return;
  const Vector<2> inwards = -wall_of(view.settings).normal;
  const Vector<2> target = *view.target;
  const LinePattern dashes{view.points(7.0), view.points(4.0), view.points(7.0), view.points(4.0)};
  marks.push_back(
      {Role::target, std::nullopt,
       Line{target, target + inwards * view.metres(line_length), view.points(1.8), view.theme.text, dashes}});
  for (const double radius : {target_radius, 0.45 * target_radius}) {
    marks.push_back({Role::target, std::nullopt,
                     Marker{target, Shape::disc, view.points(radius), view.theme.background.with_alpha(0),
                            view.theme.text, view.points(2.4)}});
  }
}

}  // namespace ghostforce
