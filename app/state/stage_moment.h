// StageMoment: what the stage shows of one moment, as values in SI units: taken from a snapshot, from closed forms, or
// on the way from one strategy to another (stage_transition.h). The layers of the stage know nothing else of the model.
// Pure, any thread.
#pragma once

#include <algorithm>

#include "core/settings.h"
#include "core/snapshot.h"

namespace ghostforce {

struct StageMoment {
  // How much of each strategy there is in what is shown: one of them 1, or on the way between two.
  PerStrategy<double> weights{};
  Vector<2> goal{0.0};              // where the hand pulls, q_u [m]
  Vector<2> handle{0.0};            // q_h [m]
  Vector<2> proxy{0.0};             // q_p, which the wall's spring pulls the handle to [m]
  Vector<2> wall_share{0.0};        // what a real wall would put on these motors [N]
  Vector<2> ghost_force{0.0};       // the excess over it [N]
  Vector<2> slide{0.0};             // the proxy drift, along the wall [m]
  Vector<2> expected_rest{0.0};     // where the handle would rest without a ghost force [m]
  Vector<2> expected_contact{0.0};  // where the wall should hold: the foot of the goal's normal [m]
  bool in_contact = false;          // the wall acts
  bool is_measured = false;         // the handle is a device's, and the goal inferred
  bool has_target = false;          // that hand was told where to press: its slide is known all the same
  bool knows_ghost_force = true;    // of a measured handle in the wall only with a target; else ghost_force is 0
  bool has_rest = true;             // under this goal the active strategy comes to rest somewhere
  bool is_outside = false;          // the device cannot follow the handle there, and does nothing

  // Without contact nothing slides, whoever holds the handle.
  bool knows_slide() const noexcept { return !is_measured || has_target || !in_contact; }
  bool is_between() const noexcept { return std::ranges::max(weights) < 1.0; }
};

// As the active strategy has it. `goal`: where the hand pulls, which may be newer than the snapshot.
StageMoment stage_moment(const Settings& settings, const Snapshot& snapshot, const Vector<2>& goal) noexcept;

// The same for a hand that was told to press at a place on the wall: against that its slide is known, whoever holds the
// handle. Other moments stay as they are.
StageMoment with_target(const StageMoment& moment, const Wall<2>& wall, const Vector<2>& target) noexcept;

// Whether the handle is beyond what the device can reach. The loop lets a simulated one run on there; links would hold
// it, and it is shown at their end.
void keep_within_links(const Settings& settings, StageMoment& moment) noexcept;

// At rest under a goal that is held still, by closed form. Without a rest it is where the handle should be.
StageMoment stage_moment_at_rest(const Settings& settings, const Vector<2>& goal) noexcept;

// Excess along the wall's share: positive where the motor pushes too hard, negative where too little [N].
double signed_ghost_force(const StageMoment& moment) noexcept;

// A guess of where the handle comes to rest that tells nothing: between the hand and the wall [m].
Vector<2> neutral_guess(const Settings& settings, const Vector<2>& goal) noexcept;

}  // namespace ghostforce
