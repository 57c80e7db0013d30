// The view of the stage in the window: it stands still while something is dragged, and afterwards moves once if the
// numbers or the buttons would cover anything. What a person has moved by hand stays.
#include <string>

#include <glad/gl.h>

#include "app/stage/landscape_layout.h"
#include "app/state/landscape.h"
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
  // When it was elsewhere [s].
  double send_hand_away_and_back() {
    session().goal = elsewhere;
    frames(60);
    const double elsewhere_s = now().time_s;
    session().goal = wall45_goal;
    frames(200);
    return elsewhere_s;
  }
  static constexpr Vector<2> elsewhere{0.06, 0.05};  // out of sight

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

// All that a motor does to the handle on the way there is seen, and then its rail goes through where it is held.
TEST_F(StageViewWindow, TheRailComesToThePointerAndStandsStillWithIt) {
  for (const StrategyId id : {StrategyId::naive, StrategyId::anisotropic}) {
    begin(1280, 800);
    press(id == StrategyId::naive ? key::digit_2 : key::digit_3);
    frames(60);
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      ASSERT_TRUE(picture().motor_grips);
      const Vector<2> beside(3.0, -4.0);
      press_at((*picture().motor_grips)[end] + beside);
      hold_control(true);
      for (const Vector<2>& place : {Vector<2>(1100.0, 250.0), Vector<2>(640.0, 180.0), Vector<2>(980.0, 600.0),
                                     Vector<2>(420.0, 640.0), Vector<2>(300.0, 480.0), Vector<2>(1150.0, 500.0)}) {
        point_at(place);
        frames(2);
        const double angle = session().settings.actuated_angle;
        frames(200);
        EXPECT_EQ(session().settings.actuated_angle, angle) << "the pointer stands still";
        const std::array<Vector<2>, 2> ends = *picture().motor_grips;
        const Vector<2> along = glm::normalize(ends[1] - ends[0]);
        const Vector<2> to_pointer = place - ends[0];
        const double apart = std::abs(along.x * to_pointer.y - along.y * to_pointer.x);
        EXPECT_LE(apart, glm::length(beside) + 1.0)
            << strategy(id).name << ", end " << end << ", " << place.x << " " << place.y;
        // No end lies on the handle: where that is at the pointer, the end is beside it.
        const double to_handle = glm::distance(place, on_window(now().strategies[index_of(id)].device));
        EXPECT_LT(glm::distance(ends[end], place), to_handle < 60.0 ? 120.0 : 10.0)
            << "the end that is held comes to the pointer: " << strategy(id).name << ", end " << end << ", " << place.x
            << " " << place.y;
      }
      hold_control(false);
      release();
      frames(120);
    }
  }
}

TEST_F(StageViewWindow, AHandGoesWhereThePointerGoes) {
  for (const Vector<2>& place : {Vector<2>(640.0, 760.0), Vector<2>(1000.0, 45.0)}) {
    begin(1280, 800);
    press_at(on_window(session().goal));
    point_at(place);
    frames(5);
    EXPECT_LT(glm::distance(on_window(session().goal), place), 1.0);
    release();
    frames(150);
    expect_nothing_is_covered("below a row of buttons");
  }
}

TEST_F(StageViewWindow, IsAsBeforeOnceTheLastMinuteIsClosed) {
  const double elsewhere_s = send_hand_away_and_back();
  press(key::f);
  frames(120);
  const SceneView before = session().stage_shown;
  press(key::h);
  session().stage.looks_back_to_s = elsewhere_s;
  frames(120);
  EXPECT_NE(session().stage_shown, before) << "the hand was elsewhere";
  press(key::escape);
  frames(120);
  EXPECT_EQ(session().stage.mode, StageMode::none);
  EXPECT_EQ(session().stage_shown, before);
}

TEST_F(StageViewWindow, IsAsBeforeOnceADragIsUndone) {
  const SceneView first = session().stage_shown;
  drag_slowly(on_window(session().goal), {1250.0, 60.0});
  const SceneView second = session().stage_shown;
  EXPECT_NE(second, first) << "the hand would be covered";
  drag_slowly(on_window(session().goal), {30.0, 700.0});
  EXPECT_NE(session().stage_shown, second) << "the hand would be covered";
  press(key::z, modifier::control);
  frames(120);
  EXPECT_EQ(session().stage_shown, second);
  press(key::z, modifier::control);
  frames(120);
  EXPECT_EQ(session().stage_shown, first);
}

// In the last degree the share falls from its greatest to none, which nobody sees on the map.
TEST_F(StageViewWindow, TheRingOfTheMapStopsBeforeTheMotorPushesAlongTheWall) {
  press(key::l);
  frames(60);
  const LandscapeLayout& map = *picture().landscape;
  const Vector<2> corner(map.map.most.x, map.map.least.y);
  press_at(ring_at(map, landscape_point(session().settings)));
  point_at(corner);
  frames(3);
  release();
  frames(60);
  EXPECT_NEAR(landscape_point(session().settings).angle * degrees_per_radian, 89.0, 1e-6);
  EXPECT_GT(*application_->stage_reading().numbers.ghost_force, 1.0);
}

TEST_F(StageViewWindow, KeepsTheHandAboveTheRibbonAndIsAsBeforeWithoutIt) {
  for (const Vector<2>& place : {Vector<2>(820.0, 655.0), Vector<2>(700.0, 560.0), Vector<2>(1000.0, 640.0)}) {
    drag_slowly(on_window(session().goal), place);
    const SceneView before = session().stage_shown;
    press(key::h);
    frames(120);
    expect_nothing_is_covered(fmt::format("the ribbon, with the hand at {}, {}", place.x, place.y));
    press(key::h);
    frames(120);
    EXPECT_EQ(session().stage_shown, before);
  }
}

TEST_F(StageViewWindow, StaysWhereAPersonHasMovedIt) {
  const Vector<2> held = to_world(picture().pane.camera, {640.0, 400.0});
  drag({640.0, 400.0}, {250.0, 300.0}, GLFW_MOUSE_BUTTON_RIGHT);
  EXPECT_LT(glm::distance(on_window(held), Vector<2>(250.0, 300.0)), 1.0) << "it has come along with the pointer";
  const SceneView moved = session().stage_shown;
  frames(120);
  EXPECT_EQ(session().stage_shown, moved) << "though something is covered";
  drag(on_window(session().goal), on_window(session().goal) + Vector<2>(5.0, 5.0));
  frames(120);
  EXPECT_EQ(covered_by_frame(Drawn(picture())), "");
}

TEST_F(StageViewWindow, StaysWhereAPersonHasMovedItWhileLookingBack) {
  const double elsewhere_s = send_hand_away_and_back();
  const double near_s = now().time_s;
  press(key::h);
  session().stage.looks_back_to_s = near_s - 0.05;
  frames(120);
  drag({640.0, 300.0}, {200.0, 200.0}, GLFW_MOUSE_BUTTON_RIGHT);
  const SceneView moved = session().stage_shown;
  frames(120);
  EXPECT_EQ(session().stage_shown, moved) << "though something may be covered";
  session().stage.looks_back_to_s = elsewhere_s;
  frames(120);
  EXPECT_NE(session().stage_shown, moved) << "the hand was elsewhere, out of sight";
  EXPECT_TRUE(contains(picture().scene, on_window(elsewhere)));
}

}  // namespace
}  // namespace ghostforce::stage_view_window_test
