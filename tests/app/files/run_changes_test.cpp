// The changes of settings in a run: what they cost to read, and that they add up.
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/run.h"
#include "app/files/run_reader.h"
#include "app/files/scene_file.h"

namespace ghostforce::run_changes_test {
namespace {

// A run of two ticks with changes between them.
std::string run_with(const std::vector<std::string>& changes, int times = 1) {
  constexpr std::string_view row = "naive,{},0,0,0,0,0,0,0,0,1,given,simulated,0,0,0,0.001,0,0\n";
  std::string text = run_header(load_scene("fig3-normal"), recording_columns) + fmt::format(row, 0);
  for (int i = 0; i < times; ++i) {
    for (const std::string& change : changes) text += fmt::format("# set t_s=0 {}\n", change);
  }
  return text + fmt::format(row, 0.001);
}

std::string words_of_refusal(const std::string& text) {
  try {
    read_run(text, "run.csv");
  } catch (const ReadError& error) {
    return error.what();
  }
  return "";
}

// A hostile file would else have TOML read a million times.
TEST(RunChanges, MayBeAnyNumberOfNumbersAndWordsButFewOfAnythingElse) {
  for (const std::string_view change :
       {"rendering.strategy=\"naive\"", "rendering.tracking_ratio=\"optimal\"", "device.mass_kg=0.2"}) {
    EXPECT_EQ(words_of_refusal(run_with({std::string(change)}, 30'000)), "");
  }
  EXPECT_EQ(words_of_refusal(run_with({"wall.point_mm=[1, 2]"}, 100)), "");
  EXPECT_NE(words_of_refusal(run_with({"wall.point_mm=[1, 2]"}, 10'001)).find("there are more changes of this kind"),
            std::string::npos);
}

TEST(RunChanges, AddUpInWhateverOrder) {
  const auto run = read_run(run_with({"device.mass_kg=0.2", "wall.point_mm=[1, 2]", "rendering.tracking_ratio=3",
                                      "rendering.strategy=\"full\"", "wall.normal_deg=90", "wall.point_mm=[3, 4]",
                                      "rendering.tracking_ratio=\"optimal\""}),
                            "run.csv");
  ASSERT_EQ(run.settings.size(), 2U);
  Settings expected = load_scene("fig3-normal").settings;
  EXPECT_EQ(run.settings[0], expected);
  expected.mass = 0.2;
  expected.wall_point = {0.003, 0.004};
  expected.wall_normal_angle = 90.0 / degrees_per_radian;
  expected.active = StrategyId::full;
  expected.stiffnesses.chosen_tracking_ratio = std::nullopt;
  EXPECT_EQ(run.settings[1], expected);
}

TEST(RunChanges, OfAWordThatIsNoneAreRefused) {
  for (const std::string_view change : {"rendering.strategy=\"nave\"", "rendering.tracking_ratio=\"best\"",
                                        "device.mass_kg=\"heavy\"", "rendering.strategy=\"", "rendering.strategy"}) {
    EXPECT_NE(words_of_refusal(run_with({std::string(change)})), "") << change;
  }
}

}  // namespace
}  // namespace ghostforce::run_changes_test
