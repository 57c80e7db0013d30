#include "app/picture/trail_history.h"

#include <gtest/gtest.h>

namespace ghostforce::trail_history_test {
namespace {

// A millisecond after the one before.
Snapshot at(int tick, double x) {
  Snapshot snapshot;
  snapshot.tick = tick;
  snapshot.time_s = 0.001 * tick;
  snapshot.goal = {x, 0.0};
  for (auto& strategy : snapshot.strategies) strategy.device = snapshot.goal;
  return snapshot;
}

TEST(History, KeepsNothingOfAHandThatRests) {
  History history;
  for (int i = 0; i < 100000; ++i) history.add(at(i, 0.01));
  EXPECT_EQ(history.points().size(), 1U);
}

TEST(History, IsBoundedAndKeepsTheNewest) {
  History history;
  const int ticks = 10 * 8 * static_cast<int>(History::most_points);
  for (int i = 0; i < ticks; ++i) history.add(at(i, 0.001 * i));
  EXPECT_EQ(history.points().size(), History::most_points);
  EXPECT_LE(history.points().back().time_s, 0.001 * (ticks - 1));
  EXPECT_GT(history.points().back().time_s, 0.001 * ticks - 2.0 * History::least_interval_s);
}

// However fast the hand is, a picture has a bounded number of pieces; however slow, none that nobody could see.
TEST(History, KeepsPointsApartInTimeAndInPlace) {
  for (const double step : {0.00001, 0.0001, 0.01}) {
    History history;
    for (int i = 0; i < 5000; ++i) history.add(at(i, step * i));
    const auto& points = history.points();
    ASSERT_GT(points.size(), 20U);
    for (std::size_t i = 1; i < points.size(); ++i) {
      EXPECT_GE(points[i].time_s - points[i - 1].time_s, History::least_interval_s);
      EXPECT_GE(points[i].goal.x - points[i - 1].goal.x, History::spacing);
    }
  }
}

TEST(History, MeasuresTheWayTravelled) {
  History history;
  for (int i = 0; i <= 100; ++i) history.add(at(10 * i, 0.001 * (i <= 50 ? i : 100 - i)));
  // There and back: 50 mm each way; 100 sums of 1 mm round to 1e-16 each.
  EXPECT_NEAR(history.points().back().goal_travelled, 0.1, 1e-14);
  EXPECT_NEAR(history.points().back().device_travelled[0], 0.1, 1e-14);
}

TEST(History, AddsAPointWhenOnlyADeviceMoves) {
  History history;
  history.add(at(0, 0.0));
  Snapshot moved = at(10, 0.0);
  moved.strategies[index_of(StrategyId::naive)].device = {0.0, 2.0 * History::spacing};
  history.add(moved);
  EXPECT_EQ(history.points().size(), 2U);
}

TEST(History, HasATrailForThreeSecondsOfModelTime) {
  History history;
  history.add(at(0, 0.0));
  EXPECT_FALSE(history.has_trail_at(0.0)) << "one point is no trail";
  for (int i = 1; i <= 1000; ++i) history.add(at(i, 0.001 * i));
  const double end_s = history.points().back().time_s;
  EXPECT_FALSE(history.has_trail_at(-1.0));
  EXPECT_TRUE(history.has_trail_at(0.5)) << "of a moment that somebody looks back at";
  EXPECT_TRUE(history.has_trail_at(end_s + 0.99 * trail_lasts_s));
  EXPECT_FALSE(history.has_trail_at(end_s + 1.01 * trail_lasts_s));
}

}  // namespace
}  // namespace ghostforce::trail_history_test
