// What a hand that is measured is told to aim at: a target on the wall, the line straight into the wall at it, and a
// ruler from there to where the proxy has gone.
#include "app/view/layers.h"

namespace ghostforce {
namespace {

constexpr double target_radius = 12.0;     // [points]
constexpr double line_length = 60.0;       // into the wall [points]
constexpr double target_ruler_out = 48.0;  // clear of the ruler of the drift [points]

void add_ruler_to_proxy(const View& view, const Vector<2>& target, Marks& marks) {
  const StrategyId id = view.settings.active;
  const StrategySnapshot<2>& now = view.snapshot.strategies[index_of(id)];
  if (view.snapshot.measured != id || !now.in_contact) return;
  if (glm::distance(now.contact, target) < smallest_drift) return;
  add_ruler(view, ruler_between(view, target, now.contact, target_ruler_out), marks);
}

}  // namespace

void add_target(const View& view, Marks& marks) {
  if (!view.target) return;
  const Wall<2> wall = wall_of(view.settings);
  const Vector<2> target = *view.target;
  const LinePattern dashes{view.points(7.0), view.points(4.0), view.points(7.0), view.points(4.0)};
  marks.push_back(
      {Role::target, std::nullopt,
       Line{target, target - wall.normal * view.metres(line_length), view.points(1.8), view.theme.text, dashes}});
  for (const double radius : {target_radius, 0.45 * target_radius}) {
    marks.push_back({Role::target, std::nullopt,
                     Marker{target, Shape::disc, view.points(radius), view.theme.background.with_alpha(0),
                            view.theme.text, view.points(2.4)}});
  }
  add_ruler_to_proxy(view, target, marks);
}

}  // namespace ghostforce
