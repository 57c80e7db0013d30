// The one sentence against the numbers: whatever it claims must be so at that moment.
#include "app/stage/stage_sentence.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "app/files/scene_file.h"
#include "app/stage/stage_transition.h"
#include "core/simulate.h"

namespace ghostforce::stage_sentence_test {
namespace {

bool says(std::string_view sentence, std::string_view words) {
  return sentence.find(words) != std::string_view::npos;
}

// In whichever language.
bool claims(std::string_view sentence, std::initializer_list<std::string_view> in_languages) {
  return std::ranges::any_of(in_languages, [&](std::string_view words) { return says(sentence, words); });
}

void expect_true(std::string_view sentence, const Settings& settings, const StageMoment& moment) {
  const double ghost = signed_ghost_force(moment);
  const double rest_ghost = signed_ghost_force(stage_moment_at_rest(settings, moment.goal));
  const double along =
      std::abs(glm::dot(direction_at(settings.wall_normal_angle), direction_at(settings.actuated_angle)));
  const Stiffnesses& stiffnesses = settings.stiffnesses;
  SCOPED_TRACE(sentence);
  if (claims(sentence, {"A ghost force drags", "Una fuerza fantasma arrastra", "a ghost force is left",
                        "queda fuerza fantasma", "still a ghost force", "aún hay fuerza fantasma",
                        "to naïve: a ghost force", "ingenuo: hay fuerza fantasma"})) {
    EXPECT_GE(std::abs(ghost), least_shown_force);
  }
  if (claims(sentence, {"is gone", "se ha ido", "no ghost force", "no hay fuerza fantasma", "sin fuerza fantasma"})) {
    EXPECT_LT(std::abs(ghost), least_shown_force);
  }
  if (claims(sentence, {"hardly any ghost force", "apenas hay fuerza fantasma"})) {
    EXPECT_LT(std::abs(ghost), 0.05);
  }
  if (claims(sentence, {"is gone", "se ha ido"})) {
    EXPECT_LT(glm::length(moment.slide), 0.0005);
    EXPECT_LT(std::abs(rest_ghost), least_shown_force);
    EXPECT_EQ(settings.active, StrategyId::anisotropic);
  }
  if (claims(sentence, {"drags", "arrastra "})) {
    EXPECT_GT(ghost, 0.0) << "it pulls the other way";
    EXPECT_EQ(settings.active, StrategyId::naive);
  }
  if (claims(sentence, {"the ghost force goes", "la fuerza fantasma se irá"})) {
    EXPECT_LT(std::abs(rest_ghost), least_shown_force);
  }
  if (claims(sentence, {"will remain", "quedará"})) {
    EXPECT_GE(std::abs(rest_ghost), least_shown_force);
  }
  if (claims(sentence, {"stiffer than believed", "más rígida de lo supuesto"})) {
    EXPECT_GT(stiffnesses.k_u, believed_user_stiffness(stiffnesses));
  }
  if (claims(sentence, {"softer than believed", "más blanda de lo supuesto"})) {
    EXPECT_LT(stiffnesses.k_u, believed_user_stiffness(stiffnesses));
  }
  const bool drags_into_wall = claims(sentence, {"Drag the hand into", "Mete la mano"});
  if (drags_into_wall || claims(sentence, {"in front of the wall", "delante de la pared"})) {
    EXPECT_FALSE(moment.in_contact);
  }
  if (drags_into_wall) {
    EXPECT_LE(depth(wall_of(settings), moment.goal), 0.0);
  }
  if (claims(sentence, {"straight at the wall", "recto contra la pared"})) {
    EXPECT_GT(along, 0.999);
  }
  if (claims(sentence, {"pushes along the wall", "empuja a lo largo de la pared"})) {
    EXPECT_LT(along, 0.03);
  }
  if (claims(sentence, {"Two motors:", "Dos motores:"})) {
    EXPECT_EQ(settings.active, StrategyId::full);
  }
  if (claims(sentence, {"On the way", "De camino", "De vuelta", "becomes", "become one", "se convierte"})) {
    EXPECT_TRUE(moment.is_between());
  } else {
    const bool is_of_any_moment = claims(sentence, {"along the wall", "por la pared", "a lo largo de la pared"});
    EXPECT_FALSE(moment.is_between() && !is_of_any_moment && moment.in_contact);
  }
  if (claims(sentence, {"estimated", "se estima", "Push the handle", "Empuja el mango"})) {
    EXPECT_TRUE(moment.is_measured);
  }
}

class Dice {
 public:
  double between(double least, double greatest) {
    return least + (greatest - least) * (static_cast<double>(engine_() % 1'000'000) / 1e6);
  }
  double decades(double least, double greatest) { return std::pow(10.0, between(least, greatest)); }
  bool coin() { return engine_() % 2 == 0; }
  std::size_t below(std::size_t count) { return engine_() % count; }

 private:
  std::mt19937 engine_{20261122};
};

Settings any_settings(Dice& dice) {
  Settings settings = load_scene("wall45").settings;
  settings.active = strategy_catalog()[dice.below(strategy_count)].id;
  settings.wall_normal_angle = dice.between(-4.0, 4.0);
  settings.actuated_angle = dice.below(8) == 0 ? settings.wall_normal_angle : dice.between(-4.0, 4.0);
  Stiffnesses& all = settings.stiffnesses;
  all.k_u = dice.decades(1.5, 3.0);
  all.k_r = all.k_u * dice.decades(-0.5, 1.5);
  all.k_c = dice.decades(3.0, 6.0);
  if (dice.below(3) == 0) all.believed_k_u = all.k_u * dice.decades(-0.7, 0.7);
  if (dice.below(6) == 0) all.chosen_tracking_ratio = dice.decades(-1.0, 1.5);
  return settings;
}

class StageSentence : public testing::TestWithParam<const StageLanguage*> {};
INSTANTIATE_TEST_SUITE_P(InEachLanguage, StageSentence, testing::ValuesIn(stage_languages),
                         [](const auto& each) { return std::string(each.param->code); });

TEST_P(StageSentence, IsTrueAtRestAndBetweenStrategies) {
  Dice dice;
  std::map<std::string, int> seen;
  for (int i = 0; i < 4000; ++i) {
    const Settings settings = any_settings(dice);
    const Vector<2> goal{dice.between(-0.03, 0.03), dice.between(-0.03, 0.03)};
    const StageMoment moment = stage_moment_at_rest(settings, goal);
    const std::string sentence(
        stage_sentence(settings, moment, {.can_drag = dice.coin(), .looks_back = dice.coin()}, *GetParam()));
    expect_true(sentence, settings, moment);
    ++seen[sentence];
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GE(seen.size(), 9U) << "the cases are too much alike";
}

TEST_P(StageSentence, IsTrueWhileEverythingMovesAndWhileOneSwitches) {
  Dice dice;
  std::map<std::string, int> seen;
  for (int i = 0; i < 60; ++i) {
    Scene scene = load_scene("wall45");
    scene.settings = any_settings(dice);
    // Soft enough for the sampled loop.
    scene.settings.stiffnesses.k_r = std::min(scene.settings.stiffnesses.k_r, 1500.0);
    scene.goal.points = {{dice.between(-0.03, 0.03), dice.between(-0.03, 0.03)},
                         {dice.between(-0.03, 0.03), dice.between(-0.03, 0.03)}};
    simulate(scene, 1500, [&](const Snapshot& snapshot) {
      if (snapshot.tick % 37 != 0) return;
      const StageBlend blend = dice.coin() ? stage_blend_of(scene.settings.active)
                                           : StageBlend{.fullness = dice.coin() ? 0.0 : dice.between(0.01, 0.99),
                                                        .cure = dice.between(0.01, 0.99)};
      const StageMoment moment = stage_moment_between(scene.settings, snapshot, snapshot.goal, blend);
      const std::string sentence(
          stage_sentence(scene.settings, moment, {.heads_for = scene.settings.active}, *GetParam()));
      expect_true(sentence, scene.settings, moment);
      ++seen[sentence];
    });
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GE(seen.size(), 10U) << "the cases are too much alike";
}

// The other strategy is chosen, and the picture has not begun to change.
TEST(StageSentenceInEnglish, IsThatOfTheSwitchFromItsFirstPictureOn) {
  Settings settings = load_scene("wall45").settings;
  const Vector<2> goal = load_scene("wall45").goal.points.back();
  settings.active = StrategyId::anisotropic;
  const StageMoment cured = stage_moment_at_rest(settings, goal);
  settings.active = StrategyId::naive;
  const StageMoment ghostly = stage_moment_at_rest(settings, goal);
  EXPECT_EQ(stage_sentence(settings, cured, {.heads_for = StrategyId::naive}, english_stage),
            "On the way between the two: no ghost force.");
  settings.active = StrategyId::anisotropic;
  EXPECT_EQ(stage_sentence(settings, ghostly, {.heads_for = StrategyId::anisotropic}, english_stage),
            "On the way to anisotropic: still a ghost force.");
  settings.active = StrategyId::full;
  EXPECT_EQ(stage_sentence(settings, ghostly, {.heads_for = StrategyId::full}, english_stage),
            "A ghost force drags the handle along the wall.");
}

TEST(StageSentenceInEnglish, OfADeviceSaysWhatCannotBeKnown) {
  const Scene scene = load_scene("wall45");
  StageMoment moment = stage_moment_at_rest(scene.settings, scene.goal.points.back());
  moment.is_measured = true;
  moment.knows_ghost_force = false;
  EXPECT_TRUE(says(stage_sentence(scene.settings, moment, {}, english_stage), "unknown"));
  moment.has_target = true;
  EXPECT_TRUE(says(stage_sentence(scene.settings, moment, {}, english_stage), "unknown"));
  moment.knows_ghost_force = true;
  moment.ghost_force = 0.5 * moment.wall_share;
  EXPECT_TRUE(says(stage_sentence(scene.settings, moment, {}, english_stage), "a ghost force drags you"));
  moment.ghost_force = Vector<2>(0.0);
  EXPECT_TRUE(says(stage_sentence(scene.settings, moment, {}, english_stage), "there is no ghost force"));
  moment.in_contact = false;
  EXPECT_TRUE(says(stage_sentence(scene.settings, moment, {}, english_stage), "Aim at the target"));
  moment.has_target = false;
  EXPECT_TRUE(says(stage_sentence(scene.settings, moment, {}, english_stage), "Push the handle"));
}

// The handle of a device touches nothing: then nobody has to guess what its hand wants.
TEST(StageNumbers, OfADeviceAreKnownOutsideTheWall) {
  Settings settings = load_scene("wall45").settings;
  settings.active = StrategyId::naive;
  Snapshot snapshot;
  snapshot.measured = StrategyId::naive;
  const auto numbers = [&] { return stage_numbers(stage_moment(settings, snapshot, snapshot.goal)); };
  EXPECT_EQ(numbers().ghost_force, 0.0);
  EXPECT_EQ(numbers().slide, 0.0);
  snapshot.strategies[index_of(StrategyId::naive)].in_contact = true;
  EXPECT_FALSE(numbers().ghost_force.has_value());
  EXPECT_FALSE(numbers().slide.has_value());
}

TEST(StageNumbers, HaveThreeDigitsAtAnySize) {
  EXPECT_EQ(force_number(0.0), "0.00");
  EXPECT_EQ(force_number(-1.274), "1.27");
  EXPECT_EQ(force_number(9.996), "10.0");
  EXPECT_EQ(force_number(99.96), "100");
  EXPECT_EQ(slide_number(0.012), "12.0");
  EXPECT_EQ(slide_number(0.1234), "123");
  EXPECT_EQ(motor_direction_words(0.0, english_stage), "left and right");
  EXPECT_EQ(motor_direction_words(-1.5707963, english_stage), "up and down");
  EXPECT_EQ(motor_direction_words(3.6651914, english_stage), "at 30°, counted from the right");
  EXPECT_EQ(force_direction_words({1.0, 0.0}, english_stage), "to the right");
  EXPECT_EQ(force_direction_words({-1.0, -0.0}, english_stage), "to the left");
  EXPECT_EQ(force_direction_words({0.0, 2.0}, english_stage), "upwards");
  EXPECT_EQ(force_direction_words({0.0, -2.0}, spanish_stage), "hacia abajo");
  EXPECT_EQ(force_direction_words({1.0, -1.0}, english_stage), "down and to the right");
  EXPECT_EQ(force_direction_words({-1.0, -0.5}, english_stage), "down and to the left");
  EXPECT_EQ(force_direction_words({-1.0, 0.4}, english_stage), "to the left");
  EXPECT_EQ(rail_words(3.6651914, english_stage), "along its rail");
  EXPECT_EQ(rail_words(3.1415927, english_stage), "left and right");
}

}  // namespace
}  // namespace ghostforce::stage_sentence_test
