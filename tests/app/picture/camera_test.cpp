#include "app/picture/camera.h"

#include <gtest/gtest.h>

namespace ghostforce::camera_test {
namespace {

TEST(Camera, PutsItsCentreInTheMiddleAndUpIsUp) {
  const Camera camera = camera_on({0.01, -0.02}, 0.1, {800.0, 600.0});
  EXPECT_EQ(to_screen(camera, {0.01, -0.02}), Vector<2>(400.0, 300.0));
  EXPECT_LT(to_screen(camera, {0.01, 0.0}).y, 300.0) << "y is up in the world and down on the screen";
  EXPECT_GT(to_screen(camera, {0.02, -0.02}).x, 400.0);
}

TEST(Camera, ToWorldUndoesToScreen) {
  const Camera camera = camera_on({-0.3, 0.7}, 0.25, {1279.0, 333.0});
  const Vector<2> world{0.123, -0.456};
  const Vector<2> back = to_world(camera, to_screen(camera, world));
  // Rounding of coordinates of a few metres: 1e-15 each way.
  EXPECT_NEAR(back.x, world.x, 1e-14);
  EXPECT_NEAR(back.y, world.y, 1e-14);
}

TEST(Camera, ShowsTheAskedWidthWhateverTheShapeOfTheWindow) {
  for (const Vector<2>& size : {Vector<2>(800.0, 600.0), Vector<2>(2000.0, 300.0), Vector<2>(300.0, 2000.0)}) {
    const Camera camera = camera_on({0.0, 0.0}, 0.2, size);
    EXPECT_GE(size.x / camera.points_per_metre, 0.2 - 1e-12);
    EXPECT_GE(size.y / camera.points_per_metre, 0.15 - 1e-12);
  }
}

}  // namespace
}  // namespace ghostforce::camera_test
