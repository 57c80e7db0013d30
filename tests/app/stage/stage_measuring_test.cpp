// The hand as it is measured on the stage: its words and its ring, in any window and each language.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/app/stage/stage_faults.h"

namespace ghostforce::stage_measuring_test {
namespace {

constexpr int cases = 400;

HandEstimate estimate_by(PictureDice& dice) {
  const double k_u = dice.between(20.0, 2000.0);
  return {.why = HandUnknown::none, .k_u = k_u, .sigma = k_u * dice.between(0.0, 0.2), .mass = 0.3, .damping = 5.0};
}

// A hand that is being measured, or was, or cannot be.
void measure_by(PictureDice& dice, StageCase& shown) {
  const StageLanguage::Buttons& words = shown.language->buttons;
  StageMeasuring measuring{.is_running = dice.one_in(3), .filled = dice.between(0.0, 1.0)};
  if (dice.one_in(2)) measuring.before = estimate_by(dice);
  if (dice.one_in(3)) {
    measuring.why = static_cast<HandUnknown>(dice.between(1.0, static_cast<double>(hand_unknown_count) - 0.001));
  } else if (!measuring.is_running) {
    measuring.result = estimate_by(dice);
    measuring.is_believed = dice.one_in(2);
    if (shown.lesson && dice.one_in(2)) measuring.asked = estimate_by(dice).k_u;
  }
  shown.mode = StageMode::measure;
  shown.measuring = measuring;
  shown.guess = {};
  shown.round.reset();
  shown.moments.reset();
  shown.looks_back_to_s.reset();
  const bool has_motors = shown.corner.has_value();
  if (has_motors || shown.lesson) {
    const std::string_view longest = shown.lesson ? words.measure_again_in_lesson : words.measure_again;
    shown.measuring_button = StageMeasuringButton{std::string(words.believe), std::string(longest)};
  }
  if (!shown.lesson && !has_motors) {
    shown.corner = StageCornerButton{StageCommand::measure, std::string(words.measure_again)};
  }
}

class StageMeasuringTest : public testing::TestWithParam<const StageLanguage*> {};

INSTANTIATE_TEST_SUITE_P(InEachLanguage, StageMeasuringTest, testing::ValuesIn(stage_languages),
                         [](const auto& tested) { return std::string(tested.param->code); });

bool overlap_at_all(const ScreenBox& a, const ScreenBox& b) {
  return a.least.x < b.most.x - rounding && b.least.x < a.most.x - rounding && a.least.y < b.most.y - rounding &&
         b.least.y < a.most.y - rounding;
}

void expect_no_faults(const StageCase& shown, int number) {
  const Drawn drawn(shown.compose());
  for (const std::string& fault : faults_of(shown, drawn)) {
    ADD_FAILURE() << "case " << number << " " << words_for(shown) << ": " << fault;
  }
  const std::vector<StageButton>& buttons = drawn.picture.buttons;
  const ScreenBox window{Vector<2>(0.0), shown.size};
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    EXPECT_TRUE(lies_in(buttons[i].box, window)) << number << " " << words_for(shown);
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_FALSE(overlap_at_all(buttons[i].box, buttons[k].box)) << number << " " << words_for(shown);
    }
  }
}

TEST_P(StageMeasuringTest, HasNoWordsOverMarksOrEachOtherOrCutOff) {
  PictureDice dice(18);
  for (int i = 0; i < cases; ++i) {
    StageCase shown = stage_case_by(dice, *GetParam());
    measure_by(dice, shown);
    // A force of four digits is wider than what is kept clear for it, in all modes.
    if (!(glm::length(shown.moment.ghost_force) < 999.0)) continue;
    expect_no_faults(shown, i);
  }
}

TEST_P(StageMeasuringTest, AMotorThatTremblesSaysSoOverNothingElse) {
  PictureDice dice(21);
  for (int i = 0; i < cases / 2; ++i) {
    StageCase shown = stage_case_by(dice, *GetParam());
    shown.audience.feels_tones = true;
    if (!(glm::length(shown.moment.ghost_force) < 999.0)) continue;
    expect_no_faults(shown, i);
  }
}

TEST_P(StageMeasuringTest, HasRoomInALesson) {
  PictureDice dice(19);
  for (int i = 0; i < cases / 2; ++i) {
    StageCase shown = lesson_case_by(dice, *GetParam());
    measure_by(dice, shown);
    for (StageLessonRow& row : shown.lesson->rows) row.has_measuring = dice.one_in(2);
    shown.lesson->rows[shown.lesson->step].has_measuring = true;
    expect_no_faults(shown, i);
    const StagePicture picture = shown.compose();
    const auto button = std::ranges::find(picture.buttons, StageAction(StageCommand::measure), &StageButton::action);
    EXPECT_NE(button, picture.buttons.end()) << i;
  }
}

// The letters are not smaller for it, on a laptop, a projector and a television.
TEST_P(StageMeasuringTest, CanBeReadFromTheLastRow) {
  for (const Vector<2>& size : {Vector<2>(1024.0, 640.0), Vector<2>(1024.0, 768.0), Vector<2>(3840.0, 2160.0)}) {
    for (const bool has_motors : {false, true}) {
      StageCase shown = stage_case_at(wall45(), wall45_goal);
      shown.language = GetParam();
      shown.size = size;
      shown.moment.is_measured = has_motors;
      PictureDice dice(20);
      if (has_motors) {
        shown.corner = StageCornerButton{StageCommand::motors, std::string(GetParam()->motors.on), true};
      }
      measure_by(dice, shown);
      const Drawn drawn(shown.compose());
      for (const LabelExtent& label : drawn.extents.labels) {
        // As tests/app/stage/stage_test.cpp has it: nominal letters of a thirtieth of the height.
        if (std::ranges::count(GetParam()->strategy_buttons, label.words, &StageLanguage::StrategyButton::about) > 0)
          continue;
        EXPECT_GE(label.style.height / 1.17, 0.8 * size.y / 30.0) << label.words << " in " << words_for(shown);
      }
    }
  }
}

// What each state of it says, beside the hand and above.
TEST(StageMeasuring, SaysWhatIsSo) {
  StageCase shown = stage_case_at(wall45(), wall45_goal);
  shown.mode = StageMode::measure;
  const HandEstimate hand{.why = HandUnknown::none, .k_u = 310.4, .sigma = 24.7};
  const auto says = [&](const StageMeasuring& measuring) {
    shown.measuring = measuring;
    return shown.read().sentence;
  };
  const auto is_beside_hand = [&](const std::string& words) {
    const Drawn drawn(shown.compose());
    std::string said;  // perhaps in two lines
    for (const LabelExtent& label : drawn.extents.labels) {
      if (label.role == Role::hand) said += (said.empty() ? "" : " ") + label.words;
    }
    return said == words;
  };
  shown.audience.can_drag = false;
  EXPECT_EQ(says({.is_running = true}), english_stage.sentences.measure_runs);
  EXPECT_TRUE(is_beside_hand("measuring your hand…"));
  EXPECT_EQ(says({.is_running = true, .why = HandUnknown::no_contact}), english_stage.sentences.measure_needs_wall);
  EXPECT_EQ(says({.is_running = true, .why = HandUnknown::no_tones}), english_stage.sentences.measure_needs_motors);
  EXPECT_EQ(says({.filled = 1.0, .result = hand}), "Your hand: 310 ± 25 N/m. A push of 3.1 N moves it 1 cm.");
  EXPECT_TRUE(is_beside_hand("your hand: 310 ± 25 N/m"));
  EXPECT_EQ(says({.filled = 1.0, .result = hand, .is_believed = true}),
            "Anisotropic (3) now counts on a hand of 310 N/m.");
  HandEstimate softer = hand;
  softer.k_u = 118.0;
  says({.filled = 1.0, .result = hand, .before = softer});
  EXPECT_TRUE(is_beside_hand("your hand: 310 ± 25 N/m before: 118 N/m"));
  // A lesson asks for another grip.
  says({.filled = 1.0, .result = hand, .before = softer, .asked = 200.0});
  EXPECT_TRUE(is_beside_hand("your hand: 310 ± 25 N/m wanted: 200 N/m or less"));
  says({.filled = 1.0, .result = hand, .asked = 400.0});
  EXPECT_TRUE(is_beside_hand("your hand: 310 ± 25 N/m wanted: 400 N/m or more"));
  EXPECT_EQ(says({.why = HandUnknown::too_much_tremor}), english_stage.sentences.hand_too_restless);
  EXPECT_EQ(says({.why = HandUnknown::at_limit}), english_stage.sentences.hand_at_limit);
  EXPECT_TRUE(is_beside_hand("your hand: unknown"));
  EXPECT_EQ(says({.why = HandUnknown::rate_too_low}), english_stage.sentences.hand_too_slowly);
  EXPECT_EQ(says({.why = HandUnknown::out_of_range}), english_stage.sentences.hand_out_of_range);
  EXPECT_EQ(says({.why = HandUnknown::damaged}), english_stage.sentences.hand_damaged);
  EXPECT_EQ(says({.why = HandUnknown::no_tones}), english_stage.sentences.hand_not_moved);
  // Nobody is quite sure.
  HandEstimate sure = hand;
  sure.sigma = 0.0;
  says({.result = sure});
  EXPECT_TRUE(is_beside_hand("your hand: 310 ± 1 N/m"));
}

// A belief that follows the hand has tones sound all the time: whoever feels them must not take them for the wall.
TEST(StageMeasuring, SaysWhyTheMotorTrembles) {
  StageCase shown = stage_case_at(wall45(), wall45_goal);
  const auto is_said = [&] {
    const Drawn drawn(shown.compose());
    std::string said;  // perhaps in two lines
    for (const LabelExtent& label : drawn.extents.labels) {
      if (label.role == Role::motor_axis) said += (said.empty() ? "" : " ") + label.words;
    }
    return said == english_stage.labels.motor_measures;
  };
  EXPECT_FALSE(is_said());
  shown.audience.feels_tones = true;
  EXPECT_TRUE(is_said());
  shown.hint = StageHint::motor;
  EXPECT_TRUE(is_said()) << "and it goes before a hint";
  shown.hint.reset();
  // The cure at rest, but for the tones.
  shown.settings.active = StrategyId::anisotropic;
  shown.moment = stage_moment_at_rest(shown.settings, wall45_goal);
  EXPECT_EQ(shown.read().sentence, english_stage.sentences.cured);
  shown.moment.handle.x += 0.0007;
  EXPECT_EQ(shown.read().sentence, english_stage.sentences.cured_but_for_tones);
  shown.audience.feels_tones = false;
  EXPECT_EQ(shown.read().sentence, english_stage.sentences.hold_still);
  shown.audience.feels_tones = true;
  shown.mode = StageMode::measure;
  shown.measuring = StageMeasuring{.is_running = true};
  EXPECT_FALSE(is_said()) << "the mode says so already";
}

// Neither the letters nor anything else tells of a fuller ring but the ring.
TEST(StageMeasuring, TheRingFills) {
  StageCase shown = stage_case_at(wall45(), wall45_goal);
  shown.mode = StageMode::measure;
  const auto pieces = [&](double filled) {
    shown.measuring = StageMeasuring{.is_running = true, .filled = filled};
    const StagePicture picture = shown.compose();
    const Colour accent = find_theme(shown.theme)->accent;
    return std::ranges::count_if(picture.pane.marks, [&](const Mark& mark) {
      const auto* const line = std::get_if<Line>(&mark.form);
      return mark.role == Role::hand && line != nullptr && line->colour == accent;
    });
  };
  EXPECT_EQ(pieces(0.0), 0);
  EXPECT_GT(pieces(0.5), pieces(0.25));
  EXPECT_GT(pieces(1.0), pieces(0.5));
}

}  // namespace
}  // namespace ghostforce::stage_measuring_test
