#include "device/input/mouse_input.h"

#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace ghostforce::mouse_input_test {
namespace {

constexpr double rate = 1000.0;
constexpr Vector<2> here{0.01, 0.02};
constexpr Vector<2> there{-0.03, 0.05};
// Positions of some cm are kept to 1e-17 m; steps are differences of two of them.
constexpr double rounding_m = 1e-15;

TEST(MouseInput, StaysWhereItStarted) {
  MouseInput mouse;
  mouse.restart(here);
  for (int k = 1; k <= 10; ++k) EXPECT_EQ(mouse.goal(k, rate), here);
}

TEST(MouseInput, GoesThereInEqualStepsAndArrivesExactly) {
  MouseInput mouse;
  mouse.restart(here);
  mouse.move_to(there, 0.016);
  Vector<2> before = here;
  for (int k = 1; k <= 16; ++k) {
    const Vector<2> goal = mouse.goal(k, rate);
    EXPECT_NEAR(glm::distance(goal, before), glm::distance(here, there) / 16.0, rounding_m) << "tick " << k;
    before = goal;
  }
  EXPECT_EQ(before, there);
  EXPECT_EQ(mouse.goal(17, rate), there);
}

TEST(MouseInput, GoesOnFromWhereItIsWhenTheTargetMoves) {
  MouseInput mouse;
  mouse.restart(here);
  mouse.move_to(there, 0.010);
  Vector<2> before = here;
  for (int k = 1; k <= 5; ++k) before = mouse.goal(k, rate);
  mouse.move_to(here, 0.010);
  const double step = glm::distance(before, here) / 10.0;
  for (int k = 6; k <= 15; ++k) {
    const Vector<2> goal = mouse.goal(k, rate);
    EXPECT_NEAR(glm::distance(goal, before), step, rounding_m);
    before = goal;
  }
  EXPECT_EQ(before, here);
}

TEST(MouseInput, TakesTheNewestOfSeveralMoves) {
  MouseInput mouse;
  mouse.restart(here);
  mouse.move_to({0.9, 0.9}, 0.010);
  mouse.move_to(there, 0.001);
  EXPECT_EQ(mouse.goal(1, rate), there);
}

TEST(MouseInput, TakesAtLeastATick) {
  for (const double duration_s : {0.0, -1.0, 1e-9}) {
    MouseInput mouse;
    mouse.restart(here);
    mouse.move_to(there, duration_s);
    EXPECT_EQ(mouse.goal(1, rate), there);
  }
}

TEST(MouseInput, TakesATenthOfASecondAtMost) {
  for (const double duration_s : {0.1, 5.0, std::numeric_limits<double>::infinity()}) {
    MouseInput mouse;
    mouse.restart(here);
    mouse.move_to(there, duration_s);
    for (int k = 1; k <= 99; ++k) EXPECT_NE(mouse.goal(k, rate), there);
    EXPECT_EQ(mouse.goal(100, rate), there);
  }
}

TEST(MouseInput, RestartForgetsMoves) {
  MouseInput mouse;
  mouse.restart(here);
  mouse.move_to(there, 0.010);
  mouse.goal(1, rate);
  mouse.move_to({0.5, 0.5}, 0.010);
  mouse.restart(here);
  EXPECT_EQ(mouse.goal(2, rate), here);
}

TEST(MouseInput, IgnoresWhatIsNoPlaceAndCountsIt) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  MouseInput mouse;
  mouse.restart(here);
  mouse.move_to({nan, 0.0}, 0.010);
  mouse.move_to({0.0, nan}, 0.010);
  mouse.move_to({infinity, 0.0}, 0.010);
  mouse.move_to({0.0, -infinity}, 0.010);
  mouse.move_to(there, nan);
  EXPECT_EQ(mouse.goal(1, rate), here);
  EXPECT_EQ(mouse.ignored_moves(), 5U);
}

TEST(MouseInput, StaysWithinAMetre) {
  MouseInput mouse;
  mouse.restart(here);
  mouse.move_to({-7.0, 1e300}, 0.001);
  EXPECT_EQ(mouse.goal(1, rate), Vector<2>(-1.0, 1.0));
  EXPECT_EQ(mouse.ignored_moves(), 0U);
}

}  // namespace
}  // namespace ghostforce::mouse_input_test
