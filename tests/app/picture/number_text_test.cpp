#include "app/picture/text.h"

#include <gtest/gtest.h>

#include <limits>

namespace ghostforce::number_text_test {
namespace {

TEST(NumberText, HasARealMinusSignAndNoNegativeZero) {
  EXPECT_EQ(decimal_text(-19.44, 1), "−19.4");
  EXPECT_EQ(decimal_text(3.6, 1), "3.6");
  EXPECT_EQ(decimal_text(-0.04, 1), "0.0");
  EXPECT_EQ(decimal_text(-0.05001, 1), "−0.1");
  EXPECT_EQ(decimal_text(-0.4, 0), "0");
  EXPECT_EQ(decimal_text(-45.0, 0), "−45");
}

TEST(NumberText, ADeviationIsNeverNothing) {
  EXPECT_EQ(deviation_text(24.7), "25");
  EXPECT_EQ(deviation_text(0.02), "1");
}

TEST(NumberText, MarksWhatIsMoreThanZeroWhereItIsAskedTo) {
  EXPECT_EQ(signed_decimal_text(3.6, 2), "+3.60");
  EXPECT_EQ(signed_decimal_text(-3.6, 2), "−3.60");
  EXPECT_EQ(signed_decimal_text(0.001, 2), "0.00");
}

TEST(NumberText, NamesWhatIsNoNumber) {
  EXPECT_EQ(decimal_text(-std::numeric_limits<double>::infinity(), 1), "−inf");
  EXPECT_EQ(decimal_text(std::numeric_limits<double>::quiet_NaN(), 1), "nan");
}

}  // namespace
}  // namespace ghostforce::number_text_test
