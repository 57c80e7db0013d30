// The sine that is the same everywhere.
#include "core/sine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ghostforce::sine_test {
namespace {

TEST(Sine, IsNearTheTrueOneAtEveryAngle) {
  long double worst = 0.0L;
  for (int i = -40'000; i <= 40'000; ++i) {
    const double turns = 0.0000731 * i + 0.01 * (i % 7);
    const long double whole = std::round(static_cast<long double>(turns));
    const long double truth =
        std::sin(2.0L * std::numbers::pi_v<long double> * (static_cast<long double>(turns) - whole));
    worst = std::max(worst, std::abs(truth - static_cast<long double>(sine_of_turns(turns))));
  }
  EXPECT_LE(worst, 4e-16L);
}

TEST(Sine, IsExactAtQuarters) {
  for (const double whole : {0.0, 3.0, -1e9}) {
    EXPECT_EQ(sine_of_turns(whole), 0.0);
    EXPECT_EQ(sine_of_turns(whole + 0.25), 1.0);
    EXPECT_EQ(sine_of_turns(whole + 0.5), 0.0);
    EXPECT_EQ(sine_of_turns(whole + 0.75), -1.0);
  }
}

// As every machine has to have them, from a desktop to a page.
TEST(Sine, IsTheSameToTheLastBit) {
  EXPECT_EQ(sine_of_turns(0.1), 0x1.2cf2304755a5ep-1);
  EXPECT_EQ(sine_of_turns(1234.56789), -0x1.a7ad270c2ea2ep-2);
  EXPECT_EQ(sine_of_turns(-0.37), -0x1.753b603d2b816p-1);
}

}  // namespace
}  // namespace ghostforce::sine_test
