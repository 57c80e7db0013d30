// Pictures as users make them, by the program's own `render`: the same bytes every time, and a clear word where a
// picture cannot be made. The stored pictures are in snapshots_test.cpp.
#include "app/image.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "app/png_file.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {
namespace {

Outcome render(std::vector<std::string> words) {
  words.insert(words.begin(), "render");
  return run_program(GHOSTFORCE_PROGRAM, std::move(words));
}

TEST(Render, MakesTheSameBytesOnEveryRun) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "b.png"}) {
    ASSERT_EQ(render({"fig1", "--strategy", "all", "-o", folder / name}).exit_code, 0);
  }
  EXPECT_EQ(read_whole(folder / "a.png"), read_whole(folder / "b.png"));
}

TEST(Render, DrawsEachStrategyAndEachMomentDifferently) {
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> calls{{"--strategy", "full"},
                                                    {"--strategy", "naive"},
                                                    {"--strategy", "anisotropic"},
                                                    {"--strategy", "all"},
                                                    {"--strategy", "all", "--at", "0.5"},
                                                    {"--strategy", "all", "--set", "wall.normal_deg=120"}};
  std::vector<std::string> pictures;
  for (std::vector<std::string> words : calls) {
    words.insert(words.end(), {"wall45", "-o", folder / "picture.png"});
    ASSERT_EQ(render(words).exit_code, 0);
    pictures.push_back(read_whole(folder / "picture.png"));
    for (std::size_t i = 0; i + 1 < pictures.size(); ++i) EXPECT_NE(pictures[i], pictures.back()) << i;
  }
}

TEST(Render, ShowsTheScenesOwnStrategyUnlessToldOtherwise) {
  const TemporaryFolder folder;
  ASSERT_EQ(render({"wall45", "-o", folder / "default.png"}).exit_code, 0);
  ASSERT_EQ(render({"wall45", "--strategy", "naive", "-o", folder / "naive.png"}).exit_code, 0);
  EXPECT_EQ(read_whole(folder / "default.png"), read_whole(folder / "naive.png"));
}

TEST(Render, RefusesTwoOutputsOfOneName) {
  const TemporaryFolder folder;
  EXPECT_EQ(render({"wall45", "-o", folder / "a", "--json", folder / "a"}).exit_code, 2);
  EXPECT_EQ(folder.count(), 0);
}

TEST(Render, DrawsUpToItsGreatestSize) {
  const TemporaryFolder folder;
  const std::string path = folder / "large.png";
  ASSERT_EQ(render({"wall45", "--size", "4096x4096", "-o", path}).exit_code, 0);
  const Image image = read_png(path);
  EXPECT_EQ(image.width, 4096);
  EXPECT_EQ(image.height, 4096);
}

TEST(Render, DescribesWhatItDrewAsJson) {
  const TemporaryFolder folder;
  const std::string path = folder / "picture.json";
  ASSERT_EQ(render({"wall45", "--strategy", "naive", "-o", folder / "picture.png", "--json", path}).exit_code, 0);
  const auto picture = nlohmann::json::parse(read_whole(path));
  EXPECT_EQ(picture["strategy"], "naive");
  EXPECT_EQ(picture["t_s"], 3.0);
  int devices = 0;
  for (const auto& mark : picture["marks"]) {
    if (mark["role"] != "device" || mark["form"] != "marker") continue;
    ++devices;
    EXPECT_EQ(mark["strategy"], "naive");
    // Where (14) and (15) put it with this scene's numbers: 14.142 − 16.930 mm. Two seconds after the motion has ended
    // the simulation is there to a thousandth.
    EXPECT_NEAR(mark["center_mm"][0].get<double>(), -2.788, 0.001);
  }
  EXPECT_EQ(devices, 1);
}

TEST(Render, RefusesASizeAMomentAndAPartThatCannotBe) {
  const TemporaryFolder folder;
  const std::string path = folder / "picture.png";
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"--size", "0x0"},
                                                                                     {"--size", "1280"},
                                                                                     {"--size", "5000x100"},
                                                                                     {"--size", "800x600x2"},
                                                                                     {"--size", "-5x20"},
                                                                                     {"--at", "-1"},
                                                                                     {"--at", "nan"},
                                                                                     {"--at", "1e9"},
                                                                                     {"--part", "windw"},
                                                                                     {"--theme", "drak"},
                                                                                     {"--scale", "0"},
                                                                                     {"--scale", "nan"},
                                                                                     {"--scale", "5"},
                                                                                     {"--at", "abc"},
                                                                                     {"--strategy", "naiv"}}) {
    std::vector<std::string> call{"wall45", "-o", path};
    call.insert(call.end(), words.begin(), words.end());
    const Outcome outcome = render(call);
    EXPECT_EQ(outcome.exit_code, 2) << words[0] << ' ' << words[1];
    EXPECT_NE(outcome.err.find(words[0]), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_EQ(folder.count(), 0);
}

TEST(Render, SaysWhereItCannotWrite) {
  const Outcome outcome = render({"wall45", "-o", "/nonexistent/folder/picture.png"});
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_NE(outcome.err.find("/nonexistent/folder"), std::string::npos) << outcome.err;
}

TEST(Render, SaysSoWhereTheSettingsMakeTheLoopUnstable) {
  const TemporaryFolder folder;
  const Outcome outcome = render(
      {"wall45", "-o", folder / "picture.png", "--set", "rendering.k_r_N_per_m=1e6", "--set", "device.mass_kg=0.001"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("unstable"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.count(), 0);
}

TEST(Render, LeavesNothingBehindWhenInterrupted) {
  const TemporaryFolder folder;
  ProgramCall call;
  // Ten million ticks: long enough to be met in the middle.
  call.words = {"render", "wall45", "--set", "goal.duration_s=10000", "-o", folder / "picture.png"};
  call.signal_when_created_in = folder.path();
  call.signal = SIGINT;
  EXPECT_EQ(run_program(GHOSTFORCE_PROGRAM, call).exit_code, 130);
  EXPECT_EQ(folder.count(), 0);
}

TEST(Render, SaysWhichOpenGlThereIsWhenItIsTooOld) {
  const TemporaryFolder folder;
  ProgramCall call;
  call.words = {"render", "wall45", "-o", folder / "picture.png"};
  call.environment = {"MESA_GL_VERSION_OVERRIDE=2.1"};
  const Outcome outcome = run_program(GHOSTFORCE_PROGRAM, call);
  EXPECT_EQ(outcome.exit_code, 6);
  EXPECT_NE(outcome.err.find("OpenGL 2.1"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("llvmpipe"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.count(), 0);
}

TEST(Run, SaysHowToMakePicturesWhereThereIsNoDisplay) {
  ProgramCall call;
  call.words = {"run"};
  call.environment = {"DISPLAY=", "WAYLAND_DISPLAY=", "XDG_SESSION_TYPE="};
  const Outcome outcome = run_program(GHOSTFORCE_PROGRAM, call);
  EXPECT_EQ(outcome.exit_code, 6);
  EXPECT_NE(outcome.err.find("display"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("ghostforce render"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace ghostforce
