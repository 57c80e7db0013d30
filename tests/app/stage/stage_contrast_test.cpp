// The words of the stage can be read, in every theme: over moments by dice, in lessons too, with buttons under the
// pointer and with the menu open.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "app/picture/system_theme.h"
#include "tests/app/picture/word_contrast.h"
#include "tests/app/stage/stage_faults.h"

namespace ghostforce::stage_contrast_test {
namespace {

class StageContrast : public testing::Test {
 protected:
  void expect_readable(const StageCase& shown, int number) {
    const Theme& theme = shown.own_theme != nullptr ? *shown.own_theme : *find_theme(shown.theme);
    for (const std::string& fault : unreadable_words(shown.compose().pane, theme, measure)) {
      if (++faulty_ <= 20) ADD_FAILURE() << number << " " << words_for(shown) << ": " << fault;
    }
  }
  void expect_readable_in_every_theme(StageCase shown, int number) {
    for (const Theme& theme : theme_catalog()) {
      shown.theme = theme.name;
      expect_readable(shown, number);
    }
  }
  ~StageContrast() override { EXPECT_EQ(faulty_, 0); }

  int faulty_ = 0;
};

TEST_F(StageContrast, EveryWordCanBeRead) {
  PictureDice dice(20261128);
  for (int i = 0; i < 300; ++i) expect_readable_in_every_theme(stage_case_by(dice), i);
}

TEST_F(StageContrast, EveryWordOfALessonCanBeRead) {
  PictureDice dice(20261129);
  for (int i = 0; i < 200; ++i) expect_readable_in_every_theme(lesson_case_by(dice, english_stage), i);
}

TEST_F(StageContrast, EveryWordOfTheMapCanBeRead) {
  PictureDice dice(20261130);
  for (int i = 0; i < 100; ++i) {
    StageCase shown = stage_case_by(dice);
    shown.mode = StageMode::landscape;
    shown.hovered.reset();
    expect_readable_in_every_theme(shown, i);
  }
}

TEST_F(StageContrast, EveryWordOfAButtonUnderThePointerCanBeRead) {
  const std::array<StageAction, 8> buttons{StageMode::predict,    StageMode::why,         StageMode::ribbon,
                                           StageCommand::lessons, StageCommand::menu,     StageCommand::link,
                                           StrategyId::full,      StrategyId::anisotropic};
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    StageCase shown = stage_case_at(wall45(), wall45_goal);
    shown.hovered = buttons[i];
    expect_readable_in_every_theme(shown, static_cast<int>(i));
    shown.shows_menu = true;
    expect_readable_in_every_theme(shown, static_cast<int>(i));
  }
}

TEST_F(StageContrast, EveryWordCanBeReadInTheSystemsColours) {
  const Theme theme = system_theme({.canvas = rgb(0x000000),
                                    .canvas_text = rgb(0xFFFFFF),
                                    .link_text = rgb(0xFFFF00),
                                    .highlight = rgb(0x1AEBFF),
                                    .gray_text = rgb(0x3FF23F)});
  PictureDice dice(20261131);
  for (int i = 0; i < 200; ++i) {
    StageCase shown = i % 2 == 0 ? stage_case_by(dice) : lesson_case_by(dice, english_stage);
    shown.own_theme = &theme;
    expect_readable(shown, i);
  }
}

}  // namespace
}  // namespace ghostforce::stage_contrast_test
