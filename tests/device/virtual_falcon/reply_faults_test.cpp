// What the device answers while its motors push, and what the driver makes of it, in virtual time: a force ends within
// 25 ms, or it is kept up with new commands; and the device can be read again once the fault has gone.
#include <algorithm>
#include <array>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/device/virtual_falcon/link_exchange.h"
#include "tests/device/virtual_falcon/rehearsal.h"

namespace ghostforce::reply_faults_test {
namespace {

constexpr double longest_hold_s = 0.025;

// Armed, and leaning into the wall.
void push(Rehearsal& rehearsal) {
  rehearsal.turn_on();
  rehearsal.input().move_to({0.02, -0.02}, 0.5);
  rehearsal.run(1.5);
  ASSERT_GT(glm::length(rehearsal.motors().sent), 0.5);
}

bool device_pushes(Rehearsal& rehearsal) {
  return rehearsal.input().link().motors() != MotorNumbers{};
}

void expect_return(Rehearsal& rehearsal, bool is_off) {
  rehearsal.input().inject({});
  rehearsal.input().move_to(Rehearsal::free_place, 0.1);
  EXPECT_TRUE(rehearsal.run_until(60.0, [&] { return rehearsal.falcon().is_readable(); }));
  rehearsal.run(3.0);
  EXPECT_TRUE(rehearsal.falcon().is_readable());
  if (!is_off) return;
  EXPECT_EQ(rehearsal.motors().state, SafetyState::off) << "nothing but a person arms them again";
  EXPECT_FALSE(device_pushes(rehearsal));
  rehearsal.turn_on();  // and a person can
}

class LastingReplyFaultTest : public testing::TestWithParam<std::string_view> {};

TEST_P(LastingReplyFaultTest, EndsTheForceAndComesBack) {
  Rehearsal rehearsal;
  ASSERT_NO_FATAL_FAILURE(push(rehearsal));
  rehearsal.input().inject(injected_fault(GetParam()));
  EXPECT_TRUE(rehearsal.run_until(longest_hold_s, [&] { return !device_pushes(rehearsal); }));
  // Long enough for each of the driver's times-out.
  for (int i = 0; i < 2000; ++i) {
    rehearsal.step();
    ASSERT_FALSE(device_pushes(rehearsal)) << i;
  }
  EXPECT_EQ(rehearsal.motors().state, SafetyState::off);
  EXPECT_NE(rehearsal.motors().reason, OffReason::none);
  expect_return(rehearsal, true);
}

constexpr std::array<std::string_view, 6> lasting{"mute",         "late-50ms",  "impossible-encoders",
                                                  "forgets-home", "power-lost", "power-blink"};

std::string test_name(const testing::TestParamInfo<std::string_view>& run) {
  std::string name(run.param);
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(, LastingReplyFaultTest, testing::ValuesIn(lasting), test_name);

class PassingReplyFaultTest : public testing::TestWithParam<std::string_view> {};

TEST_P(PassingReplyFaultTest, IsGotOverOrEndsTheForce) {
  Rehearsal rehearsal;
  ASSERT_NO_FATAL_FAILURE(push(rehearsal));
  rehearsal.input().inject(injected_fault(GetParam()));
  const auto frames = [&] { return rehearsal.input().link().device().frames(); };
  std::uint64_t seen = frames();
  double held_s = 0.0;
  for (int i = 0; i < 2000; ++i) {
    rehearsal.step();
    held_s = frames() == seen && device_pushes(rehearsal) ? held_s + 0.001 : 0.0;
    seen = frames();
    ASSERT_LE(held_s, longest_hold_s) << "a force without a new command, " << i << " ms after the fault";
    ASSERT_LE(glm::length(rehearsal.motors().sent), 6.0 + 1e-9);
  }
  expect_return(rehearsal, rehearsal.motors().state == SafetyState::off);
}

constexpr std::array<std::string_view, 11> passing{
    "late-5ms",       "late-creeping",      "lost-reply", "lost-replies", "malformed-reply", "wrong-reply",
    "encoder-glitch", "duplicated-replies", "line-noise", "short-frames", "garbage"};

INSTANTIATE_TEST_SUITE_P(, PassingReplyFaultTest, testing::ValuesIn(passing), test_name);

}  // namespace
}  // namespace ghostforce::reply_faults_test
