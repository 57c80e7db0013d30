// The stage as users have it in files, by the program's own `render`: pixels, vectors and JSON, with its words in them.
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/state/faces_and_modes.h"
#include "core/strategy.h"
#include "tests/support/no_opengl.h"
#include "tests/support/program.h"
#include "tests/support/read_png.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::stage_picture_test {
namespace {

Outcome render_stage(std::vector<std::string> words) {
  words.insert(words.begin(), {"render", "wall45", "--view", "stage"});
  return run_ghostforce(std::move(words));
}

nlohmann::json described(std::vector<std::string> words) {
  const TemporaryFolder folder;
  words.insert(words.end(), {"-o", folder / "a.svg", "--json", folder / "a.json"});
  const Outcome outcome = render_stage(std::move(words));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return nlohmann::json::parse(read_whole(folder / "a.json"));
}

// All words of the picture, a line each.
std::string words_in(const nlohmann::json& picture) {
  std::string words;
  for (const auto& mark : picture["marks"]) {
    if (mark["form"] == "label") words += mark["text"].get<std::string>() + "\n";
  }
  return words;
}

bool says(const nlohmann::json& picture, std::string_view words) {
  return words_in(picture).find(words) != std::string::npos;
}

TEST(StagePicture, IsAsLargeAsItIsAskedForAndTheSameEveryTime) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "b.png"}) {
    ASSERT_EQ(render_stage({"--size", "1024x640", "-o", folder / name}).exit_code, 0);
  }
  const Image image = read_png(folder / "a.png");
  EXPECT_EQ(image.width, 1024);
  EXPECT_EQ(image.height, 640);
  EXPECT_TRUE(read_whole(folder / "a.png") == read_whole(folder / "b.png"));
}

// The window has them, a picture of the scene does not: nobody can press them there.
TEST(StagePicture, HasButtonsOnlyAsAPartOfTheWindow) {
  const TemporaryFolder folder;
  ASSERT_EQ(render_stage({"-o", folder / "window.png"}).exit_code, 0);
  ASSERT_EQ(render_stage({"--part", "scene", "-o", folder / "scene.png"}).exit_code, 0);
  const Image window = read_png(folder / "window.png");
  const Image scene = read_png(folder / "scene.png");
  ASSERT_EQ(window.width, scene.width);
  ASSERT_EQ(window.height, scene.height);
  EXPECT_TRUE(window.rgb != scene.rgb);
  for (const std::string_view format : {"svg", "pdf"}) {
    const std::string path = folder / ("scene." + std::string(format));
    ASSERT_EQ(render_stage({"-o", path}).exit_code, 0);
    EXPECT_EQ(read_whole(path).find("Lessons"), std::string::npos);
  }
}

TEST(StagePicture, SaysItsNumbersInEveryFormat) {
  const auto naive = described({"--strategy", "naive"});
  EXPECT_EQ(naive["view"], "stage");
  EXPECT_FALSE(naive.contains("mode"));
  EXPECT_FALSE(naive.contains("compare"));
  // 1.27 N and 12.0 mm: the closed form with the numbers of wall45.
  for (const std::string_view words : {"1.27", "12.0", "ghost force", "slide", "handle", "your hand pulls here"}) {
    EXPECT_TRUE(says(naive, words)) << words << " is not in\n" << words_in(naive);
  }
  const auto cured = described({"--strategy", "anisotropic"});
  EXPECT_EQ(cured["strategy"], "anisotropic");
  EXPECT_FALSE(says(cured, "1.27"));
  EXPECT_TRUE(says(cured, "0.00")) << words_in(cured);
}

TEST(StagePicture, SpeaksTheLanguageThatItIsAskedFor) {
  const auto spanish = described({"--strategy", "naive", "--language", "es"});
  EXPECT_EQ(spanish["language"], "es");
  for (const std::string_view words : {"12.0", "desliza", "mango", "pared virtual"}) {
    EXPECT_TRUE(says(spanish, words)) << words << " is not in\n" << words_in(spanish);
  }
  EXPECT_FALSE(says(spanish, "ghost"));
  for (const StageModeEntry& each : stage_mode_catalog()) {
    const auto picture = described({"--mode", std::string(each.name), "--language", "es"});
    for (const std::string_view english : {"ghost", "wall", "hand", "motor pushes", "Esc: back"}) {
      EXPECT_FALSE(says(picture, english)) << each.name << ":\n" << words_in(picture);
    }
  }
}

// The same call gives the same picture everywhere.
TEST(StagePicture, DoesNotFollowTheEnvironmentsLanguage) {
  const TemporaryFolder folder;
  for (const char* language : {"C", "es_ES.UTF-8"}) {
    ProgramCall call;
    call.words = {"render", "wall45", "--view", "stage", "-o", folder / language};
    call.environment = {fmt::format("LC_ALL={}", language)};
    ASSERT_EQ(run_ghostforce(call).exit_code, 0);
  }
  EXPECT_TRUE(read_whole(folder / "C") == read_whole(folder / "es_ES.UTF-8"));
}

TEST(StagePicture, IsWordsAndLinesInSvgAndPdfWithoutOpenGl) {
  const NoOpenGl no_opengl;
  const TemporaryFolder folder;
  for (const char* name : {"a.svg", "b.svg", "a.pdf", "b.pdf"}) {
    ProgramCall call;
    call.words = {"render", "wall45", "--view", "stage", "--size", "1280x720", "-o", folder / name};
    call.environment = {no_opengl.variable(), "DISPLAY=", "WAYLAND_DISPLAY="};
    const Outcome outcome = run_ghostforce(call);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  const std::string svg = read_whole(folder / "a.svg");
  EXPECT_TRUE(svg == read_whole(folder / "b.svg"));
  EXPECT_NE(svg.find("viewBox=\"0 0 1280 720\""), std::string::npos);
  const std::string pdf = read_whole(folder / "a.pdf");
  EXPECT_TRUE(pdf == read_whole(folder / "b.pdf"));
  EXPECT_TRUE(pdf.starts_with("%PDF-"));
  EXPECT_NE(pdf.find("/ToUnicode"), std::string::npos) << "letters that a search understands";
  EXPECT_NE(pdf.find("DejaVuSans-Bold"), std::string::npos);
}

TEST(StagePicture, ShowsEachStrategyAndEachModeDifferently) {
  std::set<std::string> pictures;
  for (const Strategy& each : strategy_catalog()) {
    pictures.insert(described({"--strategy", std::string(each.name)})["marks"].dump());
  }
  EXPECT_EQ(pictures.size(), strategy_catalog().size());
  for (const StageModeEntry& each : stage_mode_catalog()) {
    const auto picture = described({"--mode", std::string(each.name)});
    EXPECT_EQ(picture["mode"], each.name);
    EXPECT_TRUE(pictures.insert(picture["marks"].dump()).second) << each.name;
  }
}

// The hand comes from 30 mm outside the wall.
TEST(StagePicture, HasTheHandInSightAtEveryMoment) {
  for (const char* at_s : {"0", "0.2", "0.5", "3"}) {
    const auto picture = described({"--at", at_s, "--size", "1280x720"});
    const auto& camera = picture["camera"];
    bool has_goal = false;
    for (const auto& mark : picture["marks"]) {
      if (mark["role"] != "goal" || mark["form"] != "marker") continue;
      has_goal = true;
      for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
        const double from_middle = mark["center_mm"][axis].get<double>() - camera["center_mm"][axis].get<double>();
        const double half = 0.5 * camera["size"][axis].get<double>() / camera["points_per_mm"].get<double>();
        EXPECT_LT(std::abs(from_middle), 0.8 * half) << at_s << " s, axis " << axis;
      }
    }
    EXPECT_TRUE(has_goal) << at_s;
  }
}

TEST(StagePicture, HasAShortNameForTheLandscape) {
  const TemporaryFolder folder;
  ASSERT_EQ(render_stage({"--mode", "landscape", "-o", folder / "mode.svg"}).exit_code, 0);
  for (const std::vector<std::string>& view : std::vector<std::vector<std::string>>{{}, {"--view", "stage"}}) {
    std::vector<std::string> words{"render", "wall45", "--landscape", "-o", folder / "landscape.svg"};
    words.insert(words.end(), view.begin(), view.end());
    ASSERT_EQ(run_ghostforce(words).exit_code, 0);
    EXPECT_TRUE(read_whole(folder / "landscape.svg") == read_whole(folder / "mode.svg"));
  }
}

TEST(StagePicture, IsNotTheWorkbenchNorAllStrategiesAtOnce) {
  const TemporaryFolder folder;
  const auto expect_refused = [&](std::vector<std::string> words, std::string_view said) {
    words.insert(words.begin(), {"render", "wall45", "-o", folder / "a.png"});
    const Outcome outcome = run_ghostforce(words);
    EXPECT_EQ(outcome.exit_code, 2) << said;
    EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
  };
  expect_refused({"--view", "stage", "--strategy", "all"}, "the stage shows one strategy at a time");
  expect_refused({"--landscape", "--strategy", "all"}, "the stage shows one strategy at a time");
  expect_refused({"--mode", "why", "--compare", "overlay"}, "the stage shows one strategy at a time");
  expect_refused({"--view", "workbench", "--mode", "why"}, "--mode why belongs to the stage");
  expect_refused({"--view", "workbench", "--landscape"}, "--mode landscape belongs to the stage");
  expect_refused({"--landscape", "--mode", "why"}, "--landscape");
  expect_refused({"--view", "stag"}, "did you mean 'stage'?");
  EXPECT_EQ(folder.count(), 0);
}

TEST(StagePicture, IsOnlyThereWhereItIsAskedFor) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_ghostforce({"render", "wall45", "-o", folder / "a.svg", "--json", folder / "a.json"}).exit_code, 0);
  const auto picture = nlohmann::json::parse(read_whole(folder / "a.json"));
  EXPECT_FALSE(picture.contains("view"));
  EXPECT_EQ(picture["compare"], "active-only");
}

}  // namespace
}  // namespace ghostforce::stage_picture_test
