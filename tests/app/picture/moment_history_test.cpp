// Every tick of the last minute with its settings, as they were put in, in bounded memory.
#include "app/picture/moment_history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "tests/support/heap_guard.h"

namespace ghostforce::moment_history_test {
namespace {

constexpr double rate = 1000.0;

Snapshot tick_at(std::int64_t tick, const Vector<2>& place, double rate_hz = rate) {
  Snapshot snapshot;
  snapshot.tick = tick;
  snapshot.time_s = static_cast<double>(tick) / rate_hz;
  snapshot.goal = place;
  for (auto& strategy : snapshot.strategies) strategy.device = strategy.proxy = place;
  return snapshot;
}

// Never where it was the tick before.
Snapshot moving(std::int64_t tick, double rate_hz = rate) {
  return tick_at(tick, {0.02 * std::sin(0.01 * static_cast<double>(tick)), 1e-4 * static_cast<double>(tick)}, rate_hz);
}

Snapshot resting(std::int64_t tick) {
  return tick_at(tick, {0.01, 0.02});
}

Settings settings_with(double k_r) {
  Settings settings;
  settings.rate = rate;
  settings.stiffnesses.k_r = k_r;
  return settings;
}

TEST(MomentHistory, HasNothingAtFirst) {
  const MomentHistory history;
  EXPECT_TRUE(history.is_empty());
  EXPECT_FALSE(history.oldest() || history.newest() || history.at(0.0) || history.before(1.0) || history.after(-1.0));
  EXPECT_EQ(history.changed_s(), 0.0);
}

TEST(MomentHistory, KeepsEachTickWithTheSettingsThatItRanUnder) {
  MomentHistory history;
  const auto k_r_at = [](std::int64_t tick) {
    return 100.0 + static_cast<double>(tick / 37 + (tick > 500 ? tick : 0));
  };
  for (std::int64_t tick = 0; tick < 3000; ++tick) {
    // It moves, rests and moves again.
    history.add(tick / 700 == 1 ? resting(tick) : moving(tick), settings_with(k_r_at(tick)));
  }
  ASSERT_EQ(history.size(), 3000U);
  for (std::int64_t tick = 0; tick < 3000; ++tick) {
    const double time_s = static_cast<double>(tick) / rate;
    for (const double later : {0.0, 0.0004, 0.0009}) {
      const auto at = history.at(time_s + later);
      ASSERT_TRUE(at.has_value());
      ASSERT_EQ(at->snapshot.tick, tick);
      ASSERT_EQ(at->settings, settings_with(k_r_at(tick))) << tick;
      EXPECT_TRUE(at->is_past);
    }
    const auto before = history.before(time_s);
    ASSERT_EQ(before.has_value(), tick > 0);
    if (before) {
      EXPECT_EQ(before->snapshot.tick, tick - 1);
      EXPECT_EQ(before->settings.stiffnesses.k_r, k_r_at(tick - 1));
    }
    const auto after = history.after(time_s);
    ASSERT_EQ(after.has_value(), tick < 2999);
    if (after) {
      EXPECT_EQ(after->snapshot.tick, tick + 1);
    }
  }
  EXPECT_FALSE(history.at(-0.0001));
  EXPECT_FALSE(history.at(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(history.at(1e9)->snapshot.tick, 2999);
  EXPECT_EQ(history.before(0.0105)->snapshot.tick, 10) << "between two ticks";
  EXPECT_EQ(history.after(0.0105)->snapshot.tick, 11);
}

TEST(MomentHistory, LeavesOutATickThatComesTwice) {
  MomentHistory history;
  history.add(moving(7), settings_with(1.0));
  history.add(moving(7), settings_with(2.0));
  history.add(moving(6), settings_with(3.0));
  ASSERT_EQ(history.size(), 1U);
  EXPECT_EQ(history.newest()->settings, settings_with(1.0));
}

TEST(MomentHistory, HoldsAMinute) {
  MomentHistory history;
  for (std::int64_t tick = 0; tick <= 150'000; ++tick) history.add(moving(tick), settings_with(1.0));
  EXPECT_EQ(history.newest()->snapshot.tick, 150'000);
  EXPECT_EQ(history.oldest()->snapshot.tick, 90'000);
  EXPECT_EQ(history.size(), 60'001U);
}

TEST(MomentHistory, HoldsNoMoreTicksThanItMayHoweverManyASecond) {
  MomentHistory history;
  for (std::int64_t tick = 0; tick < 200'000; ++tick) {
    history.add(moving(tick, 20000.0), settings_with(static_cast<double>(tick)));
    ASSERT_LE(history.size(), MomentHistory::capacity);
  }
  EXPECT_GE(history.size(), MomentHistory::capacity - MomentHistory::resting_capacity);
  EXPECT_EQ(history.oldest()->settings.stiffnesses.k_r, static_cast<double>(history.oldest()->snapshot.tick));
}

TEST(MomentHistory, ARestDoesNotPushOutWhatLedToIt) {
  MomentHistory history;
  for (std::int64_t tick = 0; tick < 5000; ++tick) history.add(moving(tick), settings_with(1.0));
  history.add(resting(5000), settings_with(1.0));
  for (std::int64_t tick = 5001; tick < 700'000; ++tick) history.add(resting(tick), settings_with(1.0));
  EXPECT_EQ(history.changed_s(), 5.0);
  EXPECT_EQ(history.plots().newest_s(), 5.0);
  EXPECT_EQ(history.size(), 5001U + MomentHistory::resting_capacity);
  EXPECT_EQ(history.oldest()->snapshot.tick, 0);
  EXPECT_EQ(history.before(5.0)->snapshot.tick, 4999);
  // Of the rest, the newest ticks one by one, and for what was left out a moment that looks the same.
  EXPECT_EQ(history.before(699.999)->snapshot.tick, 699'998);
  EXPECT_EQ(history.at(300.0)->snapshot.tick, 5000);

  history.add(moving(700'000), settings_with(1.0));
  EXPECT_EQ(history.changed_s(), 700.0);
  EXPECT_EQ(history.before(700.0)->snapshot.tick, 699'999);
  EXPECT_EQ(history.oldest()->snapshot.tick, 700'000 - static_cast<std::int64_t>(MomentHistory::resting_capacity));
}

TEST(MomentHistory, WhatCreepsOrOnlyChangesItsSettingsDoesNotRest) {
  MomentHistory history;
  for (std::int64_t tick = 0; tick <= 20'000; ++tick) {
    history.add(tick_at(tick, {1e-8 * static_cast<double>(tick), 0.0}), settings_with(1.0));
  }
  EXPECT_EQ(history.size(), 20'001U);
  EXPECT_GT(history.changed_s(), 18.5) << "by a hundredth of a millimetre a second";
  history.add(tick_at(20'001, {2e-4, 0.0}), settings_with(2.0));
  EXPECT_EQ(history.changed_s(), 20.001);
  for (const auto change : {+[](Snapshot& s) { s.strategies[1].ghost_force.x = 0.01; },
                            +[](Snapshot& s) { s.strategies[2].in_contact = true; },
                            +[](Snapshot& s) { s.measured = StrategyId::naive; }}) {
    MomentHistory other;
    other.add(resting(0), settings_with(1.0));
    Snapshot changed = resting(1);
    change(changed);
    other.add(changed, settings_with(1.0));
    EXPECT_EQ(other.changed_s(), 0.001);
  }
}

TEST(MomentHistory, AsksForNoMoreMemoryOnceItIsFull) {
  MomentHistory history;
  std::int64_t tick = 0;
  {
    HeapGuard guard;
    for (; tick < 70'000; ++tick) history.add(moving(tick), settings_with(1.0));
    EXPECT_LT(guard.take_uses(), 500U) << "and not for each tick before";
    for (; tick < 100'000; ++tick) history.add(moving(tick), settings_with(1.0));
  }
  history.clear();
  EXPECT_TRUE(history.is_empty());
  EXPECT_FALSE(history.newest());
  history.add(moving(3), settings_with(4.0));
  EXPECT_EQ(history.at(1.0)->settings, settings_with(4.0));
  EXPECT_EQ(history.size(), 1U);
}

}  // namespace
}  // namespace ghostforce::moment_history_test
