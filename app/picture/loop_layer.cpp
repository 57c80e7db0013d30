// The loop that the active device went round on the last turn of the circle test, filled: what it encloses is what the
// energy of the turn is about.
#include "app/picture/layers.h"

namespace ghostforce {

void add_loop(const View& view, Marks& marks) {
  if (!view.turn_s) return;
  const StrategyId id = view.settings.active;
  std::vector<Vector<2>> loop = last_loop(view.history.moments(), id, *view.turn_s);
  if (loop.size() < 3) return;
  const Colour colour = view.theme.strategy[index_of(id)];
  for (std::size_t i = 1; i < loop.size(); ++i) {
    marks.push_back({Role::area, id, Line{loop[i - 1], loop[i], view.points(1.6), colour}});
  }
  marks.push_back({Role::area, id, Area{std::move(loop), colour.with_alpha(60)}});
}

}  // namespace ghostforce
