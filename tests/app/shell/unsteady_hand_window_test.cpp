// A hand that changes while it is at the window: what is shown and predicted is about the hand of that moment, and what a
// person has set stays set.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/state/set_up.h"
#include "app/state/set_up_of.h"
#include "core/equilibrium.h"
#include "tests/app/shell/driven_window.h"

namespace ghostforce::unsteady_hand_window_test {
namespace {

class UnsteadyHandWindow : public DrivenWindow {
 protected:
  UnsteadyHandWindow() { open({}, "changing-hand"); }

  void run_to(double time_s) {
    while (now().time_s < time_s) frames(1, 500);
  }
  double hand_at(double time_s) { return stiffness_at(session().scene->stiffness_path, time_s); }
};

TEST_F(UnsteadyHandWindow, ShowsTheHandOfTheMoment) {
  for (const double time_s : {4.0, 10.2, 15.0, 24.0}) {
    run_to(time_s);
    const Settings shown = application_->shown().settings;
    EXPECT_EQ(shown.stiffnesses.k_u, hand_at(now().time_s));
    EXPECT_EQ(settings_now(session()).stiffnesses, shown.stiffnesses);
    EXPECT_EQ(shown.stiffnesses.believed_k_u, 200.0) << "the renderer has not seen it";
    EXPECT_EQ(tracking_ratio(shown.stiffnesses), 4.0);
  }
  EXPECT_EQ(session().settings, session().scene->settings) << "nobody has changed a setting";
}

// The rings of the prediction are where the devices are: within what tremor and drift move the goal in the time that the
// device takes to follow it, far less than another hand would make of it.
TEST_F(UnsteadyHandWindow, PredictsWhatThatHandComesTo) {
  for (const double time_s : {16.0, 25.0}) {
    run_to(time_s);
    const Settings shown = application_->shown().settings;
    for (const Strategy& each : strategy_catalog()) {
      const Vector<2> device = now().strategies[index_of(each.id)].device;
      EXPECT_LT(glm::length(equilibrium_of(each.id, shown, now().goal).device - device), 0.001) << each.name;
    }
    const Vector<2> naive = now().strategies[index_of(StrategyId::naive)].device;
    EXPECT_GT(glm::length(equilibrium_of(StrategyId::naive, session().settings, now().goal).device - naive), 0.003);
  }
}

TEST_F(UnsteadyHandWindow, APastMomentHasItsOwnHand) {
  run_to(15.0);
  session().paused = true;
  frames(2, 1);
  session().stage.looks_back_to_s = 8.0;
  frames(2, 1);
  ASSERT_TRUE(application_->shown().is_past);
  EXPECT_EQ(application_->shown().settings.stiffnesses.k_u, 200.0);
}

TEST_F(UnsteadyHandWindow, ASetUpLineLeavesTheHandToItsPath) {
  run_to(15.0);
  const std::string line = set_up_line(set_up_of(session(), application_->shown()));
  EXPECT_EQ(line, "ghostforce run changing-hand --view workbench");
  session().settings.stiffnesses.believed_k_u = 150.0;
  frames(2);
  EXPECT_EQ(set_up_line(set_up_of(session(), application_->shown())),
            "ghostforce run changing-hand --set user.believed_k_u_N_per_m=150.0 --view workbench");
}

// The mouse means the place where the scene's path ends; the hand wanders round it.
TEST_F(UnsteadyHandWindow, TheHandWandersRoundTheMouse) {
  Vector<2> sum(0.0);
  double farthest = 0.0;
  constexpr int frames_seen = 600;
  for (int i = 0; i < frames_seen; ++i) {
    frames(1, 50);
    sum += now().goal;
    farthest = std::max(farthest, glm::length(now().goal - session().goal));
  }
  // 2 mm/s below 0.8 Hz is some tenths of a millimetre, and its mean over half a minute is less.
  EXPECT_LT(glm::length(sum / double{frames_seen} - session().goal), 0.0005);
  EXPECT_GT(farthest, 0.0003);
  EXPECT_LT(farthest, 0.004);
}

}  // namespace
}  // namespace ghostforce::unsteady_hand_window_test
