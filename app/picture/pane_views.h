// PaneViews: what the panes of the comparison show: each its own strategy's contact, all in the same scale, for lengths
// and for forces alike. Values; pure, any thread.
#pragma once

#include "core/settings.h"
#include "core/snapshot.h"

namespace ghostforce {

struct PaneViews {
  double width;                    // of the world in each [m]
  PerStrategy<Vector<2>> centers;  // [m]
  double share_per_newton;         // length of an arrow, of a pane's width
};

// So that each pane holds goal, device, proxy, contact and force of its own strategy. `unit`: a point of the scene.
PaneViews fitted_pane_views(const Settings& settings, const Snapshot& snapshot, const Vector<2>& pane_size, double unit,
                            double arrow_scale) noexcept;

}  // namespace ghostforce
