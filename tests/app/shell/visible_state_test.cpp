// What a person could see of a change, and what not.
#include "app/shell/visible_state.h"

#include <functional>

#include <gtest/gtest.h>

#include "app/files/scene_file.h"

namespace ghostforce::visible_state_test {
namespace {

constexpr double points_per_metre = 10000.0;

class VisibleStateTest : public testing::Test {
 protected:
  VisibleState state() const {
    return visible_state(session_, {session_.settings, snapshot_}, history_, snapshot_.time_s, reading_);
  }
  // Whether what `change` does can be seen.
  bool sees(const std::function<void()>& change) {
    const VisibleState before = state();
    EXPECT_FALSE(differs_visibly(before, state(), points_per_metre));
    change();
    return differs_visibly(before, state(), points_per_metre);
  }

  Session session_ = session_of(load_scene("wall45"));
  Snapshot snapshot_;
  History history_;
  LoopReading reading_;
};

TEST_F(VisibleStateTest, ATrailIsSeenAsLongAsItFades) {
  session_.face = Face::workbench;
  for (int i = 0; i < 100; ++i) {
    snapshot_.tick = i;
    snapshot_.time_s = 0.01 * i;
    snapshot_.goal.x = 0.001 * i;
    history_.add(snapshot_);
  }
  const auto wait = [&](double seconds) { return [this, seconds] { snapshot_.time_s += seconds; }; };
  EXPECT_TRUE(sees(wait(1.0)));
  EXPECT_FALSE(sees(wait(0.0))) << "a paused picture stands still";
  EXPECT_TRUE(sees(wait(2.5))) << "it is gone";
  EXPECT_FALSE(sees(wait(1.0)));
  snapshot_.time_s = 2.0;
  session_.options.trails = false;
  EXPECT_FALSE(sees(wait(0.5)));
}

TEST_F(VisibleStateTest, AnEstimateIsSeenWhereThereIsOne) {
  session_.face = Face::workbench;
  HandReading& hand = reading_.hand;
  EXPECT_FALSE(sees([&] { hand.estimate.k_u = 310.0; })) << "nothing measures it";
  EXPECT_TRUE(sees([&] { hand.is_measuring = true; }));
  EXPECT_TRUE(sees([&] { hand.estimate.sigma += 1.0; }));
  EXPECT_FALSE(sees([&] { hand.estimate.k_u += 0.1; })) << "finer than any number on the screen";
  EXPECT_TRUE(sees([&] { hand.estimate.why = HandUnknown::too_much_tremor; }));
  EXPECT_TRUE(sees([&] { reading_.hand_unknown_s = 10.0; })) << "it no longer holds";
  EXPECT_TRUE(sees([&] { hand.tone_gain = 1.0; }));
  EXPECT_TRUE(sees([&] { session_.belief_source = BeliefSource::live; }));
}

TEST_F(VisibleStateTest, TimeAndCountsAreNotSeen) {
  EXPECT_FALSE(sees([&] {
    snapshot_.tick += 1000;
    snapshot_.time_s += 1.0;
    reading_.late_ticks += 5;
    reading_.rate_hz = 998.0;
    reading_.dropped_samples = 1;
  }));
}

TEST_F(VisibleStateTest, PlacesAndForcesAreSeenFromASmallestStepOn) {
  StrategySnapshot<2>& naive = snapshot_.strategies[index_of(StrategyId::naive)];
  EXPECT_FALSE(sees([&] { naive.device.x += 4e-7; }));
  EXPECT_TRUE(sees([&] { naive.device.x += 6e-7; }));
  EXPECT_TRUE(sees([&] { naive.proxy.y -= 6e-7; }));
  EXPECT_TRUE(sees([&] { snapshot_.goal.y += 6e-7; }));
  EXPECT_FALSE(sees([&] { naive.force.x += 0.0009; }));
  EXPECT_TRUE(sees([&] { naive.force.x += 0.0011; }));
  EXPECT_TRUE(sees([&] { naive.ghost_force.x += 0.0011; }));
  EXPECT_TRUE(sees([&] { naive.in_contact = !naive.in_contact; }));
  EXPECT_TRUE(sees([&] { snapshot_.measured = StrategyId::naive; }));
}

TEST_F(VisibleStateTest, AFinerPictureShowsMore) {
  const VisibleState before = state();
  snapshot_.goal.x += 2e-7;
  EXPECT_FALSE(differs_visibly(before, state(), points_per_metre));
  EXPECT_TRUE(differs_visibly(before, state(), 10.0 * points_per_metre));
}

TEST_F(VisibleStateTest, WhatTheSessionSaysIsSeen) {
  EXPECT_TRUE(sees([&] { session_.goal.x += 0.001; }));
  EXPECT_TRUE(sees([&] { session_.settings.wall_normal_angle += 0.01; }));
  EXPECT_TRUE(sees([&] { session_.paused = true; }));
  EXPECT_TRUE(sees([&] { session_.notice = Notice{"Something", false, 0.0}; }));
  EXPECT_FALSE(sees([&] { session_.notice->age_s = 3.0; }));
  EXPECT_TRUE(sees([&] { session_.notice.reset(); }));
}

TEST_F(VisibleStateTest, WarningsAreSeenOnBothFaces) {
  for (const Face face : {Face::stage, Face::workbench}) {
    session_.face = face;
    reading_ = {};
    EXPECT_TRUE(sees([&] { reading_.diverged = true; }));
    EXPECT_TRUE(sees([&] { reading_.motors.has_motors = true; }));
    EXPECT_TRUE(sees([&] { reading_.motors.is_ready = true; }));
    EXPECT_TRUE(sees([&] { reading_.motors.state = SafetyState::arming; }));
    EXPECT_TRUE(sees([&] { reading_.recording.is_on = true; }));
    EXPECT_TRUE(sees([&] { reading_.shader_problem = "no"; }));
  }
}

TEST_F(VisibleStateTest, NumbersOfPanelsAreSeenWherePanelsAre) {
  for (const bool has_panels : {false, true}) {
    session_.face = has_panels ? Face::workbench : Face::stage;
    session_.measurement = {};
    reading_ = {};
    reading_.motors.has_motors = true;
    reading_.readiness.push_back({});
    EXPECT_FALSE(sees([&] { reading_.recording.seconds += 0.04; }));
    EXPECT_EQ(sees([&] { reading_.recording.seconds += 0.1; }), has_panels);
    EXPECT_EQ(sees([&] { reading_.recording.bytes += 100'000; }), has_panels);
    EXPECT_EQ(sees([&] { reading_.refused = 1; }), has_panels);
    EXPECT_EQ(sees([&] { reading_.readiness.front().words += "."; }), has_panels);
    EXPECT_EQ(sees([&] { reading_.motors.sent.x += 0.1; }), has_panels);
    EXPECT_EQ(sees([&] { session_.dial_turned_s = 0.0; }), has_panels);
    EXPECT_FALSE(sees([&] { session_.dial_turned_s = 1.0; })) << "its words are there, however old";
    EXPECT_EQ(sees([&] { session_.dial_turned_s.reset(); }), has_panels);
    EXPECT_EQ(sees([&] { session_.measurement.step = MeasuringStep::hold_still; }), has_panels);
    EXPECT_EQ(sees([&] { session_.measurement.drift = 0.001; }), has_panels);
  }
  session_.face = Face::stage;
  session_.dialog = Dialog::doctor;
  EXPECT_TRUE(sees([&] { reading_.readiness.front().words += "."; }));
}

TEST_F(VisibleStateTest, TimeIsSeenInPlotsAndOnTheRibbon) {
  const auto time_goes_on = [&] {
    snapshot_.time_s += 0.01;
    history_.add(snapshot_, session_.settings);
  };
  PlotView& plots = session_.plots;
  session_.face = Face::workbench;
  plots.is_open = true;
  EXPECT_TRUE(sees(time_goes_on));
  plots.follows = false;
  EXPECT_TRUE(sees(time_goes_on)) << "the present is still in sight";
  plots.to_s = 0.001;
  EXPECT_FALSE(sees(time_goes_on));
  plots.follows = true;
  plots.tab = PlotTab::ratio;
  EXPECT_FALSE(sees(time_goes_on));
  plots.tab = PlotTab::time;
  session_.face = Face::stage;
  EXPECT_FALSE(sees(time_goes_on));
  session_.stage.mode = StageMode::ribbon;
  EXPECT_FALSE(sees(time_goes_on)) << "a rest takes no room on it";
  const Snapshot shown = snapshot_;
  EXPECT_TRUE(sees([&] {
    snapshot_.goal.x += 0.001;
    time_goes_on();
    snapshot_.goal = shown.goal;  // while somebody looks back
  }));
}

}  // namespace
}  // namespace ghostforce::visible_state_test
