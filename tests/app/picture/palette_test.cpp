// The colours, recomputed from what is known about eyes: any two that tell strategies and goal apart must differ for
// viewers with normal and with colour-blind vision, and whatever is read must stand out from what is behind it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "app/picture/theme.h"

namespace ghostforce::palette_test {
namespace {

using Triple = std::array<double, 3>;
using Transform = std::array<Triple, 3>;

Triple linear(Colour colour) {
  const auto channel = [](std::uint8_t value) {
    const double encoded = value / 255.0;
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
  };
  return {channel(colour.red), channel(colour.green), channel(colour.blue)};
}

Triple applied(const Transform& transform, const Triple& in) {
  Triple out{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) out[row] += transform[row][column] * in[column];
  }
  return out;
}

// Machado, Oliveira & Fernandes 2009, severity 1.0, on linear RGB.
struct Vision {
  std::string name;
  Transform transform;
};
const std::array<Vision, 4> visions{{
    {"normal", {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}}},
    {"protan", {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}}},
    {"deutan", {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}},
    {"tritan", {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}},
}};

// CIE L*a*b* under D65.
Triple lab(Triple rgb) {
  for (double& channel : rgb) channel = std::clamp(channel, 0.0, 1.0);
  const Transform to_xyz{
      {{0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}}};
  Triple xyz = applied(to_xyz, rgb);
  const Triple white{0.95047, 1.0, 1.08883};
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = xyz[i] / white[i];
    xyz[i] = share > 216.0 / 24389.0 ? std::cbrt(share) : (24389.0 / 27.0 * share + 16.0) / 116.0;
  }
  return {116.0 * xyz[1] - 16.0, 500.0 * (xyz[0] - xyz[1]), 200.0 * (xyz[1] - xyz[2])};
}

// CIEDE2000, all weights 1.
double difference(const Triple& one, const Triple& two) {
  constexpr double pi = std::numbers::pi;
  const auto seventh = [](double chroma) {
    const double power = std::pow(chroma, 7.0);
    return std::sqrt(power / (power + 6103515625.0));  // 25⁷
  };
  const double mean_chroma = 0.5 * (std::hypot(one[1], one[2]) + std::hypot(two[1], two[2]));
  const double stretch = 1.0 + 0.5 * (1.0 - seventh(mean_chroma));
  const double a1 = stretch * one[1], a2 = stretch * two[1];
  const double c1 = std::hypot(a1, one[2]), c2 = std::hypot(a2, two[2]);
  const auto hue = [&](double a, double b) {
    const double angle = std::atan2(b, a);
    return a == 0.0 && b == 0.0 ? 0.0 : angle < 0.0 ? angle + 2.0 * pi : angle;
  };
  const double h1 = hue(a1, one[2]), h2 = hue(a2, two[2]);
  const double lightness = two[0] - one[0];
  const double chroma = c2 - c1;
  double turn = c1 * c2 == 0.0 ? 0.0 : h2 - h1;
  if (turn > pi) turn -= 2.0 * pi;
  if (turn < -pi) turn += 2.0 * pi;
  const double hue_step = 2.0 * std::sqrt(c1 * c2) * std::sin(0.5 * turn);
  const double mean_lightness = 0.5 * (one[0] + two[0]);
  const double mean_c = 0.5 * (c1 + c2);
  double mean_hue = h1 + h2;
  if (c1 * c2 != 0.0) {
    if (std::abs(h1 - h2) > pi) mean_hue += mean_hue < 2.0 * pi ? 2.0 * pi : -2.0 * pi;
    mean_hue *= 0.5;
  }
  const double degree = pi / 180.0;
  const double t = 1.0 - 0.17 * std::cos(mean_hue - 30.0 * degree) + 0.24 * std::cos(2.0 * mean_hue) +
                   0.32 * std::cos(3.0 * mean_hue + 6.0 * degree) - 0.20 * std::cos(4.0 * mean_hue - 63.0 * degree);
  const double apart = mean_lightness - 50.0;
  const double weight_l = 1.0 + 0.015 * apart * apart / std::sqrt(20.0 + apart * apart);
  const double weight_c = 1.0 + 0.045 * mean_c;
  const double weight_h = 1.0 + 0.015 * mean_c * t;
  const double bend = std::pow((mean_hue / degree - 275.0) / 25.0, 2.0);
  const double rotation = -2.0 * seventh(mean_c) * std::sin(60.0 * degree * std::exp(-bend));
  const double l = lightness / weight_l, c = chroma / weight_c, h = hue_step / weight_h;
  return std::sqrt(l * l + c * c + h * h + rotation * c * h);
}

double contrast(Colour a, Colour b) {
  const auto luminance = [](Colour colour) {
    const Triple rgb = linear(colour);
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
  };
  const double one = luminance(a) + 0.05, two = luminance(b) + 0.05;
  return std::max(one, two) / std::min(one, two);
}

TEST(Palette, TheMeasureItselfAgreesWithPublishedPairs) {
  // Of the table of Sharma, Wu & Dalal 2005; its values have four decimals.
  EXPECT_NEAR(difference({50.0, 2.6772, -79.7751}, {50.0, 0.0, -82.7485}), 2.0425, 5e-5);
  EXPECT_NEAR(difference({50.0, 2.5, 0.0}, {50.0, 0.0, -2.5}), 4.3065, 5e-5);
  EXPECT_NEAR(difference({50.0, 2.5, 0.0}, {73.0, 25.0, -18.0}), 27.1492, 5e-5);
  EXPECT_NEAR(difference({22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}), 2.0373, 5e-5);
  EXPECT_NEAR(difference({2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}), 0.9082, 5e-5);
}

TEST(Palette, AnyTwoStrategiesAndTheGoalDifferForEveryVision) {
  constexpr double least = 19.0;  // of the design; 10 is already told apart at a glance
  for (const Theme& theme : theme_catalog()) {
    std::vector<std::pair<std::string, Colour>> colours{{"goal", theme.goal}};
    for (const Strategy& entry : strategy_catalog()) {
      colours.emplace_back(entry.name, theme.strategy[index_of(entry.id)]);
    }
    for (const Vision& vision : visions) {
      for (std::size_t i = 0; i < colours.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          const double apart = difference(lab(applied(vision.transform, linear(colours[i].second))),
                                          lab(applied(vision.transform, linear(colours[j].second))));
          EXPECT_GE(apart, least) << theme.name << ", " << vision.name << ": " << colours[i].first << " and "
                                  << colours[j].first;
        }
      }
    }
  }
}

TEST(Palette, NothingIsToldByColourAlone) {
  for (const Strategy& a : strategy_catalog()) {
    for (const Strategy& b : strategy_catalog()) {
      if (a.id == b.id) continue;
      EXPECT_NE(strategy_style(a.id).shape, strategy_style(b.id).shape);
      EXPECT_NE(strategy_style(a.id).pattern, strategy_style(b.id).pattern);
      EXPECT_NE(a.letter, b.letter);
    }
  }
}

TEST(Palette, WordsCanBeRead) {
  constexpr double least = 4.5;  // of WCAG 2 for text of this size
  for (const Theme& theme : theme_catalog()) {
    const std::vector<std::pair<std::string, Colour>> behind{
        {"panel", theme.panel}, {"field", theme.panel_field}, {"scene", theme.background}, {"wall", theme.wall}};
    for (const auto& [where, ground] : behind) {
      EXPECT_GE(contrast(theme.text, ground), least) << theme.name << ": text on " << where;
      EXPECT_GE(contrast(theme.faint_text, ground), least) << theme.name << ": faint text on " << where;
      for (const Strategy& entry : strategy_catalog()) {
        EXPECT_GE(contrast(theme.strategy_text[index_of(entry.id)], ground), least)
            << theme.name << ": " << entry.name << " on " << where;
      }
    }
    // The row of the active strategy in the table, and its button.
    for (const Strategy& entry : strategy_catalog()) {
      const std::size_t i = index_of(entry.id);
      EXPECT_GE(contrast(theme.text, mix(theme.panel, theme.strategy[i], active_tint)), least) << theme.name;
      EXPECT_GE(contrast(theme.strategy_text[i], mix(theme.panel_field, theme.strategy[i], active_tint)), least)
          << theme.name << ": the button of " << entry.name;
    }
  }
}

TEST(Palette, MarksStandOutFromTheScene) {
  for (const Theme& theme : theme_catalog()) {
    for (const Strategy& entry : strategy_catalog()) {
      // 3 is WCAG's least for graphics. On the wall, the marks have a rim of the scene's colour besides.
      EXPECT_GE(contrast(theme.strategy[index_of(entry.id)], theme.background), 3.0) << theme.name << entry.name;
      EXPECT_GE(contrast(theme.strategy[index_of(entry.id)], theme.wall), 2.2) << theme.name << entry.name;
    }
    // The goal's rim carries its shape, whatever is behind it; in the dark its fill does.
    EXPECT_GE(std::max(contrast(theme.goal_rim, theme.wall), contrast(theme.goal, theme.wall)), 4.5) << theme.name;
    EXPECT_GE(contrast(theme.goal, theme.goal_rim), 4.5) << theme.name;
    EXPECT_GE(contrast(theme.wall_edge, theme.background), 4.5) << theme.name;
    EXPECT_GE(contrast(theme.problem, theme.panel_field), 3.0) << theme.name;
    EXPECT_GE(contrast(theme.accent, theme.panel_field), 3.0) << theme.name;
  }
}

TEST(Palette, TooMuchAndTooLittleDifferForEveryVision) {
  for (const Theme& theme : theme_catalog()) {
    for (const Vision& vision : visions) {
      // From a fifth of the way on, where the map's colours begin to be seen at all.
      for (const double depth : {0.2, 0.4, 0.6, 1.0}) {
        const Colour excess = mix(theme.background, theme.excess, depth);
        const Colour shortfall = mix(theme.background, theme.shortfall, depth);
        EXPECT_GE(difference(lab(applied(vision.transform, linear(excess))),
                             lab(applied(vision.transform, linear(shortfall)))),
                  10.0 * std::min(1.0, 2.0 * depth))
            << theme.name << ", " << vision.name << ", " << depth;
      }
    }
    EXPECT_GE(contrast(theme.excess, theme.background), 4.5) << theme.name;
    EXPECT_GE(contrast(theme.shortfall, theme.background), 4.5) << theme.name;
    EXPECT_GE(contrast(theme.accent, theme.background), 4.5) << theme.name << ": the ring's words";
  }
}

}  // namespace
}  // namespace ghostforce::palette_test
