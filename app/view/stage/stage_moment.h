// StageMoment: what the stage shows of one moment, as values in SI units. Taken from a snapshot, from closed forms, or
// from something between two of them (stage_transition.h). The layers of the stage know nothing else of the model.
// Pure, any thread.
#pragma once

#include <optional>

#include "core/settings.h"
#include "core/snapshot.h"

namespace ghostforce {

struct StageMoment {
  Wall<2> wall{};
  double actuated_angle = 0.0;  // [rad]
  StrategyId strategy = StrategyId::naive;
  double fullness = 0.0;             // 1: every motor there is, 0: one, and in between on the way from one to the other
  Vector<2> goal{0.0};               // where the hand pulls [m]
  Vector<2> handle{0.0};             // q_h [m]
  Vector<2> proxy{0.0};              // q_p, where the wall holds the handle by its spring [m]
  Vector<2> wall_share{0.0};         // what a real wall would put on these motors [N]
  Vector<2> ghost_force{0.0};        // the excess over it [N]
  Vector<2> slide{0.0};              // the proxy drift, along the wall [m]
  Vector<2> expected_rest{0.0};      // where the handle would be at rest without a ghost force [m]
  Vector<2> expected_contact{0.0};   // the foot of the goal's normal on the wall's surface [m]
  bool in_contact = false;           // the wall acts
  bool is_known = true;              // ghost force and slide can be known: the goal was given, not inferred
  bool is_measured = false;          // the handle is a real or a virtual device's
  bool is_between = false;           // on the way from one strategy to another: no strategy's own numbers
  double user_stiffness = 0.0;       // k_u [N/m]
  double rendering_stiffness = 0.0;  // k_r [N/m]
};

// Of the active strategy; `goal`: where the hand pulls, which may be newer than the snapshot.
StageMoment stage_moment(const Settings& settings, const Snapshot& snapshot, const Vector<2>& goal) noexcept;

// At rest under a goal that is held still, by closed form: what snapshots of a simulation come to.
StageMoment stage_moment_at_rest(const Settings& settings, const Vector<2>& goal) noexcept;

}  // namespace ghostforce
