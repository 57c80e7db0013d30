// The theme that is made of the system's colours, for the palettes that systems bring along and for some that nobody
// would choose.
#include "app/picture/system_theme.h"

#include <gtest/gtest.h>

#include <array>

#include "app/picture/contrast.h"

namespace ghostforce::system_theme_test {
namespace {

SystemColours colours(std::uint32_t canvas, std::uint32_t text, std::uint32_t link, std::uint32_t highlight,
                      std::uint32_t gray) {
  return {.canvas = rgb(canvas),
          .canvas_text = rgb(text),
          .link_text = rgb(link),
          .highlight = rgb(highlight),
          .gray_text = rgb(gray)};
}

const std::array palettes{
    colours(0x000000, 0xFFFFFF, 0xFFFF00, 0x1AEBFF, 0x3FF23F),  // a black one of Windows
    colours(0x2D3236, 0xFFFFFF, 0x75E9FC, 0xABCFF2, 0xA6A6A6),  // dusk
    colours(0xFFFAEF, 0x3D3D3D, 0x1C5E75, 0x903909, 0x676767),  // desert
    colours(0xFFFFFF, 0x000000, 0x0000EE, 0x3390FF, 0xC0C0C0),  // a highlight that is too pale for words
    colours(0x202020, 0xEEEEEE, 0x303030, 0x202020, 0x202020),  // only the text can be read
};

TEST(Contrast, IsThatOfWcag) {
  EXPECT_NEAR(contrast(rgb(0x000000), rgb(0xFFFFFF)), 21.0, 1e-9);
  EXPECT_NEAR(contrast(rgb(0x777777), rgb(0xFFFFFF)), 4.48, 0.005);
  EXPECT_NEAR(contrast(rgb(0xFFFFFF), rgb(0x767676)), 4.54, 0.005);
  EXPECT_NEAR(contrast(rgb(0x123456), rgb(0x123456)), 1.0, 1e-9);
}

TEST(SystemTheme, HasWordsThatCanBeRead) {
  for (const SystemColours& system : palettes) {
    const Theme theme = system_theme(system);
    for (const Colour ground : {theme.background, theme.wall, theme.panel, theme.panel_field}) {
      for (const Colour words : {theme.text, theme.faint_text, theme.accent, theme.excess, theme.shortfall,
                                 theme.problem, theme.wall_edge, theme.goal_rim}) {
        EXPECT_GE(contrast(words, ground), least_word_contrast);
      }
      for (const Colour words : theme.strategy_text) EXPECT_GE(contrast(words, ground), least_word_contrast);
    }
  }
}

TEST(SystemTheme, KeepsTheSystemsColoursWhereTheyCanBeRead) {
  const Theme black = system_theme(palettes[0]);
  EXPECT_EQ(black.background, rgb(0x000000));
  EXPECT_EQ(black.text, rgb(0xFFFFFF));
  EXPECT_EQ(black.accent, rgb(0x1AEBFF));
  EXPECT_TRUE(black.dark);
  const Theme white = system_theme(palettes[3]);
  EXPECT_EQ(white.accent, rgb(0x000000)) << "in place of one that is too pale";
  EXPECT_FALSE(white.dark);
}

}  // namespace
}  // namespace ghostforce::system_theme_test
