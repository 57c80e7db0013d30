#include "device/spacemouse/spacemouse_report.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace ghostforce::spacemouse_report_test {
namespace {

using Report = std::vector<std::uint8_t>;

TEST(SpaceMouseReport, OlderOnesSendTranslationAndRotationApart) {
  SpaceMouseState state;
  EXPECT_TRUE(take_report(Report{1, 0x5E, 0x01, 0xA2, 0xFE, 0x00, 0x00}, state));
  EXPECT_EQ(state.axes, (std::array{350, -350, 0, 0, 0, 0}));
  EXPECT_TRUE(take_report(Report{2, 0x01, 0x00, 0xFF, 0xFF, 0x10, 0x00}, state));
  EXPECT_EQ(state.axes, (std::array{350, -350, 0, 1, -1, 16}));
}

TEST(SpaceMouseReport, NewerOnesSendAllAxesAtOnce) {
  SpaceMouseState state;
  EXPECT_TRUE(take_report(Report{1, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 0xFA, 0xFF}, state));
  EXPECT_EQ(state.axes, (std::array{1, 2, 3, 4, 5, -6}));
}

// Some of the newer ones pad the first report, and still send the second.
TEST(SpaceMouseReport, GoesByTheLength) {
  SpaceMouseState state;
  state.axes = {0, 0, 0, 7, 8, 9};
  EXPECT_TRUE(take_report(Report{1, 1, 0, 2, 0, 3, 0, 0, 0}, state));
  EXPECT_EQ(state.axes, (std::array{1, 2, 3, 7, 8, 9}));
}

TEST(SpaceMouseReport, ButtonsAreBits) {
  SpaceMouseState state;
  EXPECT_TRUE(take_report(Report{3, 0x02}, state));
  EXPECT_EQ(state.buttons, 2U);
  EXPECT_TRUE(take_report(Report{3, 0x01, 0x00, 0x00, 0x80}, state));
  EXPECT_EQ(state.buttons, 0x80000001U);
  EXPECT_TRUE(take_report(Report{3, 0, 0, 0, 0, 0xFF, 0xFF}, state));
  EXPECT_EQ(state.buttons, 0U);
}

TEST(SpaceMouseReport, OthersChangeNothing) {
  SpaceMouseState state;
  state.axes = {1, 2, 3, 4, 5, 6};
  state.buttons = 1;
  const SpaceMouseState before = state;
  for (const Report& report : {Report{}, Report{1}, Report{1, 0, 0, 0, 0, 0}, Report{2, 0}, Report{3},
                               Report{0x17, 80, 0}, Report{0, 1, 2, 3, 4, 5, 6}}) {
    EXPECT_FALSE(take_report(report, state));
    EXPECT_EQ(state, before);
  }
}

TEST(SpaceMouseReport, ItsNumberMayComeApart) {
  SpaceMouseState state;
  const Report bytes{1, 0, 2, 0, 3, 0};
  EXPECT_TRUE(take_report(2, bytes, state));
  EXPECT_EQ(state.axes, (std::array{0, 0, 0, 1, 2, 3}));
  EXPECT_FALSE(take_report(1, Report{}, state));
  EXPECT_FALSE(take_report(0, bytes, state));
}

TEST(SpaceMouseReport, ShowsAxesAsSharesOfFullDeflection) {
  SpaceMouseReading reading;
  reading.connection = 3;
  show({.axes = {350, -350, 35, 400, -32768, 0}, .buttons = 5}, reading);
  EXPECT_EQ(reading.axes, (std::array{1.0, -1.0, 0.1, 1.0, -1.0, 0.0}));
  EXPECT_EQ(reading.buttons, 5U);
  EXPECT_EQ(reading.connection, 3U);
}

TEST(SpaceMouseReport, TakesAnythingUnharmed) {
  std::mt19937 random(1);
  SpaceMouseState state;
  for (int i = 0; i < 20000; ++i) {
    Report report(random() % 65);
    for (std::uint8_t& byte : report) byte = static_cast<std::uint8_t>(random());
    if (!report.empty()) report[0] %= 5;
    take_report(report, state);
    for (const int axis : state.axes) ASSERT_TRUE(axis >= -32768 && axis <= 32767);
  }
}

}  // namespace
}  // namespace ghostforce::spacemouse_report_test
