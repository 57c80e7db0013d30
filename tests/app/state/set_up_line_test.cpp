#include "app/state/set_up.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "app/files/read_error.h"
#include "app/files/scene_file.h"
#include "tests/support/paper_scenes.h"
#include "tests/support/random_set_up.h"
#include "tests/support/set_up_values.h"

namespace ghostforce::set_up_line_test {
namespace {

using namespace std::string_literals;

SetUp shipped(const std::string& name, const std::vector<std::string>& overrides = {}) {
  SetUp set_up;
  set_up.scene = load_scene(name, overrides);
  set_up.goal = set_up.scene.goal.points.back();
  return set_up;
}

// What is wrong with a line; empty: nothing.
std::string refusal_of(std::string_view line) {
  try {
    read_set_up_line(line);
    return {};
  } catch (const ReadError& error) {
    EXPECT_EQ(error.kind(), ReadError::Kind::wrong);
    return error.what();
  }
}

void expect_refused(std::string_view line, std::string_view words) {
  const std::string refusal = refusal_of(line);
  EXPECT_NE(refusal.find(words), std::string::npos) << line.substr(0, 200) << "\n" << refusal;
}

TEST(SetUpLine, RestoresAThousandRandomSetUpsBitForBit) {
  Random random(15);
  std::set<std::string> bases;
  for (int i = 0; i < 1000; ++i) {
    const auto set_up = random_set_up(random);
    const std::string line = set_up_line(set_up);
    const auto again = read_set_up_line(line);
    ASSERT_EQ(set_up_values(again), set_up_values(set_up)) << i << ": " << line;
    ASSERT_EQ(set_up_line(again), line) << "the same set-up, the same line";
    bases.insert(line.substr(0, line.find(' ', "ghostforce run "s.size())));
  }
  EXPECT_EQ(bases.size(), paper_scene_names().size()) << "each shipped scene is the nearest one at times";
}

TEST(SetUpLine, SaysOnlyWhatDiffersFromTheNearestScene) {
  for (const std::string_view name : shipped_scene_names()) {
    EXPECT_EQ(set_up_line(shipped(std::string(name))), "ghostforce run " + std::string(name) + " --view stage");
  }
  auto set_up = shipped("wall45");
  set_up.scene.settings.active = StrategyId::full;
  set_up.goal = {0.025, -0.01};
  set_up.mode = StageMode::why;
  EXPECT_EQ(set_up_line(set_up), "ghostforce run wall45 --goal-mm=25,-10 --strategy full --view stage --mode why");
  set_up.face = Face::workbench;
  EXPECT_EQ(set_up_line(set_up), "ghostforce run wall45 --goal-mm=25,-10 --strategy full --view workbench")
      << "modes are the stage's";
  EXPECT_EQ(set_up_line(shipped("fig1", {"goal.motion=minimum-jerk", "rendering.k_c_N_per_m=inf",
                                         "user.believed_k_u_N_per_m=50", "rendering.tracking_ratio=2"})),
            "ghostforce run fig1 --set user.believed_k_u_N_per_m=50.0 --set rendering.k_c_N_per_m=inf"
            " --set rendering.tracking_ratio=2.0 --set goal.motion=minimum-jerk --view stage");
  EXPECT_EQ(set_up_line(shipped("wall45", {"goal.path_mm=[[1, 2]]", "goal.times_s=[0]"})),
            "ghostforce run wall45 --set 'goal.path_mm=[[1.0, 2.0]]' --set 'goal.times_s=[0.0]' --view stage");
}

TEST(SetUpLine, TellsGeneralScenes) {
  const auto line_and_back = [](const auto& set_up) {
    const std::string line = set_up_line(set_up);
    const auto again = read_set_up_line(line);
    EXPECT_EQ(set_up_values(again), set_up_values(set_up)) << line;
    return line;
  };
  EXPECT_EQ(line_and_back(shipped("arm", {"device.motor=elbow", "user.k_u_second_N_per_m=80"})),
            "ghostforce run arm --set device.motor=elbow --set user.k_u_second_N_per_m=80.0 --view stage");
  // A device and a wall that no shipped scene has together.
  line_and_back(shipped("corner", {"device.kind=strings", "device.anchors_mm=[[150, 100], [-150, 0]]"}));
  line_and_back(shipped("wall45", {"user.k_u_second_N_per_m=80", "user.k_u_first_deg=30"}));
  line_and_back(shipped("pantograph", {"wall.kind=circle", "wall.center_mm=[0, 20]", "wall.radius_mm=30",
                                       "wall.free=inside", "rendering.compliance_share=0.5"}));
}

TEST(SetUpLine, LeavesOutTitleAndAbout) {
  auto set_up = shipped("wall45");
  set_up.scene.title = "mine";
  set_up.scene.about = "two\nlines";
  EXPECT_EQ(set_up_line(set_up), "ghostforce run wall45 --view stage");
  EXPECT_EQ(read_set_up_line(set_up_line(set_up)).scene.title, load_scene("wall45").title);
}

TEST(SetUpLine, ReadsWhatPeoplePaste) {
  const auto set_up = read_set_up_line("ghostforce run wall45 --goal-mm=25,-10 --strategy naive --view stage");
  const auto expected = set_up_values(set_up);
  for (const std::string_view line : {
           "$ ghostforce run wall45 --goal-mm=25,-10 --strategy naive --view stage\n",
           "user@host:~$ ghostforce run wall45 --goal-mm=25,-10 --strategy naive",
           "user@host ~/src/ghostforce % build/release/bin/ghostforce run --goal-mm=25,-10 --strategy naive",
           "(venv) [root@host /tmp]# ghostforce run wall45 --goal-mm=25,-10\n  --strategy naive",
           "user@host ~> ghostforce run wall45 --goal-mm=25,-10 --strategy naive",
           "% ./demo --goal-mm=25,-10 --strategy naive",
           "> /opt/ghostforce run wall45 --goal-mm=25,-10 --strategy naive",
           "$ wall45 --goal-mm=25,-10 --strategy naive",
           "wall45 --goal-mm 25,-10 --strategy=naive",
           "  run --strategy naive --goal-mm=25.0,-1e1  ",
           "./demo --goal-mm=+25,-10 --strategy naive",
           "build/release/bin/ghostforce run \"wall45\" '--goal-mm=25,-10' --strategy na\\ive",
           "ghostforce run wall45 \\\n  --goal-mm=25,-10 \\\r\n --strategy naive",
           "ghostforce run wall45 --goal-mm=25,-10\n--strategy naive",
           "--strategy naive --set wall.normal_deg=1 --set wall.normal_deg=135 --goal-mm=25,-10",
       }) {
    EXPECT_EQ(set_up_values(read_set_up_line(line)), expected) << line;
  }
  EXPECT_EQ(read_set_up_line("--mode landscape").mode, StageMode::landscape);
  EXPECT_EQ(read_set_up_line("fig1 --view workbench").face, Face::workbench);
  EXPECT_EQ(read_set_up_line("ghostforce").scene.title, load_scene("wall45").title);
}

TEST(SetUpLine, NamesTheNearestWord) {
  expect_refused("ghostforce run wal45", "did you mean 'wall45'?");
  expect_refused("ghostforce run wall45 --stratgy naive", "did you mean '--strategy'?");
  expect_refused("ghostforce run wall45 --strategy nave", "--strategy: 'nave' is not one of full, naive, anisotropic");
  expect_refused("ghostforce run wall45 --strategy nave", "did you mean 'naive'?");
  expect_refused("ghostforce run wall45 --view satge", "did you mean 'stage'?");
  expect_refused("ghostforce run wall45 --mode lanscape", "did you mean 'landscape'?");
  expect_refused("ghostforce run wall45 --set wall.norml_deg=3", "did you mean 'wall.normal_deg'?");
}

TEST(SetUpLine, RefusesWhatASetUpDoesNotHold) {
  expect_refused("ghostforce run wall45 --record a.csv", "--record is not part of a set-up");
  expect_refused("ghostforce run --input falcon", "--input is not part of a set-up");
  expect_refused("ghostforce run --theme=dark", "--theme is not part of a set-up");
  expect_refused("ghostforce run -h", "-h is not part of a set-up");
  expect_refused("ghostforce run my_scene.toml", "a scene that comes with ghostforce");
  expect_refused("ghostforce render wall45", "'wall45' stands after the scene 'render'");
  expect_refused("ghostforce run wall45 fig1", "'fig1' stands after the scene 'wall45'");
  expect_refused("ghostforce run --view workbench --mode why", "why belongs to the stage");
  expect_refused("ghostforce run --strategy naive --strategy full", "--strategy: is given twice");
  expect_refused("ghostforce run --strategy", "--strategy: its value is missing");
}

TEST(SetUpLine, SurvivesHostileText) {
  expect_refused("", "there is no text");
  expect_refused(" \n\t ", "there is no text");
  expect_refused("ghostforce run 'wall45", "a quote (') is not closed");
  expect_refused("ghostforce run \"wall45", "a quote (\") is not closed");
  expect_refused("ghostforce run wall45 \\", "ends in a backslash");
  expect_refused("ghostforce run wall45; rm -rf x", "a shell would act on the ';'");
  expect_refused("ghostforce run $(id)", "a shell would act on the '$'");
  expect_refused("ghostforce run \"`id`\"", "a shell would act on the '`'");
  expect_refused("ghostforce run wall45 > x", "a shell would act on the '>'");
  expect_refused("rm -rf x; ghostforce run wall45", "a shell would act on the ';'");
  expect_refused("rm -rf x # ghostforce run wall45", "a shell would act on the '#'");
  expect_refused("echo x > ghostforce run wall45", "a shell would act on the '>'");
  expect_refused("echo x> ghostforce run wall45", "a shell would act on the '>'");
  expect_refused("a|b$ ghostforce run wall45", "a shell would act on the '|'");
  expect_refused("$(id)$ ghostforce run wall45", "a shell would act on the '$'");
  expect_refused("user@host:~$ ghostforce run wall45; id", "a shell would act on the ';'");
  expect_refused("user@host:~$ ghostforce run wall45\nuser@host:~$ id", "a shell would act on the '$'");
  expect_refused("user@host:~$ rm -rf x", "a shell would act on the '$'");
  expect_refused("sudo ghostforce run wall45", "stands after the scene 'sudo'");
  expect_refused("ghostforce run\0wall45"s, "U+0000");
  expect_refused("ghostforce run \x1b[2J", "U+001B");
  expect_refused("ghostforce run \xff", "0xFF, which is not UTF-8");
  for (const char* const goal : {"nan,0", "inf,0", "1", "1,", ",1", "1,2,3", "1e9,0", "0x1,0", " 1,2", ""}) {
    expect_refused("ghostforce run --goal-mm='"s + goal + "'", "not a position");
  }
  expect_refused("ghostforce run --set rendering.k_r_N_per_m=nan", "--set rendering.k_r_N_per_m=nan");
  expect_refused("ghostforce run --set goal.path_mm=[]", "is empty");
  expect_refused("ghostforce run --set goal.times_s=[0]", "1 times for 2 waypoints");
  expect_refused("ghostforce run --set 'wall.normal_deg=1\nformat = 2'", "is not a value");
  expect_refused("ghostforce run --set goal.path_mm=" + std::string(100'000, '['), "is not a value");
  expect_refused(std::string(std::size_t{17} << 20, 'a'), "too long");
  expect_refused(std::string(std::size_t{1} << 20, 'a'), "is not one of");
  std::string many = "ghostforce run";
  for (int i = 0; i < 4000; ++i) many += " --set wall.normal_deg=1";
  expect_refused(many, "given too often");
  for (int i = 0; i < 1'000'000; ++i) many += " a";
  expect_refused(many, "too many words");
  // Every beginning of a line is a line or refused, and so is every line with one byte changed.
  const std::string line = set_up_line(shipped("fig1", {"goal.path_mm=[[1, 2], [3, 4]]", "goal.motion=minimum-jerk"}));
  for (std::size_t i = 0; i < line.size(); ++i) {
    refusal_of(line.substr(0, i));
    for (const char other : {'\0', '\'', '"', '\\', ' ', '-', '=', '9', '\xc3'}) {
      std::string changed = line;
      changed[i] = other;
      refusal_of(changed);
    }
  }
}

TEST(PositionText, IsShortAndReadsBack) {
  EXPECT_EQ(position_mm_text({0.025, -0.01}), "25,-10");
  EXPECT_EQ(position_mm_text({30.1 / 1000.0, -0.0}), "30.1,-0");
  EXPECT_EQ(read_position_mm("25,-10"), Vector<2>(0.025, -0.01));
  EXPECT_FALSE(read_position_mm("25;-10"));
}

}  // namespace
}  // namespace ghostforce::set_up_line_test
