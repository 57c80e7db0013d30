// How much of each pixel a closed curve encloses.
#include "app/paint/area_coverage.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace ghostforce::area_coverage_test {
namespace {

using Shares = std::vector<std::uint8_t>;

// In pixels.
double area_of(const AreaCoverage& coverage) {
  return std::accumulate(coverage.shares.begin(), coverage.shares.end(), 0.0) / 255.0;
}

TEST(AreaCoverage, IsExactOnPixelsAndInPartsOfThem) {
  const std::vector<Vector<2>> rectangle{{1.0, 2.0}, {3.5, 2.0}, {3.5, 3.25}, {1.0, 3.25}};
  const AreaCoverage coverage = area_coverage(rectangle, 10, 10);
  EXPECT_EQ(coverage.left, 1);
  EXPECT_EQ(coverage.top, 2);
  EXPECT_EQ(coverage.width, 3);
  EXPECT_EQ(coverage.height, 2);
  EXPECT_EQ(coverage.shares, (Shares{255, 255, 128, 64, 64, 32}));
}

TEST(AreaCoverage, LeavesOutWhatIsEnclosedTwice) {
  // Out along one square, and on along a smaller one within it.
  const std::vector<Vector<2>> curve{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}, {0.0, 0.0},
                                     {1.0, 1.0}, {3.0, 1.0}, {3.0, 3.0}, {1.0, 3.0}, {1.0, 1.0}};
  EXPECT_EQ(area_coverage(curve, 9, 9).shares, (Shares{255, 255, 255, 255, 255, 0, 0, 255,  //
                                                       255, 0, 0, 255, 255, 255, 255, 255}));
}

TEST(AreaCoverage, HasTheAreaOfADiscWhateverItsPlace) {
  for (const Vector<2>& middle : {Vector<2>(20.0, 20.0), Vector<2>(21.37, 19.81)}) {
    std::vector<Vector<2>> circle;
    for (int i = 0; i < 200; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / 200;
      circle.push_back(middle + 15.0 * Vector<2>(std::cos(angle), std::sin(angle)));
    }
    EXPECT_NEAR(area_of(area_coverage(circle, 50, 50)), std::numbers::pi * 15.0 * 15.0, 1.0);
  }
}

// Of slanted edges too: the lines lie in the middle of what they stand for.
TEST(AreaCoverage, HasTheAreaOfATriangleWhicheverWayItPoints) {
  for (const double tip : {0.0, 10.0}) {
    const std::vector<Vector<2>> triangle{{0.0, 10.0 - tip}, {10.0, 10.0 - tip}, {0.0, tip}};
    EXPECT_NEAR(area_of(area_coverage(triangle, 12, 12)), 50.0, 0.1);
  }
}

TEST(AreaCoverage, KeepsToThePicture) {
  const std::vector<Vector<2>> large{{-1e7, -1e7}, {1e7, -1e7}, {1e7, 1e7}, {-1e7, 1e7}};
  const AreaCoverage all = area_coverage(large, 4, 3);
  EXPECT_EQ(all.shares, Shares(12, 255));
  const std::vector<Vector<2>> half{{-50.0, -50.0}, {2.0, -50.0}, {2.0, 50.0}, {-50.0, 50.0}};
  EXPECT_EQ(area_coverage(half, 4, 3).shares, Shares(6, 255));
  const std::vector<Vector<2>> beside{{5.0, 0.0}, {9.0, 0.0}, {9.0, 9.0}};
  EXPECT_TRUE(area_coverage(beside, 4, 3).shares.empty());
}

TEST(AreaCoverage, IsEmptyWhereNothingIsEnclosed) {
  EXPECT_TRUE(area_coverage({}, 5, 5).shares.empty());
  EXPECT_EQ(area_of(area_coverage(std::vector<Vector<2>>{{1.5, 1.5}}, 5, 5)), 0.0);
  EXPECT_EQ(area_of(area_coverage(std::vector<Vector<2>>{{1.0, 1.0}, {4.0, 3.5}}, 5, 5)), 0.0);
}

}  // namespace
}  // namespace ghostforce::area_coverage_test
