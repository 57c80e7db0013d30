// Figures: each in all its files, the same every time, with the numbers that it shows.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/png_writer.h"
#include "app/files/scene_file.h"
#include "app/tools/figures/figure.h"
#include "app/tools/figures/sheet.h"
#include "ghostforce_version.h"
#include "tests/app/tools/figures/figure_tables.h"
#include "tests/support/read_png.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::figures_test {
namespace {

TEST(FigureCatalog, BeginsWithThePapersFigures) {
  std::vector<std::string> names;
  for (const FigureEntry& entry : figure_catalog().first(5)) names.emplace_back(entry.name);
  EXPECT_EQ(names, (std::vector<std::string>{"figure-1", "figure-2", "figure-3", "figure-4", "figure-6"}));
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
  EXPECT_TRUE(table.comments.front().starts_with(fmt::format("# ghostforce {}; scene ", version)))
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
      all.push_back({label->text, at, at + measure_on_paper(label->text, label->style)});
      has_provenance |= label->text.starts_with(fmt::format("ghostforce {}", version));
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
       {"force-over-wall-angle", "force-over-stiffness-ratio", "proxy-drift", "energy-per-loop", "wrong-belief"}) {
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
           {"hand-estimate", "goal_depth_mm=20"},
           {"wrong-belief", "goal_depth_mm=20"},
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
            to_screen(pane.camera, label->anchor) + label->offset + 0.5 * measure_on_paper(label->text, label->style);
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

}  // namespace
}  // namespace ghostforce::figures_test
