// What the commands say of scenes, above all of format 2.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/files/scene_file.h"
#include "core/general_equilibrium.h"
#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::general_commands_test {
namespace {

Outcome run(std::vector<std::string> words) {
  return run_program(ghostforce_program(), std::move(words));
}

nlohmann::json json_of(std::vector<std::string> words) {
  words.emplace_back("--json");
  const Outcome outcome = run(words);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out, nullptr, false);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(SimulateCommand, SaysThatTheHandWillNotArriveBeforeTheEnd) {
  const Outcome late = run({"simulate", "wall45", "--set", "goal.times_s=[0, 1000]"});
  EXPECT_EQ(late.exit_code, 0);
  EXPECT_NE(late.err.find("at its last waypoint after 1000 s, and the run ends after 3 s"), std::string::npos)
      << late.err;
  EXPECT_EQ(run({"simulate", "wall45"}).err, "");
}

TEST(GeneralCommands, EquilibriumTellsEffortsAndWalls) {
  const nlohmann::json arm = json_of({"equilibrium", "arm"})["strategies"];
  EXPECT_NEAR(arm["naive"]["device_m"][0].get<double>(), -4.64190438349e-3, 1e-14);
  EXPECT_NEAR(arm["naive"]["force_N"][1].get<double>(), 0.499664666774, 1e-11);
  EXPECT_EQ(arm["naive"]["effort_units"], nlohmann::json::array({"N·m"}));
  EXPECT_EQ(arm["naive"]["active"], nlohmann::json::array({1}));
  // The number of the scene's story: 0.22 N·m too much.
  EXPECT_NEAR(std::abs(arm["naive"]["efforts"][0].get<double>() - arm["anisotropic"]["efforts"][0].get<double>()), 0.22,
              0.02);
  const nlohmann::json string = json_of({"equilibrium", "string", "--goal-mm=15,-12"})["strategies"];
  EXPECT_EQ(string["anisotropic"]["efforts"].size(), 2U);
  EXPECT_EQ(string["anisotropic"]["effort_units"], nlohmann::json::array({"N", "N"}));
  EXPECT_EQ(string["naive"]["efforts"][1].get<double>(), 0.0) << "a string that would have to push";
  const nlohmann::json corner = json_of({"equilibrium", "corner"})["strategies"];
  EXPECT_EQ(corner["naive"]["active"], nlohmann::json::array({1, 2}));
  EXPECT_EQ(corner["full"]["active"], nlohmann::json::array({1}));
  const nlohmann::json outside = json_of({"equilibrium", "arm", "--goal-mm=-10,10"})["strategies"];
  EXPECT_EQ(outside["naive"]["force_N"], nlohmann::json::array({0.0, 0.0}));
  EXPECT_EQ(outside["naive"]["active"], nlohmann::json::array());
}

// With a hand and a wall between which the arm's naïve handle rests nowhere.
std::vector<std::string> with_runaway(std::vector<std::string> words) {
  for (const std::string set :
       {"wall.normal_deg=250", "user.k_u_N_per_m=60", "rendering.k_r_N_per_m=2000", "rendering.k_t_N_per_m=2000"}) {
    words.insert(words.end(), {"--set", set});
  }
  return words;
}

TEST(GeneralCommands, EquilibriumSaysWhereThereIsNoRest) {
  const std::vector<std::string> words = with_runaway({"equilibrium", "arm", "--goal-mm=1.71,4.7"});
  const nlohmann::json all = json_of(words)["strategies"];
  EXPECT_EQ(all["naive"], (nlohmann::json{{"goal_m", {0.00171, 0.0047}}, {"no_rest", true}}));
  EXPECT_TRUE(all["full"].contains("force_N"));
  EXPECT_TRUE(all["anisotropic"].contains("force_N"));
  const Outcome table = run(words);
  EXPECT_NE(table.out.find("no rest"), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("effort 1    N·m"), std::string::npos) << table.out;
}

TEST(GeneralCommands, WhatIsOutOfReachIsRefusedWithWords) {
  const Outcome outcome = run({"equilibrium", "arm", "--goal-mm=400,0"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("the arm reaches 320 mm from its base; the goal at (400, 0) mm is 570 mm away"),
            std::string::npos)
      << outcome.err;
}

TEST(GeneralCommands, SimulateComesToTheRestThatIsTold) {
  for (const std::string scene : {"arm", "pantograph", "string", "corner", "curve"}) {
    const Outcome outcome = run({"simulate", scene, "--strategy", "all"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::vector<std::string> lines = lines_of(outcome.out);
    EXPECT_EQ(lines[1], "# format 2");
    const nlohmann::json rests = json_of({"equilibrium", scene})["strategies"];
    for (std::size_t i = lines.size() - 3; i < lines.size(); ++i) {
      std::istringstream row(lines[i]);
      std::vector<std::string> values;
      for (std::string value; std::getline(row, value, ',');) values.push_back(value);
      const nlohmann::json& rest = rests[values[0]];
      const std::size_t motors = rest["efforts"].size();
      ASSERT_EQ(values.size(), 10U + motors) << lines[i];
      const auto number = [&](std::size_t at) { return std::stod(values[at]); };
      for (std::size_t axis = 0; axis < 2; ++axis) {
        EXPECT_NEAR(number(4 + axis), rest["device_m"][axis].get<double>(), 1e-10) << scene << lines[i];
        EXPECT_NEAR(number(6 + axis), rest["proxy_m"][axis].get<double>(), 1e-10) << scene << lines[i];
        EXPECT_NEAR(number(8 + axis), rest["force_N"][axis].get<double>(), 1e-7) << scene << lines[i];
      }
      for (std::size_t motor = 0; motor < motors; ++motor) {
        EXPECT_NEAR(number(10 + motor), rest["efforts"][motor].get<double>(), 1e-7) << scene << lines[i];
      }
    }
  }
}

TEST(GeneralCommands, ReplayRepeatsARunBitForBit) {
  const TemporaryFolder folder;
  for (const std::string scene : {"string", "curve"}) {
    const std::string file = folder.path() + "/" + scene + ".csv";
    ASSERT_EQ(run({"simulate", scene, "--strategy", "all", "-o", file}).exit_code, 0);
    const Outcome again = run({"replay", file});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_NE(again.err.find("identical bit for bit for 3001 ticks"), std::string::npos) << again.err;
    std::ifstream stream(file);
    std::stringstream whole;
    whole << stream.rdbuf();
    EXPECT_EQ(again.out, whole.str());
    // The same hand with another device.
    const Outcome other = run({"replay", file, "--set", "user.k_u_N_per_m=150"});
    EXPECT_EQ(other.exit_code, 0) << other.err;
  }
  const Outcome measured = run({"measure-user", folder.path() + "/string.csv"});
  EXPECT_EQ(measured.exit_code, 2);
  EXPECT_NE(measured.err.find("is a run of a scene of format 2"), std::string::npos) << measured.err;
}

TEST(GeneralCommands, SweepHasTheRestAndTheRuns) {
  const Outcome outcome = run({"sweep", "string", "--over", "device.most_N=0.5:3:3"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  const std::size_t header = lines.size() - 10;
  EXPECT_TRUE(lines[header].ends_with(",settled,rests,effort_1,effort_2,simulated_effort_1,simulated_effort_2"))
      << lines[header];
  const auto columns = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
  for (std::size_t i = header; i < lines.size(); ++i) EXPECT_EQ(columns(lines[i]), columns(lines[header])) << lines[i];
  EXPECT_EQ(outcome.err.find("settled is 0"), std::string::npos) << outcome.err;
  const Outcome runaway = run(with_runaway({"sweep", "arm", "--set", "goal.path_mm=[[-1.71, -4.7], [1.71, 4.7]]",
                                            "--over", "device.mass_kg=0.1:0.1:1", "--at-rest", "closed-form"}));
  ASSERT_EQ(runaway.exit_code, 0) << runaway.err;
  EXPECT_NE(runaway.out.find(",,,,,,,,,,,0,\n"), std::string::npos) << runaway.out;
  const Outcome share =
      run({"sweep", "wall45", "--over", "rendering.compliance_share=0:1:2", "--at-rest", "closed-form"});
  EXPECT_EQ(share.exit_code, 0) << share.err;
  EXPECT_EQ(run({"sweep", "arm", "--over", "rendering.tracking_ratio=1:4:2"}).exit_code, 2);
}

TEST(GeneralCommands, StageAndWorkbenchShowThem) {
  const TemporaryFolder folder;
  const std::string picture = folder.path() + "/arm.png";
  for (const std::vector<std::string>& scene : {std::vector<std::string>{"arm"},
                                                {"wall45", "--set", "user.k_u_second_N_per_m=50"},
                                                {"arm", "--view", "workbench"},
                                                {"string", "--view", "workbench", "--part", "scene"}}) {
    std::vector<std::string> words{"render", "-o", picture};
    words.insert(words.end(), scene.begin(), scene.end());
    EXPECT_EQ(run(words).exit_code, 0);
  }
}

std::string text_between(const std::string& text, std::string_view begin, std::string_view end, std::size_t from) {
  const std::size_t at = text.find(begin, from);
  EXPECT_NE(at, std::string::npos) << begin;
  const std::size_t first = at + begin.size();
  return text.substr(first, text.find(end, first) - first);
}

// Each command of a guide's block, with what it is said to print.
struct ShownCommand {
  std::vector<std::string> words;
  std::string said{};
};

std::vector<ShownCommand> commands_in(const std::string& guide) {
  constexpr std::string_view prompt = "$ ghostforce ";
  std::vector<ShownCommand> commands;
  bool is_shown = false;
  for (const std::string& line : lines_of(guide)) {
    if (line.starts_with("```")) {
      is_shown = line == "```console";
    } else if (is_shown && line.starts_with(prompt)) {
      std::istringstream words(line.substr(prompt.size()));
      ShownCommand& command = commands.emplace_back();
      for (std::string word; words >> word;) command.words.push_back(word);
    } else if (is_shown) {
      commands.back().said += line + "\n";
    }
  }
  return commands;
}

// The guide's own scene is one, and of its own device each command prints and writes what the guide says.
TEST(GeneralCommands, TheGuidesOwnSceneAndDeviceAreAsItSays) {
  std::ifstream stream(source_path("/docs/scenes.md"));
  std::stringstream whole;
  whole << stream.rdbuf();
  const std::string guide = whole.str();
  const std::size_t from = guide.find("### A device of your own");
  ASSERT_NE(from, std::string::npos);
  const TemporaryFolder folder;
  const std::string scene = folder.path() + "/my-scene.toml";
  std::ofstream(scene) << text_between(guide, "```toml\n", "```", guide.find("## A scene of your own"));
  EXPECT_EQ(run({"equilibrium", scene}).exit_code, 0) << "the wall";
  const std::string path = folder.path() + "/my-device.toml";
  std::ofstream(path) << text_between(guide, "```toml\n", "```", from);
  const std::vector<ShownCommand> commands = commands_in(guide.substr(from));
  EXPECT_EQ(commands.size(), 8U);
  for (const ShownCommand& command : commands) {
    ProgramCall call;
    call.words = command.words;
    call.folder = folder.path();
    const Outcome outcome = run_program(ghostforce_program(), call);
    EXPECT_EQ(outcome.exit_code, command.said.find("my-device.toml:") == 0 ? 2 : 0) << outcome.err;
    const auto written = std::ranges::find(command.words, "-o");
    if (written != command.words.end()) {
      EXPECT_TRUE(std::ifstream(folder.path() + "/" + written[1])) << written[1];
    }
    if (!command.said.empty()) {
      EXPECT_EQ(outcome.out + outcome.err, command.said);
    }
  }
  const nlohmann::json left = json_of({"equilibrium", path, "--set", "device.motor=left"})["strategies"]["naive"];
  const double slide_mm =
      1e3 * std::hypot(left["proxy_drift_m"][0].get<double>(), left["proxy_drift_m"][1].get<double>());
  EXPECT_NE(guide.find(fmt::format("slides {:.1f} mm", slide_mm), from), std::string::npos) << slide_mm;
}

// Numbers in another unit give a result that looks like one.
TEST(SceneNotes, TellOfAHandThatHardlyMovesOrNeverArrives) {
  for (const std::string command : {"equilibrium", "simulate"}) {
    const auto said = [&](const std::string& change) { return run({command, "wall45", "--set", change}).err; };
    EXPECT_EQ(run({command, "wall45"}).err, "");
    EXPECT_NE(said("goal.path_mm=[[0.02, 0.02], [0.015, -0.015]]").find("goal.path_mm is in millimetres"),
              std::string::npos);
  }
  const Outcome late = run({"simulate", "wall45", "--set", "goal.duration_s=0.5"});
  EXPECT_NE(late.err.find("goal.duration_s are in seconds"), std::string::npos) << late.err;
  // It has no run, and this hand no path.
  EXPECT_EQ(run({"equilibrium", "wall45", "--set", "goal.duration_s=0.5"}).err, "");
  EXPECT_EQ(
      run({"equilibrium", "wall45", "--goal-mm=10,-10", "--set", "goal.path_mm=[[0.02, 0.02], [0.015, -0.015]]"}).err,
      "");
}

}  // namespace
}  // namespace ghostforce::general_commands_test
