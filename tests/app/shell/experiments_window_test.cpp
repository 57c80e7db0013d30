// The experiments in the window besides the guided measurement: beliefs, round and round, the panels themselves.
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <optional>
#include <vector>

#include <imgui_internal.h>

#include "app/shell/preferences.h"
#include "core/ghost_force.h"
#include "tests/app/shell/experiments_window.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::experiments_window_test {
namespace {

// What the stage does too is called the same there.
TEST(Panels, AreCalledAsTheModesOfTheStage) {
  EXPECT_EQ(round_panel, english_stage.modes.round.title);
  EXPECT_EQ(measuring_panel, english_stage.modes.measure.title);
}

TEST_F(ExperimentsWindow, AWrongBeliefShowsAsDrift) {
  open(with_panel("Hand"));
  const Image right = picture();
  session().settings.stiffnesses.believed_k_u = 60.0;
  frames(10, ticks);
  EXPECT_NE(picture(), right);
  const Vector<2> seen = now().strategies[index_of(StrategyId::anisotropic)].proxy_drift;
  const Equilibrium<2> rest = equilibrium_of(StrategyId::anisotropic, session().settings, now().goal);
  // ρ = 11 instead of 4 on a wall at 45°: d/2 · (ρ* − ρ)/((ρ* + ρ)/2), all but hard.
  EXPECT_NEAR(glm::length(seen), 0.020 * 0.5 * 7.0 / 7.5, 1e-4);
  EXPECT_NEAR(glm::length(seen), glm::length(proxy_drift(wall_of(session().settings), rest.proxy, now().goal)), 1e-9);
}

// A ratio that was chosen by hand is no belief.
TEST_F(ExperimentsWindow, ARatioChosenByHandShowsNoDriftOfTheBelief) {
  open(with_panel("Hand"));
  const auto column = [this] {
    frames(5, ticks);
    const Image whole = picture();
    const auto left = static_cast<int>(ImGui::FindWindowByName("panels")->Pos.x);
    std::vector<std::uint8_t> part;
    for (int y = 46; y < 400; ++y) {
      const auto begin = whole.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * whole.width + left);
      part.insert(part.end(), begin, begin + 3 * static_cast<std::ptrdiff_t>(whole.width - left));
    }
    return part;
  };
  const auto optimal = column();
  session().settings.stiffnesses.chosen_tracking_ratio = 2.0;
  const auto chosen = column();
  EXPECT_NE(chosen, optimal);
  session().settings.stiffnesses.chosen_tracking_ratio = 12.0;
  EXPECT_EQ(column(), chosen) << "another drift, of which nothing is shown";
}

TEST_F(ExperimentsWindow, AScrollbarMakesNothingNarrower) {
  open({.folded_panels = panels_folded_at_first(640.0)}, "wall45", 1024, 640);
  const ImGuiWindow& column = *ImGui::FindWindowByName("panels");
  ASSERT_FALSE(column.ScrollbarY);
  const float width = column.WorkRect.GetWidth();
  session().folded_panels.clear();
  frames(3);
  ASSERT_TRUE(column.ScrollbarY);
  EXPECT_EQ(column.WorkRect.GetWidth(), width);
  EXPECT_LE(column.WorkRect.Max.x, column.InnerClipRect.Max.x) << "nothing lies beneath it";
}

TEST_F(ExperimentsWindow, TheFirstRecordingCanBeNamed) {
  const TemporaryFolder folder;
  open(with_panel("Recording"));
  click_at(1150.0, 237.0);
  ASSERT_TRUE(ImGui::GetIO().WantTextInput);
  type(folder / "mine.csv");
  press(key::enter);
  frames(3);
  EXPECT_TRUE(std::filesystem::exists(folder / "mine.csv"));
}

TEST_F(ExperimentsWindow, TheCircleStaysInThePictureAndADragEndsIt) {
  ApplicationOptions options = with_panel("Round and round");
  options.input = "circle";
  open(options);
  frames(3);
  drag({1100.0, radius_y}, {1275.0, radius_y});
  frames(3);
  const Circle circle = application_->reading().circle->circle;
  ASSERT_TRUE(session().circle_test.choice.radius);
  EXPECT_GT(circle.radius, 0.010);
  EXPECT_LT(circle.radius, 0.050);
  const Pane& pane = screen().panes().front();
  for (double t = 0.0; t < 4.0; t += 0.05) {
    const Vector<2> at = to_screen(pane.camera, position_on(circle, t));
    EXPECT_TRUE(at.x >= 0.0 && at.y >= 0.0 && at.x <= pane.camera.size.x && at.y <= pane.camera.size.y) << t;
  }

  const Vector<2> somewhere = on_window({-0.02, -0.005});
  click(somewhere);
  EXPECT_EQ(session().input, "circle") << "a click is no drag";
  press_at(somewhere);
  point_at(on_window({-0.01, -0.005}));
  frames(4);
  EXPECT_EQ(session().input, "mouse");
  EXPECT_NEAR(glm::distance(session().goal, Vector<2>(-0.01, -0.005)), 0.0, 1e-3);
  release();
}

TEST_F(ExperimentsWindow, ACircleHasTheEnergyOfTheFormulaInEitherSense) {
  open(with_panel("Round and round"));
  click(circle_button);
  EXPECT_EQ(session().input, "circle");
  for (const bool is_clockwise : {true, false}) {
    if (!is_clockwise) click(clockwise_box);
    EXPECT_EQ(session().circle_test.choice.is_clockwise, is_clockwise);
    for (const double ratio : {1.0, 4.0, 12.0}) {
      SCOPED_TRACE(testing::Message() << is_clockwise << ' ' << ratio);
      session().settings.stiffnesses.chosen_tracking_ratio = ratio;
      frames(3);
      // At 4 s a turn: the way to the circle, a quarter to settle, and two turns.
      frames(24, 500);
      const CircleReading reading = *application_->reading().circle;
      ASSERT_GE(reading.turns, 2);
      for (const Strategy& entry : strategy_catalog()) {
        const CircleEnergy& energy = reading.strategies[index_of(entry.id)];
        EXPECT_TRUE(energy.stays_inside);
        EXPECT_EQ(energy.mean.area < 0.0, is_clockwise);
        EXPECT_NEAR(energy.last.energy, energy.mean.energy, 1e-6);
        // What the delay takes and gives is at most k_r dt ∫v² dt and 1.5 times as much (core/energy.h), with the
        // goal's speed as the device's: 600 N/m · 1 ms · (15.7 mm/s)² · 4 s = 0.6 mJ.
        if (entry.has_every_motor) {
          EXPECT_EQ(energy.predicted, 0.0);
          EXPECT_LT(std::abs(energy.last.energy), 0.6e-3);
          continue;
        }
        // A third of that where one motor does a third of the way: 3 % of the least of these energies, of 10 mJ.
        EXPECT_GT(std::abs(energy.predicted), 8e-3);
        EXPECT_NEAR(energy.last.energy / energy.predicted, 1.0, 0.03) << entry.name;
        EXPECT_EQ(energy.last.energy > 0.0, is_clockwise) << "one sense makes it, the other takes it away";
      }
    }
  }
  click(circle_button);
  EXPECT_EQ(session().input, "mouse");
  EXPECT_FALSE(application_->reading().circle);
}

// The circle is near to where the person's goal was, and so is the goal afterwards.
TEST_F(ExperimentsWindow, TheCircleTestKeepsADraggedGoal) {
  open(with_panel("Round and round"));
  const Vector<2> first = session().goal;
  drag(on_window(first), on_window({0.030, 0.012}));
  frames(5, ticks);
  const Vector<2> goal = session().goal;
  ASSERT_GT(glm::distance(goal, first), 0.02);
  const std::optional<ImVec2> start = clickable("Go round and round###circle");
  ASSERT_TRUE(start);
  click_button("Go round and round###circle");
  frames(3);
  EXPECT_EQ(session().input, "circle");
  const Circle circle = application_->reading().circle->circle;
  EXPECT_EQ(circle, circle_inside(wall_of(session().settings), goal, session().circle_test.choice));
  EXPECT_LT(glm::distance(circle.center, goal), 0.02);
  frames(5, 100);
  EXPECT_LT(glm::distance(now().goal, goal), 0.05) << "it comes from where the goal was";
  const std::optional<ImVec2> end = clickable("Stop###circle");
  ASSERT_TRUE(end);
  EXPECT_EQ(end->x, start->x) << "the button stays where it is";
  EXPECT_EQ(end->y, start->y);
  click_button("Stop###circle");
  frames(3, ticks);
  EXPECT_EQ(session().input, "mouse");
  EXPECT_EQ(session().goal, goal);
  EXPECT_EQ(now().goal, goal);
  // At rest there from the first tick on.
  const Equilibrium<2> rest = equilibrium_of(StrategyId::anisotropic, session().settings, goal);
  EXPECT_NEAR(glm::distance(now().strategies[index_of(StrategyId::anisotropic)].device, rest.device), 0.0, 1e-6);
}

// Whichever way motor and wall are turned, the sense in which the circle begins is the one that makes energy, as the
// words in the panel say.
TEST_F(ExperimentsWindow, TheCircleTestBeginsInTheSenseThatMakesEnergy) {
  for (const double motor : {0.0, -0.5 * std::numbers::pi}) {
    SCOPED_TRACE(motor);
    open(with_panel("Round and round"));
    session().settings.actuated_angle = motor;
    frames(3);
    EXPECT_EQ(count_marks(Role::area), 0);
    click(circle_button);
    frames(16, 500);
    const CircleReading reading = *application_->reading().circle;
    ASSERT_GE(reading.turns, 1);
    EXPECT_GT(reading.strategies[index_of(StrategyId::naive)].last.energy, 0.005);
    EXPECT_EQ(count_marks(Role::area, session().settings.active), 161) << "an outline and what it encloses";
  }
}

TEST_F(ExperimentsWindow, TheCircleFollowsTheWallAndBeginsAnew) {
  ApplicationOptions options = with_panel("Round and round");
  options.input = "circle";
  open(options);
  frames(16, 500);
  ASSERT_GE(application_->reading().circle->turns, 1);
  session().settings.wall_normal_angle = -0.5;  // the circle's middle would be in front of this wall
  frames(3);
  EXPECT_EQ(application_->reading().circle->turns, 0);
  frames(16, 500);
  ASSERT_GE(application_->reading().circle->turns, 1);
  const CircleReading reading = *application_->reading().circle;
  for (const CircleEnergy& energy : reading.strategies) EXPECT_TRUE(energy.stays_inside);
  press(key::r);
  EXPECT_EQ(application_->reading().circle->turns, 0);
}

}  // namespace
}  // namespace ghostforce::experiments_window_test
