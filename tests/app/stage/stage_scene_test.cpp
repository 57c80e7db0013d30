// What of the stage's scene lies over what, and where it ends; what is said beside the button that it speaks of.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "app/stage/idle_show.h"
#include "tests/app/stage/stage_faults.h"

namespace ghostforce::stage_scene_test {
namespace {

std::vector<StageCase> cases_by(unsigned int seed, int count) {
  PictureDice dice(seed);
  std::vector<StageCase> all;
  for (int i = 0; i < count; ++i) all.push_back(stage_case_by(dice));
  return all;
}

// Else nobody finds what there is to take hold of: where the motor is upright, one end is at the hand.
TEST(StageScene, NothingLiesOverTheEndsOfARailThatCanBeTurned) {
  const std::set<Role> may_cover{Role::handle, Role::hint,  Role::button,  Role::number,
                                 Role::scale,  Role::guess, Role::sentence};
  int looked_at = 0;
  for (StageCase shown : cases_by(4, 300)) {
    shown.may_turn_motor = true;
    shown.may_turn_wall = false;
    if (shown.mode == StageMode::why) continue;  // there it cannot be turned
    const Drawn drawn(shown.compose());
    const Vector<2> pivot = to_screen(drawn.picture.pane.camera, drawn.picture.pivot);
    for (const Vector<2>& end : *drawn.picture.motor_grips) {
      if (shown.mode == StageMode::none && !shown.lesson) {
        EXPECT_GE(glm::distance(end, pivot), 49.0 * drawn.picture.unit)
            << words_for(shown) << ": it lies on the handle";
      }
      const Marks& marks = drawn.picture.pane.marks;
      const auto knob = std::ranges::find_if(marks, [&](const Mark& mark) {
        const auto* const disc = std::get_if<Marker>(&mark.form);
        return disc != nullptr && mark.role == Role::handle &&
               glm::distance(to_screen(drawn.picture.pane.camera, disc->center), end) < 0.01;
      });
      ASSERT_NE(knob, marks.end()) << words_for(shown);
      const auto place = static_cast<std::size_t>(knob - marks.begin());
      for (const Extent& extent : drawn.extents.marks) {
        if (extent.mark <= place || may_cover.contains(extent.role)) continue;
        EXPECT_LE(reach_into(ScreenBox{end, end}, extent), 0.0) << words_for(shown) << ' ' << role_name(extent.role);
      }
      ++looked_at;
    }
  }
  EXPECT_GT(looked_at, 300);
}

TEST(StageScene, TheWallsEdgeEndsBeforeFitAndReset) {
  int cut = 0;
  for (const StageCase& shown : cases_by(11, 300)) {
    const StagePicture picture = shown.compose();
    if (!picture.tools) continue;
    std::size_t pieces = 0;
    for (const Mark& mark : picture.pane.marks) {
      const auto* const line = std::get_if<Line>(&mark.form);
      if (line == nullptr || mark.role != Role::wall) continue;
      ++pieces;
      ScreenPiece piece{to_screen(picture.pane.camera, line->from), to_screen(picture.pane.camera, line->to), 0.0};
      EXPECT_FALSE(clip(picture.tools->grown(picture.unit), piece)) << words_for(shown);
    }
    cut += pieces > 1 ? 1 : 0;
  }
  EXPECT_GT(cut, 5);
}

// Whatever lies there.
TEST(StageScene, TheHintStandsBesideTheButtonThatItSpeaksOf) {
  for (const StageLanguage* const language : stage_languages) {
    PictureDice dice(27);
    for (int i = 0; i < 200; ++i) {
      StageCase shown = stage_case_by(dice, *language);
      if (shown.lesson || shown.mode != StageMode::none || shown.corner || !shown.warning.empty()) continue;
      shown.hint = StageHint::cure;
      shown.hovered.reset();
      const Drawn drawn(shown.compose());
      const LabelExtent* const hint = drawn.label(Role::hint, language->buttons.cure_hint);
      ASSERT_NE(hint, nullptr) << words_for(shown);
      const auto of = [&](StrategyId id) {
        const auto& all = drawn.picture.buttons;
        return std::ranges::find(all, StageAction(id), &StageButton::action)->box;
      };
      const ScreenBox button = of(StrategyId::anisotropic);
      const double row_top = std::min(button.least.y, of(StrategyId::naive).least.y);
      EXPECT_LE(row_top - hint->box.most.y, 12.0 * drawn.picture.unit) << words_for(shown);
      EXPECT_GT(std::min(hint->box.most.x, button.most.x) - std::max(hint->box.least.x, button.least.x), 0.0)
          << words_for(shown);
      for (const std::string& fault : faults_of(shown, drawn)) ADD_FAILURE() << words_for(shown) << ": " << fault;
    }
  }
}

TEST(StageScene, AHandCanBeDraggedBelowTheButtons) {
  StageCase shown = stage_case_at(wall45(), wall45_goal);
  const StagePicture picture = shown.compose();
  EXPECT_EQ(picture.reach.least, Vector<2>(0.0));
  EXPECT_EQ(picture.reach.most, shown.size);
  PictureDice dice(2);
  shown = lesson_case_by(dice);  // whose rows are not clear
  EXPECT_EQ(shown.compose().reach.most.y, shown.compose().scene.most.y);
}

// Whoever passes by shall know at once that this is no film.
TEST(StageScene, TheShowSaysWhatToDoFromItsBeginning) {
  for (const Vector<2>& size : {Vector<2>(1024.0, 640.0), Vector<2>(1280.0, 800.0), Vector<2>(1920.0, 1080.0)}) {
    for (const StrategyId active : {StrategyId::naive, StrategyId::anisotropic}) {
      StageCase shown = stage_case_at(wall45(active), wall45_goal);
      shown.size = size;
      LabelMemory memory;
      constexpr double frame_s = 1.0 / 60.0;
      for (int i = 0; i < 60; ++i) shown.compose(memory, frame_s);
      const StageMoment left = shown.moment;
      const Settings settings = shown.settings;
      shown.audience.sees_show = true;
      for (double time_s = frame_s; time_s < 3.0; time_s += frame_s) {
        StageShow show = stage_show({settings, wall45_goal, left}, time_s, std::min(1.0, time_s / 1.2));
        shown.settings = show.settings;
        shown.moment = show.moment;
        const Drawn drawn(shown.compose(memory, frame_s));
        EXPECT_TRUE(drawn.label(Role::hint, english_stage.labels.hand_shown)) << size.x << " after " << time_s << " s";
      }
    }
  }
}

// Red is what is wrong.
TEST(StageScene, TheLastStepOfWhyIsRedForAGhostForceAlone) {
  for (const Strategy& strategy : strategy_catalog()) {
    if (strategy.has_every_motor) continue;
    StageCase shown = stage_case_at(wall45(strategy.id), wall45_goal);
    shown.mode = StageMode::why;
    shown.why_step = 4;
    const StagePicture picture = shown.compose();
    const Theme& theme = *find_theme(shown.theme);
    const Colour red = theme.strategy_text[index_of(StrategyId::naive)];
    const bool is_red = std::ranges::any_of(picture.pane.marks, [&](const Mark& mark) {
      const auto* const label = std::get_if<Label>(&mark.form);
      return label != nullptr && label->text.starts_with("4") && label->colour == red;
    });
    EXPECT_EQ(is_red, strategy.id == StrategyId::naive) << strategy.name;
  }
}

}  // namespace
}  // namespace ghostforce::stage_scene_test
