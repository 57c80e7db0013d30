// What the forms look like, pixel by pixel, by both painters.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/paint/label_painter.h"
#include "tests/app/paint/vector/both_painters.h"

namespace ghostforce::form_pixels_test {
namespace {

constexpr Colour red = rgb(0xB03407), blue = rgb(0x173C93);
const Colour paper = light.background;

// A metre for a point, from the upper left corner.
const Camera camera{0.5 * size, 1.0, size};
Vector<2> at(double x, double y) {
  return to_world(camera, {x, y});
}

Mark mark(decltype(Mark::form) form) {
  return {Role::device, std::nullopt, std::move(form), {}};
}

struct Drawn {
  std::string_view painter;
  Image image;

  Colour pixel(int x, int y) const {
    const auto first =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    return {image.rgb[first], image.rgb[first + 1], image.rgb[first + 2]};
  }
};

class FormPixels : public testing::Test {
 protected:
  std::array<Drawn, 2> draw(Marks marks) {
    const std::vector<Pane> panes{{Vector<2>(0.0), camera, StrategyId::full, std::move(marks)}};
    return {{{"OpenGL", gl_.draw(panes, light)}, {"Cairo", drawn_by_cairo(panes, light)}}};
  }

  OpenGl gl_;
};

bool is_near(Colour a, Colour b, int apart = 2) {
  const auto close = [&](std::uint8_t x, std::uint8_t y) { return std::abs(int{x} - int{y}) <= apart; };
  return close(a.red, b.red) && close(a.green, b.green) && close(a.blue, b.blue);
}

testing::AssertionResult shows(const Drawn& drawn, int x, int y, Colour expected, int apart = 2) {
  const Colour found = drawn.pixel(x, y);
  if (is_near(found, expected, apart)) return testing::AssertionSuccess();
  const auto words = [](Colour colour) {
    return testing::PrintToString(std::vector<int>{colour.red, colour.green, colour.blue});
  };
  return testing::AssertionFailure() << drawn.painter << " draws " << words(found) << " at " << x << ", " << y
                                     << " instead of " << words(expected);
}

TEST_F(FormPixels, ABoxHasRoundCornersAndARim) {
  for (const Drawn& drawn : draw({mark(Box{at(100.0, 80.0), {200.0, 120.0}, 40.0, blue, red, 8.0, {10.0, 20.0}})})) {
    EXPECT_TRUE(shows(drawn, 210, 160, blue));
    for (const auto& [x, y] : {std::pair{110, 160}, {309, 160}, {210, 100}, {210, 219}}) {
      EXPECT_TRUE(shows(drawn, x, y, red));
    }
    for (const auto& [x, y] : {std::pair{104, 160}, {315, 160}, {210, 94}, {210, 225}}) {
      EXPECT_TRUE(shows(drawn, x, y, paper));
    }
    for (const auto& [x, y] : {std::pair{114, 104}, {305, 104}, {114, 215}, {305, 215}}) {
      EXPECT_TRUE(shows(drawn, x, y, paper)) << "a corner";
    }
    EXPECT_TRUE(shows(drawn, 121, 111, red)) << "round its corner";
  }
  for (const Drawn& drawn : draw({mark(Box{at(100.0, 80.0), {200.0, 120.0}, 0.0, blue, red, 0.0})})) {
    for (const auto& [x, y] : {std::pair{100, 80}, {299, 80}, {100, 199}, {299, 199}}) {
      EXPECT_TRUE(shows(drawn, x, y, blue)) << "a sharp corner";
    }
    EXPECT_TRUE(shows(drawn, 99, 80, paper));
    EXPECT_TRUE(shows(drawn, 300, 199, paper));
  }
}

TEST_F(FormPixels, AHollowBoxShowsWhatLiesBehindAndNoOtherColourAtItsRim) {
  for (const Drawn& drawn : draw({mark(Box{at(100.5, 80.5), {200.0, 120.0}, 30.0, {0, 0, 0, 0}, red, 4.0})})) {
    EXPECT_TRUE(shows(drawn, 200, 140, paper));
    for (int x = 90; x < 312; ++x) {
      const Colour colour = drawn.pixel(x, 140);
      EXPECT_GE(colour.red, red.red - 2) << drawn.painter << ' ' << x;  // between rim and paper, never darker
      EXPECT_GE(colour.green, red.green - 2) << drawn.painter << ' ' << x;
    }
  }
}

TEST_F(FormPixels, AnArrowWithoutHeadIsABar) {
  Arrow arrow{at(100.0, 200.0), at(300.0, 200.0), 20.0, blue, blue, 0.0};
  for (const Drawn& drawn : draw({mark(arrow)})) {
    EXPECT_TRUE(shows(drawn, 297, 193, paper)) << "beside the tip";
    EXPECT_TRUE(shows(drawn, 260, 216, blue)) << "of the head";
  }
  arrow.has_head = false;
  for (const Drawn& drawn : draw({mark(arrow)})) {
    for (const auto& [x, y] : {std::pair{100, 190}, {299, 190}, {100, 209}, {299, 209}, {200, 200}}) {
      EXPECT_TRUE(shows(drawn, x, y, blue));
    }
    for (const auto& [x, y] : {std::pair{99, 200}, {300, 200}, {260, 216}, {200, 189}, {200, 210}}) {
      EXPECT_TRUE(shows(drawn, x, y, paper));
    }
  }
}

TEST_F(FormPixels, AHatchedArrowHasStripesOfItsRimOverItsFill) {
  const Colour white = rgb(0xFFFFFF);
  Arrow arrow{at(100.0, 200.0), at(500.0, 200.0), 60.0, white, red, 0.0, {}, true, true};
  const std::array<Drawn, 2> all = draw({mark(arrow)});
  for (const Drawn& drawn : all) {
    int striped = 0, bare = 0;
    for (int y = 180; y < 220; ++y) {
      for (int x = 110; x < 350; ++x) {
        striped += is_near(drawn.pixel(x, y), red) ? 1 : 0;
        bare += is_near(drawn.pixel(x, y), white) ? 1 : 0;
      }
    }
    EXPECT_NEAR(striped / (40.0 * 240.0), 0.4, 0.05) << drawn.painter;
    EXPECT_NEAR(bare / (40.0 * 240.0), 0.6, 0.06) << drawn.painter;
    // At 45°: the same along the other diagonal.
    for (int i = 0; i < 30; ++i) EXPECT_TRUE(is_near(drawn.pixel(200 + i, 215 - i), drawn.pixel(200, 215), 8)) << i;
    EXPECT_TRUE(shows(drawn, 200, 165, paper));
    EXPECT_TRUE(shows(drawn, 480, 180, paper));
  }
  // A tip that moves does not move the stripes.
  arrow.tip = at(523.0, 200.0);
  const std::array<Drawn, 2> longer = draw({mark(arrow)});
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (int x = 110; x < 350; ++x) EXPECT_TRUE(is_near(longer[i].pixel(x, 200), all[i].pixel(x, 200))) << x;
  }
}

TEST_F(FormPixels, ATranslucentAreaIsOfOneColourInside) {
  std::vector<Vector<2>> circle;
  for (int i = 0; i < 90; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 90;
    circle.push_back(at(300.0 + 150.3 * std::cos(angle), 280.0 + 150.3 * std::sin(angle)));
  }
  for (const Drawn& drawn : draw({mark(Area{circle, blue.with_alpha(128)})})) {
    const Colour inside = drawn.pixel(300, 280);
    EXPECT_TRUE(is_near(inside, mix(paper, blue, 128.0 / 255.0), 3)) << drawn.painter;
    int others = 0;
    for (int y = 120; y < 440; ++y) {
      for (int x = 140; x < 460; ++x) {
        const double from_middle = std::hypot(x + 0.5 - 300.0, y + 0.5 - 280.0);
        if (from_middle < 149.0) others += drawn.pixel(x, y) == inside ? 0 : 1;
        if (from_middle > 151.5) others += drawn.pixel(x, y) == paper ? 0 : 1;
      }
    }
    EXPECT_EQ(others, 0) << drawn.painter;
  }
}

TEST_F(FormPixels, AnAreaLeavesOutWhatItsCurveEnclosesTwice) {
  // A star in one stroke.
  std::vector<Vector<2>> star;
  for (int i = 0; i < 5; ++i) {
    const double angle = 2.0 * std::numbers::pi * (2 * i) / 5 - 0.5 * std::numbers::pi;
    star.push_back(at(300.0 + 200.0 * std::cos(angle), 280.0 + 200.0 * std::sin(angle)));
  }
  for (const Drawn& drawn : draw({mark(Area{star, red})})) {
    EXPECT_TRUE(shows(drawn, 300, 280, paper));
    EXPECT_TRUE(shows(drawn, 300, 140, red));
    EXPECT_TRUE(shows(drawn, 420, 245, red));
    EXPECT_TRUE(shows(drawn, 400, 150, paper));
  }
}

TEST_F(FormPixels, ARasterShowsEachCellsColourAtItsMiddleAndChangesEvenlyBetween) {
  const std::vector<Colour> cells{rgb(0xFF0000), rgb(0x00FF00), rgb(0x0000FF),
                                  rgb(0x000000), rgb(0xFFFFFF), rgb(0x808080)};
  for (const Drawn& drawn : draw({mark(Raster{at(100.0, 50.0), {600.0, 400.0}, 3, 2, cells})})) {
    for (int row = 0; row < 2; ++row) {
      for (int column = 0; column < 3; ++column) {
        const Colour expected = cells[static_cast<std::size_t>(3 * row + column)];
        EXPECT_TRUE(shows(drawn, 200 + 200 * column, 150 + 200 * row, expected, 3));
      }
    }
    EXPECT_TRUE(shows(drawn, 300, 150, rgb(0x808000), 3)) << "halfway";
    EXPECT_TRUE(shows(drawn, 200, 250, rgb(0x800000), 3));
    EXPECT_TRUE(shows(drawn, 100, 50, cells[0])) << "the corner cell's as far as the corner";
    EXPECT_TRUE(shows(drawn, 699, 449, cells[5]));
    EXPECT_TRUE(shows(drawn, 99, 50, paper));
    EXPECT_TRUE(shows(drawn, 700, 449, paper));
    for (int x = 101; x < 700; ++x) {
      EXPECT_TRUE(is_near(drawn.pixel(x, 150), drawn.pixel(x - 1, 150), 3)) << drawn.painter << ' ' << x;
    }
  }
}

TEST_F(FormPixels, WhatComesLaterLiesAboveWhateverItsForm) {
  const std::vector<Mark> forms{
      mark(Box{at(100.0, 100.0), {100.0, 100.0}, 5.0, rgb(0x111111), red, 0.0}),
      mark(Area{{at(100.0, 100.0), at(200.0, 100.0), at(200.0, 200.0), at(100.0, 200.0)}, rgb(0x222222)}),
      mark(Raster{at(100.0, 100.0), {100.0, 100.0}, 1, 1, {rgb(0x333333)}}),
      mark(Line{at(100.0, 150.0), at(200.0, 150.0), 90.0, rgb(0x444444)}),
      mark(Arrow{at(100.0, 150.0), at(200.0, 150.0), 90.0, rgb(0x555555), red, 0.0, {}, false}),
  };
  for (std::size_t last = 0; last < forms.size(); ++last) {
    Marks marks = forms;
    marks.push_back(forms[last]);
    const auto grey = static_cast<std::uint8_t>(0x11 * (last + 1));
    for (const Drawn& drawn : draw(marks)) EXPECT_TRUE(shows(drawn, 150, 150, {grey, grey, grey}));
  }
}

// ---- Bold letters ---------------------------------------------------------------------------------------------------

TEST_F(FormPixels, BoldLettersAreWiderByBothMeasures) {
  gl_.window().frame(0.0, [&] {
    for (const std::string_view words : {"1.27", "slid 12.0 mm", "A ghost force drags your hand along the wall."}) {
      for (const double height : {15.0, 30.0, 74.0}) {
        const Vector<2> regular = measure_vector_text(words, {height});
        const Vector<2> bold = measure_vector_text(words, {height, true});
        EXPECT_GT(bold.x, 1.05 * regular.x) << words;
        EXPECT_EQ(bold.y, height);
        const Vector<2> on_screen = measure_text(gl_.window().fonts(), words, {height, true});
        EXPECT_NEAR(on_screen.x, bold.x, 0.02 * height) << words;
        EXPECT_EQ(on_screen.y, height);
        EXPECT_GT(on_screen.x, 1.05 * measure_text(gl_.window().fonts(), words, {height}).x) << words;
        EXPECT_EQ(measure_with(gl_.window().fonts())(words, {height, true}), on_screen);
      }
    }
  });
}

TEST_F(FormPixels, BoldLettersAreDrawnBold) {
  const auto ink = [&](bool is_bold) {
    std::array<double, 2> darkness{};
    const std::array<Drawn, 2> all =
        draw({mark(Label{at(50.0, 50.0), {0.0, 0.0}, "Hand 1.27", {60.0, is_bold}, rgb(0x000000), {0, 0, 0, 0}})});
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) darkness[i] += (paper.green - all[i].pixel(x, y).green) / 255.0;
      }
    }
    return darkness;
  };
  const std::array<double, 2> regular = ink(false), bold = ink(true);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_GT(bold[i], 1.4 * regular[i]) << i;
  EXPECT_NEAR(bold[0], bold[1], 0.03 * bold[1]);
}

TEST_F(FormPixels, TheHaloOfLargeLettersIsOfItsOwnColourAlone) {
  for (const bool is_bold : {false, true}) {
    for (const Drawn& drawn :
         draw({mark(Label{at(50.0, 50.0), {0.0, 0.0}, "1.27 N, 30.45", {90.0, is_bold}, red, paper})})) {
      int off = 0;
      for (int y = 0; y < 200; ++y) {
        for (int x = 0; x < width; ++x) {
          // Anything between letters and paper.
          const Colour colour = drawn.pixel(x, y);
          const double share = (paper.green - colour.green) / static_cast<double>(paper.green - red.green);
          off += is_near(colour, mix(paper, red, std::clamp(share, 0.0, 1.0)), 4) ? 0 : 1;
        }
      }
      EXPECT_EQ(off, 0) << drawn.painter;
    }
  }
}

// ---- Files ----------------------------------------------------------------------------------------------------------

TEST(FormFiles, HaveTheSameBytesOnEveryCallWithEveryForm) {
  const std::vector<Pane> panes{
      {Vector<2>(0.0),
       camera,
       StrategyId::full,
       {mark(Raster{at(10.0, 10.0), {60.0, 40.0}, 2, 2, {red, blue, blue, red}}),
        mark(Raster{at(90.0, 10.0), {60.0, 40.0}, 1, 2, {red, blue}}),
        mark(Area{{at(100.0, 100.0), at(200.0, 100.0), at(200.0, 200.0)}, red.with_alpha(99)}),
        mark(Arrow{at(100.0, 150.0), at(200.0, 150.0), 15.0, paper, red, 2.0, {}, true, true}),
        mark(Box{at(100.0, 100.0), {100.0, 100.0}, 5.0, blue, red, 2.0}),
        mark(Label{at(50.0, 50.0), {0.0, 0.0}, "Hand 1.27", {60.0, true}, red, paper})}}};
  for (const VectorFormat format : {VectorFormat::svg, VectorFormat::pdf}) {
    const std::string first = paint_vector(panes, light, size, 1.0, format, "Forms");
    EXPECT_EQ(paint_vector(panes, light, size, 1.0, format, "Forms"), first);
    if (format == VectorFormat::pdf) {
      EXPECT_NE(first.find("+DejaVuSans-Bold"), std::string::npos);
    } else {
      for (const char* name : {"id=\"picture1\"", "href=\"#picture1\"", "id=\"picture2\"", "href=\"#picture2\""}) {
        EXPECT_NE(first.find(name), std::string::npos) << name;
      }
    }
  }
}

}  // namespace
}  // namespace ghostforce::form_pixels_test
