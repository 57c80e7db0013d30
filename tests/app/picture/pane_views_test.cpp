// The panes of the comparison: one scale for lengths, one for forces, each pane on its own contact, and all of it in sight.
#include "app/picture/pane_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "app/picture/camera.h"
#include "tests/app/picture/workbench_case.h"

namespace ghostforce::pane_views_test {
namespace {

TEST(Fit, TakesTheGreatestScaleAtWhichAllIsInSight) {
  const std::vector<FitPoint> points{{{0.0, 0.0}, {0.0, 0.0}}, {{0.1, 0.02}, {0.0, 0.0}}, {{0.05, 0.0}, {-300.0, 0.0}}};
  const Vector<2> room{400.0, 300.0};
  const double scale = fitting_scale(points, room, 1e6);
  // From 0.05 s − 300 to 0.1 s: the width of 400 is the limit, at s = 2000.
  EXPECT_NEAR(scale, 2000.0, 1e-6);
  EXPECT_EQ(fitting_scale(points, room, 500.0), 500.0) << "no closer than that";
  const Camera camera{fitting_center(points, scale), scale, room};
  for (const FitPoint& point : points) {
    const Vector<2> at = to_screen(camera, point.world) + point.offset;
    EXPECT_GE(at.x, -1e-6);
    EXPECT_LE(at.x, room.x + 1e-6);
    EXPECT_GE(at.y, -1e-6);
    EXPECT_LE(at.y, room.y + 1e-6);
  }
}

TEST(Fit, ShowsTheRestWhereAnArrowIsTooLongForAnyScale) {
  const std::vector<FitPoint> points{{{0.0, 0.0}, {0.0, 0.0}}, {{0.1, 0.0}, {5000.0, 0.0}}};
  EXPECT_NEAR(fitting_scale(points, {400.0, 300.0}, 1e6), 4000.0, 1e-6);
}

class PaneViewsTest : public testing::Test {
 protected:
  PaneViewsTest() {
    shown_.settings.wall_normal_angle = 0.75 * std::numbers::pi;
    shown_.settings.stiffnesses = {
        .k_u = 100.0, .believed_k_u = {}, .k_r = 1000.0, .k_t = 1000.0, .k_c = 1e5, .chosen_tracking_ratio = {}};
    shown_.options.compare = Compare::side_by_side;
    move_goal({0.04, -0.04});
  }
  void move_goal(const Vector<2>& goal) { shown_.snapshot = snapshot_at_rest_of_all(shown_.settings, goal); }
  static const Arrow* last_arrow(const Pane& pane) {
    const Arrow* found = nullptr;
    for (const Mark& mark : pane.marks) {
      const bool is_force = mark.role == Role::force || mark.role == Role::ghost_force;
      if (const auto* arrow = std::get_if<Arrow>(&mark.form); arrow != nullptr && is_force) found = arrow;
    }
    return found;
  }

  WorkbenchCase shown_;
};

TEST_F(PaneViewsTest, AllPanesHaveOneScaleAndShowTheirOwnMarks) {
  for (const Vector<2>& window : {Vector<2>(1024.0, 640.0), Vector<2>(1280.0, 800.0), Vector<2>(3840.0, 2160.0)}) {
    for (const bool has_plots : {false, true}) {
      shown_.size = scene_size_in(window, 1.0, has_plots);
      for (const Pane& pane : shown_.compose()) {
        const Camera& camera = pane.camera;
        EXPECT_EQ(camera.points_per_metre, shown_.compose().front().camera.points_per_metre);
        const ScreenBox picture{Vector<2>(10.0), camera.size - Vector<2>(10.0)};
        const StrategySnapshot<2>& now = shown_.snapshot.strategies[index_of(pane.active)];
        for (const Vector<2>& place : {shown_.snapshot.goal, now.device, now.proxy, now.contact}) {
          EXPECT_TRUE(contains(picture, to_screen(camera, place))) << strategy(pane.active).name;
        }
        ASSERT_NE(last_arrow(pane), nullptr);
        EXPECT_TRUE(contains(picture, to_screen(camera, last_arrow(pane)->tip))) << strategy(pane.active).name;
      }
    }
  }
}

TEST_F(PaneViewsTest, TheLongestArrowTakesFourTenthsOfAPane) {
  double longest = 0.0;
  const std::vector<Pane> panes = shown_.compose();
  for (const Pane& pane : panes) {
    const Vector<2> device = shown_.snapshot.strategies[index_of(pane.active)].device;
    longest = std::max(longest, glm::distance(last_arrow(pane)->tip, device) * pane.camera.points_per_metre);
  }
  EXPECT_NEAR(longest, 0.4 * panes[0].camera.size.x, 1e-6);
}

TEST_F(PaneViewsTest, AreSaneInFreeSpaceAndForAnySettings) {
  move_goal({-0.04, 0.04});
  EXPECT_GT(fitted_pane_views(shown_.content()).width, 0.01);
  PictureDice dice(9);
  for (int i = 0; i < 500; ++i) {
    const WorkbenchCase any = workbench_case_by(dice);
    const PaneViews views = fitted_pane_views(any.content());
    EXPECT_TRUE(std::isfinite(views.width) && views.width > 0.0) << any.words();
    EXPECT_TRUE(std::isfinite(views.share_per_newton) && views.share_per_newton > 0.0) << any.words();
    for (const Vector<2>& center : views.centers) EXPECT_TRUE(std::isfinite(center.x) && std::isfinite(center.y));
  }
}

}  // namespace
}  // namespace ghostforce::pane_views_test
