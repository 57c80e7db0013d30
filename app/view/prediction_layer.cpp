// Thin rings where the closed forms put proxy and device at rest: the simulation has to come to them by itself.
#include "app/view/layers.h"

namespace ghostforce {
namespace {

constexpr double device_ring = 13.5;               // [points], around the device's marker
constexpr double proxy_ring = 11.5;                // [points]
constexpr double inactive_prediction_size = 0.82;  // size for the strategies that are not active

}  // namespace

void add_predictions(const View& view, Marks& marks) {
  for_each_shown(view, [&](StrategyId id) {
    const Equilibrium<2> rest = equilibrium_of(id, view.settings, view.snapshot.goal);
    const double size = view.in_front(id) ? 1.0 : inactive_prediction_size;
    const Colour colour = view.theme.strategy[index_of(id)];
    const auto ring = [&](const Vector<2>& center, double radius) {
      marks.push_back(
          {Role::prediction, id,
           Marker{center, Shape::disc, view.points(radius * size), colour.with_alpha(0), colour, view.points(1.0)}});
    };
    ring(rest.device, device_ring);
    if (rest.in_contact) ring(rest.proxy, proxy_ring);
  });
}

}  // namespace ghostforce
