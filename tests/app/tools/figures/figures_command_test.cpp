// `figures` as its users have it: of a hand that they recorded, and with nothing half done.
#include <algorithm>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/tools/figures/figure.h"
#include "ghostforce_version.h"
#include "tests/app/tools/figures/figure_tables.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::figures_command_test {
namespace {

namespace fs = std::filesystem;

// ---- A recorded hand ------------------------------------------------------------------------------------------------

TEST(FiguresHand, IsTheRecordingsOwn) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_ghostforce({"simulate", "fig1", "-o", folder / "run.csv"}).exit_code, 0);
  const Outcome outcome = figures({"-o", folder / "out", "--only", "figure-6", "--hand", folder / "run.csv"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const ReadTable table = read_table(read_whole(folder / "out/figure-6.csv"));
  // The same motion as figure 1's: the same devices.
  const CsvTable& expected = entry_named("figure-1").make({}).data;
  ASSERT_EQ(table.rows.size(), expected.rows.size());
  const std::size_t x = column(expected, "device_x_m");
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    ASSERT_NEAR(number(table.rows[i][x]), std::get<double>(expected.rows[i][x]), 1e-12);
  }
}

TEST(FiguresHand, IsRefusedWhereItIsNoneOrGoesUnseen) {
  const TemporaryFolder folder;
  write_whole(folder / "words.csv", "no run at all\n");
  Outcome outcome = figures({"-o", folder / "out", "--hand", folder / "words.csv"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("words.csv"), std::string::npos) << outcome.err;
  outcome = figures({"-o", folder / "out", "--hand", folder / "nothing.csv"});
  EXPECT_NE(outcome.exit_code, 0);
  ASSERT_EQ(run_ghostforce({"simulate", "fig1", "-o", folder / "run.csv"}).exit_code, 0);
  outcome = figures({"-o", folder / "out", "--only", "figure-1", "--hand", folder / "run.csv"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("figure-6"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

// A run of wall45 whose hand rests 20 mm inside the wall all the time, as it was recorded from 2 s on.
std::string resting_run(const std::string& before_rows, const std::string& in_midst = "") {
  const std::string text = run_ghostforce({"simulate", "wall45", "--strategy", "all"}).out;
  const std::size_t midst = text.find("\nfull,2.5,") + 1;
  const std::size_t begin = text.find("\nfull,2,") + 1;
  return text.substr(0, text.find("\nfull,0,") + 1) + before_rows + text.substr(begin, midst - begin) + in_midst +
         text.substr(midst);
}

struct HandFigure {
  Outcome outcome;
  ReadTable table;
  std::string words;  // provenance and caption
};

HandFigure hand_figure(const TemporaryFolder& folder, const std::string& run) {
  write_whole(folder / "run.csv", run);
  HandFigure figure;
  figure.outcome = figures({"-o", folder / "out", "--only", "figure-6", "--hand", folder / "run.csv"});
  if (figure.outcome.exit_code != 0) return figure;
  figure.table = read_table(read_whole(folder / "out/figure-6.csv"));
  figure.words = figure.table.comments.at(0) + "\n" + figure.table.comments.at(1);
  return figure;
}

constexpr std::string_view state_at_2_s = "# state t_s=2 full=0,0,0 naive=0,0,0 anisotropic=0,0,0\n";

bool contains(const std::string& text, std::string_view words) {
  return text.find(words) != std::string::npos;
}

// How far the devices are from where they began, at most, until a time.
double greatest_move(const ReadTable& table, double until_s) {
  double greatest = 0.0;
  std::map<std::string, Vector<2>> begins;
  for (const auto& row : table.rows) {
    if (row[2] != "simulated" || number(row[3]) > until_s) continue;
    const Vector<2> device{number(row[6]), number(row[7])};
    greatest = std::max(greatest, glm::distance(device, begins.try_emplace(row[1], device).first->second));
  }
  return greatest;
}

TEST(FiguresHand, BeginsAsItWasRecorded) {
  const TemporaryFolder folder;
  const HandFigure as_recorded = hand_figure(folder, resting_run(std::string(state_at_2_s)));
  ASSERT_EQ(as_recorded.outcome.exit_code, 0) << as_recorded.outcome.err;
  EXPECT_LT(greatest_move(as_recorded.table, 1.0), 1e-9);
  // Without that line nobody knows how it began: at rest.
  const HandFigure at_rest = hand_figure(folder, resting_run(""));
  EXPECT_LT(greatest_move(at_rest.table, 1.0), 1e-9);
  EXPECT_TRUE(at_rest.words.starts_with(fmt::format("# ghostforce {}; hand run.csv\n", version))) << at_rest.words;
  EXPECT_FALSE(contains(at_rest.words, "seed"));
}

TEST(FiguresHand, TakesWhatWasChangedAndSaysWhatItLeavesOut) {
  const TemporaryFolder folder;
  const HandFigure changed = hand_figure(folder, resting_run(std::string(state_at_2_s),
                                                             "# set t_s=2.5 rendering.tracking_ratio=2\n"
                                                             "# set t_s=2.5 wall.normal_deg=120\n"));
  ASSERT_EQ(changed.outcome.exit_code, 0) << changed.outcome.err;
  EXPECT_LT(greatest_move(changed.table, 0.49), 1e-9);
  EXPECT_GT(greatest_move(changed.table, 1.0), 0.001);
  EXPECT_TRUE(
      contains(changed.words,
               "Settings were changed once while it was recorded, and the same changes are made here; wall and motor"))
      << changed.words;
  EXPECT_NE(std::ranges::find(changed.table.comments, "# set t_s=0.5 rendering.tracking_ratio=2.0"),
            changed.table.comments.end())
      << testing::PrintToString(changed.table.comments);
  // The changed ratio is not the best one.
  EXPECT_TRUE(contains(changed.words, "A does not feel like F at rest")) << changed.words;

  const std::string run = resting_run(std::string(state_at_2_s));
  const HandFigure reset = hand_figure(
      folder, run + "# state t_s=0 full=0,0,0 naive=0,0,0 anisotropic=0,0,0\n" + run.substr(run.find("\nfull,2,") + 1));
  for (const std::string& words : {reset.words, reset.outcome.err}) {
    EXPECT_TRUE(contains(words, "The run was reset after 1 s; what follows is not shown")) << words;
  }
}

TEST(FiguresHand, ClaimsNoMoreThanItsDataShow) {
  const TemporaryFolder folder;
  const auto caption_with = [&](std::vector<std::string> set) {
    set.insert(set.begin(), {"simulate", "wall45", "--strategy", "all"});
    return hand_figure(folder, run_ghostforce(std::move(set)).out).words;
  };
  EXPECT_TRUE(contains(caption_with({}), "Along the actuated direction, A feels like F at rest; N is pulled away"));
  EXPECT_TRUE(contains(caption_with({"--set", "rendering.tracking_ratio=1"}), "A does not feel like F at rest"));
  EXPECT_TRUE(contains(caption_with({"--set", "wall.normal_deg=180"}), "A feels like F at rest; so does N"));
  EXPECT_TRUE(contains(caption_with({"--set", "wall.point_mm=[500, -500]"}), "The hand never goes into the wall"));
}

TEST(FiguresHand, IsRefusedWithARemedy) {
  const TemporaryFolder folder;
  const std::string run = resting_run(std::string(state_at_2_s));
  const HandFigure one_tick = hand_figure(folder, run.substr(0, run.find("\nfull,2.001,") + 1));
  EXPECT_EQ(one_tick.outcome.exit_code, 2);
  EXPECT_TRUE(contains(one_tick.outcome.err, "run.csv: the run has no two consecutive ticks")) << one_tick.outcome.err;
  const HandFigure untold = hand_figure(folder, run.substr(run.find("\nstrategy,") + 1));
  EXPECT_EQ(untold.outcome.exit_code, 2);
  EXPECT_TRUE(contains(untold.outcome.err, "ghostforce replay RUN.csv wall45 -o told.csv")) << untold.outcome.err;
  std::string wild = run;
  const std::size_t mass = wild.find("mass_kg = ");
  wild.replace(mass, wild.find('\n', mass) - mass, "mass_kg = 0.001");
  const std::size_t damping = wild.find("damping_N_s_per_m = ");
  wild.replace(damping, wild.find('\n', damping) - damping, "damping_N_s_per_m = 0.0");
  const std::size_t k_r = wild.find("k_r_N_per_m = ");
  wild.replace(k_r, wild.find('\n', k_r) - k_r, "k_r_N_per_m = 100000.0");
  const HandFigure unstable = hand_figure(folder, wild);
  EXPECT_EQ(unstable.outcome.exit_code, 2);
  EXPECT_TRUE(contains(unstable.outcome.err, "run.csv: the sampled loop is unstable with these settings"))
      << unstable.outcome.err;
  EXPECT_TRUE(contains(unstable.outcome.err, "ghostforce replay RUN.csv --set KEY=VALUE")) << unstable.outcome.err;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

// ---- All or nothing -------------------------------------------------------------------------------------------------

TEST(FiguresCommand, RefusesAWrongNameAndSaysTheNearest) {
  const TemporaryFolder folder;
  const Outcome outcome = figures({"-o", folder / "out", "--only", "figure-7"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("did you mean 'figure-"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.count(), 0);
}

TEST(FiguresCommand, RefusesAFolderWithoutAName) {
  const Outcome outcome = figures({"-o", "", "--only", "figure-2"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "-o: the name of the folder is empty")) << outcome.err;
}

TEST(FiguresCommand, RefusesAFileAsAFolder) {
  const TemporaryFolder folder;
  write_whole(folder / "taken", "mine");
  for (const std::string_view name : {"taken", "taken/deeper"}) {
    const Outcome outcome = figures({"-o", folder / name, "--only", "figure-2"});
    EXPECT_EQ(outcome.exit_code, 8);
    EXPECT_NE(outcome.err.find("name another"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(read_whole(folder / "taken"), "mine");
  EXPECT_EQ(folder.count(), 1);
}

TEST(FiguresCommand, LeavesNothingWhenInterrupted) {
  for (const std::string_view name : {"out", "out/deeper/still"}) {
    const TemporaryFolder folder;
    ProgramCall call;
    call.words = {"figures", "-o", folder / name};
    // The folder is made before seconds of drawing.
    call.signal_when_created_in = folder.path();
    call.signal = SIGINT;
    const Outcome outcome = run_ghostforce(call);
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    EXPECT_EQ(folder.count(), 0);
  }
}

TEST(FiguresCommand, LeavesNothingNewWhenAFileCannotBeWritten) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "out/figure-2.csv");  // the last of its files
  write_whole(folder / "out/figure-2.png", "old");
  const Outcome outcome = figures({"-o", folder / "out", "--only", "figure-2"});
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_NE(outcome.err.find("figure-2.csv"), std::string::npos) << outcome.err;
  EXPECT_EQ(names_in(folder / "out"), (std::set<std::string>{"figure-2.csv", "figure-2.png"}));
  EXPECT_EQ(read_whole(folder / "out/figure-2.png"), "old");
}

TEST(FiguresCommand, NeedsNoDisplay) {
  const TemporaryFolder folder;
  ProgramCall call;
  call.words = {"figures", "-o", folder / "out/", "--only", "figure-2"};
  call.environment = {"DISPLAY=", "WAYLAND_DISPLAY="};
  EXPECT_EQ(run_ghostforce(call).exit_code, 0);
  EXPECT_EQ(names_in(folder / "out").size(), figure_file_endings.size());
}

}  // namespace
}  // namespace ghostforce::figures_command_test
