#include "app/files/run.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <locale>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "app/files/scene_file.h"
#include "ghostforce_version.h"
#include "tests/support/places.h"
#include "tests/support/scene_values.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::run_file_test {
namespace {

std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> pieces{""};
  for (const char c : text) {
    if (c == at) {
      pieces.emplace_back();
    } else {
      pieces.back() += c;
    }
  }
  return pieces;
}

double number(const std::string& text) {
  double value = std::numeric_limits<double>::quiet_NaN();
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  EXPECT_TRUE(error == std::errc{} && end == text.data() + text.size()) << text;
  return value;
}

TEST(RunFile, HeaderTellsVersionSceneAndColumns) {
  Scene scene = load_scene("fig3-normal");
  scene.about = "# end of scene\n# scene:";  // must not be taken for what it is not
  const std::vector<std::string> lines = split(run_header(scene), '\n');
  EXPECT_EQ(lines.front(), "# ghostforce " + std::string(version));
  EXPECT_EQ(lines.back(), "") << "the header ends with a newline";
  EXPECT_EQ(lines[lines.size() - 2],
            "strategy,t_s,goal_x_m,goal_y_m,device_x_m,device_y_m,proxy_x_m,proxy_y_m,force_x_N,force_y_N");
  for (std::size_t i = 0; i + 2 < lines.size(); ++i) {
    EXPECT_TRUE(lines[i].starts_with('#')) << lines[i];
    EXPECT_FALSE(lines[i].ends_with(' ')) << "blanks that nobody sees: '" << lines[i] << "'";
  }

  // The scene can be taken out again.
  std::string text;
  bool within = false;
  for (const std::string& line : lines) {
    if (line == scene_ends) within = false;
    if (within) text += line.size() > 2 ? line.substr(2) + "\n" : "\n";
    if (line == scene_begins) within = true;
  }
  EXPECT_EQ(text, scene_text(scene));
  EXPECT_EQ(scene_values(read_scene(text, "header")), scene_values(scene));
  EXPECT_TRUE(run_header(scene, ",active").ends_with(",force_y_N,active\n"));
}

Snapshot snapshot_with(std::mt19937_64& random) {
  // Any bit pattern that is a number.
  const auto any = [&] {
    double value = 0.0;
    do value = std::bit_cast<double>(random());
    while (!std::isfinite(value));
    return value;
  };
  Snapshot snapshot;
  snapshot.time_s = any();
  snapshot.goal = {any(), any()};
  for (StrategySnapshot<2>& strategy : snapshot.strategies) {
    strategy.device = {any(), any()};
    strategy.proxy = {any(), any()};
    strategy.force = {any(), -0.0};
  }
  return snapshot;
}

TEST(RunFile, RowsReadBackBitForBit) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 3000; ++i) {
    const Snapshot snapshot = snapshot_with(random);
    for (const Strategy& strategy : strategy_catalog()) {
      fmt::memory_buffer row;
      append_run_row(row, snapshot, strategy.id);
      const std::vector<std::string> cells = split({row.data(), row.size()}, ',');
      ASSERT_EQ(cells.size(), split(run_columns, ',').size());
      EXPECT_EQ(cells[0], strategy.name);
      const StrategySnapshot<2>& state = snapshot.strategies[index_of(strategy.id)];
      const double expected[] = {snapshot.time_s, snapshot.goal.x, snapshot.goal.y, state.device.x, state.device.y,
                                 state.proxy.x,   state.proxy.y,   state.force.x,   state.force.y};
      for (std::size_t k = 0; k < std::size(expected); ++k) {
        ASSERT_EQ(std::bit_cast<std::uint64_t>(number(cells[k + 1])), std::bit_cast<std::uint64_t>(expected[k]));
      }
    }
  }
}

TEST(RunFile, NumbersAreShortAndKnowNoLocale) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  Snapshot snapshot;
  snapshot.time_s = 0.001;
  snapshot.goal = {0.1, -1234567.0};
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  fmt::memory_buffer row;
  append_run_row(row, snapshot, StrategyId::naive);
  std::locale::global(before);
  EXPECT_EQ(fmt::to_string(row), "naive,0.001,0.1,-1234567,0,0,0,0,0,0");
}

// --- The page about it ---

TEST(RecordingDoc, OctaveReadsEveryColumn) {
  const std::string page = read_whole(source_path("/docs/recording.md"));
  const std::string_view call = "textscan(file, \"";
  const std::size_t found = page.find(call);
  ASSERT_NE(found, std::string::npos);
  const std::size_t begin = found + call.size();
  const std::vector<std::string> conversions = split(page.substr(begin, page.find('"', begin) - begin), ' ');
  const std::vector<std::string> columns = split(std::string(run_columns) + std::string(recording_columns), ',');
  ASSERT_EQ(conversions.size(), columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool is_text = columns[i] == "strategy" || columns[i] == "goal_kind" || columns[i] == "device_kind";
    EXPECT_EQ(conversions[i], is_text ? "%s" : "%f") << columns[i];
  }
}

}  // namespace
}  // namespace ghostforce::run_file_test
