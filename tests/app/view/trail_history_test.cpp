#include "app/view/trail_history.h"

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace ghostforce {
namespace {

Snapshot at(const Vector<2>& place) {
  Snapshot snapshot;
  snapshot.goal = place;
  for (auto& strategy : snapshot.strategies) strategy.device = place;
  return snapshot;
}

Snapshot at(double x) {
  return at(Vector<2>(x, 0.0));
}

double distance_to_piece(const Vector<2>& from, const Vector<2>& to, const Vector<2>& place) {
  const Vector<2> piece = to - from;
  const double share = glm::clamp(glm::dot(place - from, piece) / glm::dot(piece, piece), 0.0, 1.0);
  return glm::distance(place, from + share * piece);
}

double distance_to_trail(const History& history, const Vector<2>& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (auto from = history.points().begin(), to = std::next(from); to != history.points().end(); from = to++) {
    nearest = std::min(nearest, distance_to_piece(from->goal, to->goal, place));
  }
  return nearest;
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

TEST(History, KeepsOfAStraightWayLongAgoOnlyLongPieces) {
  History history;
  for (int i = 0; i < 10000; ++i) history.add(at(0.0005 * i));
  const auto& points = history.points();
  ASSERT_EQ(points.size(), History::most_points);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const bool is_old = i + History::dense_points < points.size();
    EXPECT_NEAR(points[i].goal.x - points[i - 1].goal.x, is_old ? 0.0015 : 0.0005, 1e-12) << i;
  }
}

// Round a small circle, over a corner and back the same way: what is left out was on the trail anyway.
TEST(History, LeavesOutNothingThatWouldBeMissed) {
  std::vector<Vector<2>> way;
  for (int i = 0; i <= 250; ++i) way.push_back({0.01 * std::cos(0.05 * i), 0.01 * std::sin(0.05 * i)});
  for (int i = 0; i < 100; ++i) way.push_back(way.back() + Vector<2>(0.0005, 0.0));
  for (int i = 0; i < 50; ++i) way.push_back(way.back() + Vector<2>(0.0, 0.0005));
  for (int i = 0; i < 50; ++i) way.push_back(way.back() - Vector<2>(0.0, 0.0005));
  for (std::size_t i = 0; i < History::dense_points; ++i) way.push_back(way.back() + Vector<2>(0.0, -0.0005));
  History history;
  for (const Vector<2>& place : way) history.add(at(place));
  const auto oldest = std::ranges::find(way, history.points().front().goal);
  const auto kept_of_the_old = history.points().size() - History::dense_points;
  const auto old = static_cast<std::size_t>(way.end() - oldest) - History::dense_points;
  EXPECT_LT(kept_of_the_old, old / 2);
  // Each point is measured against its own neighbours, and three of four may go.
  for (auto place = oldest; place != way.end(); ++place) {
    EXPECT_LE(distance_to_trail(history, *place), 3.0 * History::straightness);
  }
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
