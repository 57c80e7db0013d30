// The changes of settings in a run: what they cost to read, and that they add up.
#include <algorithm>
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
std::string run_with(const std::vector<std::string>& changes, int times = 1, const std::string& scene = "fig3-normal") {
  std::string text = run_header(load_scene(scene), recording_columns);
  const std::size_t begin = text.rfind('\n', text.size() - 2) + 1;
  const auto row = [columns = std::count(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end(), ',') +
                              1](std::string_view time) {
    std::string values = fmt::format("naive,{},0,0,0,0,0,0,0,0,1,given,simulated,0,0,0,0.001,0,0", time);
    for (std::ptrdiff_t i = std::count(values.begin(), values.end(), ',') + 1; i < columns; ++i) values += ",0";
    return values + "\n";
  };
  text += row("0");
  for (int i = 0; i < times; ++i) {
    for (const std::string& change : changes) text += fmt::format("# set t_s=0 {}\n", change);
  }
  return text + row("0.001");
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
TEST(RunChanges, MayBeAnyNumberOfThoseThatAHandMakesButFewOfAnythingElse) {
  struct Change {
    const char* scene;
    const char* words;
  };
  for (const auto& [scene, words] :
       {Change{"wall45", "rendering.strategy=\"naive\""}, Change{"wall45", "rendering.tracking_ratio=\"optimal\""},
        Change{"wall45", "device.mass_kg=0.2"}, Change{"wall45", "wall.point_mm=[1, 2]"},
        Change{"corner", "wall.normals_deg=[80, 170]"}, Change{"curve", "wall.center_mm=[1.5, -2]"},
        Change{"arm", "device.base_mm=[-100.25, 0]"}, Change{"arm", "device.links_mm=[150, 160]"},
        Change{"pantograph", "device.bases_mm=[[-40, -130], [40, -130]]"},
        Change{"string", "device.anchors_mm=[[-150, 90], [150, 90.5]]"}}) {
    EXPECT_EQ(words_of_refusal(run_with({words}, 12'000, scene)), "") << words;
  }
  EXPECT_EQ(words_of_refusal(run_with({"wall.point_mm=[1,2]"}, 100)), "");
  EXPECT_NE(words_of_refusal(run_with({"wall.point_mm=[1,2]"}, 10'001)).find("there are more changes of this kind"),
            std::string::npos);
}

// However they are written, a change is the same.
TEST(RunChanges, InBracketsAreWhatTomlMakesOfThem) {
  struct Change {
    const char* scene;
    const char* plain;
    const char* other;
  };
  for (const auto& [scene, plain, other] :
       {Change{"corner", "wall.normals_deg=[80, 170]", "wall.normals_deg=[80,170]"},
        Change{"arm", "device.links_mm=[150.5, 160]", "device.links_mm=[150.5 , 160]"},
        Change{"pantograph", "device.bases_mm=[[-40, -130], [40, -131]]", "device.bases_mm=[[-40,-130],[40,-131]]"},
        Change{"string", "device.anchors_mm=[[-150, 90], [150, 90.5]]", "device.anchors_mm=[[-150,90],[150,90.5]]"}}) {
    const auto plainly = read_run(run_with({plain}, 1, scene), "run.csv");
    ASSERT_EQ(plainly.settings.size(), 2U) << plain;
    EXPECT_NE(plainly.settings[0], plainly.settings[1]) << plain;
    EXPECT_EQ(plainly.settings, read_run(run_with({other}, 1, scene), "run.csv").settings) << plain;
  }
}

TEST(RunChanges, OfBracketsThatAreNoneOrOutOfRangeAreRefused) {
  for (const std::string_view change :
       {"wall.point_mm=[1, 2", "wall.point_mm=[]", "wall.point_mm=[1]", "wall.point_mm=[1, 2, 3]", "wall.point_mm=[, ]",
        "wall.point_mm=[1, 1001]", "wall.point_mm=[1, nan]", "wall.point_mm=[[1, 2]]", "device.mass_kg=[1, 2]"}) {
    EXPECT_NE(words_of_refusal(run_with({std::string(change)})), "") << change;
  }
  for (const std::string_view change : {"device.anchors_mm=[", "device.anchors_mm=[]", "device.anchors_mm=[[1, 2], ",
                                        "device.anchors_mm=[[1, 2], [3, 4], [5, 6], [7, 8], [9, 10]]"}) {
    EXPECT_NE(words_of_refusal(run_with({std::string(change)}, 1, "string")), "") << change;
  }
  EXPECT_NE(words_of_refusal(run_with({"wall.center_mm=[1, 2]"})).find("belongs to kind"), std::string::npos);
  // Each alone is in range, and together they are no corner.
  EXPECT_NE(words_of_refusal(run_with({"wall.normals_deg=[80, 81]"}, 1, "corner")).find("normals_deg"),
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
