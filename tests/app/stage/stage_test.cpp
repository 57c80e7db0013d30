// The stage as a picture, over many moments by dice: no words over a mark, over each other or beyond the window; all of
// them large enough for the last row; and the numbers always there.
#include "app/stage/stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "tests/app/stage/stage_faults.h"
#include "tests/support/long_run.h"

namespace ghostforce::stage_test {
namespace {

constexpr int cases = 700;

class Stage : public StageInEachLanguage {};
INSTANTIATE_TEST_SUITE_P(InEachLanguage, Stage, testing::ValuesIn(stage_languages),
                         [](const auto& each) { return std::string(each.param->code); });

TEST_P(Stage, HasNoWordsOverMarksOrEachOtherOrCutOff) {
  PictureDice dice(20261130);
  int faulty = 0;
  for (int i = 0; i < cases; ++i) {
    const StageCase shown = stage_case_by(dice, *GetParam());
    const Drawn drawn(shown.compose());
    const std::vector<std::string> faults = faults_of(shown, drawn);
    if (faults.empty()) continue;
    if (++faulty > 20) continue;
    for (const std::string& fault : faults) ADD_FAILURE() << "case " << i << " " << words_for(shown) << ": " << fault;
  }
  EXPECT_EQ(faulty, 0);
}

// Also where a label has just lost its place: in pictures that follow one another.
TEST_P(Stage, HasNoWordsOverMarksFromMomentToMoment) {
  PictureDice dice(7);
  int faulty = 0;
  for (int round = 0; round < 25; ++round) {
    LabelMemory memory;
    StageCase shown = stage_case_by(dice, *GetParam());
    const StageCase other = stage_case_by(dice, *GetParam());
    const Vector<2> from = shown.moment.goal;
    const Vector<2> to = to_world(camera_on(shown.shown.center, shown.shown.width, shown.size),
                                  shown.size * Vector<2>(dice.between(0.0, 1.0), dice.between(0.0, 1.0)));
    for (int i = 0; i < 30; ++i) {
      shown.moment = stage_moment_at_rest(shown.settings, from + (to - from) * (i / 30.0));
      if (i == 20) shown.size = other.size;
      if (i == 25) shown.scale = other.scale;
      const Drawn drawn(shown.compose(memory, 1.0 / 60.0));
      const std::vector<std::string> faults = faults_of(shown, drawn);
      if (faults.empty()) continue;
      if (++faulty > 20) continue;
      for (const std::string& fault : faults) {
        ADD_FAILURE() << "round " << round << "." << i << " " << words_for(shown) << ": " << fault;
      }
    }
  }
  EXPECT_EQ(faulty, 0);
}

bool has_numbers(const StageCase& shown) {
  return shown.mode == StageMode::none || shown.mode == StageMode::ribbon ||
         (shown.mode == StageMode::predict && !shown.guess.is_open);
}

TEST_P(Stage, HasItsNumbersAlwaysAtOnePlace) {
  for (const Vector<2>& size :
       {Vector<2>(1024.0, 640.0), Vector<2>(1280.0, 800.0), Vector<2>(1920.0, 1080.0), Vector<2>(3840.0, 2160.0)}) {
    PictureDice dice(31);
    std::optional<ScreenBox> place;
    for (int i = 0; i < 300; ++i) {
      StageCase shown = stage_case_by(dice, *GetParam());
      shown.size = size;
      shown.scale = 1.0;
      shown.hovered.reset();  // what is said of it takes the words below away
      const Drawn drawn(shown.compose());
      ASSERT_TRUE(drawn.picture.numbers) << i << " " << words_for(shown);
      if (!place) place = drawn.picture.numbers;
      EXPECT_EQ(drawn.picture.numbers->least, place->least) << i << " " << words_for(shown);
      EXPECT_EQ(drawn.picture.numbers->most, place->most) << i << " " << words_for(shown);
      if (!has_numbers(shown)) continue;
      EXPECT_EQ(std::ranges::count(drawn.extents.labels, Role::number, &LabelExtent::role), 6) << words_for(shown);
      EXPECT_TRUE(lies_in(drawn.numbers(), *drawn.picture.numbers)) << i << " " << words_for(shown);
    }
  }
}

TEST_P(Stage, SaysEachNumberOnce) {
  const StageLanguage::Labels& labels = GetParam()->labels;
  StageCase shown = case_at(wall45(), wall45_goal);
  const Drawn framed(shown.compose());
  ASSERT_NE(framed.label(Role::ghost_force), nullptr);
  ASSERT_NE(framed.label(Role::proxy_drift), nullptr);
  EXPECT_EQ(framed.label(Role::ghost_force)->words, labels.ghost);
  EXPECT_EQ(framed.label(Role::proxy_drift)->words, labels.slid);
  EXPECT_NE(framed.label(Role::number, "1.27"), nullptr);
  EXPECT_NE(framed.label(Role::number, "12.0"), nullptr);
  shown.is_bare = true;
  const Drawn bare(shown.compose());
  ASSERT_NE(bare.label(Role::ghost_force), nullptr);
  ASSERT_NE(bare.label(Role::proxy_drift), nullptr);
  EXPECT_EQ(bare.label(Role::ghost_force)->words, fmt::format("{} 1.27 N", labels.ghost));
  EXPECT_EQ(bare.label(Role::proxy_drift)->words, fmt::format("{} 12.0 mm", labels.slid));
  EXPECT_EQ(bare.label(Role::number), nullptr);
}

TEST_P(Stage, HasTheWallInAViewOfAHandFarAway) {
  const Settings settings = wall45();
  const Vector<2> out = wall_of(settings).normal;
  for (const double distance : {0.0, 0.01, 0.1, 0.5}) {
    const StageCase shown = case_at(settings, distance * out);
    const Camera camera = shown.compose().pane.camera;
    const ScreenBox window{Vector<2>(0.0), shown.size};
    EXPECT_TRUE(contains(window, to_screen(camera, settings.wall_point))) << distance;
    EXPECT_TRUE(contains(window, to_screen(camera, distance * out))) << distance;
  }
}

TEST_P(Stage, CoversNothingOfAViewThatFits) {
  PictureDice dice(32);
  for (int i = 0; i < 600; ++i) {
    Settings settings = wall45(dice.one_of(std::array{StrategyId::full, StrategyId::naive, StrategyId::anisotropic}));
    settings.wall_normal_angle = i % 2 == 0 ? dice.between(-7.0, 7.0) : 0.25 * std::numbers::pi * (i % 8);
    settings.actuated_angle = i % 3 == 0 ? dice.between(-7.0, 7.0) : 0.25 * std::numbers::pi * (i % 5);
    settings.stiffnesses.k_u = dice.decades(1.9, 2.7);
    settings.stiffnesses.k_r = settings.stiffnesses.k_u * dice.decades(-0.3, 1.0);
    const Vector<2> goal = dice.goal(settings);
    StageCase shown = case_at(settings, goal);
    // The arrow of a scene whose hand presses more or less deep.
    shown.reference_force *= dice.decades(-0.5, 0.5);
    shown.shown = stage_view_of(settings, std::array{goal}, shown.reference_force);
    shown.size = i % 7 == 0 ? Vector<2>(640.0, 700.0) : dice.size();
    shown.scale = dice.scale();
    shown.may_turn_motor = shown.may_turn_wall = true;
    EXPECT_EQ(covered_by_frame(Drawn(shown.compose())), "") << i << " " << words_for(shown);
  }
}

// Of the button that is there, as it is drawn.
Colour fill_of(const StagePicture& picture, const StageButton& button) {
  const Vector<2> corner = to_world(picture.pane.camera, button.box.least);
  for (const Mark& mark : picture.pane.marks) {
    const auto* const box = std::get_if<Box>(&mark.form);
    if (box != nullptr && mark.role == Role::button && glm::distance(box->corner, corner) < 1e-9) return box->fill;
  }
  ADD_FAILURE() << "there is no button " << button.words;
  return {};
}

TEST_P(Stage, ShowsWhatIsDraggedThroughButtonsButForTheOneThatStopsMotors) {
  for (const bool is_alarming : {false, true}) {
    StageCase shown = case_at(wall45(), wall45_goal);
    shown.corner = StageCornerButton{StageCommand::motors, "MOTORS", is_alarming};
    const StageAction motors{StageCommand::motors};
    const auto corner_in = [&motors](const StagePicture& picture) {
      return *std::ranges::find(picture.buttons, motors, &StageButton::action);
    };
    const StagePicture before = shown.compose();
    const ScreenBox box = corner_in(before).box;
    // The hand is dragged to below it.
    shown.shown.center += shown.moment.goal - to_world(before.pane.camera, 0.5 * (box.least + box.most));
    const StagePicture at_rest = shown.compose();
    shown.is_dragging = true;
    const StagePicture dragged = shown.compose();
    EXPECT_EQ(fill_of(at_rest, corner_in(at_rest)).alpha, 255);
    EXPECT_EQ(fill_of(dragged, corner_in(dragged)).alpha == 255, is_alarming);
  }
}

// --- What is usual loses no words --------------------------------------------------------------------------------------

std::vector<std::string> usual_words(StrategyId active, const StageLanguage::Labels& labels) {
  const auto with = [](std::string_view words, std::string_view more) { return fmt::format("{} {}", words, more); };
  std::vector<std::string> words{std::string(labels.handle), with(labels.wall, ""), std::string(labels.hand),
                                 std::string(labels.virtual_wall)};
  if (active != StrategyId::full) words.push_back(filled(labels.motor_pushes, labels.left_and_right));
  if (active == StrategyId::naive) {
    words.insert(words.end(), {std::string(labels.ghost), std::string(labels.slid), std::string(labels.should_rest),
                               std::string(labels.should_hold)});
  }
  return words;
}

TEST_P(Stage, SaysEverythingInTheUsualPictures) {
  for (const Vector<2>& size : {Vector<2>(1024.0, 640.0), Vector<2>(1024.0, 768.0), Vector<2>(1280.0, 720.0),
                                Vector<2>(1280.0, 800.0), Vector<2>(1920.0, 1080.0), Vector<2>(3840.0, 2160.0)}) {
    for (const double scale : {0.75, 1.0}) {
      for (const Theme& theme : theme_catalog()) {
        for (const Strategy& strategy : strategy_catalog()) {
          StageCase shown = case_at(wall45(strategy.id), wall45_goal);
          shown.shown = stage_view_of(shown.settings, wall45_goal);
          shown.size = size;
          shown.scale = scale;
          shown.theme = theme.name;
          const Drawn drawn(shown.compose());
          std::string all = " ";  // a label may be broken into two lines
          for (const LabelExtent& label : drawn.extents.labels) {
            if (label.role != Role::number) all += label.words + ' ';
          }
          for (const std::string& words : usual_words(strategy.id, GetParam()->labels)) {
            EXPECT_TRUE(all.find(' ' + words) != std::string::npos) << words << " in " << words_for(shown);
          }
          EXPECT_LE(drawn.extents.leaders.size(), 2U) << words_for(shown);
          EXPECT_FALSE(drawn.covers_soft_marks(drawn.numbers())) << words_for(shown);
        }
      }
    }
  }
}

// Of a piece of the force, so far as it is seen.
double arrow_length(const Drawn& drawn, Role role) {
  double length = 0.0;
  for (const Mark& mark : drawn.picture.pane.marks) {
    const auto* const arrow = std::get_if<Arrow>(&mark.form);
    if (arrow == nullptr || mark.role != role) continue;
    const Camera& camera = drawn.picture.pane.camera;
    ScreenPiece piece{to_screen(camera, arrow->tail), to_screen(camera, arrow->tip), 0.0};
    if (clip(drawn.picture.scene, piece)) length = std::max(length, glm::distance(piece.from, piece.to));
  }
  return length;
}

TEST_P(Stage, LeavesOutTheLessImportantWords) {
  PictureDice dice(99);
  std::map<Role, std::array<int, 2>> count;  // asked for, found
  const auto tally = [&](const Drawn& drawn, Role role, std::string_view words) {
    ++count[role][0];
    if (drawn.label(role, words) != nullptr) ++count[role][1];
  };
  const int pictures = is_long_run() ? 4000 : 1000;
  for (int i = 0; i < pictures; ++i) {
    StageCase shown = stage_case_by(dice, *GetParam());
    shown.mode = StageMode::none;
    shown.warning = {};
    shown.hovered.reset();  // what is said of it takes the words below away
    const Drawn drawn(shown.compose());
    const Camera& camera = drawn.picture.pane.camera;
    const StageMoment& moment = shown.moment;
    const auto is_seen = [&](const Vector<2>& world) {
      return contains(drawn.picture.scene, to_screen(camera, world));
    };
    // What lies beyond the scene or below the numbers needs no words: once it is let go, the view follows it.
    if (!covered_by_frame(drawn).empty()) continue;
    if (!is_seen(moment.handle) || !is_seen(moment.goal) || !is_seen(moment.proxy)) continue;
    // In the fist there is no handle to be seen.
    const double apart = glm::distance(moment.handle, moment.goal) * camera.points_per_metre;
    if (apart > 60.0 * drawn.picture.unit) tally(drawn, Role::device, GetParam()->labels.handle);
    tally(drawn, Role::hand, "");
    for (const auto& [role, force] :
         {std::pair(Role::ghost_force, moment.ghost_force), std::pair(Role::wall_share, moment.wall_share)}) {
      if (glm::length(force) < least_shown_force) continue;
      if (arrow_length(drawn, role) > 30.0 * drawn.picture.unit) tally(drawn, role, "");
    }
    if (!moment.is_measured && moment.in_contact && glm::length(moment.slide) * camera.points_per_metre > 10.0) {
      tally(drawn, Role::proxy_drift, GetParam()->labels.slid);
    }
    if (moment.weights[index_of(StrategyId::full)] == 0.0) tally(drawn, Role::motor_axis, "");
  }
  for (const auto& [role, both] : count) fmt::print("{}: {} of {}\n", role_name(role), both[1], both[0]);
  const auto share = [&](Role role) { return static_cast<double>(count[role][1]) / count[role][0]; };
  // Its number stands at the upper left. In two lines the Spanish words are as wide as "fantasma", and fit less often.
  EXPECT_GE(share(Role::ghost_force), GetParam() == &english_stage ? 0.97 : 0.94);
  EXPECT_GE(share(Role::proxy_drift), 0.95);
  EXPECT_GE(share(Role::device), 0.95);
  EXPECT_GE(share(Role::wall_share), 0.9);
  EXPECT_GE(share(Role::hand), 0.85);
}

// --- The menu ----------------------------------------------------------------------------------------------------------

// Words below it may go; all others stay where they are.
void expect_nothing_moves(const Drawn& before, const Drawn& now, const ScreenBox& over, const std::string& where) {
  for (const LabelExtent& label : now.extents.labels) {
    if (lies_in(label.box, over)) continue;
    EXPECT_LE(overlap(label.box, over), rounding) << label.words << " in " << where;
    const bool was_there = std::ranges::any_of(before.extents.labels, [&](const LabelExtent& other) {
      return other.words == label.words && other.box.least == label.box.least;
    });
    EXPECT_TRUE(was_there) << label.words << " in " << where;
  }
}

TEST_P(Stage, HasAMenuThatFitsAndMovesNothing) {
  PictureDice dice(314);
  const std::vector<StageMenuRow> rows = stage_menu(*GetParam(), {.lessons = "F5", .help = "F1"});
  for (std::size_t i = 0; i < 300; ++i) {
    StageCase shown = stage_case_by(dice, *GetParam());
    shown.hovered.reset();
    const Drawn before(shown.compose());
    shown.shows_menu = true;
    shown.hovered = rows[i % rows.size()].action;
    const Drawn open(shown.compose());
    ASSERT_TRUE(open.picture.menu);
    EXPECT_TRUE(lies_in(*open.picture.menu, {Vector<2>(0.0), shown.size})) << words_for(shown);
    EXPECT_EQ(open.picture.buttons.size(), before.picture.buttons.size() + rows.size());
    expect_nothing_moves(before, open, *open.picture.menu, words_for(shown));
  }
}

TEST_P(Stage, TheMapStaysClearOfTheButtonsAboveHoweverLargeTheyAre) {
  for (const double scale : {0.75, 1.0, 1.5, 2.0, 3.0}) {
    for (const Vector<2>& size : {Vector<2>(640.0, 700.0), Vector<2>(1280.0, 800.0), Vector<2>(2560.0, 800.0)}) {
      StageCase shown = case_at(wall45(), wall45_goal);
      shown.mode = StageMode::landscape;
      shown.scale = scale;
      shown.size = size;
      const Drawn drawn(shown.compose());
      for (const LabelExtent& label : drawn.extents.labels) {
        if (label.role == Role::button) continue;
        for (const StageButton& button : drawn.picture.buttons) {
          EXPECT_LE(overlap(label.box, button.box), rounding)
              << label.words << " on " << button.words << " at " << size.x << "×" << size.y << ", scale " << scale;
        }
      }
    }
  }
}

TEST_P(Stage, MovesNothingToSayWhatAButtonDoes) {
  PictureDice dice(315);
  for (int i = 0; i < 300; ++i) {
    StageCase shown = stage_case_by(dice, *GetParam());
    shown.hint.reset();
    shown.hovered.reset();
    const Drawn before(shown.compose());
    shown.hovered =
        dice.one_of(std::array<StageAction, 3>{StageMode::predict, StageCommand::menu, StageCommand::lessons});
    if (shown.hovered == StageAction(shown.mode)) continue;
    const Drawn hovered(shown.compose());
    ScreenBox panel{Vector<2>(1e9), Vector<2>(-1e9)};
    for (const LabelExtent& label : hovered.extents.labels) {
      if (label.role != Role::hint) continue;
      panel.include(label.box.least);
      panel.include(label.box.most);
    }
    ASSERT_LT(panel.least.x, panel.most.x) << words_for(shown);
    expect_nothing_moves(before, hovered, panel, words_for(shown));
  }
}

// --- Sizes -------------------------------------------------------------------------------------------------------------

TEST_P(Stage, CanBeReadFromTheLastRow) {
  PictureDice dice(5);
  for (const Vector<2>& size : {Vector<2>(1024.0, 768.0), Vector<2>(1280.0, 720.0), Vector<2>(1920.0, 1080.0)}) {
    for (const double scale : {1.0, 2.0}) {
      for (int i = 0; i < 60; ++i) {
        StageCase shown = stage_case_by(dice, *GetParam());
        shown.size = size;
        shown.scale = scale;
        for (const LabelExtent& label : Drawn(shown.compose()).extents.labels) {
          // For those who sit near; the name above it is for all.
          if (std::ranges::count(GetParam()->strategy_buttons, label.words, &StageLanguage::StrategyButton::about) > 0)
            continue;
          EXPECT_GE(label.style.height / 1.17, size.y / 30.0 - 1e-9) << label.words << " in " << words_for(shown);
        }
      }
    }
  }
}

TEST_P(Stage, SaysWhatEachStrategyIsWhereThereIsRoom) {
  for (const auto& [size, has_room] :
       {std::pair(Vector<2>(1024.0, 640.0), true), std::pair(Vector<2>(1280.0, 800.0), true),
        std::pair(Vector<2>(640.0, 700.0), false)}) {
    StageCase shown = case_at(wall45(), wall45_goal);
    shown.size = size;
    const Drawn drawn(shown.compose());
    for (const StageLanguage::StrategyButton& strategy : GetParam()->strategy_buttons) {
      const bool is_told = std::ranges::count(drawn.extents.labels, strategy.about, &LabelExtent::words) > 0;
      EXPECT_EQ(is_told, has_room) << strategy.about << " in " << words_for(shown);
    }
  }
}

TEST_P(Stage, MakesNoLettersSmallerForTheNamesOfStrategies) {
  StageLanguage terse = *GetParam();
  for (StageLanguage::StrategyButton& each : terse.strategy_buttons)
    each = {.name = "A", .about = "", .about_with_strings = ""};
  for (const Vector<2>& size : {Vector<2>(1024.0, 640.0), Vector<2>(1280.0, 800.0), Vector<2>(640.0, 700.0)}) {
    StageCase shown = case_at(wall45(), wall45_goal);
    shown.size = size;
    const double height = Drawn(shown.compose()).label(Role::sentence)->style.height;
    shown.language = &terse;
    EXPECT_EQ(height, Drawn(shown.compose()).label(Role::sentence)->style.height) << words_for(shown);
  }
}

TEST_P(Stage, HasLettersOfWholePoints) {
  PictureDice dice(6);
  for (int i = 0; i < 100; ++i) {
    const StageCase shown = stage_case_by(dice, *GetParam());
    const Drawn drawn(shown.compose());
    for (const LabelExtent& label : drawn.extents.labels) {
      if (drawn.is_in_ribbon(label.box)) continue;
      EXPECT_EQ(label.style.height, std::round(label.style.height)) << label.words << " in " << words_for(shown);
    }
  }
}

TEST_P(Stage, GrowsWithTheWindow) {
  for (const double ratio : {4.0 / 3.0, 1.6, 16.0 / 9.0, 21.0 / 9.0}) {
    for (const double scale : {0.75, 1.0, 2.0, 3.0}) {
      std::map<std::string, double> before;
      for (double height = 640.0; height <= 2160.0; height += 76.0) {
        StageCase shown = case_at(wall45(), wall45_goal);
        shown.size = {std::round(ratio * height), height};
        shown.scale = scale;
        for (const LabelExtent& label : Drawn(shown.compose()).extents.labels) {
          const auto found = before.find(label.words);
          const double least = found == before.end() ? 0.0 : found->second;
          EXPECT_GE(label.style.height, least) << label.words << height;
          before[label.words] = label.style.height;
        }
      }
    }
  }
}

// The scene may pass below the sentence; what matters should rarely be there.
TEST_P(Stage, SeldomHasHandleHandOrArrowBelowTheSentence) {
  PictureDice dice(12);
  int covered = 0;
  constexpr int looked_at = 300;
  for (int i = 0; i < looked_at; ++i) {
    const Settings settings = dice.settings();
    StageCase shown = case_at(settings, dice.goal(settings));
    shown.size = dice.size();
    shown.scale = dice.one_in(2) ? 1.0 : dice.scale();
    const Drawn drawn(shown.compose());
    const std::set<Role> important{Role::device, Role::goal, Role::hand, Role::wall_share, Role::ghost_force};
    const bool is_covered = std::ranges::any_of(drawn.extents.labels, [&](const LabelExtent& label) {
      return label.role == Role::sentence && std::ranges::any_of(drawn.extents.marks, [&](const Extent& mark) {
               return important.contains(mark.role) && reach_into(label.box, mark) > 0.0;
             });
    });
    covered += is_covered ? 1 : 0;
  }
  fmt::print("handle, hand or arrow below the sentence: {} of {}\n", covered, looked_at);
  EXPECT_LE(covered, looked_at / 10);
}

TEST_P(Stage, HasNumbersOfOneWidth) {
  const Settings settings = wall45();
  std::set<double> places;
  for (double depth = 0.0005; depth < 0.06; depth += 0.0013) {
    StageCase shown = case_at(settings, wall45_goal);
    shown.moment = stage_moment_at_rest(settings, Vector<2>(std::sqrt(0.5), -std::sqrt(0.5)) * depth);
    shown.shown = {.center = {0.3, 0.3}, .width = 0.1};  // nothing of it is to be seen: the numbers alone
    for (const LabelExtent& label : Drawn(shown.compose()).extents.labels) {
      if (label.role == Role::number && (label.words == "N" || label.words == "mm")) places.insert(label.box.least.x);
    }
  }
  EXPECT_EQ(places.size(), 1U);
}

}  // namespace
}  // namespace ghostforce::stage_test
