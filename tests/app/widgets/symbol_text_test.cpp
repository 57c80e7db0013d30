// Symbols are told from names with a _ in them, and are drawn with a small, lowered index.
#include "app/widgets/symbol_text.h"

#include <algorithm>
#include <string>

#include "app/picture/glossary.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/screen_text.h"

namespace ghostforce::symbol_text_test {
namespace {

// An index in braces.
std::string written(std::string_view words) {
  std::string text;
  for (const SymbolRun& run : symbol_runs(words)) {
    text += run.is_subscript ? fmt::format("{{{}}}", run.text) : std::string(run.text);
  }
  return text;
}

TEST(SymbolRuns, AreLettersWithAnIndex) {
  EXPECT_EQ(written("k_r"), "k{r}");
  EXPECT_EQ(written("Tracking k_ta, then k_tn."), "Tracking k{ta}, then k{tn}.");
  EXPECT_EQ(written("Σ f_r,k−1 · (q_h,k − q_h,k−1)"), "Σ f{r,k−1} · (q{h,k} − q{h,k−1})");
  EXPECT_EQ(written("believed k_u = k_u"), "believed k{u} = k{u}");
  EXPECT_EQ(written("ρ* = 1 + k_r/k_u"), "ρ* = 1 + k{r}/k{u}");
  EXPECT_EQ(written("nᵀP_A n"), "nᵀP_A n") << "a letter after another is no symbol of its own";
  EXPECT_EQ(written("P_A n"), "P{A} n");
}

TEST(SymbolRuns, LeaveNamesAlone) {
  for (const std::string_view name :
       {"my_scene.toml", "k_r_N_per_m", "a_long_name", "_", "k_", "_r", "k_ r", "x_axis", "", "ü_r"}) {
    EXPECT_EQ(written(name), name);
  }
}

TEST(SymbolRuns, LoseNoLetterOfTheGlossary) {
  for (const GlossaryEntry& entry : glossary()) {
    std::size_t letters = 0;
    for (const SymbolRun& run : symbol_runs(entry.formula)) letters += run.text.size() + (run.is_subscript ? 1 : 0);
    EXPECT_EQ(letters, entry.formula.size()) << entry.formula;
  }
}

class SymbolText : public DrivenWindow {};

TEST_F(SymbolText, HasASmallLoweredIndexInARow) {
  const std::vector<ScreenWords> all = words_on_screen();
  const auto row = std::ranges::find(all, "Rendering kr", &ScreenWords::text);
  ASSERT_NE(row, all.end());
  const auto plain = std::ranges::find(all, "Ratio ρ", &ScreenWords::text);
  ASSERT_NE(plain, all.end());
  // The r reaches below the line that the k stands on, though r has no descender; ρ has one.
  EXPECT_GT(row->ink.GetHeight(), 11.5F);
}

}  // namespace
}  // namespace ghostforce::symbol_text_test
