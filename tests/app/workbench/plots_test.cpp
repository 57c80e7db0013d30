// What the plots know, and what they save.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/scene_file.h"
#include "app/paint/vector/vector_file_painter.h"
#include "app/picture/plot_history.h"
#include "app/tools/figures/curves.h"
#include "app/tools/figures/figures.h"
#include "app/workbench/equilibrium_curves.h"
#include "app/workbench/plot_export.h"
#include "core/simulate.h"

namespace ghostforce::plots_test {
namespace {

constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
constexpr std::size_t naive = index_of(StrategyId::naive);

// A force of one spike in a tick of its own, over a slow ramp.
Snapshot snapshot_at(std::int64_t tick, double force) {
  Snapshot snapshot;
  snapshot.tick = tick;
  snapshot.time_s = static_cast<double>(tick) / 1000.0;
  snapshot.strategies[naive].force = {force, 0.0};
  return snapshot;
}

TEST(PlotHistory, HoldsEveryTickUntilItIsFull) {
  PlotHistory history;
  EXPECT_TRUE(history.is_empty());
  EXPECT_EQ(history.at(0.0), nullptr);
  for (std::int64_t k = 0; k < 1000; ++k) history.add(snapshot_at(k, static_cast<double>(k)));
  const auto ticks = history.between(0.0, 10.0, all);
  ASSERT_EQ(ticks.size(), 1000U);
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    EXPECT_EQ(ticks[k].from_s, static_cast<double>(k) / 1000.0);
    EXPECT_EQ(ticks[k].least[0][naive], static_cast<double>(k));
    EXPECT_EQ(ticks[k].greatest[0][naive], static_cast<double>(k));
  }
}

TEST(PlotHistory, NoSpikeIsLostHoweverCoarseThePlot) {
  constexpr std::int64_t spike = 31'234;
  PlotHistory history;
  for (std::int64_t k = 0; k < 60'000; ++k) history.add(snapshot_at(k, k == spike ? 100.0 : 1.0));
  for (const std::size_t most : {20U, 64U, 200U, 1000U, 5000U, 100'000U}) {
    const auto buckets = history.between(0.0, 60.0, most);
    EXPECT_LE(buckets.size(), std::max<std::size_t>(most, 60));  // the coarsest level is the end
    const auto found =
        std::ranges::find_if(buckets, [](const auto& bucket) { return bucket.greatest[0][naive] > 50.0; });
    ASSERT_NE(found, buckets.end()) << most;
    EXPECT_LE(found->from_s, 31.234);
    EXPECT_GE(found->to_s, 31.234);
    for (std::size_t i = 1; i < buckets.size(); ++i) EXPECT_GT(buckets[i].from_s, buckets[i - 1].to_s);
  }
}

TEST(PlotHistory, TheNewestTickIsInEveryPlotAtOnce) {
  PlotHistory history;
  for (std::int64_t k = 0; k < 4321; ++k) {
    history.add(snapshot_at(k, 0.0));
    for (const std::size_t most : {10U, 100U, 1000U}) {
      ASSERT_EQ(history.between(0.0, 10.0, most).back().to_s, history.newest_s()) << k << ' ' << most;
    }
  }
}

TEST(PlotHistory, ForgetsTheOldestOnly) {
  PlotHistory history;
  const auto count = static_cast<std::int64_t>(PlotHistory::capacity) + 5000;
  for (std::int64_t k = 0; k < count; ++k) history.add(snapshot_at(k, static_cast<double>(k)));
  const auto ticks = history.between(0.0, 1000.0, all);
  ASSERT_EQ(ticks.size(), PlotHistory::capacity);
  EXPECT_EQ(ticks.front().least[0][naive], 5000.0);
  EXPECT_EQ(ticks.back().least[0][naive], static_cast<double>(count - 1));
  EXPECT_EQ(history.oldest_s(), ticks.front().from_s);
  // The coarse ones reach no farther back than a few of their buckets.
  EXPECT_NEAR(history.between(0.0, 1000.0, 300).front().from_s, history.oldest_s(), 1.1);
}

TEST(PlotHistory, ATimeInBetweenIsTheTickBefore) {
  PlotHistory history;
  for (std::int64_t k = 10; k < 20; ++k) history.add(snapshot_at(k, static_cast<double>(k)));
  EXPECT_EQ(history.at(0.0099), nullptr);
  EXPECT_EQ(history.at(0.0125)->least[0][naive], 12.0);
  EXPECT_EQ(history.at(0.019)->least[0][naive], 19.0);
  EXPECT_EQ(history.at(0.0191), nullptr) << "that has not been yet";
}

TEST(PlotHistory, WhatNobodyKnewIsNoNumberAndStaysOneThough) {
  constexpr std::size_t ghost = 1;
  ASSERT_TRUE(quantity_catalog()[ghost].is_against_goal);
  PlotHistory history;
  for (std::int64_t k = 0; k < 3000; ++k) {
    Snapshot snapshot = snapshot_at(k, 1.0);
    snapshot.strategies[naive].ghost_force = {2.0, 0.0};
    if (k >= 1000 && k < 2000) snapshot.measured = StrategyId::naive;
    history.add(snapshot);
  }
  EXPECT_EQ(history.at(0.5)->least[ghost][naive], 2.0);
  EXPECT_TRUE(std::isnan(history.at(1.5)->least[ghost][naive]));
  EXPECT_EQ(history.at(1.5)->least[0][naive], 1.0);
  EXPECT_EQ(history.at(2.5)->greatest[ghost][naive], 2.0);
  for (const PlotBucket& bucket : history.between(0.0, 3.0, 20)) {
    const bool is_in_between = bucket.from_s >= 1.0 && bucket.to_s < 2.0;
    EXPECT_EQ(std::isnan(bucket.greatest[ghost][naive]), is_in_between) << bucket.from_s;
  }
}

TEST(PlotHistory, ATickThatIsNoLaterCountsOnce) {
  PlotHistory history;
  history.add(snapshot_at(5, 1.0));
  history.add(snapshot_at(5, 2.0));
  history.add(snapshot_at(4, 3.0));
  ASSERT_EQ(history.between(0.0, 1.0, all).size(), 1U);
  EXPECT_EQ(history.at(0.005)->least[0][naive], 1.0);
  history.clear();
  EXPECT_TRUE(history.is_empty());
  EXPECT_TRUE(history.between(0.0, 1.0, all).empty());
}

// ---- Curves ---------------------------------------------------------------------------------------------------------

class EquilibriumCurvesTest : public testing::Test {
 protected:
  Scene scene_ = load_scene("fig3-normal");
  EquilibriumQuestion question_{scene_.settings, scene_.goal.points.back(), false};
};

TEST_F(EquilibriumCurvesTest, PassThroughTheSettingInUse) {
  // Section 1 of the design: naïve −6.656 N, the others −3.633 N, no drift but for the naïve one.
  EXPECT_NEAR(equilibrium_value(StrategyId::naive, question_).force, -6.656, 5e-4);
  EXPECT_NEAR(equilibrium_value(StrategyId::full, question_).force, -3.633, 5e-4);
  const EquilibriumCurves curves = equilibria_over_wall_angle(question_, 9);  // every 45°
  ASSERT_EQ(curves.at.size(), 9U);
  EXPECT_NEAR(curves.at[3], 0.75 * std::numbers::pi, 1e-15);
  for (const Strategy& entry : strategy_catalog()) {
    const EquilibriumValue now = equilibrium_value(entry.id, question_);
    EXPECT_NEAR(curves.values[index_of(entry.id)][3].force, now.force, 1e-12);
    EXPECT_NEAR(curves.values[index_of(entry.id)][3].drift, now.drift, 1e-15);
  }
}

TEST_F(EquilibriumCurvesTest, AreFlatWhereTheGoalIsOutside) {
  question_.goal = -question_.goal;
  const EquilibriumCurves curves = equilibria_over_wall_angle(question_, 9);
  for (const auto& values : curves.values) {
    for (const EquilibriumValue& value : values) EXPECT_EQ(value.force, 0.0);
  }
}

TEST_F(EquilibriumCurvesTest, KeepTheDepthOverTheWallsAngle) {
  question_.settings.wall_point = {0.012, -0.007};
  const double before = depth(wall_of(question_.settings), question_.goal);
  const EquilibriumCurves curves = equilibria_over_wall_angle(question_, 37);
  for (std::size_t k = 0; k < curves.at.size(); ++k) {
    Settings turned = question_.settings;
    turned.wall_normal_angle = curves.at[k];
    const Wall<2> wall = wall_of(turned);
    const Vector<2> goal = goal_turned_with_wall(question_.settings, question_.goal, curves.at[k]);
    // Rounding of positions of some centimetres.
    EXPECT_NEAR(depth(wall, goal), before, 1e-15);
    // Force and drift depend on the depth alone: any other goal that deep tells the same.
    const Vector<2> behind = wall.point - before * wall.normal;
    for (const Strategy& entry : strategy_catalog()) {
      const EquilibriumValue& value = curves.values[index_of(entry.id)][k];
      const Equilibrium<2> rest = equilibrium_of(entry.id, turned, behind);
      EXPECT_NEAR(value.force, glm::dot(rest.force, direction_at(turned.actuated_angle)), 1e-12);
      const Vector<2> along_wall(-wall.normal.y, wall.normal.x);
      EXPECT_NEAR(value.drift, glm::dot(rest.proxy - behind, along_wall), 1e-12);
    }
  }
  const Vector<2> same =
      goal_turned_with_wall(question_.settings, question_.goal, question_.settings.wall_normal_angle);
  EXPECT_NEAR(glm::distance(same, question_.goal), 0.0, 1e-16);
}

// `ghostforce figures --only force-over-wall-angle` draws the same curve, over the angle between normal and motor.
TEST_F(EquilibriumCurvesTest, AreThoseOfTheFigure) {
  const Curves figure = force_over_wall_angle();
  EquilibriumQuestion question = question_;
  question.goal = goal_behind(wall_of(question.settings));
  std::size_t compared = 0;
  for (const CurvePoint& point : figure) {
    if (point.is_simulated) continue;
    const double angle = std::numbers::pi - point.x * std::numbers::pi / 180.0;
    EquilibriumQuestion turned = question;
    turned.settings.wall_normal_angle = angle;
    turned.goal = goal_turned_with_wall(question.settings, question.goal, angle);
    const EquilibriumValue value = equilibrium_value(*find_strategy(point.series), turned);
    EXPECT_NEAR(-value.force, point.y, 1e-12) << point.series << ' ' << point.x;  // the figure's is away from the wall
    ++compared;
  }
  EXPECT_EQ(compared, 3U * 181U);
  // And the plot's own samples: every whole degree.
  const EquilibriumCurves curves = equilibria_over_wall_angle(question, 361);
  compared = 0;
  for (const CurvePoint& point : figure) {
    if (point.is_simulated || point.x != std::floor(point.x)) continue;
    const auto degrees = static_cast<std::size_t>(180.0 - point.x);
    EXPECT_NEAR(-curves.values[index_of(*find_strategy(point.series))][degrees].force, point.y, 1e-12) << point.x;
    ++compared;
  }
  EXPECT_EQ(compared, 3U * 91U);
}

TEST_F(EquilibriumCurvesTest, CrossTheFullyActuatedForceAndNoDriftAtTheOptimalRatio) {
  const double optimal = optimal_tracking_ratio(1000.0, 100.0);
  const EquilibriumCurves curves = equilibria_over_ratio(question_, 1.0, optimal * optimal, 3);
  const auto& cured = curves.values[index_of(StrategyId::anisotropic)];
  const auto& full = curves.values[index_of(StrategyId::full)];
  EXPECT_NEAR(curves.at[1], optimal, 1e-12);
  EXPECT_NEAR(cured[1].force, full[1].force, 1e-9);
  EXPECT_NEAR(cured[1].drift, 0.0, 1e-12);
  EXPECT_LT(cured[0].drift * cured[2].drift, 0.0);  // it changes sides there
  EXPECT_NEAR(cured[0].force, equilibrium_value(StrategyId::naive, question_).force, 1e-12);
  EXPECT_EQ(full[0].force, full[2].force);
  EXPECT_EQ(curves.values[naive][0].force, curves.values[naive][2].force);
}

TEST_F(EquilibriumCurvesTest, AskNothingThatNobodyKnowsOfARealHand) {
  Snapshot snapshot;
  snapshot.goal = question_.goal;
  snapshot.measured = StrategyId::naive;
  Settings settings = scene_.settings;
  settings.stiffnesses.k_u = 1e4;  // whoever set that did not know the hand
  settings.stiffnesses.believed_k_u = 100.0;
  const EquilibriumQuestion question = equilibrium_question(settings, snapshot);
  EXPECT_TRUE(std::isnan(equilibrium_value(StrategyId::naive, question).drift));
  EXPECT_NEAR(equilibrium_value(StrategyId::naive, question).force,
              equilibrium_value(StrategyId::naive, question_).force, 1e-12);
  snapshot.measured.reset();
  EXPECT_FALSE(std::isnan(equilibrium_value(StrategyId::naive, equilibrium_question(settings, snapshot)).drift));
}

// ---- Files ----------------------------------------------------------------------------------------------------------

class PlotFile : public testing::Test {
 protected:
  PlotFile() {
    simulate(scene_, last_tick(scene_), [&](const Snapshot& snapshot) {
      history_.add(snapshot);
      snapshot_ = snapshot;
    });
    session_.plots.from_s = 1.0;
    session_.plots.to_s = 1.5;
  }

  std::string file(const std::string& path, bool whole_history = false) const {
    return plot_file(session_, {session_.settings, snapshot_}, history_, {path, whole_history}, cairo_file_painter());
  }
  // Without comments.
  static std::vector<std::string> rows(const std::string& text) {
    std::vector<std::string> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with('#')) rows.push_back(line);
    }
    return rows;
  }

  Scene scene_ = load_scene("wall45");
  Session session_ = session_of(scene_);
  History history_;
  Snapshot snapshot_;
};

TEST_F(PlotFile, HoldsTheTicksInSight) {
  const auto lines = rows(file("plots.csv"));
  ASSERT_EQ(lines.size(), 1U + 3U * 501U);  // ends included
  EXPECT_EQ(lines[0], "t_s,strategy,force_N,ghost_force_N,proxy_drift_mm,energy_mJ");
  EXPECT_TRUE(lines[1].starts_with("1,full,"));
  EXPECT_TRUE(lines.back().starts_with("1.5,anisotropic,"));
}

TEST_F(PlotFile, HoldsAllTicksAndTheirExactNumbers) {
  const auto lines = rows(file("plots.CSV", true));
  ASSERT_EQ(lines.size(), 1U + 3U * 3001U);
  const StrategySnapshot<2>& last = snapshot_.strategies[naive];
  std::istringstream row(lines[lines.size() - 2]);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
  ASSERT_EQ(cells.size(), 6U);
  EXPECT_EQ(cells[1], "naive");
  EXPECT_EQ(std::stod(cells[2]), glm::length(last.force));
  EXPECT_EQ(std::stod(cells[5]), last.energy * 1000.0);
}

TEST_F(PlotFile, SaysWhereItComesFrom) {
  session_.settings.stiffnesses.k_r = 750.0;
  const std::string text = file("plots.csv");
  EXPECT_NE(text.find("# ghostforce "), std::string::npos);
  EXPECT_NE(text.find("# k_r_N_per_m = 750"), std::string::npos);
}

// A real hand from 1.2 s to 1.3 s.
TEST_F(PlotFile, LeavesOutWhatCouldNotBeKnownOfARealHandAndNothingElse) {
  history_.clear();
  simulate(scene_, last_tick(scene_), [&](const Snapshot& snapshot) {
    snapshot_ = snapshot;
    if (snapshot.tick >= 1200 && snapshot.tick <= 1300) snapshot_.measured = StrategyId::naive;
    history_.add(snapshot_);
  });
  std::size_t empty = 0;
  for (const std::string& line : rows(file("plots.csv"))) {
    if (line.starts_with("t_s")) continue;
    const double time_s = std::stod(line);
    const bool is_empty = line.find(",,,") != std::string::npos;
    EXPECT_EQ(is_empty, time_s >= 1.2 && time_s <= 1.3) << line;
    if (is_empty) ++empty;
  }
  EXPECT_EQ(empty, 3U * 101U);
  EXPECT_TRUE(file("plots.png").starts_with("\x89PNG"));

  session_.plots.tab = PlotTab::ratio;
  snapshot_.measured = StrategyId::naive;
  for (const std::string& line : rows(file("plots.csv"))) {
    EXPECT_TRUE(line.starts_with("tracking") || line.ends_with(",")) << line;
  }
}

TEST_F(PlotFile, HoldsTheCurvesOverASetting) {
  session_.plots.tab = PlotTab::wall_angle;
  const auto angles = rows(file("plots.csv"));
  EXPECT_EQ(angles[0], "wall_normal_deg,strategy,force_along_motor_axis_N,proxy_drift_along_wall_mm");
  EXPECT_EQ(angles.size(), 1U + 3U * 361U);
  EXPECT_NE(file("plots.csv").find("# goal at a depth of 20.0 mm"), std::string::npos);
  session_.plots.tab = PlotTab::ratio;
  EXPECT_TRUE(rows(file("plots.csv"))[0].starts_with("tracking_ratio,strategy,"));
}

TEST_F(PlotFile, TheHandOverTimeHasItsBandAndTheReasonOfEachGap) {
  session_.plots.tab = PlotTab::hand;
  const std::string without_it = file("plots.svg");
  const HandEstimate known{.why = HandUnknown::none, .k_u = 310.0, .sigma = 25.0, .mass = 0.2, .damping = 6.0};
  const HandEstimate doubtful{
      .why = HandUnknown::too_much_tremor, .k_u = 300.0, .sigma = 90.0, .mass = 0.2, .damping = 6.0};
  history_.add(HandPoint{.time_s = 0.5, .estimate = known, .believed_k_u = 200.0, .given_k_u = 290.0});
  history_.add(HandPoint{.time_s = 1.1, .estimate = known, .believed_k_u = 312.5, .given_k_u = 290.0});
  history_.add(HandPoint{.time_s = 1.2, .estimate = doubtful, .believed_k_u = 312.5, .given_k_u = {}});
  history_.add(
      HandPoint{.time_s = 1.3, .estimate = {.why = HandUnknown::no_contact}, .believed_k_u = 312.5, .given_k_u = {}});
  EXPECT_EQ(rows(file("plots.csv")),
            (std::vector<std::string>{
                "t_s,k_u_live_N_per_m,sigma_N_per_m,mass_kg,damping_N_s_per_m,known,reason,k_u_believed_N_per_m,"
                "k_u_given_N_per_m",
                "1.1,310,25,0.2,6,1,,312.5,290",
                fmt::format("1.2,300,90,0.2,6,0,{},312.5,", sentence_of(HandUnknown::too_much_tremor)),
                fmt::format("1.3,,,,,0,{},312.5,", sentence_of(HandUnknown::no_contact))}));
  EXPECT_EQ(rows(file("plots.csv", true)).size(), 5U);
  EXPECT_NE(file("plots.svg"), without_it);
}

TEST_F(PlotFile, IsAPictureWhereTheNameSaysSo) {
  for (const PlotTab tab : {PlotTab::time, PlotTab::wall_angle, PlotTab::ratio, PlotTab::hand}) {
    session_.plots.tab = tab;
    EXPECT_TRUE(file("plots.png").starts_with("\x89PNG"));
    EXPECT_TRUE(file("plots.pdf").starts_with("%PDF"));
    EXPECT_NE(file("plots.svg").find("<svg"), std::string::npos);
    EXPECT_EQ(file("plots.png"), file("plots.png"));
  }
}

}  // namespace
}  // namespace ghostforce::plots_test
