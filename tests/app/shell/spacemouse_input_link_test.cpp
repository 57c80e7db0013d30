#include "app/shell/spacemouse_input_link.h"

#include <gtest/gtest.h>

namespace ghostforce::spacemouse_input_link_test {
namespace {

using Trouble = SpaceMouseReading::Trouble;

TEST(SpaceMouseInputLink, HasNewsUntilTheFrameAfter) {
  SpaceMouseInput input;
  Session session;
  SpaceMouseInputLink link(input, {}, {}, {});
  link.poll();
  EXPECT_FALSE(link.has_news());
  SpaceMouseReading reading;
  reading.trouble = Trouble::none;
  reading.connection = 1;
  input.publish(reading);
  link.poll();
  EXPECT_TRUE(link.has_news());
  link.poll();
  EXPECT_TRUE(link.has_news());
  link.send(session, 0.01);
  link.poll();
  EXPECT_FALSE(link.has_news());
  ++reading.reports;
  input.publish(reading);
  link.poll();
  EXPECT_TRUE(link.has_news());
}

TEST(SpaceMouseInputLink, HasSomethingToShowAndEndsWithTheTrouble) {
  SpaceMouseInput input;
  SpaceMouseInputLink link(input, {}, {}, {});
  LoopReading shown;
  link.fill(shown);
  EXPECT_TRUE(shown.draw_input);
  EXPECT_EQ(link.end().code, ExitCode::device_absent);
  SpaceMouseReading reading;
  reading.trouble = Trouble::not_opened;
  input.publish(reading);
  link.poll();
  EXPECT_EQ(link.end().code, ExitCode::device_refused);
}

TEST(SpaceMouseInputLink, TellsTheInputItsSettings) {
  constexpr double rate = 1000.0;
  SpaceMouseInput input;
  Session session;
  session.spacemouse.reach_m = 0.020;
  SpaceMouseInputLink link(input, {}, {}, {});
  link.send(session, 0.01);
  SpaceMouseReading reading;
  reading.connection = 1;
  reading.axes[0] = 1.0;
  input.publish(reading);
  Vector<2> goal{0.0};
  for (int tick = 0; tick < 1000; ++tick) goal = input.goal(tick, rate);
  EXPECT_NEAR(goal.x, 0.020, 1e-6);
}

}  // namespace
}  // namespace ghostforce::spacemouse_input_link_test
