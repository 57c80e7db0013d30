// The hand of a recording, measured by its tones: what the servo found live, found again in its file, and files that do
// not tell it.
#include "app/runs/live_readings.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/run.h"
#include "app/files/run_reader.h"
#include "app/files/scene_file.h"
#include "app/runs/recording.h"
#include "app/runs/replay.h"
#include "device/input/mouse_input.h"
#include "device/servo/servo.h"

namespace ghostforce::live_readings_test {
namespace {

// A recording of a hand that holds still in the wall, and what the servo found meanwhile.
struct Recorded {
  std::string text;
  std::vector<LiveReading> live;
};

Recorded recorded(double seconds, bool follows = false, double rate = 1000.0,
                  StrategyId active = StrategyId::anisotropic) {
  Scene scene = load_scene("wall45");
  scene.settings.rate = rate;
  scene.settings.active = active;
  if (follows) scene.settings.stiffnesses.believed_k_u = 60.0;
  ServoCommand command;
  command.settings = scene.settings;
  command.recording = 1;
  command.measures_hand = true;
  command.belief_follows_hand = follows;
  command.restart_state = state_at_start(scene.goal.points.back());
  Servo servo(std::make_unique<MouseInput>(), command);
  SampleText text(scene.settings);
  fmt::memory_buffer lines;
  Recorded result;
  double newest_s = 0.0;
  for (std::int64_t i = 0; i < std::llround(seconds * rate); ++i) {
    servo.step();
    for (Sample sample; servo.take_record(sample);) text.append(lines, sample);
    const HandReading& hand = servo.newest().hand;
    if (hand.at_s != newest_s) result.live.push_back({hand.at_s, hand.estimate});
    newest_s = hand.at_s;
  }
  result.text = run_header(scene, recording_columns) + std::string(lines.data(), lines.size());
  return result;
}

// The text with these rows changed: each line that is a row goes through `edit`, and an empty one is left out.
std::string edited(const std::string& text, const auto& edit) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    const bool is_row = !line.starts_with('#') && !line.starts_with("strategy");
    if (is_row) line = edit(line);
    if (!is_row || !line.empty()) result += line + "\n";
  }
  return result;
}

// One value of a row, found by its column.
void replace(std::string& row, std::string_view column, const std::string& value) {
  const std::string columns = std::string(run_columns) + std::string(recording_columns) + ",";
  auto place = std::count(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(columns.find(column)), ',');
  std::size_t begin = 0;
  for (; place > 0; --place) begin = row.find(',', begin) + 1;
  const std::size_t end = std::min(row.find(',', begin), row.size());
  row.replace(begin, end - begin, value);
}

double time_of_row(const std::string& row) {
  return std::stod(row.substr(row.find(',') + 1));
}

std::vector<LiveReading> readings_of(const std::string& text) {
  return live_readings(read_run(text, "run.csv"));
}

TEST(LiveReadings, ComeEveryTenthAndEndNearWhatTheServoFound) {
  const Recorded recorded = live_readings_test::recorded(4.0);
  const std::vector<LiveReading> found = readings_of(recorded.text);
  ASSERT_EQ(found.size(), 20U) << "every 0.1 s from 2 s on; the last tick is at 3.999 s";
  const auto last = std::ranges::find_if(recorded.live, [](const auto& each) { return each.estimate.is_known(); });
  ASSERT_NE(last, recorded.live.end());
  EXPECT_FALSE(found[0].estimate.has_number());
  EXPECT_EQ(found[0].estimate.why, HandUnknown::collecting) << "the first of 2 s of ticks has no tone yet";
  EXPECT_TRUE(found.back().estimate.is_known());
  // Windows that end at another phase of the tones, of which the best parabola takes 0.05 % along.
  EXPECT_NEAR(found.back().estimate.k_u, recorded.live.back().estimate.k_u, 1e-3 * 200.0);
  EXPECT_NEAR(found.back().estimate.k_u, 200.0, 0.005 * 200.0) << "the bound for a hand without noise";
}

TEST(LiveReadings, EveryMoveOfTheBeliefIsReplayedBitForBit) {
  const Recorded recorded = live_readings_test::recorded(6.0, true);
  const auto run = read_run(recorded.text, "run.csv");
  ASSERT_GT(run.settings.size(), 5U);
  EXPECT_NEAR(believed_user_stiffness(run.settings.back().stiffnesses), 200.0, 2.0);
  const ReplayReport report = replay(run);
  EXPECT_FALSE(report.first) << report.first->column << " at " << report.first->time_s;
  EXPECT_EQ(report.skipped, 0);
  EXPECT_EQ(report.compared, 6000);
  // And without the tones it is another run.
  auto silent = run;
  for (RunTick& tick : silent.ticks) {
    for (auto& row : tick.rows) row->tone = Vector<2>(0.0);
  }
  EXPECT_TRUE(replay(silent).first);
}

TEST(LiveReadings, ARunWithoutTonesTellsNothing) {
  const Recorded recorded = live_readings_test::recorded(3.0);
  const std::string columns = ",tone_x_N,tone_y_N";
  // The columns are not there, and there but zero.
  std::string without = edited(recorded.text, [](std::string row) {
    for (int i = 0; i < 2; ++i) row.resize(row.rfind(','));
    return row;
  });
  without.erase(without.find(columns), columns.size());
  const std::string zero = edited(recorded.text, [](std::string row) {
    for (int i = 0; i < 2; ++i) row.resize(row.rfind(','));
    return row + ",0,0";
  });
  for (const std::string& text : {without, zero}) {
    const std::vector<LiveReading> found = readings_of(text);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].estimate.why, HandUnknown::no_tones);
    EXPECT_FALSE(found[0].estimate.has_number());
    EXPECT_FALSE(has_tones(read_run(text, "run.csv")));
  }
}

// After what cuts the window short there is no number until 2 s later.
void expect_unknown_from(const std::string& text, double from_s, HandUnknown why) {
  const std::vector<LiveReading> found = readings_of(text);
  int without = 0;
  int again = 0;
  for (const LiveReading& reading : found) {
    const bool is_affected = reading.time_s >= from_s && reading.time_s < from_s + HandEstimator::usual_window_s;
    if (is_affected) {
      ++without;
      EXPECT_EQ(reading.estimate.why, why) << reading.time_s;
      EXPECT_FALSE(reading.estimate.has_number()) << reading.time_s;
    } else if (reading.time_s > from_s + HandEstimator::usual_window_s + 0.1) {
      ++again;
      EXPECT_TRUE(reading.estimate.is_known()) << reading.time_s;
    }
  }
  EXPECT_GE(without, 19);
  EXPECT_GT(again, 5);
}

TEST(LiveReadings, AGapIsDamage) {
  const Recorded recorded = live_readings_test::recorded(6.0);
  expect_unknown_from(edited(recorded.text,
                             [](const std::string& row) {
                               const double time_s = time_of_row(row);
                               return time_s > 2.9995 && time_s < 3.0035 ? std::string() : row;
                             }),
                      3.004, HandUnknown::damaged);
  // Only the row of the device that the tones shake.
  expect_unknown_from(
      edited(recorded.text,
             [](const std::string& row) {
               return std::abs(time_of_row(row) - 3.0) < 1e-4 && row.starts_with("anisotropic") ? std::string() : row;
             }),
      3.0, HandUnknown::damaged);
}

TEST(LiveReadings, ALimitOrALostContactIsNoWindow) {
  const Recorded recorded = live_readings_test::recorded(6.0);
  const auto at_three = [&](std::string_view column, const std::string& value) {
    return edited(recorded.text, [&](std::string row) {
      if (std::abs(time_of_row(row) - 3.0) < 1e-4 && row.starts_with("anisotropic")) replace(row, column, value);
      return row;
    });
  };
  expect_unknown_from(at_three("saturated", "1"), 3.0, HandUnknown::at_limit);
  // In front of the wall.
  expect_unknown_from(at_three("device_x_m", "-0.05"), 3.0, HandUnknown::no_contact);
  // No handle is there, and no motor is that strong.
  expect_unknown_from(at_three("force_x_N", "1e300"), 3.0, HandUnknown::damaged);
}

TEST(LiveReadings, AnotherAxisBeginsAnew) {
  std::string text = live_readings_test::recorded(7.0).text;
  const std::size_t at = text.find("\nfull,3.5,") + 1;
  text.insert(at, "# set t_s=3.5 device.actuated_deg=1\n");
  expect_unknown_from(text, 3.5, HandUnknown::collecting);
}

// The header of a run that was made elsewhere may tell another strategy, or none: the tones tell whose hand it is.
TEST(LiveReadings, AreOfTheDeviceThatTheTonesShake) {
  std::string text = recorded(4.0, false, 1000.0, StrategyId::naive).text;
  const std::string told = "strategy = \"naive\"";
  const std::size_t at = text.find(told);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, told.size(), "strategy = \"full\"");
  EXPECT_NEAR(readings_of(text).back().estimate.k_u, 200.0, 0.005 * 200.0);
}

TEST(LiveReadings, AShortRunHasOneThatSaysSo) {
  const std::vector<LiveReading> found = readings_of(recorded(1.0).text);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].estimate.why, HandUnknown::collecting);
  EXPECT_FALSE(found[0].estimate.has_number());
}

TEST(LiveReadings, HalfOfTheTonesIsNone) {
  std::string text = recorded(3.0).text;
  text.replace(text.find("tone_y_N"), 8, "another_");
  const auto run = read_run(text, "run.csv");
  ASSERT_EQ(run.warnings.size(), 1U);
  EXPECT_NE(run.warnings[0].find("no column tone_y_N"), std::string::npos) << run.warnings[0];
  EXPECT_FALSE(has_tones(run));
}

TEST(LiveReadings, OtherRatesAreReadOrRefused) {
  for (const double rate : {400.0, 2500.0}) {
    SCOPED_TRACE(rate);
    const std::vector<LiveReading> found = readings_of(recorded(4.0, false, rate).text);
    ASSERT_TRUE(found.back().estimate.is_known()) << sentence_of(found.back().estimate.why);
    // At 400 Hz the tick's own delay shows: see docs/theory.md.
    EXPECT_NEAR(found.back().estimate.k_u, 200.0, 0.01 * 200.0);
  }
  const std::vector<LiveReading> slow = readings_of(recorded(4.0, false, 200.0).text);
  ASSERT_FALSE(slow.empty());
  for (const LiveReading& reading : slow) {
    EXPECT_EQ(reading.estimate.why, HandUnknown::rate_too_low);
    EXPECT_FALSE(reading.estimate.has_number());
  }
}

// As of a real device: what was sent counts, and what the model says does not. `gain`: of a handle whose way is shown
// enlarged.
std::string of_a_device(const std::string& text, double gain) {
  return edited(text, [&](std::string row) {
    if (!row.starts_with("anisotropic")) return std::string();
    std::vector<std::string> values;
    for (std::size_t begin = 0; begin <= row.size();) {
      const std::size_t end = std::min(row.find(',', begin), row.size());
      values.push_back(row.substr(begin, end - begin));
      begin = end + 1;
    }
    const double tone = gain * std::stod(values[17]);
    replace(row, "goal_kind", "estimated");
    replace(row, "device_kind", "measured");
    replace(row, "sent_x_N", fmt::format("{}", gain * std::stod(values[8]) + tone));
    replace(row, "tone_x_N", fmt::format("{}", tone));
    return row;
  });
}

TEST(LiveReadings, OfARealDeviceGoByWhatWasSent) {
  const Recorded recorded = live_readings_test::recorded(4.0);
  for (const double gain : {1.0, 0.35}) {
    SCOPED_TRACE(gain);
    const std::string text = of_a_device(recorded.text, gain);
    const std::vector<LiveReading> found = readings_of(text);
    ASSERT_TRUE(found.back().estimate.is_known()) << sentence_of(found.back().estimate.why);
    EXPECT_NEAR(found.back().estimate.k_u, 200.0, 0.005 * 200.0);
  }
}

// Between two of its rows a real hand may have moved as it liked.
TEST(LiveReadings, ALateLoopAtARealDeviceIsAGap) {
  const std::string text = of_a_device(live_readings_test::recorded(6.0).text, 1.0);
  const auto with_loop_s = [&](const std::string& loop_s) {
    return edited(text, [&](std::string row) {
      if (std::abs(time_of_row(row) - 3.0) < 1e-4) replace(row, "loop_s", loop_s);
      return row;
    });
  };
  expect_unknown_from(with_loop_s("0.5"), 3.0, HandUnknown::damaged);
  EXPECT_EQ(readings_of(with_loop_s("0.004")).size(), readings_of(text).size());
  EXPECT_TRUE(readings_of(with_loop_s("0.004"))[15].estimate.is_known());
}

}  // namespace
}  // namespace ghostforce::live_readings_test
