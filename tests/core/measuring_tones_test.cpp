#include "core/measuring_tones.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace ghostforce::measuring_tones_test {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

std::vector<double> sounded(MeasuringTones& tones, double seconds, double rate, bool are_wanted = true,
                            bool in_contact = true, double force = usual_tone_force) {
  std::vector<double> forces;
  for (std::int64_t i = 0; i < std::llround(seconds * rate); ++i) {
    forces.push_back(tones.step(are_wanted, in_contact, force, 1.0 / rate));
  }
  return forces;
}

// Of the sine of this frequency in whole turns of it [N].
double amplitude(const std::vector<double>& forces, double hz, double rate) {
  std::complex<double> sum = 0.0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    sum += forces[i] * std::polar(1.0, -turn * hz * static_cast<double>(i) / rate);
  }
  return 2.0 * std::abs(sum) / static_cast<double>(forces.size());
}

TEST(MeasuringTonesTest, AreTwoTonesAndNothingElse) {
  for (const double rate : {250.0, 1000.0, 4000.0}) {
    MeasuringTones tones;
    sounded(tones, 0.25, rate);
    EXPECT_EQ(tones.gain(), 1.0);
    const std::vector<double> forces = sounded(tones, 1.0, rate);
    double power = 0.0;
    for (const double force : forces) power += force * force / static_cast<double>(forces.size());
    // Sums of up to 4000 terms; the sines' angles are rounded after a second to 1e-14.
    EXPECT_NEAR(amplitude(forces, 3.0, rate), 0.4 / 1.6, 1e-12);
    EXPECT_NEAR(amplitude(forces, 16.0, rate), 0.6 * 0.4 / 1.6, 1e-12);
    EXPECT_NEAR(power, 0.5 * (0.25 * 0.25 + 0.15 * 0.15), 1e-12);
  }
}

TEST(MeasuringTonesTest, NeverGiveMoreThanTheirForceAndNeverJump) {
  for (const double rate : {250.0, 1000.0, 20000.0}) {
    MeasuringTones tones;
    // Wanted and not, touching and not, again and again in the middle of fading.
    double before = 0.0;
    double gain_before = 0.0;
    for (std::int64_t i = 0; i < std::llround(20.0 * rate); ++i) {
      const double seconds = static_cast<double>(i) / rate;
      const bool are_wanted = std::fmod(seconds, 1.7) < 1.3;
      const bool in_contact = std::fmod(seconds, 0.9) < 0.8;
      const double force = tones.step(are_wanted, in_contact, 0.4, 1.0 / rate);
      ASSERT_LE(std::abs(force), 0.4);
      // The steepest: both tones through zero, 0.25 N · 2π·3/s + 0.15 N · 2π·16/s, and the fading, 0.4 N in 0.2 s.
      ASSERT_LE(std::abs(force - before), 1.001 * (0.25 * turn * 3.0 + 0.15 * turn * 16.0 + 2.0) / rate);
      // As fast as fading takes 0.2 s, but for rounding.
      ASSERT_LE(std::abs(tones.gain() - gain_before), 1.0 / (0.2 * rate) + 1e-12);
      before = force;
      gain_before = tones.gain();
    }
  }
}

TEST(MeasuringTonesTest, FadeInAndOutWithinAFifthOfASecond) {
  MeasuringTones tones;
  EXPECT_EQ(tones.gain(), 0.0);
  sounded(tones, 0.1, 1000.0);
  EXPECT_NEAR(tones.gain(), 0.5, 1e-12);  // a hundred roundings
  sounded(tones, 0.101, 1000.0);
  EXPECT_EQ(tones.gain(), 1.0);
  sounded(tones, 0.1, 1000.0, false);
  EXPECT_NEAR(tones.gain(), 0.5, 1e-12);
  sounded(tones, 0.101, 1000.0, false);
  EXPECT_EQ(tones.gain(), 0.0);
  EXPECT_EQ(tones.step(false, true, 0.4, 0.001), 0.0);
}

TEST(MeasuringTonesTest, AreOffWhereNothingIsTouched) {
  MeasuringTones tones;
  for (const double force : sounded(tones, 1.0, 1000.0, true, false)) EXPECT_EQ(force, 0.0);
  sounded(tones, 0.5, 1000.0);
  EXPECT_EQ(tones.gain(), 1.0);
  sounded(tones, 0.201, 1000.0, true, false);
  EXPECT_EQ(tones.gain(), 0.0);
}

TEST(MeasuringTonesTest, BeginEachTimeInTheSameWay) {
  MeasuringTones tones;
  const std::vector<double> first = sounded(tones, 0.7, 1000.0);
  sounded(tones, 0.3, 1000.0, false);
  EXPECT_EQ(sounded(tones, 0.7, 1000.0), first);
  tones.silence();
  EXPECT_EQ(tones.gain(), 0.0);
  EXPECT_EQ(sounded(tones, 0.7, 1000.0), first);
}

TEST(MeasuringTonesTest, SoundInProportionToTheirForce) {
  MeasuringTones loud;
  MeasuringTones quiet;
  const std::vector<double> all = sounded(loud, 1.0, 1000.0);
  const std::vector<double> half = sounded(quiet, 1.0, 1000.0, true, true, 0.2);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_NEAR(half[i], 0.5 * all[i], 1e-15);
  MeasuringTones none;
  for (const double force : sounded(none, 1.0, 1000.0, true, true, 0.0)) EXPECT_EQ(force, 0.0);
}

}  // namespace
}  // namespace ghostforce::measuring_tones_test
