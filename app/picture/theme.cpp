#include "app/picture/theme.h"

namespace ghostforce {
namespace {

struct StrategyLook {
  StrategyStyle style;
  Colour light, light_letters;
  Colour dark, dark_letters;
};

constexpr PerStrategy<StrategyLook> looks = std::to_array<StrategyLook>({
    {{Shape::disc, solid_line}, rgb(0x173C93), rgb(0x173C93), rgb(0x4F8DEB), rgb(0x8FB8F7)},
    {{Shape::diamond, {13.0, 6.0, 13.0, 6.0}}, rgb(0xB03407), rgb(0x9E2E06), rgb(0xFF5530), rgb(0xFF9478)},
    {{Shape::triangle, {10.0, 4.0, 2.0, 4.0}}, rgb(0x37A080), rgb(0x14604A), rgb(0x86EBD0), rgb(0x86EBD0)},
});

constexpr PerStrategy<Colour> colours_of(Colour StrategyLook::*member) {
  PerStrategy<Colour> colours;
  for (std::size_t i = 0; i < strategy_count; ++i) colours[i] = looks[i].*member;
  return colours;
}

constexpr std::array themes{
    Theme{.name = "light",
          .dark = false,
          .thickness = 1.0,
          .strategy = colours_of(&StrategyLook::light),
          .strategy_text = colours_of(&StrategyLook::light_letters),
          .goal = rgb(0xF4D800),
          .goal_rim = rgb(0x3A3200),
          .background = rgb(0xFBFAF7),
          .wall = rgb(0xE7E3DB),
          .hatch = rgb(0xA9A294),
          .wall_edge = rgb(0x3F3A33),
          .grid = rgb(0xEFEDE7),
          .text = rgb(0x23211E),
          .faint_text = rgb(0x5F5A52),
          .panel = rgb(0xF3F1EC),
          .panel_field = rgb(0xFFFFFF),
          .panel_border = rgb(0xD3CEC4),
          .accent = rgb(0x2F6FB0),
          .excess = rgb(0x961E05),
          .shortfall = rgb(0x2C506B),
          .problem = rgb(0x9E1B32)},
    Theme{.name = "dark",
          .dark = true,
          .thickness = 1.0,
          .strategy = colours_of(&StrategyLook::dark),
          .strategy_text = colours_of(&StrategyLook::dark_letters),
          .goal = rgb(0xFFE600),
          .goal_rim = rgb(0x1A1700),
          .background = rgb(0x15171B),
          .wall = rgb(0x262A31),
          .hatch = rgb(0x5A626F),
          .wall_edge = rgb(0xC9D0DA),
          .grid = rgb(0x1E2127),
          .text = rgb(0xECEFF3),
          .faint_text = rgb(0xA7AFBA),
          .panel = rgb(0x1C1F25),
          .panel_field = rgb(0x2A2F37),
          .panel_border = rgb(0x3A404A),
          .accent = rgb(0x5FA3E6),
          .excess = rgb(0xFF7A52),
          .shortfall = rgb(0xA4C4DE),
          .problem = rgb(0xFF7A8A)},
    // White, black and thick: a beamer washes out everything in between.
    Theme{.name = "projector",
          .dark = false,
          .thickness = 1.35,
          .strategy = colours_of(&StrategyLook::light),
          .strategy_text = colours_of(&StrategyLook::light_letters),
          .goal = rgb(0xF4D800),
          .goal_rim = rgb(0x3A3200),
          .background = rgb(0xFFFFFF),
          .wall = rgb(0xDDD8CE),
          .hatch = rgb(0x7D776B),
          .wall_edge = rgb(0x000000),
          .grid = rgb(0xF4F3F0),
          .text = rgb(0x000000),
          .faint_text = rgb(0x38342E),
          .panel = rgb(0xFFFFFF),
          .panel_field = rgb(0xF0EEE9),
          .panel_border = rgb(0x8C867A),
          .accent = rgb(0x1F5FA8),
          .excess = rgb(0x961E05),
          .shortfall = rgb(0x2C506B),
          .problem = rgb(0x9E1B32)},
};

}  // namespace

const StrategyStyle& strategy_style(StrategyId id) noexcept {
  return looks[index_of(id)].style;
}

std::span<const Theme> theme_catalog() noexcept {
  return themes;
}

const Theme& paper() noexcept {
  static const Theme theme = [] {
    Theme light = themes.front();
    light.name = "paper";
    light.background = rgb(0xFFFFFF);
    light.panel_border = rgb(0xFFFFFF);  // what lies between panes
    light.grid = rgb(0xE9E9E9);
    light.wall = rgb(0xEDEAE3);
    light.text = rgb(0x141414);
    light.faint_text = rgb(0x4A4A4A);
    return light;
  }();
  return theme;
}

const Theme* find_theme(std::string_view name) noexcept {
  for (const Theme& theme : themes) {
    if (theme.name == name) return &theme;
  }
  return nullptr;
}

}  // namespace ghostforce
