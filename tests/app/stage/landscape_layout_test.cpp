#include "app/stage/landscape_layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/app/stage/random_settings.h"

namespace ghostforce::landscape_layout_test {
namespace {

// As the stage has it there.
LandscapeLayout layout_of(const Vector<2>& size, double unit) {
  const double header = size.y / 720.0;
  return landscape_layout(size, unit, {{{size.x - 480.0 * header, 0.0}, {size.x, 64.0 * header}}, 618.0 * header});
}

TEST(LandscapeLayout, StaysClearOfWhatIsRoundIt) {
  for (const double unit : {0.75, 1.0, 2.0, 3.0}) {
    for (const double taken : {20.0, 64.0, 128.0}) {
      const ScreenBox header{{700.0, 0.0}, {1280.0, taken}};
      const LandscapeLayout layout = landscape_layout({1280.0, 720.0}, unit, {header, 720.0 - taken});
      EXPECT_GE(layout.axis_title_top, taken) << unit;
      EXPECT_LT(layout.column.most.y, 720.0 - taken) << unit;
      EXPECT_GT(layout.map.extent().y, 100.0) << unit;
      EXPECT_FALSE(contains(layout.column, Vector<2>(701.0, taken - 1.0))) << unit;
    }
  }
}

TEST(LandscapeLayout, PointsAndPlacesOnTheScreenAreThereAndBackTheSame) {
  RandomSettings random(1);
  for (int i = 0; i < 500; ++i) {
    const LandscapeLayout layout =
        layout_of({random.between(1024.0, 3840.0), random.between(640.0, 2160.0)}, random.between(0.75, 3.0));
    const LandscapePoint point{random.between(0.0, 0.5 * std::numbers::pi), std::pow(10.0, random.between(0.0, 2.0))};
    const LandscapePoint back = landscape_point_under(layout, ring_at(layout, point));
    EXPECT_NEAR(back.angle, point.angle, 1e-9);
    EXPECT_NEAR(back.kappa, point.kappa, 1e-9 * point.kappa);
    const double dial = random.between(0.0, 1.0);
    EXPECT_NEAR(dial_under(layout, knob_at(layout, dial)), dial, 1e-9);
  }
}

TEST(LandscapeLayout, WhatLiesBeyondTheMapIsAtItsNearestEdge) {
  const LandscapeLayout layout = layout_of({1280.0, 720.0}, 1.0);
  EXPECT_NEAR(glm::distance(ring_at(layout, {0.0, 1e6}), layout.map.least), 0.0, 1e-9);
  EXPECT_EQ(ring_at(layout, {0.0, 0.0}).y, layout.map.most.y);
  EXPECT_TRUE(is_on_map({0.0, 1.0}));
  EXPECT_FALSE(is_on_map({0.0, 0.5}));
  EXPECT_FALSE(is_on_map({0.0, 101.0}));
  const LandscapePoint corner = landscape_point_under(layout, {-1e9, -1e9});
  EXPECT_EQ(corner.angle, 0.0);
  EXPECT_NEAR(corner.kappa, 100.0, 1e-9);
  EXPECT_EQ(dial_under(layout, {1e9, 0.0}), 1.0);
}

TEST(LandscapeLayout, APressTakesTheDialTheRingOrNothing) {
  const LandscapeLayout layout = layout_of({1280.0, 720.0}, 1.0);
  EXPECT_EQ(landscape_handle_under(layout, knob_at(layout, 0.3)), LandscapeHandle::dial);
  EXPECT_EQ(landscape_handle_under(layout, 0.5 * (layout.map.least + layout.map.most)), LandscapeHandle::ring);
  EXPECT_EQ(landscape_handle_under(layout, ring_at(layout, {0.0, 1.0}) - Vector<2>(0.9 * layout.ring_radius, 0.0)),
            LandscapeHandle::ring)
      << "what of the ring lies outside the map";
  EXPECT_EQ(landscape_handle_under(layout, {640.0, 700.0}), LandscapeHandle::none);
}

TEST(LandscapeLayout, ItsLettersGrowWithPictureAndScaleAsFarAsTheyFit) {
  EXPECT_DOUBLE_EQ(layout_of({1280.0, 720.0}, 1.0).em, 24.0);
  EXPECT_DOUBLE_EQ(layout_of({1280.0, 720.0}, 0.75).em, 18.0);
  EXPECT_DOUBLE_EQ(layout_of({3840.0, 2160.0}, 1.0).em, 72.0);
  EXPECT_DOUBLE_EQ(layout_of({1024.0, 768.0}, 1.0).em, 768.0 / 30.0) << "4:3 has room for all";
  const double most = layout_of({1280.0, 720.0}, 3.0).em;
  EXPECT_GT(most, 1.2 * 24.0);
  EXPECT_EQ(layout_of({1280.0, 720.0}, 2.0).em, most);
}

TEST(LandscapeLayout, IsFiniteForAnySize) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const double width : {-5.0, 0.0, 1.0, 1e9, infinity, none}) {
    for (const double height : {-5.0, 0.0, 1.0, 1e9, infinity, none}) {
      for (const double unit : {-1.0, 0.0, 1.0, infinity, none}) {
        const LandscapeLayout layout = layout_of({width, height}, unit);
        EXPECT_GT(layout.em, 0.0);
        const LandscapePoint point = landscape_point_under(layout, {3.0, 4.0});
        EXPECT_TRUE(std::isfinite(point.angle) && std::isfinite(point.kappa)) << width << ' ' << height << ' ' << unit;
        const Vector<2> ring = ring_at(layout, {0.5, 10.0});
        EXPECT_TRUE(std::isfinite(ring.x) && std::isfinite(ring.y)) << width << ' ' << height << ' ' << unit;
        EXPECT_TRUE(std::isfinite(dial_under(layout, {3.0, 4.0})));
        EXPECT_GT(layout.map.extent().x, 0.0);
        EXPECT_GT(layout.map.extent().y, 0.0);
      }
    }
  }
}

}  // namespace
}  // namespace ghostforce::landscape_layout_test
