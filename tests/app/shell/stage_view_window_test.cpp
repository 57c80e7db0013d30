// The view of the stage in the window: it stands still while something is dragged, and afterwards moves once if the
// numbers or the buttons would cover anything. What a person has moved by hand stays.
#include <numbers>
#include <string>
#include <vector>

#include <glad/gl.h>

#include "app/state/stage_view.h"
#include "tests/app/shell/driven_window.h"
#include "tests/app/stage/stage_faults.h"

namespace ghostforce::stage_view_window_test {
namespace {

class StageViewWindow : public DrivenWindow {
 protected:
  StageViewWindow() { begin(1280, 800); }

  void begin(int width, int height) {
    open({.face = Face::stage, .input = "mouse"}, "wall45", width, height);
    glEnable(GL_RASTERIZER_DISCARD);  // the marks are looked at, and no pixel
    frames(60);
  }
  const StagePicture& picture() const { return screen().stage().picture(); }
  Vector<2> on_window(const Vector<2>& world) const { return to_screen(picture().pane.camera, world); }
  ScreenBox numbers() const { return *picture().numbers; }

  // Holds it, drags it there, and lets it go there.
  void drag_slowly(const Vector<2>& from, const Vector<2>& to) {
    const ScreenBox numbers_before = numbers();
    press_at(from);
    const Camera camera = picture().pane.camera;
    for (int i = 1; i <= 20; ++i) {
      point_at(from + (to - from) * (i / 20.0));
      frames(3);
      ASSERT_EQ(picture().pane.camera.center, camera.center) << i;
      ASSERT_EQ(picture().pane.camera.points_per_metre, camera.points_per_metre) << i;
      ASSERT_EQ(numbers().least, numbers_before.least) << i;
    }
    release();
    frames(150);
    ASSERT_EQ(numbers().least, numbers_before.least);
  }
  void expect_nothing_is_covered(const std::string& where) {
    EXPECT_EQ(covered_by_frame(Drawn(picture())), "") << where;
    const SceneView shown = session().stage_shown;
    frames(60);
    EXPECT_EQ(session().stage_shown, shown) << where;
  }
};

TEST_F(StageViewWindow, FollowsAHandThatIsDraggedToTheEdges) {
  for (const Vector<2>& size : {Vector<2>(1280.0, 800.0), Vector<2>(1024.0, 640.0)}) {
    begin(static_cast<int>(size.x), static_cast<int>(size.y));
    for (const Vector<2>& share : {Vector<2>(0.08, 0.3), Vector<2>(0.02, 0.02), Vector<2>(0.98, 0.98),
                                   Vector<2>(0.5, 0.85), Vector<2>(0.02, 0.98), Vector<2>(0.98, 0.02)}) {
      drag_slowly(on_window(session().goal), share * size);
      expect_nothing_is_covered(fmt::format("{}x{} at {}, {}", size.x, size.y, share.x, share.y));
    }
  }
}

TEST_F(StageViewWindow, FollowsARailOrAWallThatIsTurned) {
  for (const double degrees : {15.0, 60.0, 90.0, 140.0, 0.0}) {
    const double angle = degrees / degrees_per_radian;
    ASSERT_TRUE(picture().motor_grips);
    const Vector<2> pivot = on_window(picture().pivot);
    const Vector<2> grip = (*picture().motor_grips)[1];
    const Vector<2> way = to_screen_direction(direction_at(angle)) * glm::distance(pivot, grip);
    drag_slowly(grip, pivot + way);
    expect_nothing_is_covered(fmt::format("rail at {}°", degrees));
  }
  for (const double degrees : {45.0, 90.0, 180.0, 260.0}) {
    ASSERT_TRUE(picture().wall_grips);
    const Vector<2> pivot = on_window(session().settings.wall_point);
    const Vector<2> grip = (*picture().wall_grips)[1];
    const Vector<2> way = to_screen_direction(direction_at(degrees / degrees_per_radian)) * glm::distance(pivot, grip);
    drag_slowly(grip, pivot + way);
    expect_nothing_is_covered(fmt::format("wall at {}°", degrees));
  }
}

TEST_F(StageViewWindow, StaysWhereAPersonHasMovedIt) {
  drag({640.0, 400.0}, {250.0, 300.0}, GLFW_MOUSE_BUTTON_RIGHT);
  const SceneView moved = session().stage_shown;
  frames(120);
  EXPECT_EQ(session().stage_shown, moved) << "though something is covered";
  drag(on_window(session().goal), on_window(session().goal) + Vector<2>(5.0, 5.0));
  frames(120);
  EXPECT_EQ(covered_by_frame(Drawn(picture())), "");
}

}  // namespace
}  // namespace ghostforce::stage_view_window_test
