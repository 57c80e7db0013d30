// StageTransition: switching is seen, not cut. On a change of the active strategy the stage moves from what the old one
// showed to what the new one shows. Between the two strategies of one motor every picture on the way is the rest at a
// ratio ρ between 1 and the anisotropic one's, under the goal as it stands; what the simulated states differ from their
// own rests is carried along. To and from the fully actuated strategy it is a straight line. Simulation, recordings and
// replay know nothing of it. Values, pure; told the time by whoever draws. Any one thread.
#pragma once

#include <algorithm>

#include "app/state/stage_moment.h"

namespace ghostforce {

// A place among the strategies.
struct StageBlend {
  double fullness = 0.0;  // 1: fully actuated, 0: one motor
  double cure = 0.0;      // of one motor: 0 naïve, 1 anisotropic; the ratio there is ρ_A^cure

  friend bool operator==(const StageBlend&, const StageBlend&) = default;
};

StageBlend stage_blend_of(StrategyId id) noexcept;

// ρ on the way: between 1 and that of anisotropic rendering, in equal steps of its logarithm [1].
double tracking_ratio_at(const Settings& settings, double cure) noexcept;

// What the stage shows at that place. With a device in the hand nothing is between: the active strategy's.
StageMoment stage_moment_between(const Settings& settings, const Snapshot& snapshot, const Vector<2>& goal,
                                 const StageBlend& blend) noexcept;

class StageTransition {
 public:
  static constexpr double usual_s = 0.6;
  static constexpr double slow_s = 6.0;

  explicit StageTransition(StrategyId id) noexcept { jump_to(id); }

  // At once: another scene, or nothing that can be shown in between.
  void jump_to(StrategyId id) noexcept;
  // From what is shown now. Again the same target: goes on as it was.
  void go_to(StrategyId id, bool slowly) noexcept;
  void advance(double interval_s) noexcept { elapsed_s_ = std::min(elapsed_s_ + interval_s, duration_s_); }

  bool is_running() const noexcept { return elapsed_s_ < duration_s_; }
  StrategyId target() const noexcept { return target_; }
  StageBlend blend() const noexcept;

 private:
  StrategyId target_;
  StageBlend from_;
  StageBlend to_;
  double elapsed_s_ = 0.0;
  double duration_s_ = 0.0;
};

}  // namespace ghostforce
