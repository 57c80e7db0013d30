// Each quantity of tasks, against what other parts of the program say of the same moment.
#include "app/state/lesson_quantities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "app/files/scene_file.h"
#include "core/general_equilibrium.h"
#include "core/prediction.h"

namespace ghostforce::lesson_quantities_test {
namespace {

class LessonQuantities : public testing::Test {
 protected:
  double value(LessonQuantity id) const {
    const StageMoment moment = stage_moment_at_rest(settings_, goal_);
    return lesson_quantity(id).read({moment, settings_, has_circle_ ? &circle_ : nullptr});
  }

  Settings settings_ = load_scene("wall45").settings;
  Vector<2> goal_ = load_scene("wall45").goal.points.back();
  CircleReading circle_;
  bool has_circle_ = false;
};

TEST_F(LessonQuantities, AreThoseOfTheModel) {
  constexpr double rounding = 1e-9;
  const PredictedEquilibrium rest = predicted_equilibria(settings_, goal_)[index_of(StrategyId::naive)];
  EXPECT_NEAR(value(LessonQuantity::depth), 20.0, rounding);
  EXPECT_NEAR(value(LessonQuantity::force), std::hypot(rest.at.force.x, rest.at.force.y), rounding);
  EXPECT_NEAR(value(LessonQuantity::ghost_force), std::abs(rest.ghost_force.x), rounding);
  EXPECT_NEAR(value(LessonQuantity::slide), 1000.0 * std::hypot(rest.proxy_drift.x, rest.proxy_drift.y), rounding);
  const double missing = 1000.0 * std::abs(rest.ghost_force.x) / settings_.stiffnesses.k_u;
  EXPECT_NEAR(value(LessonQuantity::handle_to_target), missing, 0.01) << "the wall is hard, but not infinitely so";
  EXPECT_NEAR(value(LessonQuantity::angle), 45.0, rounding);
  EXPECT_EQ(value(LessonQuantity::belief), 1.0);
  settings_.stiffnesses.believed_k_u = 50.0;
  EXPECT_EQ(value(LessonQuantity::belief), 0.25);
  goal_ = {-0.01, 0.0};
  EXPECT_LT(value(LessonQuantity::depth), 0.0) << "in front of the wall";
}

TEST_F(LessonQuantities, TakeAnAngleForWhatItIsWhicheverWayTheMotorIsTurned) {
  constexpr double degree = 0.017453292519943295;
  for (const double turned : {-180.0, 0.0, 180.0, 360.0}) {
    settings_.actuated_angle = settings_.wall_normal_angle + (turned + 20.0) * degree;
    EXPECT_NEAR(value(LessonQuantity::angle), 20.0, 1e-9);
    settings_.actuated_angle = settings_.wall_normal_angle + (turned - 20.0) * degree;
    EXPECT_NEAR(value(LessonQuantity::angle), 20.0, 1e-9);
  }
  settings_.actuated_angle = settings_.wall_normal_angle;
  EXPECT_NEAR(value(LessonQuantity::angle), 0.0, 1e-5) << "an arc cosine near 1";
}

TEST_F(LessonQuantities, OfRoundsAreKnownOnceThereIsOne) {
  EXPECT_TRUE(std::isnan(value(LessonQuantity::turns)));
  EXPECT_TRUE(std::isnan(value(LessonQuantity::energy)));
  has_circle_ = true;
  EXPECT_EQ(value(LessonQuantity::turns), 0.0);
  EXPECT_TRUE(std::isnan(value(LessonQuantity::energy)));
  circle_.turns = 2;
  circle_.strategies[index_of(StrategyId::naive)].last.energy = 0.005;
  EXPECT_EQ(value(LessonQuantity::turns), 2.0);
  EXPECT_EQ(value(LessonQuantity::energy), 5.0);
}

// They are what equilibrium says of the same rest.
TEST_F(LessonQuantities, OfAnyDeviceAreThoseOfItsRest) {
  struct Case {
    const char* scene;
    Vector<2> goal;
    double slack;  // strings; below 0: there are none
  };
  for (const auto& [scene, goal, slack] :
       {Case{"arm", {0.0141421, -0.0141421}, -1.0}, Case{"string", {0.00347296, -0.0196962}, 1.0},
        Case{"corner", {0.022, -0.006}, -1.0}, Case{"curve", {0.034, -0.034}, -1.0}}) {
    settings_ = load_scene(scene).settings;
    goal_ = goal;
    for (const Strategy& each : strategy_catalog()) {
      if (each.id == StrategyId::full) continue;
      settings_.active = each.id;
      const auto rest = general_equilibrium_of(each.id, general_scene_of(settings_), goal_);
      ASSERT_TRUE(rest);
      double hardest = 0.0;
      for (const double effort : rest->efforts) hardest = std::max(hardest, std::abs(effort));
      EXPECT_NEAR(value(LessonQuantity::effort), hardest, 1e-9) << scene << " " << each.name;
      EXPECT_EQ(value(LessonQuantity::active_walls), std::popcount(rest->active)) << scene << " " << each.name;
      if (slack < 0.0) {
        EXPECT_TRUE(std::isnan(value(LessonQuantity::slack_strings))) << scene;
      } else {
        EXPECT_EQ(value(LessonQuantity::slack_strings), slack) << scene << " " << each.name;
      }
    }
    goal_ = load_scene(scene).goal.points.front();
    EXPECT_EQ(value(LessonQuantity::active_walls), 0.0) << "in front of the wall";
    EXPECT_EQ(value(LessonQuantity::effort), 0.0);
  }
}

TEST_F(LessonQuantities, OfAMeasuredHandAreNotGuessed) {
  StageMoment moment = stage_moment_at_rest(settings_, goal_);
  moment.is_measured = true;
  moment.knows_ghost_force = false;
  const LessonReading reading{moment, settings_};
  EXPECT_TRUE(std::isnan(lesson_quantity(LessonQuantity::ghost_force).read(reading)));
  EXPECT_TRUE(std::isnan(lesson_quantity(LessonQuantity::slide).read(reading)));
  EXPECT_FALSE(is_met({.quantity = LessonQuantity::ghost_force, .greatest = 1e9}, reading));
  moment.in_contact = false;
  moment.knows_ghost_force = true;
  EXPECT_TRUE(std::isnan(lesson_quantity(LessonQuantity::ghost_force).read(reading))) << "it touches nothing";
}

TEST_F(LessonQuantities, MeetAConditionAtBothOfItsEnds) {
  const StageMoment moment = stage_moment_at_rest(settings_, goal_);
  const LessonReading reading{moment, settings_};
  const double slide = value(LessonQuantity::slide);
  EXPECT_TRUE(is_met({LessonQuantity::slide, slide, slide}, reading));
  EXPECT_NEAR(missed_by({LessonQuantity::slide, slide + 2.0, slide + 3.0}, reading), 2.0, 1e-9);
  EXPECT_NEAR(missed_by({LessonQuantity::slide, 0.0, slide - 2.0}, reading), 2.0, 1e-9);

  LessonStep task;
  task.conditions = {{LessonQuantity::slide, slide, slide}};
  EXPECT_TRUE(is_done(task, reading));
  task.with = StrategyId::anisotropic;
  EXPECT_FALSE(is_done(task, reading));
  task.with = StrategyId::naive;
  EXPECT_TRUE(is_done(task, reading));
  task.conditions.push_back({.quantity = LessonQuantity::depth, .least = 21.0});
  EXPECT_FALSE(is_done(task, reading)) << "all at once";
}

TEST(LessonQuantityCatalog, HasARowForEach) {
  for (int i = 0; i <= static_cast<int>(LessonQuantity::active_walls); ++i) {
    EXPECT_EQ(lesson_quantity(static_cast<LessonQuantity>(i)).id, static_cast<LessonQuantity>(i));
  }
  EXPECT_EQ(lesson_quantity_catalog().size(), static_cast<std::size_t>(LessonQuantity::active_walls) + 1);
}

}  // namespace
}  // namespace ghostforce::lesson_quantities_test
