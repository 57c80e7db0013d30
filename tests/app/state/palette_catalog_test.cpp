// The palette's catalog as values: all that a person can do is in it, with words, keys and reasons.
#include "app/state/palette_catalog.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <typeinfo>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "app/files/scene_file.h"
#include "app/state/key_bindings.h"
#include "app/state/lesson_file.h"
#include "app/state/lesson_guide.h"
#include "app/state/stage_action.h"

namespace ghostforce::palette_catalog_test {
namespace {

constexpr std::array inputs{mouse_hand, circling_hand};

class PaletteCatalog : public testing::Test {
 protected:
  PaletteCatalog() { loop.inputs = inputs; }

  const PaletteEntry none{.words = {}, .also = {}, .key = {}, .action = Escape{}, .refusal = {}, .group = {}};

  std::vector<PaletteEntry> catalog() const { return palette_catalog(session, loop); }
  template <typename A>
  PaletteEntry entry_with() const {
    const std::vector<PaletteEntry> all = catalog();
    const auto found =
        std::ranges::find_if(all, [](const PaletteEntry& entry) { return std::holds_alternative<A>(entry.action); });
    return found == all.end() ? none : *found;
  }
  PaletteEntry entry_called(std::string_view words) const {
    const std::vector<PaletteEntry> all = catalog();
    const auto found = std::ranges::find(all, words, &PaletteEntry::words);
    return found == all.end() ? none : *found;
  }
  // The one that is found first.
  PaletteEntry found(std::string_view sought) const {
    const std::vector<PaletteEntry> all = catalog();
    const std::vector<std::size_t> numbers = find_in_palette(all, sought);
    return numbers.empty() ? none : all[numbers.front()];
  }

  Session session = session_of(load_scene("wall45"));
  LoopReading loop;
};

// They need the pointer or an amount, or are what an arrow does.
using WithAmount = std::variant<HoldControl, MoveHandBy, MoveHandTo, LetGoOfHand, MoveGuessTo, TurnMotorTo, TurnWallTo,
                                GoToLandscapePoint, MovePart, TurnLandscapeDial, LookBackTo, MoveSliderTo, NudgeSlider,
                                MoveView, PanView, ChangeSpeed, ChangePlots, ChangeSafety, ChangeSpaceMouse,
                                ChangeStiffnesses, Believe, ChangeCircle, InjectFault>;
// They answer what stands on the screen, with its button beside it.
using OfWhatIsOpen = std::variant<PressMeasuringButton, Confirm, GoOn, AnswerLesson, TakeReading, RevealHand,
                                  BelieveMeasurement, FollowNewest, ForgetLessons, Escape, CloseDialog, CloseNotice,
                                  HideHints, ResetPreferences, ToggleMenu, CancelMeasuring, EndCircleTest>;
// A dialog that is in the catalog asks for their path first, or nobody chooses them by words.
using WithPath = std::variant<DropFiles, SaveScene, SavePicture, SaveClip, SavePlots>;
// Another Action in the catalog does the same.
using OtherWay = std::variant<ChooseByNumber, UseMotors, ShowFace, NextLanguage, BeginCircleTest>;
// A page has it.
using InPageAlone = std::variant<ShowLink, ShowControls>;
// No person does it.
using OfTheSystem = std::variant<FollowSystemMotion>;

TEST_F(PaletteCatalog, HasEveryActionThatNeedsNoPointerAndNoValue) {
  std::set<std::size_t> present;
  for (const PaletteEntry& entry : catalog()) present.insert(entry.action.index());
  const auto expect = [&]<typename... A>(std::type_identity<std::variant<A...>> /*all*/) {
    const auto one = [&]<typename T>(std::type_identity<T> /*kind*/) {
      constexpr bool stays_out = is_one_of<T, WithAmount> || is_one_of<T, OfWhatIsOpen> || is_one_of<T, WithPath> ||
                                 is_one_of<T, OtherWay> || is_one_of<T, InPageAlone> || is_one_of<T, OfTheSystem>;
      EXPECT_NE(present.contains(Action(T{}).index()), stays_out) << typeid(T).name();
    };
    (one(std::type_identity<A>{}), ...);
  };
  expect(std::type_identity<AnyAction>{});
}

TEST_F(PaletteCatalog, UsesAllWordsOfEachLanguageOnce) {
  for (const StageLanguage* const language : stage_languages) {
    session.language = language->code;
    const std::vector<PaletteEntry> all = catalog();
    std::set<std::string> seen;
    for (const PaletteEntry& entry : all) {
      EXPECT_FALSE(entry.words.empty());
      EXPECT_TRUE(seen.insert(entry.words).second) << entry.words;
    }
    const auto said = words_of(language->actions);
    for (std::size_t i = 0; i < said.size(); i += 2) {
      const std::string_view beginning = said[i].substr(0, said[i].find("{}"));
      const bool is_there =
          std::ranges::any_of(all, [&](const PaletteEntry& entry) { return entry.words.starts_with(beginning); });
      EXPECT_NE(is_there, said[i] == language->actions.link.words) << said[i];
    }
  }
}

TEST_F(PaletteCatalog, ShowsTheKeysOfTheTable) {
  EXPECT_EQ(found("save a picture").key, "Ctrl+Shift+S");
  EXPECT_EQ(found("strategy naive").key, "2");
  EXPECT_EQ(found("landscape").key, "L");
  EXPECT_EQ(found("zoom out").key, "Shift+Z");
  EXPECT_EQ(found("raise ratio").key, "+");
  EXPECT_EQ(found("arm").key, "");
  for (const KeyBinding& binding : key_table()) {
    if (binding.named == nullptr) continue;
    const std::string_view words = (english_stage.actions.*binding.named).words;
    const PaletteEntry same = entry_called(words);
    EXPECT_EQ(same.key, chord_of(binding)) << words;
    EXPECT_EQ(same.action.index(), binding.action->index()) << words;
    const bool is_one_key = !binding.shown.empty() && binding.sentence == words;
    if (is_one_key) {
      EXPECT_EQ(binding.shown, chord_of(binding)) << words;
    }
  }
}

// The palette arms what the button would arm at that moment.
TEST_F(PaletteCatalog, ArmsAndDismissesWhereTheButtonDoes) {
  for (int bits = 0; bits < 16; ++bits) {
    for (const SafetyState state :
         {SafetyState::off, SafetyState::arming, SafetyState::ramp, SafetyState::on, SafetyState::fade}) {
      MotorReport& motors = loop.motors;
      motors.has_motors = (bits & 1) != 0;
      motors.is_ready = (bits & 2) != 0;
      motors.may_still_push = (bits & 4) != 0;
      motors.reason = (bits & 8) != 0 ? OffReason::key : OffReason::none;
      motors.state = state;
      const std::optional<Action> button = action_of_motor_button(motors);
      const auto expect_same = [&](const PaletteEntry& entry) {
        EXPECT_EQ(entry.refusal.empty(), button && button->index() == entry.action.index()) << entry.words << bits;
        EXPECT_TRUE(entry.refusal.empty() || entry.refusal.ends_with('.')) << entry.refusal;
      };
      expect_same(entry_with<ArmMotors>());
      expect_same(entry_with<AcknowledgeOff>());
      EXPECT_EQ(entry_with<StopMotors>().refusal, "") << "whatever there is";
    }
  }
}

TEST_F(PaletteCatalog, TakesTheZeroPoseFromAPersonWhileADeviceWaitsForIt) {
  EXPECT_EQ(entry_with<ConfirmZeroPose>().refusal, english_stage.refusals.no_zero_pose);
  loop.motors = {.has_motors = true, .waits_for_zero_pose = true};
  EXPECT_EQ(entry_with<ConfirmZeroPose>().refusal, "");
  EXPECT_TRUE(std::holds_alternative<ConfirmZeroPose>(action_of_motor_button(loop.motors).value()));
}

// Whoever presses Enter without a look at the list arms nothing.
TEST_F(PaletteCatalog, BeginsWithStop) {
  loop.motors = {.has_motors = true, .is_ready = true};
  EXPECT_EQ(entry_with<ArmMotors>().refusal, "");
  for (const std::string_view sought : {"", "motor", "motors"}) {
    EXPECT_TRUE(std::holds_alternative<StopMotors>(found(sought).action)) << sought << found(sought).words;
  }
}

TEST_F(PaletteCatalog, SaysInItsLanguageWhyNot) {
  EXPECT_EQ(entry_with<ArmMotors>().refusal, english_stage.refusals.no_motors);
  EXPECT_EQ(entry_with<Undo>().refusal, english_stage.refusals.nothing_to_undo);
  session.undo_offer.undo = "k_r";
  EXPECT_EQ(entry_with<Undo>().refusal, "");
  EXPECT_EQ(entry_with<StopRecording>().refusal, english_stage.refusals.is_not_on);
  loop.recording.is_on = true;
  EXPECT_EQ(entry_with<StopRecording>().refusal, "");
  EXPECT_EQ(entry_with<StartRecording>().refusal, english_stage.refusals.is_so_already);
  session.language = "es";
  EXPECT_EQ(entry_with<NextCompareMode>().refusal, "");
  session.face = Face::stage;
  EXPECT_EQ(entry_with<NextCompareMode>().refusal, spanish_stage.refusals.only_on_workbench);
  EXPECT_EQ(entry_called(spanish_stage.actions.light_theme.words).refusal, spanish_stage.refusals.is_so_already);
  EXPECT_EQ(entry_called(spanish_stage.actions.dark_theme.words).refusal, "");
  EXPECT_EQ(entry_with<LeaveLesson>().refusal, spanish_stage.refusals.is_not_on);
  begin_lesson(session, shipped_lessons().front());
  EXPECT_EQ(entry_with<LeaveLesson>().refusal, "");
  EXPECT_EQ(entry_with<Undo>().refusal, spanish_stage.refusals.left_to_lesson);
  EXPECT_EQ(entry_with<ChooseInput>().refusal, spanish_stage.refusals.left_to_lesson);
}

}  // namespace
}  // namespace ghostforce::palette_catalog_test
