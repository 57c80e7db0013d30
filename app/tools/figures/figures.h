// Every figure: its numbers as a pure function, and the sheet that is drawn from them. Each has a file of its own
// beside this one. Any one thread at a time.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/tools/figures/curves.h"
#include "app/tools/figures/figure.h"
#include "app/tools/figures/simulated_motion.h"
#include "core/hand_estimator.h"
#include "core/prediction.h"
#include "core/strategy.h"
#include "core/workspace_map.h"

namespace ghostforce {

// Figure 1: one motion from A to B into a slanted wall, and where the three devices go.
SimulatedMotion one_motion();
Figure one_motion_figure(const FigureRequest& request);

// Figure 2: the same hand at rest under each strategy: goal, device, proxy and contact.
struct ThreeEquilibria {
  Scene scene;
  PerStrategy<PredictedEquilibrium> rest{};
};
ThreeEquilibria three_equilibria();
CsvTable table_of(const ThreeEquilibria& data);
Figure three_equilibria_figure(const FigureRequest& request);

// Figure 3: three directions in which the hand wants to go: without a motor, into the wall, along the motor.
std::vector<SimulatedMotion> directions_of_intent();
Figure directions_of_intent_figure(const FigureRequest& request);

// Figure 4: the stiffer the rendering against the hand, the larger the ghost force of naïve rendering. k_r/k_u = 1, 5,
// 10, 20.
std::vector<SimulatedMotion> stiffness_ratios();
Figure stiffness_ratios_figure(const FigureRequest& request);

// Figure 6: one and the same hand under the three strategies: a recorded one where there is one, else a simulated hand
// with minimum-jerk motion and tremor. Throws Failure(wrong_call) where the loop is unstable with the recording's
// settings.
SimulatedMotion one_hand(const FigureRequest& request);
Figure one_hand_figure(const FigureRequest& request);

// Force along the motor at rest over the angle between wall normal and motor axis: (11), (15), (20), and the simulated
// loop. x: angle [°]; y: force along the motor, away from the wall [N].
Curves force_over_wall_angle();
Figure force_over_wall_angle_figure(const FigureRequest& request);

// The same over the ratio of rendering stiffness to the hand's. x: k_r/k_u [1].
Curves force_over_stiffness_ratio();
Figure force_over_stiffness_ratio_figure(const FigureRequest& request);

// Proxy drift at rest over the tracking ratio ρ, and over how wrong the renderer's belief about the hand is. Panels:
// these two words; series: anisotropic. x: ρ [1], or k̂_u/k_u [1]; y: drift along the wall, positive the way that naïve
// rendering drifts [mm].
inline constexpr std::string_view over_ratio = "tracking ratio";
inline constexpr std::string_view over_belief = "believed over true k_u";
Curves proxy_drifts();
Figure proxy_drift_figure(const FigureRequest& request);

// Energy that the rendering gives to the hand on one slow closed loop inside the wall, over the tracking ratio ρ, in
// both senses: by the formula, and measured on the simulated loop.
struct EnergyOfLoop {
  StrategyId strategy;
  double ratio;  // ρ [1]
  bool is_counter_clockwise;
  bool is_simulated;  // else by the formula, on the loop of the device at rest under each goal
  double area;        // of the device's loop, counter-clockwise + [m²]
  double energy;      // [J]
};
std::vector<EnergyOfLoop> energies_of_loops();
Figure energy_per_loop_figure(const FigureRequest& request);

// The hand measured live while it grips harder and softer, and the belief that follows it. A moment for each estimate.
struct MeasuredMoment {
  double time_s;
  double k_u;             // of the simulated hand [N/m]
  HandEstimate estimate;  // of it
  double believed_k_u;    // from here on [N/m]
  double live_error;      // of the force along the motor at rest, over that of the fully actuated strategy [1]
  double fixed_error;     // with the belief that the run began with
  double naive_error;
};
std::vector<MeasuredMoment> hand_measured_live();
Figure hand_estimate_figure(const FigureRequest& request);

// What a belief about the hand costs, over how wrong it is, for some angles between motor and wall normal. Series: the
// angle, "45°". x: believed over true k_u [1]; y: ghost force, or proxy drift, over that of naïve rendering [1].
Curves errors_of_wrong_beliefs();
Figure wrong_belief_figure(const FigureRequest& request);

// Base or elbow? Where the handle of an arm may rest, what naïve rendering does there at a wall of the scene's
// direction, for either place of the motor.
struct WallOfMotor {
  std::string motor;
  Vector<2> handle;  // [m]
  WallAtPose found;
};
std::vector<WallOfMotor> walls_of_motors();
Figure which_walls_figure(const FigureRequest& request);

}  // namespace ghostforce
