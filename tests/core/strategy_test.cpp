#include "core/strategy.h"

#include <optional>
#include <set>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/core/random_setting.h"

namespace ghostforce::strategy_test {
namespace {

TEST(StrategyTest, CatalogIsInTheOrderOfTheIdentifiers) {
  ASSERT_EQ(strategy_catalog().size(), strategy_count);
  for (std::size_t i = 0; i < strategy_count; ++i) {
    EXPECT_EQ(index_of(strategy_catalog()[i].id), i);
    EXPECT_EQ(&strategy(strategy_catalog()[i].id), &strategy_catalog()[i]);
  }
}

TEST(StrategyTest, NamesLettersAndTitlesAreUniqueAndComplete) {
  std::set<std::string_view> names;
  std::set<std::string_view> titles;
  std::set<std::string_view> sentences;
  std::set<char> letters;
  for (const Strategy& entry : strategy_catalog()) {
    EXPECT_FALSE(entry.name.empty());
    EXPECT_FALSE(entry.title.empty());
    EXPECT_FALSE(entry.sentence.empty());
    EXPECT_NE(entry.tracking_ratio, nullptr);
    names.insert(entry.name);
    titles.insert(entry.title);
    sentences.insert(entry.sentence);
    letters.insert(entry.letter);
  }
  EXPECT_EQ(names.size(), strategy_count);
  EXPECT_EQ(titles.size(), strategy_count);
  EXPECT_EQ(sentences.size(), strategy_count);
  EXPECT_EQ(letters.size(), strategy_count);
}

// Files, command lines and pictures made with one version are read by the next.
TEST(StrategyTest, NamesAndLettersAreThoseOfTheFiles) {
  EXPECT_EQ(strategy(StrategyId::full).name, "full");
  EXPECT_EQ(strategy(StrategyId::naive).name, "naive");
  EXPECT_EQ(strategy(StrategyId::anisotropic).name, "anisotropic");
  EXPECT_EQ(strategy(StrategyId::full).letter, 'F');
  EXPECT_EQ(strategy(StrategyId::naive).letter, 'N');
  EXPECT_EQ(strategy(StrategyId::anisotropic).letter, 'A');
}

TEST(StrategyTest, IsFoundByItsNameOnly) {
  for (const Strategy& entry : strategy_catalog()) EXPECT_EQ(find_strategy(entry.name), entry.id);
  for (const std::string_view other : {"", "Full", "naïve", "full ", "all", "anisotropi"}) {
    EXPECT_EQ(find_strategy(other), std::nullopt) << other;
  }
}

// The table of docs/theory.md: K_r and K_t of each strategy, one horizontal motor.
TEST(StrategyTest, CouplingsAreThoseOfTheTable) {
  Stiffnesses stiffnesses = make_stiffnesses(100.0, 300.0, 500.0, 1e5);
  const Actuation<2> actuation = actuated_along(Vector<2>{1.0, 0.0});

  const Coupling<2> full = make_coupling(strategy(StrategyId::full), stiffnesses, actuation);
  EXPECT_EQ(full.rendering, Matrix<2>(300.0));
  EXPECT_EQ(full.tracking, Matrix<2>(500.0));

  const Coupling<2> naive = make_coupling(strategy(StrategyId::naive), stiffnesses, actuation);
  EXPECT_EQ(naive.rendering, Matrix<2>(300.0, 0.0, 0.0, 0.0));
  EXPECT_EQ(naive.tracking, Matrix<2>(500.0));

  const Coupling<2> anisotropic = make_coupling(strategy(StrategyId::anisotropic), stiffnesses, actuation);
  EXPECT_EQ(anisotropic.rendering, Matrix<2>(300.0, 0.0, 0.0, 0.0));
  EXPECT_EQ(anisotropic.tracking, Matrix<2>(500.0, 0.0, 0.0, 125.0));  // ρ* = 1 + 300/100

  // Belief and choice move the anisotropic one only.
  stiffnesses.believed_k_u = 300.0;
  EXPECT_EQ(make_coupling(strategy(StrategyId::anisotropic), stiffnesses, actuation).tracking[1][1], 250.0);
  stiffnesses.chosen_tracking_ratio = 10.0;
  EXPECT_EQ(make_coupling(strategy(StrategyId::anisotropic), stiffnesses, actuation).tracking[1][1], 50.0);
  EXPECT_EQ(make_coupling(strategy(StrategyId::naive), stiffnesses, actuation).tracking, Matrix<2>(500.0));
  EXPECT_EQ(make_coupling(strategy(StrategyId::full), stiffnesses, actuation).tracking, Matrix<2>(500.0));
}

static_assert(noexcept(strategy_catalog()) && noexcept(find_strategy("")));
static_assert(noexcept(make_coupling(strategy(StrategyId::full), Stiffnesses{}, Actuation<2>{})));

}  // namespace
}  // namespace ghostforce::strategy_test
