#include "app/picture/text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace ghostforce::text_test {
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

// Seven points to a letter, each of one byte.
Vector<2> measure_letters(std::string_view text, const TextStyle& style) {
  return {7.0 * static_cast<double>(text.size()), style.height};
}

double widest_of(const std::vector<std::string>& lines) {
  double widest = 0.0;
  for (const std::string& line : lines) widest = std::max(widest, measure_letters(line, {}).x);
  return widest;
}

TEST(BrokenText, HasAsFewLinesAsItCanAndThenTheNarrowest) {
  std::mt19937 random(7);
  for (int run = 0; run < 300; ++run) {
    std::string words;
    const int count = std::uniform_int_distribution(1, 14)(random);
    for (int i = 0; i < count; ++i) {
      if (i > 0) words += ' ';
      words += std::string(std::uniform_int_distribution<std::size_t>(1, 9)(random), 'x');
    }
    const double width = std::uniform_real_distribution(7.0, 400.0)(random);
    const std::vector<std::string> lines = broken_into_lines(words, width, {}, measure_letters);
    std::string joined = lines.front();
    for (std::size_t i = 1; i < lines.size(); ++i) joined += ' ' + lines[i];
    EXPECT_EQ(joined, words);
    EXPECT_EQ(line_count(words, width, {}, measure_letters), lines.size()) << words << " in " << width;
    if (lines.size() == 1) continue;
    const double widest = widest_of(lines);
    const bool is_one_word = std::ranges::any_of(lines, [&](const std::string& line) {
      return widest_of({line}) == widest && line.find(' ') == std::string::npos;
    });
    EXPECT_TRUE(widest <= width || is_one_word) << words << " in " << width;
    EXPECT_TRUE(is_one_word || line_count(words, widest - 1.0, {}, measure_letters) > lines.size())
        << words << " in " << width << " could be narrower";
  }
}

}  // namespace
}  // namespace ghostforce::text_test
