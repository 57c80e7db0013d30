#include "device/spacemouse/spacemouse_input.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "device/spacemouse/spacemouse_report.h"

namespace ghostforce::spacemouse_motion_test {
namespace {

using Axes = std::array<double, 6>;
using Mode = SpaceMouseSettings::Mode;
using Up = SpaceMouseSettings::Up;

constexpr double rate_hz = 1000.0;
constexpr Vector<2> here{0.01, 0.02};
constexpr Axes untouched{};
constexpr Axes right{1.0, 0.0, 0.0, 0.0, 0.0, 0.0};
constexpr Axes lifted{0.0, 0.0, -1.0, 0.0, 0.0, 0.0};
constexpr Axes pushed_away{0.0, -1.0, 0.0, 0.0, 0.0, 0.0};
constexpr double rounding_m = 1e-12;

SpaceMouseSettings in_mode(Mode mode) {
  SpaceMouseSettings settings;
  settings.mode = mode;
  return settings;
}

// As a cap that is held there repeats it: a report a tick.
SpaceMouseReading reading_of(std::uint32_t connection, const Axes& axes) {
  static std::uint64_t reports = 0;
  SpaceMouseReading reading;
  reading.connection = connection;
  reading.axes = axes;
  reading.reports = ++reports;
  return reading;
}

// Steps for so long, and sees to it that the goal never jumps; returns where it ends.
Vector<2> run(SpaceMouseMotion& motion, double duration_s, std::uint32_t connection, const Axes& axes,
              const SpaceMouseSettings& settings, Vector<2> from) {
  for (int k = 0; k < std::lround(duration_s * rate_hz); ++k) {
    const Vector<2> goal = motion.step(reading_of(connection, axes), settings, rate_hz);
    EXPECT_LE(glm::distance(goal, from), SpaceMouseMotion::fastest_m_s / rate_hz + rounding_m) << "tick " << k;
    from = goal;
  }
  return from;
}

TEST(SpaceMouseDeflection, RightIsXAndLiftingIsY) {
  const SpaceMouseSettings settings;
  EXPECT_EQ(deflection(right, settings), Vector<2>(1.0, 0.0));
  EXPECT_EQ(deflection(lifted, settings), Vector<2>(0.0, 1.0));
  EXPECT_EQ(deflection(pushed_away, settings), Vector<2>(0.0, 0.0));
}

TEST(SpaceMouseDeflection, PushingAwayCanBeY) {
  SpaceMouseSettings settings;
  settings.up = Up::push_away;
  EXPECT_EQ(deflection(pushed_away, settings), Vector<2>(0.0, 1.0));
  EXPECT_EQ(deflection(lifted, settings), Vector<2>(0.0, 0.0));
}

TEST(SpaceMouseDeflection, TurnsMoveNothing) {
  EXPECT_EQ(deflection({0.0, 0.0, 0.0, 1.0, -1.0, 1.0}, {}), Vector<2>(0.0));
}

TEST(SpaceMouseDeflection, StartsFromNothingAtTheEdgeOfTheDeadZone) {
  const SpaceMouseSettings settings;
  for (const double angle : {0.0, 0.3, 1.0, 2.0, 4.0}) {
    double before = 0.0;
    for (double length = 0.0; length <= 1.5; length += 0.001) {
      const Vector<2> d =
          deflection({length * std::cos(angle), 0.0, -length * std::sin(angle), 0.0, 0.0, 0.0}, settings);
      const double now = glm::length(d);
      if (length < settings.dead_zone) {
        EXPECT_EQ(now, 0.0);
      } else if (now > 0.0) {
        EXPECT_NEAR(d.x, now * std::cos(angle), rounding_m) << "the direction stays";
      }
      EXPECT_GE(now, before - rounding_m);
      EXPECT_LE(now - before, 0.0011) << "a step at " << length;
      before = now;
    }
    EXPECT_NEAR(before, 1.0, rounding_m);
  }
}

TEST(SpaceMouseSettings, RefusesWhatIsNoAmount) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(is_valid({}));
  for (const double bad : {nan, -0.1, std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(is_valid({Mode::rate, Up::lift, bad, 0.06, 0.15}));
    EXPECT_FALSE(is_valid({Mode::rate, Up::lift, 0.05, bad, 0.15}));
    EXPECT_FALSE(is_valid({Mode::rate, Up::lift, 0.05, 0.06, bad}));
  }
  EXPECT_FALSE(is_valid({Mode::rate, Up::lift, 1.0, 0.06, 0.15}));
}

TEST(SpaceMouseMotion, StaysWhereItStartedWithoutADevice) {
  for (const Mode mode : {Mode::position, Mode::rate}) {
    SpaceMouseMotion motion;
    motion.restart(here);
    EXPECT_EQ(run(motion, 0.1, 0, right, in_mode(mode), here), here);
  }
}

TEST(SpaceMouseMotion, StaysWhereItStartedWhenNobodyTouchesIt) {
  for (const Mode mode : {Mode::position, Mode::rate}) {
    SpaceMouseMotion motion;
    motion.restart(here);
    EXPECT_EQ(run(motion, 0.1, 1, untouched, in_mode(mode), here), here);
  }
}

TEST(SpaceMouseMotion, PositionModeGoesAsFarAsTheCap) {
  const SpaceMouseSettings settings = in_mode(Mode::position);
  SpaceMouseMotion motion;
  motion.restart(here);
  Vector<2> goal = run(motion, 0.5, 1, right, settings, here);
  EXPECT_NEAR(goal.x, here.x + settings.reach_m, 1e-9);
  EXPECT_NEAR(goal.y, here.y, 1e-9);
  goal = run(motion, 0.5, 1, lifted, settings, goal);
  EXPECT_NEAR(goal.y, here.y + settings.reach_m, 1e-9);
  goal = run(motion, 0.5, 1, untouched, settings, goal);
  EXPECT_NEAR(glm::distance(goal, here), 0.0, 1e-9) << "let go: back again";
}

TEST(SpaceMouseMotion, RateModeGoesAsFastAsTheCapAndStays) {
  const SpaceMouseSettings settings = in_mode(Mode::rate);
  SpaceMouseMotion motion;
  motion.restart(here);
  Vector<2> goal = run(motion, 0.2, 1, right, settings, here);
  const Vector<2> after = run(motion, 0.5, 1, right, settings, goal);
  EXPECT_NEAR(after.x - goal.x, 0.5 * settings.speed_m_s, 1e-6);
  goal = run(motion, 0.2, 1, untouched, settings, after);
  EXPECT_NEAR(run(motion, 0.5, 1, untouched, settings, goal).x, goal.x, 1e-9);
}

TEST(SpaceMouseMotion, RateModeIsTheSameAtEveryRate) {
  const auto distance_after_a_second = [](double rate) {
    SpaceMouseMotion motion;
    motion.restart(here);
    Vector<2> goal = here;
    for (int k = 0; k < static_cast<int>(rate); ++k)
      goal = motion.step(reading_of(1, right), in_mode(Mode::rate), rate);
    return goal.x - here.x;
  };
  EXPECT_NEAR(distance_after_a_second(1000.0), distance_after_a_second(4000.0), 2e-4);
}

TEST(SpaceMouseMotion, RateModeCountsSilenceAsACapAtRestAtEveryRate) {
  for (const double rate : {100.0, 1000.0, 4000.0}) {
    SpaceMouseMotion motion;
    motion.restart(here);
    const SpaceMouseReading last = reading_of(1, right);
    const auto goal_after = [&](double duration_s, Mode mode) {
      Vector<2> goal{0.0};
      for (int k = 0; k < std::lround(duration_s * rate); ++k) goal = motion.step(last, in_mode(mode), rate);
      return goal;
    };
    const Vector<2> goal = goal_after(1.0, Mode::rate);
    EXPECT_NEAR(goal.x - here.x, SpaceMouseMotion::longest_silence_s * SpaceMouseSettings{}.speed_m_s, 3e-3) << rate;
    EXPECT_NEAR(goal_after(10.0, Mode::rate).x, goal.x, 1e-6) << rate;
    EXPECT_NEAR(goal_after(1.0, Mode::position).x, goal.x, 1e-6) << "nor does another mode move it, at " << rate;
  }
}

TEST(SpaceMouseMotion, PositionModeHoldsWhatWasReportedLast) {
  SpaceMouseMotion motion;
  motion.restart(here);
  const SpaceMouseReading last = reading_of(1, right);
  Vector<2> goal{0.0};
  for (int k = 0; k < 5000; ++k) goal = motion.step(last, in_mode(Mode::position), rate_hz);
  EXPECT_NEAR(goal.x, here.x + SpaceMouseSettings{}.reach_m, 1e-6);
}

TEST(SpaceMouseMotion, StaysWithinAMetre) {
  SpaceMouseSettings settings = in_mode(Mode::rate);
  settings.speed_m_s = 5.0;
  SpaceMouseMotion motion;
  motion.restart({0.9, 0.0});
  const Vector<2> goal = run(motion, 2.0, 1, right, settings, {0.9, 0.0});
  EXPECT_EQ(goal.x, SpaceMouseMotion::farthest_m);
  // And does not have to come back from beyond.
  EXPECT_LT(run(motion, 0.2, 1, {-1.0, 0.0, 0.0, 0.0, 0.0, 0.0}, settings, goal).x, 0.95);
}

// Reports come in steps; the goal's speed changes a little at a time.
TEST(SpaceMouseMotion, IsSmoothBetweenReports) {
  const SpaceMouseSettings settings = in_mode(Mode::position);
  SpaceMouseMotion motion;
  motion.restart(here);
  Vector<2> before = here;
  Vector<2> move_before{0.0};
  for (int k = 0; k < 1000; ++k) {
    const double at_report_s = (k / 10) * 0.010;
    const Axes axes{0.5 * std::sin(6.0 * at_report_s), 0.0, 0.0, 0.0, 0.0, 0.0};
    const Vector<2> goal = motion.step(reading_of(1, axes), settings, rate_hz);
    const Vector<2> move = goal - before;
    EXPECT_LT(glm::distance(move, move_before), 20e-6) << "tick " << k;  // of up to 0.2 m/s
    before = goal;
    move_before = move;
  }
}

TEST(SpaceMouseMotion, AChangeOfModeMovesNothing) {
  SpaceMouseMotion motion;
  motion.restart(here);
  Vector<2> goal = run(motion, 0.3, 1, right, in_mode(Mode::rate), here);
  const Axes half_right{0.5, 0.0, 0.0, 0.0, 0.0, 0.0};
  const Vector<2> later = run(motion, 0.3, 1, half_right, in_mode(Mode::rate), goal);
  goal = run(motion, 0.3, 1, half_right, in_mode(Mode::position), later);
  EXPECT_NEAR(glm::distance(goal, later), 0.0, 1e-6);
}

TEST(SpaceMouseMotion, StaysWhereItIsWhenTheDeviceGoesAndComesBack) {
  for (const Mode mode : {Mode::position, Mode::rate}) {
    const SpaceMouseSettings settings = in_mode(mode);
    SpaceMouseMotion motion;
    motion.restart(here);
    const Vector<2> goal = run(motion, 0.3, 1, right, settings, here);
    EXPECT_GT(goal.x, here.x + 0.03);
    EXPECT_EQ(run(motion, 0.3, 0, untouched, settings, goal), goal);
    EXPECT_EQ(run(motion, 0.3, 2, untouched, settings, goal), goal);
    // Held aside when it comes back: the goal sets out from there, at no more than its greatest speed (run() looks).
    EXPECT_GT(run(motion, 0.3, 3, right, settings, goal).x, goal.x + 0.03);
  }
}

TEST(SpaceMouseMotion, RestartForgets) {
  const SpaceMouseSettings settings = in_mode(Mode::position);
  SpaceMouseMotion motion;
  motion.restart({0.0, 0.0});
  run(motion, 0.3, 1, right, settings, {0.0, 0.0});
  motion.restart(here);
  EXPECT_NEAR(glm::distance(run(motion, 0.3, 1, untouched, settings, here), here), 0.0, 1e-9);
}

// From a device's own bytes to the goal.
TEST(SpaceMouseMotion, FollowsReports) {
  SpaceMouseState state;
  const std::uint8_t report[] = {1, 0x5E, 0x01, 0, 0, 0, 0};  // +350 to the right
  ASSERT_TRUE(take_report(report, state));
  Axes axes{};
  std::transform(state.axes.begin(), state.axes.end(), axes.begin(), [](int axis) { return axis / 350.0; });
  SpaceMouseMotion motion;
  motion.restart(here);
  EXPECT_NEAR(run(motion, 0.5, 1, axes, {}, here).x, here.x + SpaceMouseSettings{}.reach_m, 1e-9);
}

}  // namespace
}  // namespace ghostforce::spacemouse_motion_test
