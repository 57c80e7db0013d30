// Figures: each in all its files, the same every time, with the numbers that it shows; and a command that leaves
// nothing half done.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
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

// ---- A recorded hand ------------------------------------------------------------------------------------------------

TEST(FiguresHand, IsTheRecordingsOwn) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program(GHOSTFORCE_PROGRAM, {"simulate", "fig1", "-o", folder / "run.csv"}).exit_code, 0);
  const Outcome outcome = figures({"-o", folder / "out", "--only", "figure-6", "--hand", folder / "run.csv"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const ReadTable table = read_table(read_whole(folder / "out/figure-6.csv"));
  EXPECT_NE(table.comments.front().find("of run.csv"), std::string::npos) << table.comments.front();
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

// ---- All or nothing -------------------------------------------------------------------------------------------------

TEST(FiguresCommand, RefusesAWrongNameAndSaysTheNearest) {
  const TemporaryFolder folder;
  const Outcome outcome = figures({"-o", folder / "out", "--only", "figure-7"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("did you mean 'figure-"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.count(), 0);
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
