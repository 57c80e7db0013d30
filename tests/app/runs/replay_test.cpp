// A run driven once more: what simulate wrote, what a servo did under every kind of live change, and what is missing.
#include "app/runs/replay.h"

#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/run_file.h"
#include "app/files/run_reader.h"
#include "app/files/scene_file.h"
#include "app/runs/recording.h"
#include "core/simulate.h"
#include "tests/app/runs/recorded_by_dice.h"
#include "tests/support/replay_run.h"

namespace ghostforce {
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
}  // namespace ghostforce
