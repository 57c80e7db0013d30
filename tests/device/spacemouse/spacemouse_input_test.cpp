#include "device/spacemouse/spacemouse_input.h"

#include <gtest/gtest.h>

#include "device/spacemouse/spacemouse_report.h"

namespace ghostforce::spacemouse_input_test {
namespace {

constexpr double rate = 1000.0;
constexpr Vector<2> here{0.01, 0.02};

// As whoever reads the device does it: report by report.
class ReadSpaceMouse : public testing::Test {
 protected:
  ReadSpaceMouse() { input.restart(here); }

  void connect(std::uint32_t connection) {
    reading.connection = connection;
    reading.trouble = connection != 0 ? SpaceMouseReading::Trouble::none : SpaceMouseReading::Trouble::absent;
    input.publish(reading);
  }
  void push_right_fully() {
    constexpr std::uint8_t bytes[] = {0x5E, 0x01, 0, 0, 0, 0};
    ASSERT_TRUE(take_report(1, bytes, state));
    ++reading.reports;
    show(state, reading);
    input.publish(reading);
  }
  Vector<2> after(int ticks) {
    Vector<2> goal = here;
    for (int tick = 1; tick <= ticks; ++tick) goal = input.goal(tick, rate);
    return goal;
  }

  SpaceMouseInput input;
  SpaceMouseState state;
  SpaceMouseReading reading;
};

TEST_F(ReadSpaceMouse, MovesTheGoal) {
  connect(1);
  push_right_fully();
  const Vector<2> goal = after(1000);
  EXPECT_NEAR(goal.x, here.x + SpaceMouseSettings{}.reach_m, 1e-6);
  EXPECT_NEAR(goal.y, here.y, 1e-6);
}

TEST_F(ReadSpaceMouse, StopsWhereTheLastReportIsNotFollowedByAnother) {
  SpaceMouseSettings settings;
  settings.mode = SpaceMouseSettings::Mode::rate;
  ASSERT_TRUE(input.set(settings));
  connect(1);
  push_right_fully();
  const Vector<2> goal = after(1000);
  EXPECT_NEAR(goal.x, here.x + 0.5 * settings.speed_m_s, 1e-6);
  EXPECT_NEAR(after(5000).x, goal.x, 1e-9);
  push_right_fully();
  EXPECT_GT(after(200).x, goal.x + 0.02) << "the next report moves it again";
}

TEST_F(ReadSpaceMouse, MovesNothingWithoutADevice) {
  push_right_fully();
  EXPECT_EQ(after(1000), here);
}

TEST_F(ReadSpaceMouse, ShowsTheWindowWhatHasBeenRead) {
  EXPECT_FALSE(input.reading().connected());
  connect(1);
  push_right_fully();
  EXPECT_TRUE(input.reading().connected());
  EXPECT_EQ(input.reading().axes[0], 1.0);
}

TEST_F(ReadSpaceMouse, GoesByTheWindowsSettings) {
  SpaceMouseSettings settings;
  settings.reach_m = 0.01;
  EXPECT_TRUE(input.set(settings));
  settings.reach_m = -1.0;
  EXPECT_FALSE(input.set(settings));
  connect(1);
  push_right_fully();
  EXPECT_NEAR(after(1000).x, here.x + 0.01, 1e-6);
}

}  // namespace
}  // namespace ghostforce::spacemouse_input_test
