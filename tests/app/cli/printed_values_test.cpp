// The printed lines against the picture: the same words and the same digits; and when there is a line at all.
#include "app/cli/reading_aloud.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/app/picture/picture_extents.h"
#include "tests/app/stage/stage_dice.h"

namespace ghostforce::printed_values_test {
namespace {

// In the order of printed_header().
enum Column : std::size_t { sentence, active_strategy, force, wall_share, ghost_force, slide, time_s, all_columns };

std::string printed_line(const StageReading& reading, double at_s) {
  return PrintedValues(1.0).poll(reading, at_s).value();
}

std::vector<std::string> columns_of_line(const std::string& line) {
  std::vector<std::string> columns(1);
  EXPECT_TRUE(line.ends_with('\n'));
  for (const char letter : line.substr(0, line.size() - 1)) {
    if (letter == '\t') {
      columns.emplace_back();
    } else {
      columns.back() += letter;
    }
  }
  EXPECT_EQ(columns.size(), all_columns) << line;
  columns.resize(all_columns);
  return columns;
}

// The words with this role, joined as one reads them.
std::string words_on(const PictureExtents& picture, Role role) {
  std::string words;
  for (const LabelExtent& label : picture.labels) {
    if (label.role == role) words += (words.empty() ? "" : " ") + label.words;
  }
  return words;
}

std::string without_sign(const std::string& number) {
  return number.starts_with('-') ? number.substr(1) : number;
}

TEST(PrintedValues, SayWhatThePictureSays) {
  PictureDice dice(20261122);
  int with_numbers = 0;
  int without_ghost_force = 0;
  for (int i = 0; i < 400; ++i) {
    const StageCase shown = stage_case_by(dice);
    const auto columns = columns_of_line(printed_line(shown.read(), 0.0));
    const PictureExtents picture(shown.compose().pane, measure_vector_text);
    EXPECT_EQ(columns[sentence], words_on(picture, Role::sentence));
    const bool has_numbers = shown.mode == StageMode::none || shown.mode == StageMode::ribbon;
    const std::string numbers = words_on(picture, Role::number);
    if (!has_numbers || numbers.empty()) continue;
    ++with_numbers;
    const bool knows_ghost = columns[ghost_force] != "-";
    without_ghost_force += knows_ghost ? 0 : 1;
    const std::string ghost_digits = knows_ghost ? without_sign(columns[ghost_force]) : "–";
    const std::string slide_digits = columns[slide] != "-" ? columns[slide] : "–";
    EXPECT_TRUE(numbers.starts_with(ghost_digits + " N ")) << numbers << " against " << ghost_digits;
    EXPECT_NE(numbers.find(" " + slide_digits + " mm "), std::string::npos) << numbers << " against " << slide_digits;
    const bool is_negative = numbers.find("negative ghost force") != std::string::npos;
    EXPECT_EQ(columns[ghost_force].starts_with('-') && knows_ghost, is_negative) << numbers;
    EXPECT_EQ(columns[wall_share] == "-", !knows_ghost);
  }
  EXPECT_GT(with_numbers, 100);
  EXPECT_GT(without_ghost_force, 3);
}

TEST(PrintedValues, AddUp) {
  const auto columns = columns_of_line(printed_line(stage_case_at(wall45(), wall45_goal).read(), 1.5));
  EXPECT_EQ(columns[sentence], "A ghost force drags the handle along the wall.");
  EXPECT_EQ(columns[active_strategy], "naive");
  EXPECT_EQ(columns[time_s], "1.500");
  EXPECT_NEAR(std::stod(columns[force]), std::stod(columns[wall_share]) + std::stod(columns[ghost_force]), 0.011);
  EXPECT_GT(std::stod(columns[ghost_force]), 0.0);
}

TEST(PrintedValues, HaveAColumnForEachName) {
  EXPECT_TRUE(printed_header().starts_with("# sentence\tstrategy\t"));
  EXPECT_EQ(columns_of_line(printed_header())[slide], "slide mm");
}

TEST(PrintedValues, DoNotGiveAwayTheAnswerToAGuess) {
  StageCase shown = stage_case_at(wall45(), wall45_goal);
  shown.mode = StageMode::predict;
  shown.guess = {.at = wall45_goal, .is_open = true};
  for (const Column column : {force, wall_share, ghost_force, slide}) {
    EXPECT_EQ(columns_of_line(printed_line(shown.read(), 0.0))[column], "-");
  }
  shown.guess.is_open = false;
  EXPECT_NE(columns_of_line(printed_line(shown.read(), 0.0))[slide], "-");
}

TEST(PrintedValues, SayTheVerdictOfTheLandscape) {
  StageCase shown = stage_case_at(wall45(), wall45_goal);
  shown.mode = StageMode::landscape;
  EXPECT_EQ(shown.read().sentence, "At this wall and this hand: +42 % of the wall's push, too much.");
  shown.settings.active = StrategyId::full;
  shown.moment = stage_moment_at_rest(shown.settings, wall45_goal);
  EXPECT_EQ(shown.read().sentence, "At this wall and this hand: no ghost force here.");
}

TEST(PrintedValues, StayOnOneLineWhateverIsSaid) {
  StageCase shown = stage_case_at(wall45(), wall45_goal);
  shown.warning = "two\tcolumns\nand two lines\r";
  EXPECT_EQ(columns_of_line(printed_line(shown.read(), 0.0))[sentence], "two columns and two lines ");
}

TEST(PrintedValues, AreDashesWhereTheyAreNoNumbers) {
  StageCase shown = stage_case_at(wall45(), wall45_goal);
  shown.moment.ghost_force = Vector<2>(std::numeric_limits<double>::quiet_NaN());
  shown.moment.slide = Vector<2>(std::numeric_limits<double>::infinity());
  const auto columns = columns_of_line(printed_line(shown.read(), 0.0));
  for (const Column column : {force, ghost_force, slide}) EXPECT_EQ(columns[column], "-");
}

TEST(PrintedValues, ComeWhenSomethingElseThanTheTimeIsNewAndNotTooOften) {
  const StageReading naive = stage_case_at(wall45(), wall45_goal).read();
  const StageReading cure = stage_case_at(wall45(StrategyId::anisotropic), wall45_goal).read();
  PrintedValues values(5.0);
  EXPECT_TRUE(values.advance(0.0)) << "the first line comes at once";
  EXPECT_EQ(columns_of_line(values.poll(naive, 1.0).value())[time_s], "1.000");
  EXPECT_FALSE(values.advance(0.1));
  EXPECT_TRUE(values.advance(0.1));
  EXPECT_FALSE(values.poll(naive, 2.0)) << "only the time is new";
  EXPECT_TRUE(values.advance(0.0)) << "what comes after a rest is printed at once";
  EXPECT_EQ(columns_of_line(values.poll(cure, 2.1).value())[active_strategy], "anisotropic");
  EXPECT_FALSE(values.advance(0.0));
  EXPECT_EQ(values.poll(cure, 2.099, true), printed_line(cure, 2.099)) << "a step back";
  EXPECT_FALSE(values.poll(cure, 2.099, true));
}

}  // namespace
}  // namespace ghostforce::printed_values_test
