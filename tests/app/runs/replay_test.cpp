// A run driven once more: what simulate wrote, what a servo did under every kind of live change, and what is missing.
#include "app/runs/replay.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/program_build.h"
#include "app/files/run.h"
#include "app/files/run_reader.h"
#include "app/files/scene_file.h"
#include "app/runs/recording.h"
#include "core/simulate.h"
#include "tests/app/runs/recorded_by_dice.h"

namespace ghostforce::replay_test {
namespace {

ReplayReport replay_text(const std::string& text) {
  const auto run = read_run(text, "run.csv");
  return replay(run, [](const ReplayedTick&) {});
}

TEST(Replay, RepeatsWhatAServoDidUnderEveryLiveChangeBitForBit) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const auto run = read_run(recorded_by_dice(seed, 600), "run.csv");
    EXPECT_TRUE(run.warnings.empty()) << run.warnings.front();
    ASSERT_GT(run.settings.size(), 100U);
    ASSERT_GT(run.states.size(), 10U);
    const ReplayReport report = replay(run, [](const ReplayedTick&) {});
    if (report.first) {
      ADD_FAILURE() << report.first->column << " at " << report.first->time_s << ": " << report.first->recorded
                    << " became " << report.first->replayed;
    }
    EXPECT_EQ(report.skipped, 0);
    EXPECT_EQ(report.compared, static_cast<std::int64_t>(run.ticks.size()));
    EXPECT_GT(report.compared, 5000);
  }
}

// A hand that trembles, drifts and changes its grip, seen through an encoder: its goals are in the rows, and its
// stiffness follows from the scene in the header.
TEST(Replay, RepeatsAHandThatIsNotStillBitForBit) {
  const Scene scene = load_scene(
      "wall45", std::vector<std::string>{"device.encoder_mm=0.06", "user.tremor_mm_rms=0.3", "user.drift_mm_per_s=10",
                                         "user.k_u_path_N_per_m=[200, 500, 120]", "user.k_u_times_s=[0, 3.5, 6]"});
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    auto run = read_run(recorded_by_dice(seed, 600, 0, scene), "run.csv");
    EXPECT_TRUE(run.warnings.empty()) << run.warnings.front();
    EXPECT_EQ(run.scene->stiffness_path, scene.stiffness_path);
    const ReplayReport report = replay(run);
    if (report.first) {
      ADD_FAILURE() << report.first->column << " at " << report.first->time_s << ": " << report.first->recorded
                    << " became " << report.first->replayed;
    }
    EXPECT_EQ(report.skipped, 0);
    EXPECT_GT(report.compared, 5000);
    run.scene->stiffness_path = {};
    EXPECT_TRUE(replay(run).first) << "the stiffness counts";
  }
}

TEST(Replay, AHandPlayedFromZeroIsAsStiffAsItWas) {
  Scene scene = load_scene("wall45");
  scene.stiffness_path = {{200.0, 500.0}, {0.0, 5.0}};
  RunFacts run;
  run.scene = scene;
  RunTick first;
  first.time_s = 3.0;
  EXPECT_EQ(scene_since(run, first).stiffness_path, (StiffnessPath{{380.0, 500.0}, {0.0, 2.0}}));
}

TEST(Replay, FindsTheLastBitOfAnyValueThatIsAnother) {
  const auto whole = read_run(recorded_by_dice(4, 60), "run.csv");
  std::mt19937 random(9);
  for (int i = 0; i < 100; ++i) {
    auto run = whole;
    RunTick& tick = run.ticks[random() % run.ticks.size()];
    const StrategyId id = strategy_catalog()[random() % strategy_count].id;
    RunRow& row = *tick.rows[index_of(id)];
    // Where it goes on from a recorded state, only forces are the replay's own.
    const auto which = tick.state != RunTick::none ? 4 + random() % 2 : random() % 6;
    double& value = which == 0   ? row.device.x
                    : which == 1 ? row.device.y
                    : which == 2 ? row.proxy.x
                    : which == 3 ? row.proxy.y
                    : which == 4 ? row.force.x
                                 : row.force.y;
    value = std::nextafter(value, 10.0);
    const ReplayReport report = replay(run, [](const ReplayedTick&) {});
    ASSERT_TRUE(report.first);
    EXPECT_EQ(report.diverging, 1);
    EXPECT_EQ(report.first->time_s, tick.time_s);
    EXPECT_EQ(report.first->strategy, id);
    EXPECT_EQ(report.first->recorded, value);
    EXPECT_EQ(report.first->column.substr(0, 5), which < 2 ? "devic" : which < 4 ? "proxy" : "force");
  }
}

// The last bits of every value another, as a build that rounds otherwise leaves them.
Run rounded_otherwise(Run run) {
  std::mt19937 random(3);
  for (RunTick& tick : run.ticks) {
    for (std::optional<RunRow>& row : tick.rows) {
      for (Vector<2>* const vector : {&row->device, &row->proxy, &row->force}) {
        // A recorded state is where the replay goes on: what follows from it would not be this run.
        if (tick.state != RunTick::none && vector != &row->force) continue;
        for (double* const value : {&vector->x, &vector->y})
          *value = std::nextafter(*value, random() % 2 == 0 ? 9 : -9);
      }
    }
  }
  return run;
}

TEST(Replay, AgreesWithAnotherBuildThatRoundsOtherwise) {
  auto run = rounded_otherwise(read_run(recorded_by_dice(7, 100), "run.csv"));
  const ReplayReport report = replay(run);
  ASSERT_TRUE(report.first);
  EXPECT_EQ(report.first->time_s, run.ticks.front().time_s);
  EXPECT_EQ(report.diverging, static_cast<std::int64_t>(run.ticks.size()));
  EXPECT_GT(report.worst().relative(), 1e-17);
  EXPECT_LE(report.worst().relative(), 2.3e-16) << "the last of 53 bits";
  EXPECT_FALSE(report.of(ReplayedQuantity::time).greatest);

  ASSERT_EQ(run.version, program_build());
  EXPECT_EQ(agreement(run, report), Agreement::diverging) << "the same build repeats every bit";
  for (const std::string& other : {program_build() + ", page", std::string("0.0.1"), std::string()}) {
    run.version = other;
    EXPECT_EQ(agreement(run, report), Agreement::close) << other;
  }
}

TEST(Replay, DoesNotAgreeWithAnotherBuildThatIsOffByMore) {
  auto run = rounded_otherwise(read_run(recorded_by_dice(8, 100), "run.csv"));
  run.version = program_build() + ", page";
  const double magnitude = replay(run).of(ReplayedQuantity::force).magnitude;
  EXPECT_GT(magnitude, 1.0);
  RunTick& tick = run.ticks[700];
  RunRow& row = *tick.rows[index_of(StrategyId::naive)];
  const double force = row.force.y;
  for (const auto& [relative, wanted] :
       {std::pair(0.9e-12, Agreement::close), std::pair(1.1e-12, Agreement::diverging),
        std::pair(1e-9, Agreement::diverging), std::pair(std::nan(""), Agreement::diverging),
        std::pair(std::numeric_limits<double>::infinity(), Agreement::diverging)}) {
    SCOPED_TRACE(relative);
    row.force.y = force + relative * magnitude;
    const ReplayReport report = replay(run);
    EXPECT_EQ(agreement(run, report), wanted);
    const Deviation& worst = report.worst();
    EXPECT_EQ(&worst, &report.of(ReplayedQuantity::force));
    EXPECT_EQ(worst.magnitude, magnitude) << "a damaged value is no measure";
    ASSERT_TRUE(worst.greatest);
    EXPECT_EQ(worst.greatest->time_s, tick.time_s);
    EXPECT_EQ(worst.greatest->strategy, StrategyId::naive);
    EXPECT_EQ(worst.greatest->column, "force_y_N");
  }
}

TEST(Replay, MeasuresWhatIsZeroButForRoundingWithItsQuantity) {
  const std::vector<std::string> straight_down{"wall.normal_deg=90", "goal.path_mm=[[0, 40], [0, -40]]"};
  Scene scene = load_scene("fig3-normal", straight_down);
  scene.duration = 0.8;
  fmt::memory_buffer rows;
  simulate(scene, last_tick(scene), [&](const Snapshot& snapshot) {
    append_run_row(rows, snapshot, StrategyId::full);
    rows.push_back('\n');
  });
  auto run = read_run(run_header(scene) + std::string(rows.data(), rows.size()), "run.csv");
  run.version = "0.0.1";
  ASSERT_EQ(agreement(run, replay(run)), Agreement::identical);
  RunRow& row = *run.ticks[700].rows[index_of(StrategyId::full)];
  ASSERT_GT(row.force.y, 1.0);
  ASSERT_LT(std::abs(row.force.x), 1e-13);
  row.force.x += 1e-14;
  EXPECT_EQ(replay(run).diverging, 1);
  EXPECT_EQ(agreement(run, replay(run)), Agreement::close);
  row.force.x += 1e-9;
  EXPECT_EQ(agreement(run, replay(run)), Agreement::diverging);
}

TEST(Replay, TakesTheSignOfAZeroForABitButNotForADifference) {
  auto run = read_run(recorded_by_dice(7, 20), "run.csv");
  bool has_zero = false;
  for (RunTick& tick : run.ticks) {
    for (std::optional<RunRow>& row : tick.rows) {
      if (std::exchange(has_zero, has_zero || row->force.x == 0.0) || row->force.x != 0.0) continue;
      row->force.x = -row->force.x;
    }
  }
  ASSERT_TRUE(has_zero);
  const ReplayReport report = replay(run);
  EXPECT_EQ(report.diverging, 1);
  EXPECT_EQ(report.worst().relative(), 0.0);
  EXPECT_EQ(agreement(run, report), Agreement::diverging);
  run.version.clear();
  EXPECT_EQ(agreement(run, report), Agreement::close);
}

TEST(Replay, OfNothingIsNoAgreement) {
  auto run = read_run(recorded_by_dice(9, 10), "run.csv");
  run.ticks.clear();
  EXPECT_EQ(agreement(run, replay(run)), Agreement::unknown);
}

TEST(Replay, GoesOnAfterLostSamples) {
  const auto run = read_run(recorded_by_dice(5, 200, 20), "run.csv");
  EXPECT_EQ(run.dropped, 9U) << "what is lost after the last row does not show";
  const ReplayReport report = replay(run, [](const ReplayedTick&) {});
  EXPECT_FALSE(report.first);
  EXPECT_EQ(report.skipped, 0);
  EXPECT_GE(report.resumed, 9);
}

TEST(Replay, LeavesOutWhatFollowsFromMissingRows) {
  Scene scene = load_scene("fig3-normal");
  scene.duration = 0.1;
  fmt::memory_buffer rows;
  simulate(scene, last_tick(scene), [&](const Snapshot& snapshot) {
    append_run_row(rows, snapshot, StrategyId::naive);
    rows.push_back('\n');
  });
  const std::string text = run_header(scene) + std::string(rows.data(), rows.size());
  EXPECT_EQ(replay_text(text).compared, 101);

  std::string shorter = text;
  shorter.erase(shorter.find("\nnaive,0.06,"), shorter.find("\nnaive,0.061,") - shorter.find("\nnaive,0.06,"));
  const ReplayReport report = replay_text(shorter);
  EXPECT_FALSE(report.first);
  EXPECT_EQ(report.compared, 60);
  EXPECT_EQ(report.skipped, 40);

  const std::string headless = text.substr(0, text.find("\nnaive,0,")) + text.substr(text.find("\nnaive,0.001,"));
  EXPECT_EQ(replay_text(headless).compared, 0);
  EXPECT_EQ(replay_text(headless).skipped, 100);
}

TEST(Replay, LeavesMeasuredDevicesAsTheyAreAndComparesTheOthers) {
  // As the servo ticks with the device in the hand: tick_with_device() of core, with motors that give half of what is
  // asked.
  const Scene scene = load_scene("wall45");
  const TickCoefficients<2> coefficients = coefficients_of(scene.settings);
  TickState<2> state = simulate(scene, last_tick(scene), [](const Snapshot&) {});
  SampleText text(scene.settings);
  fmt::memory_buffer lines;
  std::uint64_t serial = 0;
  const auto record = [&] {
    Sample sample;
    sample.snapshot = snapshot_of(coefficients, state);
    for (std::size_t i = 0; i < strategy_count; ++i) sample.velocity[i] = state.strategies[i].motion.velocity;
    sample.settings = scene.settings;
    sample.serial = serial++;
    text.append(lines, sample);
  };
  const StrategyId active = scene.settings.active;
  for (int k = 0; k < 400; ++k) {
    record();
    const double phase = 0.02 * k;
    if (k / 100 % 2 == 0) {
      tick(coefficients, Vector<2>(0.02 * std::sin(phase), -0.02), state);
    } else {
      const auto& before = state.strategies[index_of(active)];
      tick_with_device(coefficients, active, Vector<2>(0.01 * std::sin(phase), -0.01 * std::cos(phase)),
                       Vector<2>(300.0 * (before.proxy.x - before.motion.position.x), 0.0), 200.0, state);
    }
  }
  std::string file = run_header(scene, recording_columns) + std::string(lines.data(), lines.size());
  const auto run = read_run(file, "run.csv");
  const ReplayReport report = replay(run, [](const ReplayedTick&) {});
  EXPECT_FALSE(report.first);
  EXPECT_EQ(report.compared, 400);
  EXPECT_EQ(report.measured, 199);
  EXPECT_EQ(report.resumed, 4) << "the beginning, and each time motors come on or go off";
  ASSERT_EQ(run.ticks[150].measured, active);

  // A simulated device beside the measured one is compared.
  auto other = run;
  other.ticks[150].rows[index_of(StrategyId::full)]->device.x += 1e-9;
  EXPECT_TRUE(replay(other, [](const ReplayedTick&) {}).first);
}

}  // namespace
}  // namespace ghostforce::replay_test
