// The experiments in the window: the guided measurement of the hand, and the circle test.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <optional>
#include <vector>

#include <imgui_internal.h>

#include "app/session/measurement_guide.h"
#include "app/ui/panels/panel_catalog.h"
#include "core/energy.h"
#include "core/ghost_force.h"
#include "tests/app/live/driven_window.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {
namespace {

class ExperimentsWindow : public DrivenWindow {
 protected:
  // All panels folded but one.
  static ApplicationOptions with_panel(std::string_view open_panel) {
    ApplicationOptions options;
    for (const Panel& panel : panel_catalog()) {
      if (panel.title != open_panel) options.folded_panels.emplace(panel.title);
    }
    return options;
  }
  // Where things are at 1280×800 with that panel alone open.
  static constexpr Vector<2> start_button{930.0, 199.0};
  static constexpr Vector<2> take_button{900.0, 321.0};
  static constexpr Vector<2> cancel_button{995.0, 321.0};
  static constexpr Vector<2> believe_button{890.0, 340.0};
  static constexpr Vector<2> circle_button{905.0, 205.0};
  static constexpr Vector<2> end_circle_button{930.0, 170.0};
  static constexpr Vector<2> clockwise_box{1012.0, 202.0};
  static constexpr float button_x = 40.0F;  // in the column
  static constexpr double radius_y = 231.0;
  static constexpr double slider_left = 1012.0;
  static constexpr double slider_right = 1254.0;
  static constexpr double slider_y = 290.0;

  // Few frames and many ticks: drawing is what takes the time.
  static constexpr int ticks = 200;

  void click(const Vector<2>& at) {
    press_at(at);
    release();
  }
  UserMeasurement& measurement() { return session().measurement; }
  // The heights between which the first button of a row can be clicked in the column of panels; empty: nowhere.
  std::optional<ImVec2> clickable(const char* button) {
    ImGuiWindow& column = *ImGui::FindWindowByName("panels");
    const ImGuiID wanted = column.GetID(button);
    const auto is_there = [&](float y) {
      point_at(static_cast<double>(column.Pos.x + button_x), static_cast<double>(y));
      frames(1, 0);
      return ImGui::GetCurrentContext()->HoveredId == wanted;
    };
    const float end = column.Pos.y + column.Size.y;
    float y = column.Pos.y;
    while (y < end && !is_there(y)) y += 10.0F;
    if (y >= end) return std::nullopt;
    ImVec2 range{y, y};
    while (is_there(range.x - 1.0F)) range.x -= 1.0F;
    while (is_there(range.y + 1.0F)) range.y += 1.0F;
    return range;
  }
  void expect_all_of_it_in_sight(const char* button) {
    const std::optional<ImVec2> found = clickable(button);
    ASSERT_TRUE(found) << button;
    EXPECT_GE(found->y - found->x, ImGui::GetFrameHeight() - 2.0F) << button;
  }
  // With the ratio that is right for the hand, known to the test.
  void take_readings(std::size_t count) {
    const Stiffnesses& k = session().settings.stiffnesses;
    for (std::size_t i = 0; i < count; ++i) {
      session().settings.stiffnesses.chosen_tracking_ratio = optimal_tracking_ratio(k.k_r, k.k_u);
      frames(5, ticks);
      take_reading(session());
    }
  }
  // As a person does: drags the slider of ρ, this way and that, until the drift is gone.
  void null_the_drift() {
    double low = slider_left;
    double high = slider_right;
    press_at({0.5 * (low + high), slider_y});
    while (high - low > 1.0) {
      const double middle = std::floor(0.5 * (low + high));
      point_at(middle, slider_y);
      frames(2, ticks);
      ASSERT_TRUE(measurement().drift);
      (*measurement().drift > 0.0 ? low : high) = middle;
    }
    // Of the two nearest points, the better one.
    const double at_high = std::abs(measurement().drift.value_or(1.0));
    point_at(low, slider_y);
    frames(2, ticks);
    if (std::abs(measurement().drift.value_or(1.0)) > at_high) point_at(high, slider_y);
    frames(2, ticks);
    release();
    frames(2, ticks);
  }
};

TEST_F(ExperimentsWindow, MeasuresTheHandWithTheMouse) {
  open(with_panel("Measure the hand"));
  session().settings.stiffnesses.believed_k_u = 130.0;
  frames(2);
  const Settings before = session().settings;
  const double k_u = before.stiffnesses.k_u;
  click(start_button);
  ASSERT_TRUE(is_measuring(session()));
  EXPECT_EQ(session().settings.active, StrategyId::anisotropic);
  EXPECT_EQ(measurement().target, std::nullopt) << "the goal of a simulated hand is given";

  int from_above = 0;
  int from_below = 0;
  std::vector<double> starts;
  for (std::size_t i = 0; i < readings_wanted; ++i) {
    SCOPED_TRACE(i);
    ASSERT_EQ(measurement().readings.size(), i);
    frames(2, ticks);
    starts.push_back(tracking_ratio(session().settings.stiffnesses));
    (*measurement().drift > 0.0 ? from_below : from_above) += 1;
    EXPECT_GT(std::abs(*measurement().drift), null_drift(measurement()));
    click(take_button);
    EXPECT_EQ(measurement().readings.size(), i) << "too early";
    EXPECT_TRUE(measurement().was_refused);
    null_the_drift();
    ASSERT_EQ(measurement().step, MeasuringStep::take) << words_for(measurement().step, false);
    if (i % 2 == 0) {
      click(take_button);
    } else {
      press(GLFW_KEY_ENTER);
    }
  }
  EXPECT_GT(from_above, 0);
  EXPECT_GT(from_below, 0);
  std::ranges::sort(starts);
  EXPECT_EQ(std::ranges::adjacent_find(starts), starts.end()) << "never the same way twice";

  ASSERT_EQ(measurement().stage, UserMeasurement::Stage::done);
  EXPECT_EQ(session().settings, before) << "ratio and strategy are as they were";
  const double median = spread_of(measurement()).median;
  // A drift of 0.2 mm counts as none. Near ρ° it is d √(α(1−α)) Δρ/ρ = 20 mm · ½ · Δρ/ρ, so ρ is within 2 %, and
  // k_u = k_r/(ρ − 1) within 2 % · ρ/(ρ − 1) = 2.7 %.
  EXPECT_NEAR(median, k_u, 0.027 * k_u);

  click(believe_button);
  EXPECT_EQ(session().settings.stiffnesses.believed_k_u, median);
  EXPECT_EQ(measurement().stage, UserMeasurement::Stage::off);
  // The whole of it is one step to take back.
  press(GLFW_KEY_Z, GLFW_MOD_CONTROL);
  EXPECT_EQ(session().settings, before);
}

TEST_F(ExperimentsWindow, CancelAndUndoRestoreRatioAndStrategy) {
  open(with_panel("Measure the hand"));
  session().settings.stiffnesses.chosen_tracking_ratio = 2.5;
  frames(2);
  const Settings before = session().settings;
  for (const bool by_undo : {false, true}) {
    click(start_button);
    ASSERT_TRUE(is_measuring(session()));
    press(GLFW_KEY_EQUAL);
    EXPECT_NE(session().settings, before);
    if (by_undo) {
      press(GLFW_KEY_Z, GLFW_MOD_CONTROL);
    } else {
      click(cancel_button);
    }
    EXPECT_FALSE(is_measuring(session()));
    EXPECT_EQ(session().settings, before);
  }
  // No step was left behind: the next undo takes back the ratio of 2.5.
  press(GLFW_KEY_Z, GLFW_MOD_CONTROL);
  EXPECT_EQ(session().settings, load_scene("wall45").settings);
}

TEST_F(ExperimentsWindow, SaysWhatToDoInsteadOfTaking) {
  open(with_panel("Measure the hand"));
  click(start_button);
  const auto expect_step = [&](MeasuringStep step) {
    frames(4, ticks);
    EXPECT_EQ(measurement().step, step) << words_for(measurement().step, false);
    take_reading(session());
    EXPECT_TRUE(measurement().readings.empty());
    EXPECT_TRUE(measurement().was_refused);
  };
  expect_step(MeasuringStep::lower_ratio);
  session().settings.stiffnesses.chosen_tracking_ratio = 2.0;
  expect_step(MeasuringStep::raise_ratio);
  session().goal = {-0.02, 0.02};
  expect_step(MeasuringStep::press);
  EXPECT_EQ(measurement().drift, std::nullopt);
  session().goal = {0.0142, -0.0141};
  session().paused = true;
  expect_step(MeasuringStep::go_on);
  session().paused = false;
  session().settings.active = StrategyId::naive;
  expect_step(MeasuringStep::choose_a);
  session().settings.active = StrategyId::anisotropic;
  session().settings.wall_normal_angle = std::numbers::pi;
  expect_step(MeasuringStep::turn_wall);
  session().settings = load_scene("wall45").settings;
  session().settings.active = StrategyId::anisotropic;
  session().settings.stiffnesses.k_r = 0.0;
  expect_step(MeasuringStep::render);
  session().settings.stiffnesses.k_r = 600.0;
  frames(2, ticks);
  // Just turned to where there is no drift: not at rest yet.
  session().settings.stiffnesses.chosen_tracking_ratio = 4.0;
  for (int i = 0; i < 50 && measurement().step != MeasuringStep::hold_still; ++i) frames(1, 20);
  EXPECT_EQ(measurement().step, MeasuringStep::hold_still);
  frames(4, ticks);
  EXPECT_EQ(measurement().step, MeasuringStep::take);
}

// Whatever else is open, in the smallest window that the program is made for too.
TEST_F(ExperimentsWindow, WhatIsToBePressedIsInSight) {
  struct Case {
    int width;
    int height;
    const char* input;
  };
  for (const Case& c : {Case{1024, 640, "mouse"}, Case{1280, 800, "mouse"}, Case{1280, 800, "virtual-falcon"}}) {
    SCOPED_TRACE(testing::Message() << c.width << "x" << c.height << ' ' << c.input);
    ApplicationOptions options;
    options.folded_panels = panels_folded_at_first(c.height);
    options.folded_panels.erase("Measure the hand");
    options.input = c.input;
    options.input_options.virtual_falcon_clock = VirtualLink::Clock::stepped;
    open(options, "wall45", c.width, c.height);
    const std::optional<ImVec2> start = clickable("Start measuring");
    ASSERT_TRUE(start);
    click({static_cast<double>(ImGui::FindWindowByName("panels")->Pos.x + button_x),
           static_cast<double>(0.5F * (start->x + start->y))});
    ASSERT_TRUE(is_measuring(session()));
    frames(2);
    expect_all_of_it_in_sight("Take   Enter");
    EXPECT_FALSE(measurement().has_news);

    // The last reading may be taken while the column has been scrolled elsewhere.
    ImGui::SetScrollY(ImGui::FindWindowByName("panels"), 0.0F);
    measurement().readings.assign(readings_wanted, {4.0, 200.0});
    measurement().stage = UserMeasurement::Stage::done;
    measurement().has_news = true;
    frames(3);
    expect_all_of_it_in_sight("Believe it");
  }
}

TEST_F(ExperimentsWindow, TheResultIsComparedWithTheHandThatWasMeasured) {
  open(with_panel("Measure the hand"));
  start_measuring(session());
  take_readings(readings_wanted);
  ASSERT_EQ(measurement().stage, UserMeasurement::Stage::done);
  EXPECT_EQ(measurement().given_k_u, 200.0);
  session().settings.stiffnesses.k_u = 881.0;
  frames(3);
  EXPECT_EQ(measurement().given_k_u, 200.0);
  EXPECT_NEAR(spread_of(measurement()).median, 200.0, 1e-9);
}

TEST_F(ExperimentsWindow, ReadingsOfAnotherHandBeginAnew) {
  open(with_panel("Measure the hand"));
  start_measuring(session());
  session().settings.stiffnesses.chosen_tracking_ratio = 4.0;
  frames(5, ticks);
  take_reading(session());
  ASSERT_EQ(measurement().readings.size(), 1U);
  session().settings.stiffnesses.believed_k_u = 150.0;
  frames(2);
  EXPECT_EQ(measurement().readings.size(), 1U) << "what is believed is no part of it";
  session().settings.stiffnesses.k_u = 300.0;
  frames(2);
  EXPECT_TRUE(measurement().readings.empty());
  EXPECT_TRUE(measurement().has_begun_anew);
  session().settings.stiffnesses.k_u = 310.0;  // as in the second frame of a drag
  frames(2);
  EXPECT_TRUE(measurement().has_begun_anew) << "it is still to be told";
  take_readings(1);
  ASSERT_EQ(measurement().readings.size(), 1U);
  EXPECT_FALSE(measurement().has_begun_anew);
  session().requests.open_scene = "fig1";
  frames(3);
  EXPECT_FALSE(is_measuring(session()));
  EXPECT_EQ(session().settings, load_scene("fig1").settings) << "nothing of the old scene comes back";
}

TEST_F(ExperimentsWindow, AWrongBeliefShowsAsDrift) {
  open(with_panel("User"));
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
  open(with_panel("User"));
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
  press(GLFW_KEY_ENTER);
  frames(3);
  EXPECT_TRUE(std::filesystem::exists(folder / "mine.csv"));
}

TEST_F(ExperimentsWindow, TheCircleStaysInThePictureAndADragEndsIt) {
  ApplicationOptions options = with_panel("Energy");
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
  open(with_panel("Energy"));
  click(circle_button);
  EXPECT_EQ(session().input, "circle");
  for (const bool is_clockwise : {false, true}) {
    if (is_clockwise) click(clockwise_box);
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
  click(end_circle_button);
  EXPECT_EQ(session().input, "mouse");
  EXPECT_FALSE(application_->reading().circle);
}

TEST_F(ExperimentsWindow, TheCircleFollowsTheWallAndBeginsAnew) {
  ApplicationOptions options = with_panel("Energy");
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
  press(GLFW_KEY_R);
  EXPECT_EQ(application_->reading().circle->turns, 0);
}

// A real device's driver with a simulated arm and hand behind it: its goal is not known, so it has a target to aim at.
TEST_F(ExperimentsWindow, AHandOnADeviceIsMeasuredAgainstATarget) {
  ApplicationOptions options = with_panel("Measure the hand");
  options.input = "virtual-falcon";
  options.input_options.virtual_falcon_clock = VirtualLink::Clock::stepped;
  open(options);
  const auto lead_to = [&](const Vector<2>& goal) {
    const Vector<2> from = session().goal;
    for (int i = 1; i <= 10; ++i) {
      session().goal = glm::mix(from, goal, i / 10.0);
      frames(1, ticks / 2);
    }
    frames(10, ticks / 2);
  };
  for (int i = 0; i < 300 && virtual_falcon().report().state != FalconState::idle; ++i) frames(1, 100);
  lead_to({-0.015, 0.015});
  start_measuring(session());
  frames(40);  // words take a moment to find their place
  ASSERT_TRUE(measurement().target);
  EXPECT_LT(glm::length(*measurement().target), 1e-15) << "the foot of the scene's last waypoint";
  EXPECT_EQ(count_marks(Role::target), 4) << "line, two rings and words";
  EXPECT_EQ(measurement().step, MeasuringStep::arm);
  ++session().arms_asked;
  for (int i = 0; i < 60 && application_->report().motors.state != SafetyState::on; ++i) frames(1, 100);
  ASSERT_EQ(application_->report().motors.state, SafetyState::on);
  frames(2);
  EXPECT_EQ(measurement().step, MeasuringStep::press);
  lead_to({0.012, -0.012});
  frames(10, ticks);
  ASSERT_TRUE(measurement().drift);
  EXPECT_GT(count_marks(Role::proxy_drift), 0) << "a ruler from the target";

  double low = 1.0;
  double high = 30.0;
  for (int i = 0; i < 8; ++i) {
    const double ratio = std::sqrt(low * high);
    session().settings.stiffnesses.chosen_tracking_ratio = ratio;
    frames(8, ticks);
    ASSERT_TRUE(measurement().drift);
    (*measurement().drift > 0.0 ? low : high) = ratio;
  }
  frames(4, ticks);
  ASSERT_EQ(measurement().step, MeasuringStep::take) << words_for(measurement().step, true);
  take_reading(session());
  ASSERT_EQ(measurement().readings.size(), 1U);
  // The last of eight halvings of 1 … 30 leaves 1.3 % of ρ; encoders and the drift that averages to none, 12 mm deep, a
  // few per cent more, times ρ/(ρ − 1).
  const double k_u = session().settings.stiffnesses.k_u;
  EXPECT_NEAR(measurement().readings[0].k_u, k_u, 0.1 * k_u);
  session().offs_asked++;
  frames(2);
}

}  // namespace
}  // namespace ghostforce
