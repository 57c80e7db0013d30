// The layers of the picture, back to front; each appends its marks.
#pragma once

#include "app/view/marks.h"
#include "app/view/view.h"

namespace ghostforce {

void add_wall(const View& view, Marks& marks);         // grid, wall, hatching
void add_trails(const View& view, Marks& marks);       // where goal and devices have been
void add_predictions(const View& view, Marks& marks);  // where the closed forms say that everything comes to rest
void add_hand(const View& view, Marks& marks);         // the spring from the goal to the active device
void add_loop(const View& view, Marks& marks);         // the active device's last turn of the circle test
void add_guides(const View& view, Marks& marks);       // legend and scale bars: above trails, below all that moves
// Strategy by strategy, so that all of the active one lies above all of the others.
void add_arrows(const View& view, StrategyId id, Marks& marks);   // rendered force, ghost force, proxy drift
void add_markers(const View& view, StrategyId id, Marks& marks);  // proxy, contact, device
void add_goal(const View& view, Marks& marks);
void add_target(const View& view, Marks& marks);   // where the hand at a device is to aim
void add_handles(const View& view, Marks& marks);  // motor axis, wall grips
void add_labels(const View& view, Marks& marks);   // words and numbers beside the marks above

// --- Where arrow and label layers must agree -------------------------------------------------------------------------

// Length of an arrow per newton [points]; does not change with the zoom, so that pictures can be compared. Panes are
// narrow: their arrows are a third as long, as the scale bar says.
inline double points_per_newton(const View& view) {
  return view.is_pane ? 10.0 : 30.0;
}
// Shorter arrows are not drawn: their head alone would be longer than they are [points].
inline constexpr double shortest_arrow = 7.0;
// Smaller drifts are not drawn [m].
inline constexpr double smallest_drift = 0.0002;

// Where an arrow for a force ends that starts at `tail` [m].
inline Vector<2> arrow_tip(const View& view, const Vector<2>& tail, const Vector<2>& force) {
  return tail + force * view.metres(points_per_newton(view));
}
inline bool is_drawn(const View& view, const Vector<2>& force) {
  return glm::length(force) * points_per_newton(view) >= shortest_arrow;
}
bool has_ghost_arrow(const View& view, StrategyId id);

// The ghost force lies on the same line as the rendered force: its arrow is moved aside, to the free side of the wall
// [points, y down].
Vector<2> ghost_arrow_offset(const View& view);

// The proxy drift as a ruler inside the wall, beside the edge: its two ends [m].
struct DriftRuler {
  Vector<2> from;  // beside the projection of goal or target on the wall
  Vector<2> to;    // beside the contact
};
bool has_drift_ruler(const View& view, StrategyId id);
DriftRuler drift_ruler(const View& view, StrategyId id);
void add_ruler(const View& view, StrategyId id, const DriftRuler& ruler, Marks& marks);

}  // namespace ghostforce
