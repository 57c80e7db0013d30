#include "app/stage/landscape_contours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/files/scene_file.h"
#include "tests/app/stage/random_settings.h"

namespace ghostforce::landscape_contours_test {
namespace {

bool is_at_the_edge(const LandscapePoint& point) {
  const Vector<2> place = map_place(point);
  const auto is_end = [](double share) { return std::abs(share) < 1e-9 || std::abs(share - 1.0) < 1e-9; };
  return is_end(place.x) || is_end(place.y);
}

TEST(LandscapeContours, LieOnTheirLevel) {
  RandomSettings random(1);
  std::size_t count = 0;
  for (int i = 0; i < 80; ++i) {
    const Landscape landscape = landscape_of(random.next(), random.between(0.0, 1.0));
    for (const Contour& contour : contours_of(landscape)) {
      for (const LandscapePoint& point : contour.points) {
        // The crossings are looked for until they are as near as this.
        EXPECT_NEAR(ghost_share(landscape, point), contour.level, 1e-8) << i;
        ++count;
      }
    }
  }
  EXPECT_GT(count, 10000U);
}

TEST(LandscapeContours, AreUnbrokenAndEndAtTheMapsEdge) {
  RandomSettings random(2);
  for (int i = 0; i < 80; ++i) {
    for (const Contour& contour : contours_of(landscape_of(random.next(), random.between(0.0, 1.0)))) {
      ASSERT_GE(contour.points.size(), 2U);
      for (std::size_t j = 1; j < contour.points.size(); ++j) {
        const Vector<2> way = map_place(contour.points[j]) - map_place(contour.points[j - 1]);
        EXPECT_TRUE(std::abs(way.x) < 1.0 / 119.0 && std::abs(way.y) < 1.0 / 79.0) << i << ": a cell at a time";
      }
      const bool is_closed = contour.points.front() == contour.points.back();
      EXPECT_TRUE(is_closed || (is_at_the_edge(contour.points.front()) && is_at_the_edge(contour.points.back()))) << i;
    }
  }
}

TEST(LandscapeContours, AreAllThatThereAre) {
  RandomSettings random(3);
  for (int i = 0; i < 100; ++i) {
    const Landscape landscape = landscape_of(random.next(), random.between(0.0, 1.0));
    const std::vector<Contour> contours = contours_of(landscape);
    for (const double level : contour_levels) {
      // How often a level is crossed along the upper edge: there each crossing is the end of a line.
      int crossings = 0;
      bool was_over = 0.0 >= level;
      for (int column = 1; column <= 120; ++column) {
        const bool is_over = ghost_share(landscape, landscape_point_at({column / 120.0, 1.0})) >= level;
        crossings += is_over != was_over ? 1 : 0;
        was_over = is_over;
      }
      int ends = 0;
      for (const Contour& contour : contours) {
        if (contour.level != level) continue;
        for (const LandscapePoint& end : {contour.points.front(), contour.points.back()}) {
          ends += map_place(end).y > 1.0 - 1e-9 ? 1 : 0;
        }
      }
      EXPECT_EQ(ends, crossings) << i << ", level " << level;
    }
  }
}

TEST(LandscapeContours, OfWall45AreTheFourOfThePicture) {
  const Settings settings = load_scene("wall45").settings;
  std::vector<double> levels;
  for (const Contour& contour : contours_of(landscape_of(settings, 0.0))) levels.push_back(contour.level);
  // The line of 10 % leaves the map at its foot and comes back.
  EXPECT_EQ(levels, (std::vector<double>{0.1, 0.1, 0.5, 1.0, 2.0}));
  EXPECT_TRUE(contours_of(landscape_of(settings, 1.0)).empty()) << "drained";
}

TEST(LandscapeContours, OfTooLittleAreThereWhereTheHandIsSofterThanBelieved) {
  Settings settings = load_scene("wall45").settings;
  settings.stiffnesses.believed_k_u = 10.0;
  std::vector<double> levels;
  for (const Contour& contour : contours_of(landscape_of(settings, 1.0))) levels.push_back(contour.level);
  EXPECT_EQ(std::ranges::count(levels, -0.1), 2);
  EXPECT_EQ(std::ranges::count(levels, -0.5), 2);
  EXPECT_EQ(levels.size(), 4U);
}

TEST(LandscapeContours, PlacesOnTheMapAreThereAndBackTheSame) {
  RandomSettings random(4);
  for (int i = 0; i < 80; ++i) {
    const Vector<2> place{random.between(0.0, 1.0), random.between(0.0, 1.0)};
    const Vector<2> back = map_place(landscape_point_at(place));
    EXPECT_NEAR(back.x, place.x, 1e-12);
    EXPECT_NEAR(back.y, place.y, 1e-12);
  }
  EXPECT_EQ(landscape_point_at({0.0, 0.0}), (LandscapePoint{0.0, 1.0}));
  EXPECT_NEAR(landscape_point_at({1.0, 1.0}).angle, 0.5 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(landscape_point_at({1.0, 1.0}).kappa, 100.0, 1e-9);
}

}  // namespace
}  // namespace ghostforce::landscape_contours_test
