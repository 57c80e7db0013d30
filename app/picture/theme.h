// Theme: every colour, shape, line pattern and size of the screen, in one table. Immutable, any thread.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/strategy.h"

namespace ghostforce {

// sRGB, straight alpha.
struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  std::uint8_t alpha = 255;

  constexpr Colour with_alpha(std::uint8_t other) const noexcept { return {red, green, blue, other}; }
  friend constexpr bool operator==(const Colour&, const Colour&) noexcept = default;
};

// 0xRRGGBB, as in the design's palette.
constexpr Colour rgb(std::uint32_t hex) noexcept {
  return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8), static_cast<std::uint8_t>(hex)};
}

// `share` of `over`, the rest of `under`: a tint that needs no blending, so overlapping strokes do not darken.
constexpr Colour mix(Colour under, Colour over, double share) noexcept {
  const auto channel = [share](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(static_cast<double>(a) +
                                     share * (static_cast<double>(b) - static_cast<double>(a)) + 0.5);
  };
  return {channel(under.red, over.red), channel(under.green, over.green), channel(under.blue, over.blue)};
}

// A colour that lets what is beneath it through: 0 all, 1 nothing.
constexpr Colour faded(Colour colour, double strength) noexcept {
  const double share = strength < 0.0 ? 0.0 : strength > 1.0 ? 1.0 : strength;
  return colour.with_alpha(static_cast<std::uint8_t>(share * static_cast<double>(colour.alpha) + 0.5));
}

enum class Shape : std::uint8_t { disc, diamond, triangle };

// Drawn and left-out lengths, in turn [px]. All zero: a solid line.
using LinePattern = std::array<double, 4>;
inline constexpr LinePattern solid_line{0.0, 0.0, 0.0, 0.0};
inline constexpr LinePattern dotted_line{1.5, 4.5, 1.5, 4.5};

// Strategy = colour and shape and line pattern and letter (the letter is in the strategy catalog), so that nothing is
// told apart by colour alone.
struct StrategyStyle {
  Shape shape;
  LinePattern pattern;
};
const StrategyStyle& strategy_style(StrategyId id) noexcept;

// Share of its strategy's colour in a button or row that is active; more, and its letters were hard to read.
inline constexpr double active_tint = 0.16;

struct Theme {
  std::string_view name;
  bool dark;                          // panels start from a dark or a light base
  double thickness;                   // of every line, marker and letter in the scene, 1 is normal
  PerStrategy<Colour> strategy;       // for marks
  PerStrategy<Colour> strategy_text;  // hues of the strategies, dark or light enough to be read as letters
  Colour goal, goal_rim;
  Colour background, wall, hatch, wall_edge, grid;
  Colour text, faint_text;
  Colour panel, panel_field, panel_border, accent;
  Colour excess, shortfall;  // of a force: the deep ends of a map's colours, and the letters that go with them
  Colour problem;            // the border of bad news

  friend constexpr bool operator==(const Theme&, const Theme&) noexcept = default;
};

std::span<const Theme> theme_catalog() noexcept;

// What is printed: the light theme's colours on white. Not one of the catalog.
const Theme& paper() noexcept;

// Null when no theme has that name.
const Theme* find_theme(std::string_view name) noexcept;

}  // namespace ghostforce
