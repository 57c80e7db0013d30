#include "app/base/typed_text.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace ghostforce::did_you_mean_test {
namespace {

using namespace std::string_view_literals;

constexpr std::array names{"run"sv, "render"sv, "simulate"sv, "equilibrium"sv, "wall45"sv, "k_r_N_per_m"sv};

TEST(NearestName, FindsTheWordBehindASlip) {
  EXPECT_EQ(nearest_name("simulat", names), "simulate");    // a letter missing
  EXPECT_EQ(nearest_name("simmulate", names), "simulate");  // one too many
  EXPECT_EQ(nearest_name("simukate", names), "simulate");   // a wrong one
  EXPECT_EQ(nearest_name("simualte", names), "simulate");   // two swapped
  EXPECT_EQ(nearest_name("SIMULATE", names), "simulate");   // case does not count
  EXPECT_EQ(nearest_name("wall54", names), "wall45");
}

TEST(NearestName, TakesABeginningForTheWhole) {
  EXPECT_EQ(nearest_name("k_r", names), "k_r_N_per_m");
  EXPECT_EQ(nearest_name("equi", names), "equilibrium");
  EXPECT_EQ(nearest_name("eq", names), std::nullopt);  // could be anything
}

TEST(NearestName, IsSilentWhenNothingIsNear) {
  EXPECT_EQ(nearest_name("banana", names), std::nullopt);
  EXPECT_EQ(nearest_name("", names), std::nullopt);
  EXPECT_EQ(nearest_name("x", std::array{"y"sv}), std::nullopt);
  EXPECT_EQ(nearest_name(std::string(100'000, 's'), names), std::nullopt);
  EXPECT_EQ(nearest_name("run", {}), std::nullopt);
}

TEST(NearestName, PrefersFewerSlipsThenTheFirst) {
  EXPECT_EQ(nearest_name("abcdef", std::array{"abcxyf"sv, "abcdxf"sv}), "abcdxf");
  EXPECT_EQ(nearest_name("abcdef", std::array{"abcdxf"sv, "abcdyf"sv}), "abcdxf");
  // A slip is nearer than a beginning that much has to be added to, when it is exact.
  EXPECT_EQ(nearest_name("full", std::array{"fuller"sv, "full"sv}), "full");
}

TEST(NearestName, AsksAsTheEndOfASentence) {
  EXPECT_EQ(did_you_mean("rendr", names), "; did you mean 'render'?");
  EXPECT_EQ(did_you_mean("banana", names), "");
}

}  // namespace
}  // namespace ghostforce::did_you_mean_test
