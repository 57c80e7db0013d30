// The stored pictures of this program, through its own `check`: a test per case file, so that each can be run and can
// fail alone. The pictures of those that fail are in the report's folder.
#include <algorithm>
#include <filesystem>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/scene_file.h"
#include "app/view/theme.h"
#include "app/view/view.h"
#include "tests/support/program.h"

namespace ghostforce {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_of_files(const std::string& extension) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(GHOSTFORCE_SOURCE_DIR "/tests/snapshots")) {
    if (entry.path().extension() == extension) names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class Snapshots : public testing::TestWithParam<std::string> {};

TEST_P(Snapshots, AreDrawnAsTheyAreStored) {
  // A folder each: tests run side by side.
  const std::string report = std::string(GHOSTFORCE_SNAPSHOTS_REPORT) + "/" + GetParam();
  const Outcome outcome =
      run_program(GHOSTFORCE_PROGRAM, std::vector<std::string>{"check", GHOSTFORCE_SOURCE_DIR "/tests/snapshots",
                                                               "--only", GetParam(), "--report", report});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err << "look at " << report << "/report.html";
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace_if(
      name.begin(), name.end(),
      [](char c) { return !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(, Snapshots, testing::ValuesIn(names_of_files(".toml")), test_name);

TEST(SnapshotsFolder, HasACaseForEachPicture) {
  const std::vector<std::string> cases = names_of_files(".toml");
  for (const std::string& picture : names_of_files(".png")) {
    EXPECT_TRUE(std::binary_search(cases.begin(), cases.end(), picture)) << picture << ".png belongs to nothing";
  }
}

TEST(SnapshotsFolder, HoldsEverySceneUnderEveryStrategyAndEveryWayToCompareInEveryTheme) {
  const std::vector<std::string> cases = names_of_files(".toml");
  const auto expect_case = [&](const std::string& name) {
    EXPECT_TRUE(std::binary_search(cases.begin(), cases.end(), name)) << "want " << name << ".toml";
  };
  for (const std::string_view scene : shipped_scene_names()) {
    for (const Strategy& entry : strategy_catalog()) expect_case(fmt::format("{}-{}", scene, entry.name));
    expect_case(fmt::format("{}-all", scene));
  }
  for (const Theme& theme : theme_catalog()) {
    for (const CompareMode& mode : compare_catalog()) expect_case(fmt::format("compare-{}-{}", mode.name, theme.name));
    expect_case(fmt::format("window-{}", theme.name));
    expect_case(fmt::format("scale-two-{}", theme.name));
  }
}

}  // namespace
}  // namespace ghostforce
