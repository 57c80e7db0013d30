// Thin rings where the closed form puts proxy and device at rest: the simulation has to come to them by itself.
#include "app/picture/layers.h"

namespace ghostforce {
namespace {

constexpr double device_ring = 15.5;  // around the device's marker [points]
constexpr double proxy_ring = 13.0;

}  // namespace

void add_predictions(const View& view, Marks& marks) {
  const StrategyId id = view.settings.active;
  const Equilibrium<2> rest = equilibrium_of(id, view.settings, view.snapshot.goal);
  const Colour colour = view.theme.strategy[index_of(id)];
  const auto ring = [&](const Vector<2>& center, double radius) {
    marks.push_back({Role::prediction, id,
                     Marker{center, Shape::disc, view.points(radius), colour.with_alpha(0), colour, view.points(1.0)}});
  };
  ring(rest.device, device_ring);
  if (rest.in_contact) ring(rest.proxy, proxy_ring);
}

}  // namespace ghostforce
