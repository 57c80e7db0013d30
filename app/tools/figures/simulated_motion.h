// SimulatedMotion: a scene's hand simulated from beginning to end under all strategies, thinned out to what a picture
// needs; and where theory says that it all comes to rest. What figures 1 to 6 are drawn from. Pure, any thread.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/files/csv_table.h"
#include "app/files/run.h"
#include "app/tools/figures/figure.h"
#include "core/prediction.h"
#include "core/scene.h"
#include "core/snapshot.h"

namespace ghostforce {

struct SimulatedMotion {
  std::string name;  // what sets it apart from the others of its figure
  Scene scene;
  std::vector<SettingsChange> changes{};     // of the scene's settings
  std::vector<Snapshot> moments{};           // every 5th tick, in long motions fewer, and the last one
  PerStrategy<PredictedEquilibrium> rest{};  // by closed form, under the last goal
};

// Throws Failure(wrong_call) where the loop is unstable.
SimulatedMotion simulate_motion(std::string name, const Scene& scene);

// A recorded hand in place of the scene's, with what was changed while it was recorded. Throws likewise.
SimulatedMotion simulate_hand(const RecordedHand& hand);

// The settings in use at a time [s], and in the end.
const Settings& settings_at(const SimulatedMotion& motion, double time_s);
const Settings& last_settings(const SimulatedMotion& motion);

// One row per motion, strategy and moment, and one of the closed form at rest, where t_s is nan.
CsvTable table_of(std::span<const SimulatedMotion> motions);

// The hand of a run, as figure 6 takes it. `name` is what messages and the figure call the run. Throws
// Failure(wrong_call) where the run tells no scene, or has no two ticks to move between.
RecordedHand recorded_hand(const Run& run, std::string name);

}  // namespace ghostforce
