// Every gesture of the mouse in the scene, through the backend's callbacks.
#include "app/shell/gestures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "app/picture/handles.h"
#include "app/picture/screen_box.h"
#include "app/widgets/tooltips.h"
#include "tests/app/shell/driven_window.h"

#include <imgui_internal.h>

namespace ghostforce::gestures_test {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

class GesturesTest : public DrivenWindow {
 protected:
  const Camera& camera() const { return screen().panes()[0].camera; }
  MotorDial dial() const { return motor_dial(camera(), 1.0); }
  Vector<2> dial_head(double angle) const {
    return in_window(dial().middle + 0.8 * dial().radius * Vector<2>(std::cos(angle), -std::sin(angle)));
  }
  Vector<2> wall_grip(std::size_t which) { return in_window((*wall_grips(session().settings, camera(), 1.0))[which]); }
  // Where a point of the window lies in the world.
  Vector<2> world_at(const Vector<2>& in_window) const {
    const Vector<2> corner{static_cast<double>(screen().scene_corner().x),
                           static_cast<double>(screen().scene_corner().y)};
    return to_world(camera(), in_window - corner);
  }
};

TEST_F(GesturesTest, TheArrowsHeadTurnsTheMotorAxisInStepsOfFiveDegrees) {
  const int trail = count_marks(Role::motor_axis);
  drag(dial_head(0.0), dial_head(35.5 * degree));
  EXPECT_NEAR(session().settings.actuated_angle, 35.0 * degree, 1e-9);
  EXPECT_EQ(count_marks(Role::motor_axis), trail);
  EXPECT_EQ(session().goal, load_scene("wall45").goal.points.back()) << "the goal stays where it is";
}

TEST_F(GesturesTest, ControlTurnsItFreely) {
  press_at(dial_head(0.0));
  hold_control(true);
  point_at(dial_head(37.0 * degree));
  frames(3);
  // The pointer stands on whole points: 2° at this radius.
  EXPECT_NEAR(session().settings.actuated_angle, 37.0 * degree, 2.0 * degree);
  EXPECT_GT(std::abs(std::remainder(session().settings.actuated_angle / degree, 5.0)), 0.05);
  hold_control(false);
  release();
}

TEST_F(GesturesTest, AClickOnTheArrowTurnsNothing) {
  session().settings.actuated_angle = 12.3 * degree;
  frames(2);
  press_at(dial_head(12.3 * degree));
  release();
  EXPECT_NEAR(session().settings.actuated_angle, 12.3 * degree, 1e-12);
}

TEST_F(GesturesTest, TheWallsEndTurnsTheWallAboutItsPoint) {
  for (const std::size_t which : {0U, 1U}) {
    open({});
    const Vector<2> point = session().settings.wall_point;
    const Vector<2> pivot = on_window(point);
    const Vector<2> grip = wall_grip(which);
    const Vector<2> arm = grip - pivot;
    const double turn = 20.0 * degree;  // counter-clockwise as one sees it; y is down
    const Vector<2> turned{arm.x * std::cos(turn) + arm.y * std::sin(turn),
                           arm.y * std::cos(turn) - arm.x * std::sin(turn)};
    drag(grip, pivot + turned);
    EXPECT_NEAR(session().settings.wall_normal_angle, 155.0 * degree, 1e-9) << which;
    EXPECT_EQ(session().settings.wall_point, point);
  }
}

TEST_F(GesturesTest, GripsShowWhereAPersonCanTakeThemAndNotInPictures) {
  EXPECT_EQ(count_marks(Role::handle), 2);
  session().has_handles = false;
  frames(2);
  EXPECT_EQ(count_marks(Role::handle), 0);
}

TEST_F(GesturesTest, TheWheelZoomsAtThePointer) {
  const Vector<2> at{300.0, 300.0};
  point_at(at);
  frames(3);
  const Vector<2> under = world_at(at);
  const double before = camera().points_per_metre;
  scroll(3.0);
  EXPECT_GT(camera().points_per_metre, 1.4 * before);
  // 1e-9 m: the arithmetic of one zoom.
  EXPECT_NEAR(world_at(at).x, under.x, 1e-9);
  EXPECT_NEAR(world_at(at).y, under.y, 1e-9);
  scroll(-3.0);
  EXPECT_NEAR(camera().points_per_metre, before, 1e-6 * before);
}

TEST_F(GesturesTest, TheZoomHasEnds) {
  point_at(300.0, 300.0);
  frames(2);
  for (int i = 0; i < 30; ++i) scroll(10.0);
  EXPECT_EQ(session().shown.width, 0.001) << "those of a scene's file";
  for (int i = 0; i < 60; ++i) scroll(-10.0);
  EXPECT_EQ(session().shown.width, 10.0);
  EXPECT_GT(picture().width, 0);
}

TEST_F(GesturesTest, ARightDragMovesThePicture) {
  const Vector<2> from{300.0, 300.0};
  const Vector<2> to{340.0, 260.0};
  const Vector<2> grabbed = world_at(from);
  const Vector<2> goal = session().goal;
  drag(from, to, GLFW_MOUSE_BUTTON_RIGHT);
  EXPECT_NEAR(world_at(to).x, grabbed.x, 1e-9);
  EXPECT_NEAR(world_at(to).y, grabbed.y, 1e-9);
  EXPECT_EQ(session().goal, goal);
}

TEST_F(GesturesTest, FitShowsEverythingAgain) {
  drag({300.0, 300.0}, {800.0, 700.0}, GLFW_MOUSE_BUTTON_RIGHT);
  drag({100.0, 100.0}, {800.0, 700.0}, GLFW_MOUSE_BUTTON_RIGHT);
  const auto is_visible = [&](const Vector<2>& world) {
    const Vector<2> at = to_screen(camera(), world);
    return at.x > 20.0 && at.y > 20.0 && at.x < camera().size.x - 20.0 && at.y < camera().size.y - 20.0;
  };
  ASSERT_FALSE(is_visible(now().goal));
  press(key::f);
  EXPECT_TRUE(is_visible(now().goal));
  for (const auto& strategy : now().strategies) EXPECT_TRUE(is_visible(strategy.device));
}

TEST_F(GesturesTest, EachPaneOfTheComparisonTakesTheGoal) {
  session().options.compare = Compare::side_by_side;
  frames(3);
  for (std::size_t pane = 0; pane < 3; ++pane) {
    const Vector<2> target{0.002 * static_cast<double>(pane), 0.010};
    const Vector<2> there = on_window(target, pane);
    drag(there - Vector<2>(20.0, 20.0), there);
    frames(10);
    const double point = 1.0 / screen().panes()[pane].camera.points_per_metre;
    EXPECT_NEAR(now().goal.x, target.x, point) << pane;
    EXPECT_NEAR(now().goal.y, target.y, point) << pane;
  }
}

TEST_F(GesturesTest, PanesSideBySideStandStillInADragAndAreZoomedAndMovedAlike) {
  session().options.compare = Compare::side_by_side;
  frames(3);
  const auto cameras = [&] {
    std::vector<Camera> all;
    for (const Pane& pane : screen().panes()) all.push_back(pane.camera);
    return all;
  };
  const std::vector<Camera> fitted = cameras();
  const SceneView shown = session().shown;
  // The picture must not swim under the pointer.
  drag({300.0, 300.0}, {330.0, 420.0});
  frames(5);
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    EXPECT_EQ(cameras()[i].center, fitted[i].center);
    EXPECT_EQ(cameras()[i].points_per_metre, fitted[i].points_per_metre);
  }
  point_at(300.0, 300.0);
  frames(2);
  scroll(3.0);
  const std::vector<Camera> closer = cameras();
  drag({300.0, 300.0}, {320.0, 330.0}, GLFW_MOUSE_BUTTON_RIGHT);
  const std::vector<Camera> moved = cameras();
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    EXPECT_GT(closer[i].points_per_metre, 1.4 * fitted[i].points_per_metre);
    EXPECT_EQ(closer[i].points_per_metre, closer[0].points_per_metre);
    const Vector<2> by = moved[i].center - closer[i].center;
    EXPECT_LT(glm::distance(by, moved[0].center - closer[0].center), 1e-12);
    EXPECT_LT(by.x, 0.0);
  }
  // F fits them to this moment; the one picture has kept its own view.
  press(key::f);
  frames(2);
  EXPECT_LT(glm::distance(cameras()[1].center, now().goal), 0.05);
  EXPECT_NE(cameras()[1].points_per_metre, moved[1].points_per_metre);
  session().options.compare = Compare::overlay;
  frames(2);
  EXPECT_EQ(session().shown.center, shown.center);
  EXPECT_EQ(session().shown.width, shown.width);
  EXPECT_FALSE(session().pane_views) << "who comes back finds them fitted anew";
}

TEST_F(GesturesTest, FitShowsTheArrowToo) {
  session().appearance.arrow_scale = Appearance::greatest_arrow_scale;
  frames(2);
  press(key::f);
  frames(2);
  int arrows = 0;
  for (const Mark& mark : screen().panes()[0].marks) {
    const auto* arrow = std::get_if<Arrow>(&mark.form);
    if (arrow == nullptr || (mark.role != Role::force && mark.role != Role::ghost_force)) continue;
    ++arrows;
    EXPECT_TRUE(contains({Vector<2>(20.0), camera().size - Vector<2>(20.0)}, to_screen(camera(), arrow->tip)));
  }
  EXPECT_GT(arrows, 0);
}

TEST_F(GesturesTest, HandlesWorkWhileAScriptMovesTheGoal) {
  open({.input = "script"}, "fig1");
  drag(dial_head(0.0), dial_head(30.0 * degree));
  EXPECT_NEAR(session().settings.actuated_angle, 30.0 * degree, 1e-9);
}

TEST_F(GesturesTest, WordsOfSceneAndLegendNameWhatTheyAreAbout) {
  std::vector<Term> found;
  for (const Mark& mark : screen().panes()[0].marks) {
    const auto* label = std::get_if<Label>(&mark.form);
    if (label == nullptr) continue;
    const Vector<2> inside = to_screen(camera(), label->anchor) + label->offset + Vector<2>(4.0, 6.0);
    const Mark* const hit = mark_at(screen().panes()[0], window().fonts(), inside, 1.0);
    ASSERT_NE(hit, nullptr) << label->text;
    found.push_back(term_of(*hit).value());
  }
  for (const Term term : {Term::goal, Term::device, Term::proxy, Term::prediction, Term::ghost_force, Term::force,
                          Term::proxy_drift, Term::force_scale, Term::motor_axis}) {
    EXPECT_EQ(std::ranges::count(found, term) > 0, true) << glossary(term).title;
  }
}

TEST_F(GesturesTest, AnArrowIsMeantWhereASpringCrossesIt) {
  for (const Mark& mark : screen().panes()[0].marks) {
    if (mark.role != Role::ghost_force) continue;
    const auto* arrow = std::get_if<Arrow>(&mark.form);
    if (arrow == nullptr) continue;
    const Vector<2> tail = to_screen(camera(), arrow->tail) + arrow->offset;
    const Vector<2> tip = to_screen(camera(), arrow->tip) + arrow->offset;
    EXPECT_EQ(term_of(*mark_at(screen().panes()[0], window().fonts(), 0.5 * (tail + tip), 1.0)), Term::ghost_force);
  }
}

TEST_F(GesturesTest, AnEntryOfTheLegendChoosesItsStrategyAndMovesNoGoal) {
  const Vector<2> goal = session().goal;
  const auto entries = [&] {
    std::vector<Mark> marks = screen().panes()[0].marks;
    std::erase_if(
        marks, [](const Mark& mark) { return mark.role != Role::legend || !std::holds_alternative<Label>(mark.form); });
    return marks;
  };
  // What is chosen changes the legend.
  for (std::size_t i = 0; i < entries().size(); ++i) {
    const Mark mark = entries()[i];
    const auto* label = std::get_if<Label>(&mark.form);
    press_at(in_window(to_screen(camera(), label->anchor) + label->offset + Vector<2>(5.0, 6.0)));
    release();
    if (mark.strategy) {
      EXPECT_EQ(session().settings.active, *mark.strategy);
    }
    EXPECT_EQ(session().goal, goal) << label->text;
  }
}

TEST_F(GesturesTest, APointerOnAMarkExplainsIt) {
  point_at(on_window(now().goal));
  const Image before = picture();
  for (int i = 0; i < 60; ++i) frames(1);
  int tooltips = 0;
  for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
    tooltips += (window->Flags & ImGuiWindowFlags_Tooltip) != 0 && window->WasActive ? 1 : 0;
  }
  EXPECT_EQ(tooltips, 1);
  EXPECT_NE(before, picture());
}

// As far from the edges as words beside it need.
TEST_F(GesturesTest, AllThatThereIsFitsWithAMargin) {
  session().goal = {0.04, 0.0};
  session().settings.wall_point = {-0.04, 0.0};
  const Vector<2> size{800.0, 600.0};
  const SceneView shown = view_of_everything(session(), {}, size, 1.0);
  const Camera fitted = camera_on(shown.center, shown.width, size);
  EXPECT_NEAR(to_screen(fitted, session().settings.wall_point).x, 90.0, 1e-6);
  EXPECT_NEAR(to_screen(fitted, session().goal).x, size.x - 90.0, 1e-6);
}

// News cover nothing that somebody may want to take hold of; a problem has a button that closes it.
TEST_F(GesturesTest, APressOnNewsIsTheScenesAndOneOnAProblemIsNot) {
  for (const bool is_problem : {false, true}) {
    open({.face = Face::stage});
    session().notice =
        Notice{.words = "This is done, and nobody needs to know more about it.", .is_problem = is_problem};
    frames(3);
    const ImVec2 center = ImGui::FindWindowByName("notice")->Rect().GetCenter();
    const Vector<2> place{static_cast<double>(center.x), static_cast<double>(center.y)};
    const Settings settings = session().settings;
    const Vector<2> goal = session().goal;
    drag(place, place + Vector<2>(-60.0, 60.0));
    EXPECT_EQ(session().settings == settings && session().goal == goal, is_problem);
  }
}

}  // namespace
}  // namespace ghostforce::gestures_test
