// Compiled for both fronts' sources: what a page makes of a text is what the standard library makes of it here.
#include "app/base/number.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace ghostforce::number_test {
namespace {

std::optional<double> expected(std::string_view text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [after, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && after == end ? std::optional(number) : std::nullopt;
}

void compare(std::string_view text) {
  const std::optional<double> read = read_number(text);
  const std::optional<double> wanted = expected(text);
  ASSERT_EQ(read.has_value(), wanted.has_value()) << text;
  if (!read) return;
  ASSERT_EQ(std::isnan(*read), std::isnan(*wanted)) << text;
  ASSERT_EQ(std::signbit(*read), std::signbit(*wanted)) << text;
  if (std::isnan(*read)) return;
  ASSERT_EQ(std::bit_cast<std::uint64_t>(*read), std::bit_cast<std::uint64_t>(*wanted)) << text;
}

TEST(Number, ReadsWhatIsOneAndNothingElse) {
  for (const std::string_view text :
       {"",      "-",     "--1",  "+1",    " 1",       "1 ",       "1-",       ".",     "e5",  "1e",
        "1e+",   "1.2.3", "1..2", "1,2",   "0x10",     "0x",       "1e5e5",    "1e5.",  "1_0", "1d5",
        "infin", "infx",  "nan(", "nan)",  "nan(a",    "nan(a b)", "nan(abc)", "nan()", "nan", "-nan",
        "NaN",   "inf",   "-inf", "INF",   "Infinity", "0",        "-0",       "0.0",   ".5",  "5.",
        "-.5e1", "1E5",   "1e+5", "00012", "in",       "n",        "infinit"}) {
    compare(text);
  }
}

TEST(Number, IsTheNearestThereIs) {
  for (const std::string_view text : {"1e999",
                                      "1e-400",
                                      "4e-324",
                                      "2.4e-324",
                                      "2.5e-324",
                                      "1.7976931348623157e308",
                                      "1.7976931348623159e308",
                                      "0e999999999999999999999",
                                      "1e99999999999999999999",
                                      "1e-99999999999999999999",
                                      "9007199254740993",
                                      "9007199254740992.5",
                                      "9007199254740993.00000000000000000000000001",
                                      "0.1",
                                      "1e27",
                                      "1e28",
                                      "1e-27",
                                      "1e-28",
                                      "18446744073709551615",
                                      "18446744073709551616",
                                      "9999999999999999999",
                                      "0000000000000000000000000001e-3",
                                      "0.00000000000000000000000000000000001",
                                      "2.2250738585072011e-308",
                                      "6.103515625e-5"}) {
    compare(text);
  }
}

// All sizes, lengths and places of the point, and halves between two neighbours, where the last digit decides.
TEST(Number, IsReadAsItWasWritten) {
  std::mt19937_64 random(1);
  const auto below = [&random](std::uint64_t limit) { return static_cast<int>(random() % limit); };
  for (int i = 0; i < 50'000 && !::testing::Test::HasFatalFailure(); ++i) {
    compare(fmt::format("{:.17g}", std::bit_cast<double>(random())));
    const double usual = std::ldexp(static_cast<double>(random()), -64 - below(40));
    compare(fmt::format("{}", usual));
    compare(fmt::format("{:.{}e}", usual, below(22)));
    const std::uint64_t significand = (std::uint64_t{1} << 53) + (random() >> 12);
    compare(fmt::format("{}e{}", 2 * significand + 1, below(55) - 27));
    compare(fmt::format("{}.5", significand));
    compare(fmt::format("{}E{}", random() >> below(64), below(60) - 30));
  }
}

}  // namespace
}  // namespace ghostforce::number_test
