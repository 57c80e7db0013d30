#include "device/input/scripted_input.h"

#include <gtest/gtest.h>

#include "core/tick.h"

namespace ghostforce::scripted_input_test {
namespace {

TEST(ScriptedInput, FollowsThePathByTickNumber) {
  const GoalPath path{{{0.0, 0.0}, {0.1, 0.0}, {0.1, 0.2}}, {0.0, 0.5, 2.0}, Motion::minimum_jerk};
  ScriptedInput script(path);
  for (const double rate : {100.0, 1000.0}) {
    script.restart(path.points.front());
    for (std::int64_t k = 0; k < 3000; k += 7) {
      EXPECT_EQ(script.goal(k, rate), goal_at(path, time_of(k, rate)));
    }
  }
}

}  // namespace
}  // namespace ghostforce::scripted_input_test
