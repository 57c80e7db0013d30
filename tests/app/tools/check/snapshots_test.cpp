// The stored pictures of this program, through its own `check`: by EGL, and by OSMesa once more, which must give the same
// bytes. To look at one alone: ghostforce check tests/snapshots --only NAME.
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/scene_file.h"
#include "app/picture/theme.h"
#include "app/picture/view.h"
#include "app/state/lesson_file.h"
#include "tests/support/long_run.h"
#include "tests/support/no_opengl.h"
#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::snapshots_test {
namespace {

namespace fs = std::filesystem;

const std::string snapshots = source_path("/tests/snapshots");
const std::string lesson_snapshots = source_path("/tests/snapshots/lessons");

std::vector<std::string> names_of_files(const std::string& extension, const std::string& folder = snapshots) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == extension) names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

// In one process, without a display. What is not drawn as it is stored lies in the report.
void expect_drawn_as_stored(const std::string& folder, const std::string& renderer) {
  const std::string report =
      fmt::format("{}/{}-{}", GHOSTFORCE_SNAPSHOTS_REPORT, fs::path(folder).stem().string(), renderer);
  std::vector<std::string> call{"check", folder, "--report", report, "--renderer", renderer};
#ifdef GHOSTFORCE_ADDRESS_SANITIZED
  if (!is_long_run()) {
    // Ten of them, spread over the folder.
    const std::vector<std::string> cases = names_of_files(".toml", folder);
    call.emplace_back("--only");
    for (std::size_t i = 0; i < 10; ++i) call.push_back(cases[i * cases.size() / 10]);
  }
#endif
  const Outcome outcome = run_ghostforce(call);
#ifdef __clang__  // rounds the edges of letters otherwise than g++, by which the pictures are stored
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) {
    constexpr std::string_view before_percent = " pixels (";
    if (!line.starts_with("FAIL ")) continue;
    const std::size_t at = line.find(before_percent);
    ASSERT_NE(at, std::string::npos) << line;
    EXPECT_LT(std::stod(line.substr(at + before_percent.size())), 0.1) << line;
  }
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1)
#else
  EXPECT_EQ(outcome.exit_code, 0)
#endif
      << outcome.out << outcome.err << "look at " << report << "/report.html";
}

TEST(SnapshotsFolder, IsDrawnByEglAsItIsStored) {
  expect_drawn_as_stored(snapshots, "egl");
}

TEST(SnapshotsFolder, IsDrawnByOsMesaAsItIsStored) {
  if (!has_osmesa()) GTEST_SKIP() << "this system has no OSMesa";
  expect_drawn_as_stored(snapshots, "osmesa");
}

TEST(LessonSnapshotsFolder, IsDrawnByEglAsItIsStored) {
  expect_drawn_as_stored(lesson_snapshots, "egl");
}

TEST(LessonSnapshotsFolder, IsDrawnByOsMesaAsItIsStored) {
  if (!has_osmesa()) GTEST_SKIP() << "this system has no OSMesa";
  expect_drawn_as_stored(lesson_snapshots, "osmesa");
}

// Each step in light and on a projector, the first one of large letters too.
std::vector<std::string> cases_of(const Lesson& lesson) {
  std::vector<std::string> cases;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    for (const std::string_view theme : {"light", "projector"}) {
      const std::string name = fmt::format("{}-{}-{}", lesson.name, lesson.steps[i].name, theme);
      cases.push_back(name);
      if (i == 0) cases.push_back(name + "-scale-two");
    }
  }
  return cases;
}

std::vector<std::string> names_of_lessons() {
  const std::vector<std::string_view> names = shipped_lesson_names();
  return {names.begin(), names.end()};
}

TEST(LessonSnapshotsFolder, ShowsTheStepsThatItsCasesAreNamedAfter) {
  for (const std::string& name : names_of_lessons()) {
    const Lesson lesson = load_lesson(name);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
      const std::string path = fmt::format("{}/{}-{}-light.toml", lesson_snapshots, lesson.name, lesson.steps[i].name);
      EXPECT_NE(read_whole(path).find(fmt::format("\nstep = {}\n", i + 1)), std::string::npos) << path;
    }
  }
}

TEST(SnapshotsFolder, HasACaseForEachPicture) {
  for (const std::string& folder : {snapshots, lesson_snapshots}) {
    const std::vector<std::string> cases = names_of_files(".toml", folder);
    for (const std::string& picture : names_of_files(".png", folder)) {
      EXPECT_TRUE(std::binary_search(cases.begin(), cases.end(), picture)) << picture << ".png belongs to nothing";
    }
  }
}

TEST(SnapshotsFolder, HoldsNoStepThatNoLessonHas) {
  std::vector<std::string> expected;
  for (const std::string& name : names_of_lessons()) {
    for (std::string& step : cases_of(load_lesson(name))) expected.push_back(std::move(step));
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(names_of_files(".toml", lesson_snapshots), expected);
}

TEST(SnapshotsFolder, HoldsEverySceneUnderEveryStrategyAndEveryWayToCompareInEveryTheme) {
  const std::vector<std::string> cases = names_of_files(".toml");
  const auto expect_case = [&](const std::string& name) {
    EXPECT_TRUE(std::binary_search(cases.begin(), cases.end(), name)) << "want " << name << ".toml";
  };
  for (const std::string_view scene : shipped_scene_names()) {
    if (is_general(load_scene(std::string(scene)).settings)) {
      expect_case(fmt::format("stage-{}", scene));
      continue;
    }
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
}  // namespace ghostforce::snapshots_test
