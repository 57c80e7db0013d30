// The stored pictures of this program, through its own `check`: a test per case file, so that each can be run and can
// fail alone. The pictures of those that fail are in the report's folder. Each is drawn by EGL, and by OSMesa once more,
// which must give the same bytes.
#include <algorithm>
#include <filesystem>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/scene_file.h"
#include "app/lessons/lesson_file.h"
#include "app/view/theme.h"
#include "app/view/view.h"
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

// `cases`: empty for all. `name` of the report, which has a folder of its own: tests run side by side.
void expect_drawn_as_stored(const std::string& folder, const std::vector<std::string>& cases, const std::string& name,
                            const char* renderer = "egl") {
  const std::string report = std::string(GHOSTFORCE_SNAPSHOTS_REPORT) + "/" + name;
  std::vector<std::string> call{"check", folder, "--report", report, "--renderer", renderer};
  if (!cases.empty()) call.push_back("--only");
  call.insert(call.end(), cases.begin(), cases.end());
  const Outcome outcome = run_program(ghostforce_program(), call);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err << "look at " << report << "/report.html";
}

class Snapshots : public testing::TestWithParam<std::string> {};

TEST_P(Snapshots, AreDrawnAsTheyAreStored) {
  expect_drawn_as_stored(snapshots, {GetParam()}, GetParam());
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace_if(
      name.begin(), name.end(),
      [](char c) { return !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(, Snapshots, testing::ValuesIn(names_of_files(".toml")), test_name);

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

// A test for each lesson, not for each step: the program starts once.
class LessonSnapshots : public testing::TestWithParam<std::string> {};

TEST_P(LessonSnapshots, AreDrawnAsTheyAreStored) {
  const Lesson lesson = load_lesson(GetParam());
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const std::string path = fmt::format("{}/{}-{}-light.toml", lesson_snapshots, lesson.name, lesson.steps[i].name);
    EXPECT_NE(read_whole(path).find(fmt::format("\nstep = {}\n", i + 1)), std::string::npos) << path;
  }
  expect_drawn_as_stored(lesson_snapshots, cases_of(lesson), "lesson-" + GetParam());
}

INSTANTIATE_TEST_SUITE_P(, LessonSnapshots, testing::ValuesIn(names_of_lessons()), test_name);

// It draws nothing else than EGL does, so once is enough: not in builds that take long.
#ifndef GHOSTFORCE_ADDRESS_SANITIZED
TEST(SnapshotsFolder, IsDrawnByOsMesaAsItIsStored) {
  if (!has_osmesa()) GTEST_SKIP() << "this system has no OSMesa";
  expect_drawn_as_stored(snapshots, {}, "osmesa", "osmesa");
}

TEST(LessonSnapshotsFolder, IsDrawnByOsMesaAsItIsStored) {
  if (!has_osmesa()) GTEST_SKIP() << "this system has no OSMesa";
  expect_drawn_as_stored(lesson_snapshots, {}, "lessons-osmesa", "osmesa");
}
#endif

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
