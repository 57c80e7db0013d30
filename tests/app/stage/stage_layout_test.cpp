// Where words stand on the stage and how large letters are, whatever is said there.
#include "app/stage/stage_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/stage/sentence_widths.h"
#include "tests/app/stage/stage_faults.h"

namespace ghostforce::stage_layout_test {
namespace {

class StageLayoutTest : public testing::TestWithParam<const StageLanguage*> {};
INSTANTIATE_TEST_SUITE_P(InEachLanguage, StageLayoutTest, testing::ValuesIn(stage_languages),
                         [](const auto& each) { return std::string(each.param->code); });

TEST_P(StageLayoutTest, TheNumbersStandInOnePlaceWhateverIsSaid) {
  const StageFrameWords words{.language = *GetParam(), .keys = {.lessons = "F5", .help = "F1"}, .sentence = {}};
  for (const Vector<2>& size : {Vector<2>(640.0, 700.0), Vector<2>(1024.0, 640.0), Vector<2>(1280.0, 800.0)}) {
    const StageLayout empty = stage_layout(size, 1.0, measure, words);
    for (const std::string_view sentence : words_of(GetParam()->sentences)) {
      StageFrameWords said = words;
      said.sentence = sentence;
      const StageLayout layout = stage_layout(size, 1.0, measure, said);
      EXPECT_EQ(layout.words_end, empty.words_end) << sentence;
      EXPECT_EQ(layout.unit, empty.unit) << sentence;
    }
  }
}

// However many bytes the others have.
TEST_P(StageLayoutTest, TheWidestSentenceDecidesHowLargeLettersAre) {
  StageLanguage language = *GetParam();
  const StageFrameWords words{.language = language, .keys = {.lessons = "F5", .help = "F1"}, .sentence = {}};
  const auto unit = [&] { return stage_layout({700.0, 700.0}, 1.0, measure, words).unit; };
  const double usual = unit();
  const std::string wide = "W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W";
  language.sentences.push = wide;
  const double with_wide = unit();
  EXPECT_LT(with_wide, usual);
  std::string many_bytes;
  for (int i = 0; i < 45; ++i) many_bytes += "í ";
  ASSERT_GT(many_bytes.size(), wide.size());
  language.sentences.two_motors = many_bytes;
  EXPECT_EQ(unit(), with_wide);
}

TEST_P(StageLayoutTest, WhatMayBeSaidIsMeasuredOnce) {
  const std::vector<std::string_view> all = all_said_there(*GetParam());
  std::size_t measured = 0;
  const MeasureText counting = [&](std::string_view text, const TextStyle& style) {
    measured += std::ranges::find(all, text) != all.end() ? 1U : 0U;
    return measure(text, style);
  };
  SentenceWidths widths;
  StageFrameWords words{.language = *GetParam(), .keys = {.lessons = "F5", .help = "F1"}, .sentence = "W"};
  words.widths = &widths;
  const StageLayout first = stage_layout({1280.0, 800.0}, 1.0, counting, words);
  EXPECT_GE(measured, 2 * all.size());
  measured = 0;
  const StageLayout second = stage_layout({1280.0, 800.0}, 1.0, counting, words);
  EXPECT_LT(measured, all.size());
  EXPECT_EQ(second.words_end, first.words_end);
  words.widths = nullptr;
  EXPECT_EQ(stage_layout({1280.0, 800.0}, 1.0, counting, words).unit, first.unit);
}

// Upright and on its side.
const std::array phones{Vector<2>(390.0, 844.0), Vector<2>(844.0, 390.0), Vector<2>(360.0, 640.0),
                        Vector<2>(640.0, 360.0)};

TEST_P(StageLayoutTest, HasButtonsForFingersOnAPhone) {
  for (const Vector<2>& size : phones) {
    for (const StageMode mode : {StageMode::none, StageMode::predict, StageMode::why}) {
      StageCase shown = stage_case_at(wall45(), wall45_goal);
      shown.language = GetParam();
      shown.size = size;
      shown.mode = mode;
      if (mode != StageMode::none) shown.corner = StageCornerButton{mode, std::string(GetParam()->buttons.back)};
      const Drawn drawn(shown.compose());
      const ScreenBox window{Vector<2>(0.0), size};
      std::set<StageAction> there;
      for (const StageButton& button : drawn.picture.buttons) {
        there.insert(button.action);
        EXPECT_TRUE(lies_in(button.box, window)) << button.words;
        EXPECT_GE(button.box.extent().y, 44.0 - rounding) << button.words;
        EXPECT_GE(button.box.extent().x, 24.0) << button.words;
        for (const StageButton& other : drawn.picture.buttons) {
          if (other.action == button.action) continue;
          EXPECT_LE(overlap(button.box, other.box), 0.0) << button.words << " and " << other.words;
        }
      }
      for (const StageAction& action :
           std::array<StageAction, 6>{StageCommand::fit, StageCommand::reset_all, StageCommand::menu,
                                      StageCommand::lessons, StrategyId::naive, StrategyId::anisotropic}) {
        EXPECT_TRUE(there.contains(action)) << size.x << "x" << size.y;
      }
      for (const std::string& fault : faults_of(shown, drawn))
        ADD_FAILURE() << size.x << "x" << size.y << ": " << fault;
    }
  }
}

// Also where the picture is too low for all rows below each other.
TEST_P(StageLayoutTest, HasAMenuForFingersOnAPhone) {
  for (const Vector<2>& size : phones) {
    StageCase shown = stage_case_at(wall45(), wall45_goal);
    shown.language = GetParam();
    shown.size = size;
    shown.shows_menu = true;
    shown.keys.full_screen = "X";  // as a page has them
    shown.keys.controls = "Tab";
    const Drawn drawn(shown.compose());
    ASSERT_TRUE(drawn.picture.menu);
    EXPECT_TRUE(lies_in(*drawn.picture.menu, {Vector<2>(0.0), size})) << size.x << "x" << size.y;
    for (const StageMenuRow& row : stage_menu(*GetParam(), shown.keys)) {
      const auto button = std::ranges::find(drawn.picture.buttons, row.action, &StageButton::action);
      ASSERT_NE(button, drawn.picture.buttons.end()) << row.title;
      EXPECT_TRUE(lies_in(button->box, *drawn.picture.menu)) << size.x << "x" << size.y << " " << row.title;
      EXPECT_GE(button->box.extent().y, 44.0 - rounding) << size.x << "x" << size.y << " " << row.title;
    }
    for (const std::string& fault : faults_of(shown, drawn)) ADD_FAILURE() << size.x << "x" << size.y << ": " << fault;
  }
}

TEST_P(StageLayoutTest, HasLettersThatCanBeReadOnAPhone) {
  for (const Vector<2>& size : phones) {
    const StageCase shown = [&] {
      StageCase made = stage_case_at(wall45(), wall45_goal);
      made.language = GetParam();
      made.size = size;
      return made;
    }();
    double least = 1e9;
    for (const LabelExtent& label : Drawn(shown.compose()).extents.labels) {
      least = std::min(least, label.style.height);
    }
    EXPECT_GE(least, 9.0) << size.x << "x" << size.y;
  }
}

// As many as have room, the link first.
TEST_P(StageLayoutTest, SaysTheKeysOfAPage) {
  StageCase shown = stage_case_at(wall45(), wall45_goal);
  shown.language = GetParam();
  shown.keys = {.lessons = "M", .help = "K", .link = "U"};
  std::size_t before = 0;
  for (const double width : {1280.0, 1920.0}) {
    shown.size = {width, 800.0};
    const std::vector<StageButton> buttons = shown.compose().buttons;
    const auto is_hint = [](const StageButton& each) {
      return each.words.starts_with("U ") || each.words.starts_with("M ") || each.words.starts_with("K ");
    };
    const auto count = static_cast<std::size_t>(std::ranges::count_if(buttons, is_hint));
    const bool has_room_for_all = width > 1280.0 || GetParam() == &english_stage;
    EXPECT_GE(count, has_room_for_all ? 3U : std::max<std::size_t>(1, before)) << width;
    before = count;
  }
}

TEST_P(StageLayoutTest, HasTheLinkOfAPage) {
  for (const Vector<2>& size : {Vector<2>(1280.0, 800.0), Vector<2>(800.0, 1280.0), Vector<2>(390.0, 844.0)}) {
    StageCase shown = stage_case_at(wall45(), wall45_goal);
    shown.language = GetParam();
    shown.size = size;
    const auto has_it = [&] {
      const std::vector<StageButton> buttons = shown.compose().buttons;
      return std::ranges::count(buttons, StageAction(StageCommand::link), &StageButton::action) == 1;
    };
    shown.keys.link = "U";
    EXPECT_TRUE(has_it()) << size.x << "x" << size.y;
    shown.keys.link = {};
    EXPECT_FALSE(has_it()) << size.x << "x" << size.y;
  }
}

TEST(StageMenu, HasWhatThisFrontHas) {
  const auto has = [](StageCommand command, const StageKeys& keys) {
    return std::ranges::count(stage_menu(english_stage, keys), StageAction(command), &StageMenuRow::action) == 1;
  };
  EXPECT_TRUE(has(StageCommand::full_screen, {.lessons = "F5", .help = "F1", .full_screen = "F11"}));
  EXPECT_TRUE(has(StageCommand::controls, {.lessons = "M", .help = "K", .controls = "Tab"}));
  for (const StageCommand command : {StageCommand::full_screen, StageCommand::controls}) {
    EXPECT_FALSE(has(command, {.lessons = "F5", .help = "F1"}));
  }
}

TEST(ScaleOverStage, GrowsWithTheWindowAsFarAsDialogsFit) {
  EXPECT_DOUBLE_EQ(scale_over_stage({1280.0, 720.0}, 1.0), 16.0 / 15.0);
  EXPECT_DOUBLE_EQ(scale_over_stage({1280.0, 800.0}, 1.0), 1.2);
  EXPECT_DOUBLE_EQ(scale_over_stage({3840.0, 2160.0}, 1.0), 50.0 / 15.0);
  EXPECT_DOUBLE_EQ(scale_over_stage({1920.0, 1440.0}, 1.0), 2.2);
  EXPECT_DOUBLE_EQ(scale_over_stage({640.0, 2000.0}, 1.0), 1.0) << "too narrow for larger ones";
  EXPECT_DOUBLE_EQ(scale_over_stage({800.0, 600.0}, 1.0), 1.0) << "never below what the person has chosen";
  EXPECT_DOUBLE_EQ(scale_over_stage({800.0, 600.0}, 2.0), 2.0);
  EXPECT_DOUBLE_EQ(scale_over_stage({1280.0, 720.0}, 0.75), 14.0 / 15.0);
}

TEST(ScaleOverStage, NeedsOtherLettersOnlyNowAndThen) {
  std::set<double> scales;
  for (double height = 720.0; height <= 1440.0; height += 1.0) {
    const double scale = scale_over_stage({4000.0, height}, 1.0);
    const double grown = std::min(1.25 * height / 720.0, height / 640.0);
    EXPECT_LE(scale, grown + 1e-9);
    EXPECT_GT(scale, grown - 0.067);
    scales.insert(scale);
  }
  EXPECT_EQ(scales.size(), 18U);
}

}  // namespace
}  // namespace ghostforce::stage_layout_test
