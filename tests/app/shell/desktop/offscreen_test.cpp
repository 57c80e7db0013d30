// Pictures as users make them, by the program's own `render`: the same bytes every time, and a clear word where a
// picture cannot be made. The stored pictures are in snapshots_test.cpp.
#include "app/files/image.h"

#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/no_opengl.h"
#include "tests/support/program.h"
#include "tests/support/read_png.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::offscreen_test {
namespace {

Outcome render(std::vector<std::string> words) {
  words.insert(words.begin(), "render");
  return run_ghostforce(std::move(words));
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
  EXPECT_EQ(run_ghostforce(call).exit_code, 130);
  EXPECT_EQ(folder.count(), 0);
}

// Left over from another program, or from another machine.
TEST(Render, ChoosesItsOwnDriverAndSaysSo) {
  const TemporaryFolder folder;
  const auto render = [&](const std::string& name, std::vector<std::string> environment) {
    ProgramCall call;
    call.words = {"render", "wall45", "--size", "640x400", "-o", folder / name};
    call.environment = std::move(environment);
    return run_ghostforce(call);
  };
  ASSERT_EQ(render("plain.png", {}).exit_code, 0);
  const std::string plain = read_whole(folder / "plain.png");
  for (const std::string variable :
       {"GALLIUM_DRIVER=d3d12", "GALLIUM_DRIVER=zink", "GALLIUM_DRIVER=softpipe", "GALLIUM_DRIVER=llvmpype",
        "LIBGL_ALWAYS_SOFTWARE=0", "MESA_LOADER_DRIVER_OVERRIDE=zink", "MESA_GL_VERSION_OVERRIDE=2.1",
        "MESA_GLSL_VERSION_OVERRIDE=110", "MESA_GLES_VERSION_OVERRIDE=1.0",
        "MESA_EXTENSION_OVERRIDE=-GL_ARB_framebuffer_object", "LP_NATIVE_VECTOR_WIDTH=128", "LP_PERF=no_blend"}) {
    const Outcome outcome = render("picture.png", {variable});
    EXPECT_EQ(outcome.exit_code, 0) << variable << '\n' << outcome.err;
    EXPECT_TRUE(read_whole(folder / "picture.png") == plain) << variable;
    EXPECT_NE(outcome.err.find("Drawing offscreen with Mesa's own software renderer"), std::string::npos);
    EXPECT_NE(outcome.err.find(variable.substr(0, variable.find('='))), std::string::npos) << outcome.err;
  }
  const Outcome two = render("picture.png", {"MESA_GL_VERSION_OVERRIDE=2.1", "GALLIUM_DRIVER=zink"});
  EXPECT_TRUE(read_whole(folder / "picture.png") == plain);
  EXPECT_NE(two.err.find("GALLIUM_DRIVER, "), std::string::npos) << two.err;
  const Outcome strangers = render("picture.png", {"ST_ASSETS=1", "DRAW_ME=1", "NIR_VANA=1"});
  EXPECT_EQ(strangers.err.find("ignored"), std::string::npos) << strangers.err;
  EXPECT_NE(two.err.find("MESA_GL_VERSION_OVERRIDE are ignored"), std::string::npos) << two.err;
  EXPECT_EQ(render("picture.png", {"LP_NUM_THREADS=1"}).err.find("LP_NUM_THREADS"), std::string::npos);
}

TEST(Render, SaysWhatIsMissingWhereThereIsNoOpenGl) {
  const TemporaryFolder folder;
  const NoOpenGl no_opengl;
  ProgramCall call;
  call.words = {"render", "wall45", "-o", folder / "picture.png"};
  call.environment = {no_opengl.variable()};
  const Outcome outcome = run_ghostforce(call);
  EXPECT_EQ(outcome.exit_code, 6);
  EXPECT_NE(outcome.err.find("no OpenGL at all"), std::string::npos) << outcome.err;
  for (const std::string words : {"--renderer egl", "libegl1", "libgl1-mesa-dri", "--renderer osmesa", "libosmesa6"}) {
    EXPECT_NE(outcome.err.find(words), std::string::npos) << words << " in " << outcome.err;
  }
  EXPECT_EQ(folder.count(), 0);
}

TEST(Run, SaysHowToMakePicturesWhereThereIsNoDisplay) {
  ProgramCall call;
  call.words = {"run"};
  call.environment = {"DISPLAY=", "WAYLAND_DISPLAY=", "XDG_SESSION_TYPE="};
  const Outcome outcome = run_ghostforce(call);
  EXPECT_EQ(outcome.exit_code, 6);
  EXPECT_NE(outcome.err.find("display"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("ghostforce render"), std::string::npos) << outcome.err;
}

// In pixels and in vectors alike: a step's view is there in the first frame that somebody sees.
TEST(Render, ShowsAStepOfALesson) {
  const TemporaryFolder folder;
  std::vector<nlohmann::json> described;
  for (const char* name : {"step.png", "step.svg"}) {
    const std::string json = folder / (std::string(name) + ".json");
    ASSERT_EQ(render({"--lesson", "ghost", "--step", "2", "--size", "1280x720", "-o", folder / name, "--json", json})
                  .exit_code,
              0);
    described.push_back(nlohmann::json::parse(read_whole(json)));
    EXPECT_EQ(described.back()["lesson"], "ghost");
    EXPECT_EQ(described.back()["step"], 2);
  }
  const double drawn = described[0]["camera"]["points_per_mm"];
  const double composed = described[1]["camera"]["points_per_mm"];
  EXPECT_NEAR(drawn, composed, 0.02 * composed);
}

TEST(Render, RefusesAStepThatALessonDoesNotHave) {
  const TemporaryFolder folder;
  const Outcome outcome = render({"--lesson", "ghost", "--step", "99", "-o", folder / "step.png"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("the lesson ghost has"), std::string::npos) << outcome.err;
  for (const char* const step : {"0", "1.5", "two", "99999999999"}) {
    const Outcome refused = render({"--lesson", "ghost", "--step", step, "-o", folder / "step.png"});
    EXPECT_EQ(refused.exit_code, 2) << step;
    EXPECT_NE(refused.err.find(" is not a whole number, 1 or more"), std::string::npos) << refused.err;
  }
  EXPECT_EQ(render({"--step", "2", "-o", folder / "step.png"}).exit_code, 2);
  EXPECT_EQ(render({"-o", folder / "step.png"}).exit_code, 2) << "neither a scene nor a lesson";
}

}  // namespace
}  // namespace ghostforce::offscreen_test
