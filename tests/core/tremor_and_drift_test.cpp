#include "core/tremor_and_drift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

namespace ghostforce::tremor_and_drift_test {
namespace {

constexpr double rate = 1000.0;
constexpr double lasts_s = 60.0;

// From where it has begun, tick by tick.
std::vector<Vector<2>> ways_of(const TremorAndDrift& tremor_and_drift) {
  const TremorAndDriftMotion motion(tremor_and_drift);
  std::vector<Vector<2>> ways;
  for (double tick = TremorAndDriftMotion::begins_within_s * rate; tick < lasts_s * rate; ++tick) {
    ways.push_back(motion.at(tick / rate));
  }
  return ways;
}

double rms(const std::vector<Vector<2>>& ways, glm::length_t axis) {
  double sum = 0.0;
  for (const Vector<2>& way : ways) sum += way[axis] * way[axis];
  return std::sqrt(sum / static_cast<double>(ways.size()));
}

std::vector<Vector<2>> velocities_of(const std::vector<Vector<2>>& ways) {
  std::vector<Vector<2>> velocities;
  for (std::size_t k = 1; k < ways.size(); ++k) velocities.push_back(rate * (ways[k] - ways[k - 1]));
  return velocities;
}

// Of the part of one axis at one frequency, seen through Hann's window, or the ends would leak into others [m].
double amplitude(const std::vector<Vector<2>>& ways, double hz) {
  double cosine = 0.0;
  double sine = 0.0;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const double angle = 2.0 * std::numbers::pi * hz * static_cast<double>(k) / rate;
    const double window =
        1.0 - std::cos(2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(ways.size()));
    cosine += window * ways[k].x * std::cos(angle);
    sine += window * ways[k].x * std::sin(angle);
  }
  return 2.0 * std::hypot(cosine, sine) / static_cast<double>(ways.size());
}

TEST(HandUnrestTest, AStillHandIsExactlyWhereItMeansToBe) {
  const Vector<2> goal(-0.0, 0.1 + 0.2);
  for (const TremorAndDriftMotion& motion : {TremorAndDriftMotion{}, TremorAndDriftMotion(TremorAndDrift{})}) {
    EXPECT_TRUE(motion.is_still());
    const Vector<2> shaken = motion.shaken(goal, 3.0);
    EXPECT_EQ(shaken, goal);
    EXPECT_TRUE(std::signbit(shaken.x)) << "to the last bit";
  }
}

TEST(HandUnrestTest, TremorHasItsSizeAndItsBand) {
  const std::vector<Vector<2>> ways = ways_of({.tremor_rms = 0.0003, .tremor_hz = {6.0, 9.0}});
  // 24 waves in 3 Hz: their neighbours beat in 8 s, of which the minute has too few for a better mean.
  EXPECT_NEAR(rms(ways, 0), 0.0003, 0.00001);
  EXPECT_NEAR(rms(ways, 1), 0.0003, 0.00001);
  double inside = 0.0;
  double outside = 0.0;
  for (double hz = 1.0; hz < 20.0; hz += 0.02) {
    double& greatest = hz > 5.9 && hz < 9.1 ? inside : outside;
    greatest = std::max(greatest, amplitude(ways, hz));
  }
  EXPECT_GT(inside, 20.0 * outside);
}

TEST(HandUnrestTest, DriftHasItsSpeedAndIsSlow) {
  const std::vector<Vector<2>> ways = ways_of({.drift_speed = 0.02});
  const std::vector<Vector<2>> velocities = velocities_of(ways);
  // Eight waves per axis in 0.6 Hz beat within 13 s: a minute has some five of these.
  EXPECT_NEAR(std::hypot(rms(velocities, 0), rms(velocities, 1)), 0.02, 0.001);
  double slow = 0.0;
  double fast = 0.0;
  for (double hz = 0.05; hz < 5.0; hz += 0.02) {
    double& greatest = hz < 1.0 ? slow : fast;
    greatest = std::max(greatest, amplitude(ways, hz));
  }
  EXPECT_GT(slow, 20.0 * fast);
}

TEST(HandUnrestTest, BeginsWhereTheGoalIs) {
  const TremorAndDriftMotion motion(TremorAndDrift{.tremor_rms = 0.001, .drift_speed = 0.02});
  EXPECT_FALSE(motion.is_still());
  EXPECT_EQ(motion.at(0.0), Vector<2>(0.0));
  EXPECT_EQ(motion.at(-1.0), Vector<2>(0.0));
  // Nothing jumps: a tick of 1 mm at 12 Hz and 20 mm/s, each a few times their rms, is far below 1 mm.
  Vector<2> before(0.0);
  for (int tick = 1; tick < 2000; ++tick) {
    const Vector<2> now = motion.at(tick / rate);
    ASSERT_LT(glm::length(now - before), 0.0005) << tick;
    before = now;
  }
}

TEST(HandUnrestTest, ASeedIsAHand) {
  const TremorAndDrift one{.tremor_rms = 0.0002, .drift_speed = 0.01, .seed = 7.0};
  TremorAndDrift other = one;
  other.seed = 8.0;
  EXPECT_EQ(TremorAndDriftMotion(one).at(2.0), TremorAndDriftMotion(one).at(2.0));
  EXPECT_NE(TremorAndDriftMotion(one).at(2.0), TremorAndDriftMotion(other).at(2.0));
  EXPECT_NE(TremorAndDriftMotion(one).at(2.0).x, TremorAndDriftMotion(one).at(2.0).y) << "the axes are apart";
}

// The same on every machine: what a sine may differ by, and no more. The numbers are this generator's own.
TEST(HandUnrestTest, IsTheSameOnEveryMachine) {
  const TremorAndDriftMotion motion(TremorAndDrift{.tremor_rms = 0.0002, .drift_speed = 0.01, .seed = 1.0});
  const Vector<2> way = motion.at(3.25);
  EXPECT_NEAR(way.x, -0.00090497896630136018, 1e-15);
  EXPECT_NEAR(way.y, -0.00024765424940040239, 1e-15);
}

}  // namespace
}  // namespace ghostforce::tremor_and_drift_test
