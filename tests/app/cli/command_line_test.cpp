// The program as scripts see it: what it prints where, and how it ends.
#include <algorithm>
#include <bit>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/files/run.h"
#include "app/files/scene_file.h"
#include "core/equilibrium.h"
#include "core/ghost_force.h"
#include "core/simulate.h"
#include "ghostforce_version.h"
#include "tests/support/program.h"
#include "tests/support/scene_values.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::command_line_test {
namespace {

// A call that is wrong: exit 2, nothing on stdout, and these words on stderr.
void expect_refused(const std::vector<std::string>& words, std::string_view said, int code = 2) {
  const Outcome outcome = run_ghostforce(words);
  std::string call;
  for (const std::string& word : words) call += word + " ";
  EXPECT_EQ(outcome.exit_code, code) << call << outcome.err;
  EXPECT_EQ(outcome.out, "") << call;
  EXPECT_NE(outcome.err.find(said), std::string::npos) << call << outcome.err;
  EXPECT_TRUE(outcome.err.ends_with("\n")) << call;
}

// --- Words and exit codes ---

TEST(CommandLine, HelpAtEveryLevel) {
  const Outcome program = run_ghostforce({"--help"});
  EXPECT_EQ(program.exit_code, 0);
  EXPECT_EQ(program.err, "");
  for (const std::string_view words : {"simulate", "equilibrium", "wall45", "130  interrupted", "--version"}) {
    EXPECT_NE(program.out.find(words), std::string::npos) << words;
  }
  for (const Command& listed : command_catalog()) {
    const std::string command(listed.name);
    EXPECT_NE(program.out.find("  " + command), std::string::npos) << command;
    const Outcome outcome = run_ghostforce({command, "--help"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    std::vector<std::string_view> told{"SCENE", "--set KEY=VALUE"};
    if (command == "check") told = {"DIR", "--update"};          // a folder of cases names its scenes itself
    if (command == "figures") told = {"-o,--output", "--hand"};  // each has scenes of its own
    if (command == "doctor") told = {"--json", "--wait"};        // a device needs none
    if (command == "worksheet") told = {"LESSON", "--answers"};
    if (command == "help") told = {"COMMAND", "--format"};
    if (command == "replay-session") told = {"SESSION", "--headless"};
    if (command == "measure-user") told = {"RUN.csv", "--target-mm"};
    for (const std::string_view words : told) {
      EXPECT_NE(outcome.out.find(words), std::string::npos) << command << words;
    }
  }
  EXPECT_NE(program.out.find("a replay diverged, no reading"), std::string::npos) << "exit code 1 of measure-user";
  EXPECT_NE(run_ghostforce({"measure-user", "--help"}).out.find("the nearest point of the wall counts"),
            std::string::npos);
  EXPECT_NE(run_ghostforce({"simulate", "--help"}).out.find("--strategy"), std::string::npos);
  EXPECT_NE(run_ghostforce({"equilibrium", "-h"}).out.find("--goal-mm"), std::string::npos);
}

TEST(CommandLine, RunIsMeantWhereNoCommandIsNamed) {
  const std::string run_help = run_ghostforce({"run", "--help"}).out;
  EXPECT_NE(run_help.find("ghostforce run"), std::string::npos) << run_help;
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"fig1", "--help"}, {"some/where.toml", "--help"}, {"--strategy", "naive", "--help"}}) {
    const Outcome outcome = run_ghostforce(words);
    EXPECT_EQ(outcome.exit_code, 0) << words.front();
    EXPECT_EQ(outcome.out, run_help) << words.front();
  }
}

TEST(CommandLine, Version) {
  const Outcome outcome = run_ghostforce({"--version"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  // The first line is for scripts; the others tell what a report of a fault needs.
  EXPECT_TRUE(outcome.out.starts_with(fmt::format("ghostforce {}\ncommit     ", version))) << outcome.out;
  for (const char* const words :
       {"\nbuild      ", "\nlibraries  Dear ImGui 1.", ", Cairo 1.", ", libusb 1.0.", "\nrenderer   llvmpipe ("}) {
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << " in\n" << outcome.out;
  }
  EXPECT_EQ(std::ranges::count(outcome.out, '\n'), 5) << outcome.out;
}

TEST(CommandLine, WrongCallsAreNamedAndExit2) {
  expect_refused({"simulat"}, "no command or scene named 'simulat'; did you mean the command 'simulate'?");
  expect_refused({"wal45"}, "no command or scene named 'wal45'; did you mean the scene 'wall45'?");
  expect_refused({"qqqqqqqq"}, "no command or scene named 'qqqqqqqq'; 'ghostforce --help' lists the commands");
  expect_refused({"simulate"}, "SCENE is required");
  expect_refused({"simulate", "wall45", "--stratgy", "full"}, "no option --stratgy; did you mean '--strategy'?");
  expect_refused({"simulate", "wall45", "--stratgy=full"}, "no option --stratgy; did you mean '--strategy'?");
  expect_refused({"simulate", "--stratgy"}, "no option --stratgy; did you mean '--strategy'?");
  expect_refused({"simulate", "wall45", "--zzz"}, "no option --zzz; see 'ghostforce simulate --help'");
  expect_refused({"simulate", "wall45", "fig1"}, "unexpected argument 'fig1'");
  expect_refused({"simulate", "wall45", "--strategy", "naiv"}, "did you mean 'naive'?");
  expect_refused({"simulate", "wall45", "--strategy"}, "--strategy");
  expect_refused({"simulate", "wall45", "--strategy", ""}, "is not one of full, naive, anisotropic, all");
  expect_refused({"simulate", "wall45", "-o"}, "--output");
  expect_refused({"simulate", "wall45", "--set"}, "--set");
  expect_refused({"simulate", "wall45", "--set", "k_r=1"}, "--set k_r=1: the key k_r is unknown");
  expect_refused({"simulate", "wal45"}, "no scene named 'wal45'; did you mean 'wall45'?");
  expect_refused({"simulate", "none/x.toml"}, "there is no file 'none/x.toml'");
  expect_refused({"simulate", "equilibrium"}, "no scene named 'equilibrium'");
  expect_refused({"equilibrium", "wall45", "--josn"}, "did you mean '--json'?");
  expect_refused({"equilibrium", "wall45", "--goal-mm", "5", "-12"},
                 "no option -12; join the numbers of one option with commas, as in --goal-mm=5,-12");
}

TEST(CommandLine, ProblemsOfASceneFileAreToldByLine) {
  const TemporaryFolder folder;
  std::string text = scene_text(load_scene("wall45"));
  text.replace(text.find("mass_kg = 0.1"), 13, "mass_kg = -1 ");
  text.replace(text.find("rate_hz"), 7, "rate_Hz");
  write_whole(folder / "bad.toml", text);
  ProgramCall call;
  call.words = {"simulate", "bad.toml", "-o", "run.csv"};
  call.folder = folder.path();
  const Outcome outcome = run_ghostforce(call);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err,
            "bad.toml:9:1: the key device.rate_hz is missing\n"
            "bad.toml:11:11: the key device.mass_kg: -1 is out of range; give 0.001 to 100 kg\n"
            "bad.toml:13:1: the key device.rate_Hz is unknown; did you mean 'device.rate_hz'?\n");
  EXPECT_EQ(folder.count(), 1) << "no run.csv";
}

TEST(CommandLine, FileTroubleExits8) {
  expect_refused({"simulate", "/proc/self/mem"}, "cannot be read", 8);
  expect_refused({"simulate", "wall45", "-o", "/none/run.csv"}, "/none/run.csv cannot be written: No such file", 8);
  ProgramCall call;
  call.out_to = "/dev/full";
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"simulate", "wall45"}, {"--help"}, {"equilibrium", "fig1"}}) {
    call.words = words;
    const Outcome outcome = run_ghostforce(call);
    EXPECT_EQ(outcome.exit_code, 8);
    EXPECT_NE(outcome.err.find("standard output cannot be written: No space left"), std::string::npos);
  }
}

TEST(CommandLine, AReaderThatLeavesIsNoTrouble) {
  ProgramCall call;
  call.words = {"simulate", "wall45", "--strategy", "all", "--set", "goal.duration_s=10000"};
  call.close_after_first_piece = true;
  const Outcome outcome = run_ghostforce(call);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
}

class CommandLineInterrupted : public testing::TestWithParam<int> {};

TEST_P(CommandLineInterrupted, LeavesNothingAndExits130) {
  const TemporaryFolder folder;
  write_whole(folder / "run.csv", "old");
  ProgramCall call;
  // Ten million ticks: the signal, sent as soon as the temporary file is there, arrives long before the end.
  call.words = {"simulate", "wall45", "--set", "goal.duration_s=10000", "-o", folder / "run.csv"};
  call.signal_when_created_in = folder.path();
  call.signal = GetParam();
  const Outcome outcome = run_ghostforce(call);
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(outcome.err, "interrupted\n");
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(folder.count(), 1);
  EXPECT_EQ(read_whole(folder / "run.csv"), "old");
}

INSTANTIATE_TEST_SUITE_P(Signals, CommandLineInterrupted, testing::Values(SIGINT, SIGTERM, SIGHUP));

// --- simulate ---

struct Csv {
  std::vector<std::string> comments;
  std::string columns;
  std::vector<std::string> names;            // the first cell of each row
  std::vector<std::vector<double>> numbers;  // the others
};

Csv parse_csv(const std::string& text) {
  Csv csv;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) {
      EXPECT_EQ(csv.columns, "") << "comments come first";
      csv.comments.push_back(line);
    } else if (csv.columns.empty()) {
      csv.columns = line;
    } else {
      csv.names.push_back(line.substr(0, line.find(',')));
      csv.numbers.emplace_back();
      for (const char* at = line.data() + csv.names.back().size(); at != line.data() + line.size();) {
        double value = 0.0;
        const auto [end, error] = std::from_chars(at + 1, line.data() + line.size(), value);
        if (*at != ',' || error != std::errc{}) {
          ADD_FAILURE() << line;
          return csv;
        }
        csv.numbers.back().push_back(value);
        at = end;
      }
    }
  }
  return csv;
}

std::vector<double> expected_row(const Snapshot& snapshot, StrategyId id) {
  const StrategySnapshot<2>& state = snapshot.strategies[index_of(id)];
  return {snapshot.time_s, snapshot.goal.x, snapshot.goal.y, state.device.x, state.device.y,
          state.proxy.x,   state.proxy.y,   state.force.x,   state.force.y};
}

TEST(Simulate, WritesEveryTickOfEveryStrategyExactly) {
  const Outcome outcome = run_ghostforce({"simulate", "fig3-normal", "--strategy", "all"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const Csv csv = parse_csv(outcome.out);
  EXPECT_EQ(csv.columns,
            "strategy,t_s,goal_x_m,goal_y_m,device_x_m,device_y_m,proxy_x_m,proxy_y_m,force_x_N,force_y_N");
  ASSERT_EQ(csv.names.size(), 3U * 3001U);  // 3 s at 1000 Hz, both ends included
  const Scene scene = load_scene("fig3-normal");
  std::size_t row = 0;
  simulate(scene, last_tick(scene), [&](const Snapshot& snapshot) {
    for (const StrategyId id : {StrategyId::full, StrategyId::naive, StrategyId::anisotropic}) {
      ASSERT_EQ(csv.names[row], strategy(id).name);
      const std::vector<double> expected = expected_row(snapshot, id);
      ASSERT_EQ(csv.numbers[row].size(), expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i) {
        ASSERT_EQ(std::bit_cast<std::uint64_t>(csv.numbers[row][i]), std::bit_cast<std::uint64_t>(expected[i]))
            << "row " << row << ", column " << i;
      }
      ++row;
    }
  });
  EXPECT_EQ(csv.numbers.front()[0], 0.0);
  EXPECT_EQ(csv.numbers.back()[0], 3.0);
}

TEST(Simulate, EndsWhereTheDesignSays) {
  // fig3-normal at rest: device x +3.669 mm (F), −26.556 mm (N), +3.669 mm (A); force along x −3.633, −6.656, −3.633 N.
  // After 2 s at rest what still moves is far below the last digit given.
  const Csv csv = parse_csv(run_ghostforce({"simulate", "fig3-normal", "--strategy=all"}).out);
  ASSERT_GE(csv.numbers.size(), 3U);
  const double device_x[] = {3.669e-3, -26.556e-3, 3.669e-3};
  const double force_x[] = {-3.633, -6.656, -3.633};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<double>& row = csv.numbers[csv.numbers.size() - 3 + i];
    EXPECT_NEAR(row[3], device_x[i], 0.5e-6) << i;
    EXPECT_NEAR(row[7], force_x[i], 0.5e-3) << i;
  }
}

TEST(Simulate, WritesTheSceneStrategyUnlessTold) {
  for (const auto& [words, name] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"simulate", "wall45"}, std::string(strategy(load_scene("wall45").settings.active).name)},
           {{"simulate", "wall45", "--set", "rendering.strategy=full"}, "full"},
           {{"simulate", "wall45", "--strategy", "anisotropic"}, "anisotropic"}}) {
    const Csv csv = parse_csv(run_ghostforce(words).out);
    ASSERT_EQ(csv.names.size(), 3001U);
    for (const std::string& row_name : csv.names) ASSERT_EQ(row_name, name);
    EXPECT_NE(std::find(csv.comments.begin(), csv.comments.end(), "# strategy = \"" + name + "\""), csv.comments.end());
  }
}

TEST(Simulate, HeaderHoldsTheEffectiveScene) {
  const Csv csv = parse_csv(
      run_ghostforce({"simulate", "wall45", "--set", "wall.normal_deg=120.5", "--set", "goal.duration_s=0.0125"}).out);
  EXPECT_EQ(csv.comments.front(), fmt::format("# ghostforce {}", version));
  std::string text;
  bool within = false;
  for (const std::string& line : csv.comments) {
    if (line == scene_ends) within = false;
    if (within) text += line.size() > 2 ? line.substr(2) + "\n" : "\n";
    if (line == scene_begins) within = true;
  }
  EXPECT_EQ(
      scene_values(read_scene(text, "header")),
      scene_values(load_scene("wall45", std::vector<std::string>{"wall.normal_deg=120.5", "goal.duration_s=0.0125"})));
  EXPECT_EQ(csv.numbers.size(), 14U);  // round(12.5) = 13, and the first
}

TEST(Simulate, FileAndStandardOutputAreTheSameBytes) {
  const TemporaryFolder folder;
  const Outcome to_file = run_ghostforce({"simulate", "fig1", "--strategy", "all", "-o", folder / "run.csv"});
  EXPECT_EQ(to_file.exit_code, 0);
  EXPECT_EQ(to_file.out, "");
  EXPECT_EQ(to_file.err, "");
  EXPECT_EQ(folder.count(), 1);
  const std::string bytes = read_whole(folder / "run.csv");
  EXPECT_GT(bytes.size(), 100'000U);
  for (const std::string locale : {"C", "C.UTF-8", "de_DE.UTF-8"}) {
    ProgramCall call;
    call.words = {"simulate", "fig1", "--strategy", "all", "-o", "-"};
    call.environment = {"LC_ALL=" + locale, "LANG=" + locale, "LC_NUMERIC=" + locale};
    EXPECT_EQ(run_ghostforce(call).out, bytes) << locale;
  }
}

TEST(Simulate, PlaysNoTimeToo) {
  const Csv csv = parse_csv(run_ghostforce({"simulate", "wall45", "--set", "goal.duration_s=0"}).out);
  EXPECT_EQ(csv.numbers.size(), 1U);
}

// --- equilibrium ---

Vector<2> vector_in(const nlohmann::json& json) {
  EXPECT_EQ(json.size(), 2U);
  return {json.at(0).get<double>(), json.at(1).get<double>()};
}

TEST(EquilibriumCommand, JsonIsWhatTheModelSays) {
  for (const std::vector<std::string>& overrides : {std::vector<std::string>{},
                                                    {"user.believed_k_u_N_per_m=40"},
                                                    {"rendering.k_c_N_per_m=inf"},
                                                    {"rendering.tracking_ratio=3"}}) {
    std::vector<std::string> words{"equilibrium", "fig1", "--json"};
    for (const std::string& override : overrides) words.insert(words.end(), {"--set", override});
    const Outcome outcome = run_ghostforce(words);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const nlohmann::json json = nlohmann::json::parse(outcome.out);
    ASSERT_EQ(json.size(), 2U);
    ASSERT_EQ(json.at("strategies").size(), 3U);

    const Scene scene = load_scene("fig1", overrides);
    const Wall<2> wall = wall_of(scene.settings);
    const Actuation<2> actuation = actuation_of(scene.settings);
    const Vector<2> goal = scene.goal.points.back();
    EXPECT_EQ(json.at("depth_m"), depth(wall, goal));
    const Equilibrium<2> full =
        equilibrium_of(strategy(StrategyId::full), wall, actuation, scene.settings.stiffnesses, goal);
    for (const Strategy& strategy : strategy_catalog()) {
      const Equilibrium<2> expected = equilibrium_of(strategy, wall, actuation, scene.settings.stiffnesses, goal);
      const nlohmann::json& got = json.at("strategies").at(std::string(strategy.name));
      EXPECT_EQ(got.size(), 7U);
      EXPECT_EQ(vector_in(got.at("goal_m")), goal);
      EXPECT_EQ(vector_in(got.at("proxy_m")), expected.proxy);
      EXPECT_EQ(vector_in(got.at("device_m")), expected.device);
      EXPECT_EQ(vector_in(got.at("contact_m")), expected.contact);
      EXPECT_EQ(vector_in(got.at("force_N")), expected.force);
      EXPECT_EQ(vector_in(got.at("ghost_force_N")), ghost_force(actuation, expected.force, full.force));
      EXPECT_EQ(vector_in(got.at("proxy_drift_m")), proxy_drift(wall, expected.proxy, goal));
    }
  }
}

TEST(EquilibriumCommand, JsonHoldsTheNumbersOfTheDesign) {
  const nlohmann::json json = nlohmann::json::parse(run_ghostforce({"equilibrium", "fig3-normal", "--json"}).out);
  EXPECT_NEAR(json.at("depth_m").get<double>(), 56.569e-3, 0.5e-6);
  const auto at = [&](const char* strategy, const char* key) {
    return vector_in(json.at("strategies").at(strategy).at(key));
  };
  EXPECT_NEAR(at("full", "device_m").x, 3.669e-3, 0.5e-6);
  EXPECT_NEAR(at("naive", "device_m").x, -26.556e-3, 0.5e-6);
  EXPECT_NEAR(at("anisotropic", "device_m").x, 3.669e-3, 0.5e-6);
  EXPECT_NEAR(at("naive", "ghost_force_N").x, -6.656 + 3.633, 1e-3);
  EXPECT_NEAR(at("anisotropic", "ghost_force_N").x, 0.0, 1e-12);
}

TEST(EquilibriumCommand, OutsideTheWallNothingPushes) {
  const nlohmann::json json =
      nlohmann::json::parse(run_ghostforce({"equilibrium", "fig1", "--goal-mm=-30,20", "--json"}).out);
  EXPECT_LT(json.at("depth_m").get<double>(), 0.0);
  for (const auto& [name, values] : json.at("strategies").items()) {
    EXPECT_EQ(vector_in(values.at("goal_m")), Vector<2>(-0.03, 0.02)) << name;
    EXPECT_EQ(vector_in(values.at("device_m")), Vector<2>(-0.03, 0.02)) << name;
    EXPECT_EQ(vector_in(values.at("proxy_m")), Vector<2>(-0.03, 0.02)) << name;
    for (const char* zero : {"force_N", "ghost_force_N", "proxy_drift_m"}) {
      EXPECT_EQ(vector_in(values.at(zero)), Vector<2>(0.0)) << name << zero;
    }
  }
}

TEST(EquilibriumCommand, TakesGoalsAsPeopleWriteThem) {
  const std::string expected = run_ghostforce({"equilibrium", "fig1", "--goal-mm=-10,5", "--json"}).out;
  EXPECT_NE(expected.find("\"goal_m\":[-0.01,0.005]"), std::string::npos) << expected;
  EXPECT_EQ(run_ghostforce({"equilibrium", "fig1", "--goal-mm", "-10,5", "--json"}).out, expected);
  EXPECT_EQ(run_ghostforce({"equilibrium", "--goal-mm", "-10.0,+5e0", "--json", "fig1"}).out, expected);
  for (const std::string bad :
       {"1", "1,", ",1", "1,2,3", "1;2", "a,b", "nan,1", "1,inf", "1, 2", "1,2 ", "1e4,0", "0,-1000.1", ""}) {
    expect_refused({"equilibrium", "fig1", "--goal-mm=" + bad}, "--goal-mm");
  }
}

TEST(EquilibriumCommand, TableIsForPeople) {
  const Outcome outcome = run_ghostforce({"equilibrium", "fig3-normal"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out,
            "Motion normal to a 45 degree wall\n"
            "goal (40.000, -40.000) mm, 56.569 mm inside the wall; tracking ratio 11\n"
            "\n"
            "                                  F full                 N naive           A anisotropic\n"
            "proxy       mm           (0.036, -0.036)      (-33.211, -33.344)         (0.036, -0.036)\n"
            "device      mm           (3.669, -3.669)      (-26.556, -40.000)        (3.669, -40.000)\n"
            "contact     mm            (0.000, 0.000)      (-33.278, -33.278)          (0.000, 0.000)\n"
            "force       N            (-3.633, 3.633)         (-6.656, 0.000)         (-3.633, 0.000)\n"
            "ghost force N             (0.000, 0.000)         (-3.023, 0.000)          (0.000, 0.000)\n"
            "proxy drift mm            (0.000, 0.000)      (-33.278, -33.278)          (0.000, 0.000)\n");
}

TEST(Run, RefusesWhatBelongsToAnotherFaceOrHand) {
  expect_refused({"run", "--view", "bench"}, "is not one of stage, workbench");
  expect_refused({"run", "--mode", "lanscape"}, "did you mean 'landscape'?");
  expect_refused({"run", "--mode", "why", "--view", "workbench"}, "--mode why belongs to the stage");
  expect_refused({"run", "--goal-mm=5"}, "--goal-mm 5: not a position");
  expect_refused({"run", "--goal-mm=5,nan"}, "--goal-mm");
  expect_refused({"run", "--goal-mm=5,5", "--input", "script"}, "--goal-mm places your own hand");
  expect_refused({"run", "wall45", "--lesson", "ghost"}, "--lesson and SCENE contradict each other");
  expect_refused({"run", "--lesson", "ghost", "--view", "workbench"}, "lessons are on the stage");
  expect_refused({"run", "--misbehave", "silence"}, "--misbehave is about virtual devices");
}

TEST(Run, RefusesATimeThatIsNoNumber) {
  for (const char* time : {"nan", "-1", "inf", "soon"}) {
    const Outcome outcome = run_ghostforce({"run", "--exit-after", time});
    EXPECT_EQ(outcome.exit_code, 2) << time;
    EXPECT_NE(outcome.err.find("--exit-after"), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace ghostforce::command_line_test
