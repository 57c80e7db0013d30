#include "app/view/history.h"

#include <gtest/gtest.h>

namespace ghostforce {
namespace {

Snapshot at(double x) {
  Snapshot snapshot;
  snapshot.goal = {x, 0.0};
  for (auto& strategy : snapshot.strategies) strategy.device = {x, 0.0};
  return snapshot;
}

TEST(History, KeepsNothingOfAHandThatRests) {
  History history;
  for (int i = 0; i < 100000; ++i) history.add(at(0.01));
  EXPECT_EQ(history.points().size(), 1U);
}

TEST(History, IsBoundedAndKeepsTheNewest) {
  History history;
  double x = 0.0;
  for (int i = 0; i < 10000; ++i) history.add(at(x = 0.001 * i));
  EXPECT_EQ(history.points().size(), History::most_points);
  EXPECT_EQ(history.points().back().goal.x, x);
}

TEST(History, MeasuresTheWayTravelled) {
  History history;
  for (int i = 0; i <= 100; ++i) history.add(at(0.001 * (i <= 50 ? i : 100 - i)));
  // There and back: 50 mm each way; 100 sums of 1 mm round to 1e-16 each.
  EXPECT_NEAR(history.points().back().goal_travelled, 0.1, 1e-14);
  EXPECT_NEAR(history.points().back().device_travelled[0], 0.1, 1e-14);
}

TEST(History, AddsAPointWhenOnlyADeviceMoves) {
  History history;
  history.add(at(0.0));
  Snapshot moved = at(0.0);
  moved.strategies[index_of(StrategyId::naive)].device = {0.0, 2.0 * History::spacing};
  history.add(moved);
  EXPECT_EQ(history.points().size(), 2U);
}

}  // namespace
}  // namespace ghostforce
