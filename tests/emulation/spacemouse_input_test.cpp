// A SpaceMouse as the hand with the real hidapi, against devices that exist only at the kernel's boundary.
#include "device/spacemouse/hid_spacemouse_input.h"

#include <chrono>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/emulation/emulated_hid_device.h"
#include "tests/emulation/ordinary_user.h"

namespace ghostforce::spacemouse_input_test {
namespace {

using Report = std::vector<std::uint8_t>;
using Trouble = SpaceMouseReading::Trouble;

constexpr std::uint8_t multi_axis = 8;
constexpr std::uint8_t pointer = 2;
constexpr UsbId navigator{0x046D, 0xC626};
constexpr UsbId compact{0x256F, 0xC635};
constexpr Vector<2> here{0.01, 0.02};
constexpr double rate_hz = 1000.0;

// For long, because machines stand still for seconds.
bool wait_for(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

// So many ticks as fast as they go; the goal never jumps.
Vector<2> run(HidSpaceMouseInput& input, int ticks, Vector<2> from) {
  for (int k = 0; k < ticks; ++k) {
    const Vector<2> goal = input.goal(k, rate_hz);
    EXPECT_LE(glm::distance(goal, from), SpaceMouseMotion::fastest_m_s / rate_hz + 1e-12);
    from = goal;
  }
  return from;
}

class SpaceMouseInputTest : public testing::Test {
 protected:
  TestBed bed;
};

TEST_F(SpaceMouseInputTest, SaysThatThereIsNone) {
  EmulatedHidDevice mouse(bed, {0x046D, 0xC077}, "USB Optical Mouse", pointer);
  mouse.plug();
  HidSpaceMouseInput input;
  input.restart(here);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_FALSE(input.reading().connected());
  EXPECT_EQ(input.reading().trouble, Trouble::absent);
  EXPECT_EQ(run(input, 100, here), here);
}

TEST_F(SpaceMouseInputTest, ReadsAnOlderOne) {
  EmulatedHidDevice mouse(bed, navigator, "SpaceNavigator", multi_axis);
  mouse.plug();
  HidSpaceMouseInput input;
  input.restart(here);
  ASSERT_TRUE(wait_for([&] { return input.reading().connected(); }));
  EXPECT_EQ(input.reading().trouble, Trouble::none);
  EXPECT_STREQ(input.reading().name.data(), "SpaceNavigator");
  mouse.send({1, 0x5E, 0x01, 0, 0, 0xA2, 0xFE});
  mouse.send({2, 0xAF, 0x00, 0, 0, 0x51, 0xFF});
  mouse.send({3, 0x02});
  ASSERT_TRUE(wait_for([&] { return input.reading().reports == 3; }));
  EXPECT_EQ(input.reading().axes, (std::array{1.0, 0.0, -1.0, 0.5, 0.0, -0.5}));
  EXPECT_EQ(input.reading().buttons, 2U);
  const Vector<2> goal = run(input, 500, here);
  EXPECT_NEAR(glm::distance(goal, here), SpaceMouseSettings{}.reach_m, 1e-9);
  EXPECT_GT(goal.x, here.x);
  EXPECT_GT(goal.y, here.y);
}

TEST_F(SpaceMouseInputTest, ReadsANewerOne) {
  EmulatedHidDevice mouse(bed, compact, "SpaceMouse Compact", multi_axis);
  mouse.plug();
  HidSpaceMouseInput input;
  input.restart(here);
  ASSERT_TRUE(wait_for([&] { return input.reading().connected(); }));
  mouse.send({1, 0xAF, 0x00, 0, 0, 0x51, 0xFF, 0x5E, 0x01, 0xFF, 0x7F, 0, 0x80});
  ASSERT_TRUE(wait_for([&] { return input.reading().reports == 1; }));
  EXPECT_EQ(input.reading().axes, (std::array{0.5, 0.0, -0.5, 1.0, 1.0, -1.0}));
}

TEST_F(SpaceMouseInputTest, TakesReportsOneByOneAndInOrder) {
  EmulatedHidDevice mouse(bed, compact, "SpaceMouse Compact", multi_axis);
  mouse.plug();
  HidSpaceMouseInput input;
  input.restart(here);
  ASSERT_TRUE(wait_for([&] { return input.reading().connected(); }));
  for (int i = 0; i <= 200; ++i) {
    mouse.send({1, static_cast<std::uint8_t>(i), 0, 0, 0, 0, 0});
    mouse.send({0x17, 80, 0});  // the battery's: no business of ours
  }
  ASSERT_TRUE(wait_for([&] { return input.reading().reports == 201; }));
  EXPECT_EQ(input.reading().axes[0], 200.0 / 350.0);
}

TEST_F(SpaceMouseInputTest, SettingsArriveWhole) {
  EmulatedHidDevice mouse(bed, compact, "SpaceMouse Compact", multi_axis);
  mouse.plug();
  HidSpaceMouseInput input;
  input.restart(here);
  ASSERT_TRUE(wait_for([&] { return input.reading().connected(); }));
  SpaceMouseSettings settings;
  settings.reach_m = 0.010;
  EXPECT_TRUE(input.set(settings));
  settings.reach_m = -1.0;
  EXPECT_FALSE(input.set(settings));
  mouse.send({1, 0x5E, 0x01, 0, 0, 0, 0});
  ASSERT_TRUE(wait_for([&] { return input.reading().reports == 1; }));
  EXPECT_NEAR(run(input, 500, here).x, here.x + 0.010, 1e-9);
}

TEST_F(SpaceMouseInputTest, SaysWhenItMayNotBeOpened) {
  EmulatedHidDevice mouse(bed, compact, "SpaceMouse Compact", multi_axis);
  mouse.plug();
  mouse.set_mode(0);
  const OrdinaryUser without_root;  // the reading thread is one too
  HidSpaceMouseInput input;
  ASSERT_TRUE(wait_for([&] { return input.reading().trouble == Trouble::not_allowed; }));
  EXPECT_FALSE(input.reading().connected());
  EXPECT_STREQ(input.reading().name.data(), "SpaceMouse Compact");
  mouse.set_mode(0600);
  EXPECT_TRUE(wait_for([&] { return input.reading().connected(); })) << "it looks again by itself";
}

TEST_F(SpaceMouseInputTest, TheGoalStaysWhereItIsWhenThePlugIsPulled) {
  EmulatedHidDevice mouse(bed, compact, "SpaceMouse Compact", multi_axis);
  HidSpaceMouseInput input;
  input.restart(here);
  Vector<2> goal = here;
  for (int cycle = 0; cycle < 3; ++cycle) {
    mouse.plug();
    ASSERT_TRUE(wait_for([&] { return input.reading().connected(); })) << "cycle " << cycle;
    goal = run(input, 100, goal);
    const std::uint64_t reports = input.reading().reports;
    mouse.send({1, 0x5E, 0x01, 0, 0, 0, 0});
    ASSERT_TRUE(wait_for([&] { return input.reading().reports > reports; }))
        << "cycle " << cycle << ", connection " << input.reading().connection << ", " << input.reading().reports
        << " reports, " << reports << " before";
    const Vector<2> moved = run(input, 500, goal);
    EXPECT_NEAR(moved.x, goal.x + SpaceMouseSettings{}.reach_m, 1e-9);
    mouse.unplug();
    ASSERT_TRUE(wait_for([&] { return !input.reading().connected(); })) << "cycle " << cycle;
    EXPECT_EQ(run(input, 100, moved), moved);
    EXPECT_EQ(input.reading().axes[0], 0.0);
    goal = moved;
  }
}

// Unplugged while the reading thread looks at it: hidapi 0.13 ends the program there.
TEST_F(SpaceMouseInputTest, ADeviceThatIsHalfGoneIsNone) {
  EmulatedHidDevice going(bed, compact, "SpaceMouse Compact", multi_axis);
  going.plug();
  going.forget_what_it_is();
  EmulatedHidDevice mouse(bed, navigator, "SpaceNavigator", multi_axis);
  HidSpaceMouseInput input;
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // the first look
  EXPECT_EQ(input.reading().trouble, Trouble::absent);
  EXPECT_STREQ(input.reading().name.data(), "");
  mouse.plug();
  ASSERT_TRUE(wait_for([&] { return input.reading().connected(); }));
  EXPECT_STREQ(input.reading().name.data(), "SpaceNavigator");
}

TEST_F(SpaceMouseInputTest, EndsWithOrWithoutADevice) {
  for (const bool plugged : {false, true}) {
    EmulatedHidDevice mouse(bed, compact, "SpaceMouse Compact", multi_axis);
    if (plugged) mouse.plug();
    auto input = std::make_unique<HidSpaceMouseInput>();
    if (plugged) {
      ASSERT_TRUE(wait_for([&] { return input->reading().connected(); }));
    }
    input.reset();  // where that waits for ever, ctest ends the test
  }
}

}  // namespace
}  // namespace ghostforce::spacemouse_input_test
