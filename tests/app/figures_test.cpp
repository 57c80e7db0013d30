// Figures: each in all its files, the same every time, with the numbers that it shows; and a command that leaves
// nothing half done.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/figures/figure_catalog.h"
#include "app/figures/figure_files.h"
#include "app/figures/sheet.h"
#include "app/paint/vector_painter.h"
#include "app/png_file.h"
#include "app/scene_file.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {
namespace {

namespace fs = std::filesystem;

Outcome figures(std::vector<std::string> words) {
  words.insert(words.begin(), "figures");
  return run_program(GHOSTFORCE_PROGRAM, std::move(words));
}

std::set<std::string> names_in(const std::string& folder) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

// No cell of a figure's table needs quotes.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells{""};
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

double number(const std::string& text) {
  double value = -12345.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  EXPECT_TRUE(error == std::errc{} && end == text.data() + text.size()) << text;
  return value;
}

struct ReadTable {
  std::vector<std::string> comments;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

ReadTable read_table(const std::string& text) {
  ReadTable table;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    if (line.starts_with('#')) {
      table.comments.push_back(line);
    } else if (table.columns.empty()) {
      table.columns = cells_of(line);
    } else {
      table.rows.push_back(cells_of(line));
    }
  }
  return table;
}

TEST(FigureCatalog, HasThePapersFiguresAndFourFurtherOnes) {
  std::vector<std::string> names;
  for (const FigureEntry& entry : figure_catalog()) names.emplace_back(entry.name);
  EXPECT_EQ(names, (std::vector<std::string>{"figure-1", "figure-2", "figure-3", "figure-4", "figure-6",
                                             "force-over-wall-angle", "force-over-stiffness-ratio", "proxy-drift",
                                             "energy-per-loop"}));
}

// ---- Each figure ----------------------------------------------------------------------------------------------------

class EachFigure : public testing::TestWithParam<const FigureEntry*> {};

TEST_P(EachFigure, HasAllItsFilesAndTheSameBytesEachTime) {
  const TemporaryFolder folder;
  const std::string name(GetParam()->name);
  std::set<std::string> expected;
  for (const std::string_view ending : figure_file_endings) expected.insert(name + std::string(ending));
  for (const std::string_view place : {"one", "two"}) {
    const Outcome outcome = figures({"-o", folder / place, "--only", name});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(name + ": "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("5 files in "), std::string::npos);
    EXPECT_EQ(names_in(folder / place), expected);
  }
  for (const std::string& file : expected) {
    const std::string bytes = read_whole(folder / "one/" + file);
    EXPECT_GT(bytes.size(), 1000U) << file;
    EXPECT_EQ(bytes, read_whole(folder / "two/" + file)) << file;
  }
  const Image small = read_png(folder / "one/" + name + ".png");
  const Image large = read_png(folder / "one/" + name + "@2x.png");
  EXPECT_EQ(large.width, 2 * small.width);
  EXPECT_EQ(large.height, 2 * small.height);
  EXPECT_TRUE(read_whole(folder / "one/" + name + ".svg").starts_with("<?xml"));
  EXPECT_TRUE(read_whole(folder / "one/" + name + ".pdf").starts_with("%PDF-"));
}

TEST_P(EachFigure, HasATableThatSaysWhereItComesFromAndReadsBack) {
  const Figure figure = GetParam()->make({});
  const ReadTable table = read_table(csv_text(figure.data));
  ASSERT_GE(table.comments.size(), 2U);
  EXPECT_TRUE(table.comments.front().starts_with("# ghostforce " GHOSTFORCE_VERSION "; scene "))
      << table.comments.front();
  EXPECT_TRUE(table.comments.front().ends_with("; seed 1"));
  EXPECT_EQ(table.columns, figure.data.columns);
  ASSERT_EQ(table.rows.size(), figure.data.rows.size());
  ASSERT_GE(table.rows.size(), strategy_count);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    ASSERT_EQ(table.rows[i].size(), table.columns.size());
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      const CsvCell& cell = figure.data.rows[i][k];
      if (const auto* value = std::get_if<double>(&cell)) {
        if (std::isnan(*value)) {
          EXPECT_EQ(table.rows[i][k], "nan");
        } else {
          ASSERT_EQ(number(table.rows[i][k]), *value);
        }
      } else {
        EXPECT_EQ(table.rows[i][k], std::get<std::string>(cell));
      }
    }
  }
}

struct Words {
  std::string text;
  Vector<2> least, most;
};

TEST_P(EachFigure, HasItsWordsOnThePaperAndApart) {
  const Figure figure = GetParam()->make({});
  bool has_provenance = false;
  for (const Pane& pane : figure.panes) {
    EXPECT_GE(pane.corner.x, 0.0);
    EXPECT_LE(pane.corner.x + pane.camera.size.x, figure.size.x);
    EXPECT_LE(pane.corner.y + pane.camera.size.y, figure.size.y);
    std::vector<Words> all;
    for (const Mark& mark : pane.marks) {
      const auto* label = std::get_if<Label>(&mark.form);
      if (label == nullptr) continue;
      const Vector<2> at = to_screen(pane.camera, label->anchor) + label->offset;
      all.push_back({label->text, at, at + measure_on_paper(label->text, label->size)});
      has_provenance |= label->text.starts_with("ghostforce " GHOSTFORCE_VERSION);
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Words& words = all[i];
      EXPECT_GE(words.least.x, -0.01) << words.text;
      EXPECT_GE(words.least.y, -0.01) << words.text;
      EXPECT_LE(words.most.x, pane.camera.size.x + 0.01) << words.text;
      EXPECT_LE(words.most.y, pane.camera.size.y + 0.01) << words.text;
      for (std::size_t k = 0; k < i; ++k) {
        const Vector<2> common = glm::min(words.most, all[k].most) - glm::max(words.least, all[k].least);
        // Lines of letters are higher than their letters.
        EXPECT_FALSE(common.x > 0.5 && common.y > 4.0) << words.text << " on " << all[k].text;
      }
    }
  }
  EXPECT_TRUE(has_provenance);
}

TEST_P(EachFigure, HasATableThatSaysWhatItsRowsAre) {
  const Figure figure = GetParam()->make({});
  EXPECT_TRUE(std::ranges::any_of(figure.data.comments,
                                  [](const std::string& line) { return line.starts_with("One row per "); }));
}

TEST_P(EachFigure, WritesItsSignsAsSigns) {
  for (const Pane& pane : GetParam()->make({}).panes) {
    for (const Mark& mark : pane.marks) {
      const auto* label = std::get_if<Label>(&mark.form);
      if (label == nullptr || label->text.starts_with("ghostforce ")) continue;  // keys of a scene have their names
      for (const std::string_view raw : {"k_r", "k_u", "k_t", "k_c", "K_r", "K_t", "q_u", "q_h", "q_p", "q_c"}) {
        EXPECT_EQ(label->text.find(raw), std::string::npos) << label->text;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, EachFigure, testing::ValuesIn([] {
                           std::vector<const FigureEntry*> entries;
                           for (const FigureEntry& entry : figure_catalog()) entries.push_back(&entry);
                           return entries;
                         }()),
                         [](const testing::TestParamInfo<const FigureEntry*>& each) {
                           std::string name(each.param->name);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

const FigureEntry& entry_named(std::string_view name) {
  return *std::ranges::find(figure_catalog(), name, &FigureEntry::name);
}

std::size_t column(const CsvTable& table, std::string_view name) {
  const auto at = std::ranges::find(table.columns, name);
  EXPECT_NE(at, table.columns.end()) << name;
  return static_cast<std::size_t>(at - table.columns.begin());
}

// Wherever a trajectory goes, and wherever one of the scenes' devices is, the table has a row that says so.
TEST(Figures, ShowNoPointThatIsNotInTheirTable) {
  for (const std::string_view name : {"figure-1", "figure-3", "figure-4", "figure-6"}) {
    const Figure figure = entry_named(name).make({});
    std::set<std::pair<double, double>> told;
    for (const std::string_view what : {"goal", "device", "proxy"}) {
      const std::size_t x = column(figure.data, std::string(what) + "_x_m");
      for (const auto& row : figure.data.rows) told.emplace(std::get<double>(row[x]), std::get<double>(row[x + 1]));
    }
    int looked_at = 0;
    for (const Pane& pane : figure.panes) {
      if (pane.camera.points_per_metre == 1.0) continue;  // no scene
      for (const Mark& mark : pane.marks) {
        const auto* line = std::get_if<Line>(&mark.form);
        const auto* marker = std::get_if<Marker>(&mark.form);
        if (mark.role == Role::trail && line != nullptr) {
          EXPECT_TRUE(told.contains({line->to.x, line->to.y})) << name;
          ++looked_at;
        } else if (mark.role == Role::device && marker != nullptr) {
          EXPECT_TRUE(told.contains({marker->center.x, marker->center.y})) << name;
          ++looked_at;
        }
      }
    }
    EXPECT_GT(looked_at, 500) << name;
  }
}

TEST(Figures, ShowEachSimulatedPointOfTheirTable) {
  for (const std::string_view name :
       {"force-over-wall-angle", "force-over-stiffness-ratio", "proxy-drift", "energy-per-loop"}) {
    const Figure figure = entry_named(name).make({});
    const std::size_t source = column(figure.data, "source");
    const auto told = std::ranges::count_if(
        figure.data.rows, [&](const auto& row) { return std::get<std::string>(row[source]) == "simulated"; });
    std::ptrdiff_t shown = 0;
    for (const Pane& pane : figure.panes) {
      shown += std::ranges::count_if(pane.marks, [](const Mark& mark) { return mark.role == Role::device; });
    }
    EXPECT_GE(told, 22) << name;
    // Where ρ = 1 is naïve rendering, its shape stands there besides.
    EXPECT_EQ(shown, told + (name == "proxy-drift" ? 1 : 0)) << name;
  }
}

TEST(Figures, SayInTheirTablesWhereAGoalIsThatIsNotTheScenes) {
  for (const auto& [name, key] : std::vector<std::pair<std::string, std::string>>{
           {"figure-6", "path_mm=[[-45, 30], [10, -20], [45, 15], [10, 50], [30, -10]] times_s=[0, 1, 2, 3, 4] "},
           {"force-over-wall-angle", "goal_depth_mm=20"},
           {"force-over-stiffness-ratio", "goal_depth_mm=20"},
           {"proxy-drift", "goal_depth_mm=20"},
           {"energy-per-loop", "circle_center_depth_mm=25 circle_radius_mm=10 turns_per_s=0.1"}}) {
    const std::vector<std::string> comments = entry_named(name).make({}).data.comments;
    EXPECT_TRUE(std::ranges::any_of(comments, [&](const std::string& line) { return line.starts_with(key); })) << name;
  }
}

// What a mark of a pane reaches, in points of the pane.
struct Reach {
  Vector<2> least, most;
};

Reach reach_of(const Pane& pane, const Arrow& arrow) {
  const Vector<2> tail = to_screen(pane.camera, arrow.tail);
  const Vector<2> tip = to_screen(pane.camera, arrow.tip);
  const double head = 2.0 * arrow.width;
  return {glm::min(tail, tip) - Vector<2>(head), glm::max(tail, tip) + Vector<2>(head)};
}

// Whichever way motor and wall stand.
TEST(Figures, DrawNoArrowOverTheEdge) {
  Scene scene = load_scene("wall45");
  for (const double degrees : {0.0, 30.0, 60.0, 90.0, 135.0, 270.0}) {
    scene.settings.actuated_angle = degrees * std::numbers::pi / 180.0;
    const Figure figure =
        entry_named("figure-6")
            .make({.hand = RecordedHand{
                       .name = "run.csv", .scene = scene, .start = state_at_start(scene.goal.points.front())}});
    int arrows = 0;
    for (const Pane& pane : figure.panes) {
      for (const Mark& mark : pane.marks) {
        const auto* arrow = std::get_if<Arrow>(&mark.form);
        if (arrow == nullptr) continue;
        ++arrows;
        const Reach reach = reach_of(pane, *arrow);
        EXPECT_GE(reach.least.x, 0.0) << degrees;
        EXPECT_GE(reach.least.y, 0.0) << degrees;
        EXPECT_LE(reach.most.x, pane.camera.size.x) << degrees;
        EXPECT_LE(reach.most.y, pane.camera.size.y) << degrees;
      }
    }
    EXPECT_EQ(arrows, 2) << "the motor axis";
  }
}

// Nobody should have to guess whose a letter is.
TEST(Figures, PutLettersNearestToTheirOwnDevices) {
  for (const std::string_view name : {"figure-3", "figure-4", "figure-6"}) {
    int looked_at = 0;
    for (const Pane& pane : entry_named(name).make({}).panes) {
      for (const Mark& mark : pane.marks) {
        const auto* label = std::get_if<Label>(&mark.form);
        if (label == nullptr || (label->text != "F" && label->text != "N" && label->text != "A")) continue;
        const Vector<2> middle =
            to_screen(pane.camera, label->anchor) + label->offset + 0.5 * measure_on_paper(label->text, label->size);
        double own = 1e9;
        double other = 1e9;
        for (const Mark& spot : pane.marks) {
          const auto* marker = std::get_if<Marker>(&spot.form);
          if (spot.role != Role::device || marker == nullptr) continue;
          const auto strategy = std::ranges::find(strategy_catalog(), label->text[0], &Strategy::letter);
          ASSERT_NE(strategy, strategy_catalog().end());
          const double way = glm::distance(middle, to_screen(pane.camera, marker->center));
          double& least = marker->fill == paper().strategy[index_of(strategy->id)] ? own : other;
          least = std::min(least, way);
        }
        ++looked_at;
        EXPECT_LT(own, other) << name << ' ' << label->text;
      }
    }
    EXPECT_GE(looked_at, 3) << name;
  }
}

// ---- A recorded hand ------------------------------------------------------------------------------------------------

TEST(FiguresHand, IsTheRecordingsOwn) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program(GHOSTFORCE_PROGRAM, {"simulate", "fig1", "-o", folder / "run.csv"}).exit_code, 0);
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
  ASSERT_EQ(run_program(GHOSTFORCE_PROGRAM, {"simulate", "fig1", "-o", folder / "run.csv"}).exit_code, 0);
  outcome = figures({"-o", folder / "out", "--only", "figure-1", "--hand", folder / "run.csv"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("figure-6"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

// A run of wall45 whose hand rests 20 mm inside the wall all the time, as it was recorded from 2 s on.
std::string resting_run(const std::string& before_rows, const std::string& in_midst = "") {
  const std::string text = run_program(GHOSTFORCE_PROGRAM, {"simulate", "wall45", "--strategy", "all"}).out;
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
  EXPECT_TRUE(at_rest.words.starts_with("# ghostforce " GHOSTFORCE_VERSION "; hand run.csv\n")) << at_rest.words;
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
  EXPECT_TRUE(contains(changed.words, "Settings were changed once while it was recorded, and are here; wall and motor"))
      << changed.words;
  EXPECT_NE(std::ranges::find(changed.table.comments, "# set t_s=0.5 rendering.tracking_ratio=2.0"),
            changed.table.comments.end())
      << testing::PrintToString(changed.table.comments);
  // The changed ratio is not the best one.
  EXPECT_TRUE(contains(changed.words, "A does not feel as F does at rest")) << changed.words;

  const std::string run = resting_run(std::string(state_at_2_s));
  const HandFigure reset = hand_figure(
      folder, run + "# state t_s=0 full=0,0,0 naive=0,0,0 anisotropic=0,0,0\n" + run.substr(run.find("\nfull,2,") + 1));
  for (const std::string& words : {reset.words, reset.outcome.err}) {
    EXPECT_TRUE(contains(words, "The run was reset after 1 s: what comes after is not shown")) << words;
  }
}

TEST(FiguresHand, ClaimsNoMoreThanItsDataShow) {
  const TemporaryFolder folder;
  const auto caption_with = [&](std::vector<std::string> set) {
    set.insert(set.begin(), {"simulate", "wall45", "--strategy", "all"});
    return hand_figure(folder, run_program(GHOSTFORCE_PROGRAM, std::move(set)).out).words;
  };
  EXPECT_TRUE(contains(caption_with({}), "Along the motor axis A feels as F does at rest; N is pulled away"));
  EXPECT_TRUE(contains(caption_with({"--set", "rendering.tracking_ratio=1"}), "A does not feel as F does at rest"));
  EXPECT_TRUE(contains(caption_with({"--set", "wall.normal_deg=180"}), "A feels as F does at rest; N does so too"));
  EXPECT_TRUE(contains(caption_with({"--set", "wall.point_mm=[500, -500]"}), "The hand never goes into the wall"));
}

TEST(FiguresHand, IsRefusedWithARemedy) {
  const TemporaryFolder folder;
  const std::string run = resting_run(std::string(state_at_2_s));
  const HandFigure one_tick = hand_figure(folder, run.substr(0, run.find("\nfull,2.001,") + 1));
  EXPECT_EQ(one_tick.outcome.exit_code, 2);
  EXPECT_TRUE(contains(one_tick.outcome.err, "run.csv: the hand does not move")) << one_tick.outcome.err;
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
  EXPECT_TRUE(contains(unstable.outcome.err, "run.csv: with its settings the sampled loop is unstable"))
      << unstable.outcome.err;
  EXPECT_TRUE(contains(unstable.outcome.err, "--set rendering.k_r_N_per_m=")) << unstable.outcome.err;
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
    const Outcome outcome = run_program(GHOSTFORCE_PROGRAM, call);
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
  EXPECT_EQ(run_program(GHOSTFORCE_PROGRAM, call).exit_code, 0);
  EXPECT_EQ(names_in(folder / "out").size(), figure_file_endings.size());
}

}  // namespace
}  // namespace ghostforce
