// The guided measurement of the hand in the window, and numbers against a target.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

#include <imgui_internal.h>

#include "app/picture/glossary.h"
#include "app/shell/preferences.h"
#include "app/state/user_measurement_guide.h"
#include "app/workbench/panel_catalog.h"
#include "core/prediction.h"
#include "tests/app/shell/experiments_window.h"

namespace ghostforce::measurement_window_test {
namespace {

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
      press(key::enter);
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

  click_button("Use this stiffness");
  EXPECT_EQ(session().settings.stiffnesses.believed_k_u, median);
  EXPECT_EQ(measurement().stage, UserMeasurement::Stage::off);
  // The whole of it is one step to take back.
  press(key::z, modifier::control);
  EXPECT_EQ(session().settings, before);
}

TEST_F(ExperimentsWindow, RedoDoesNotEndTheMeasurement) {
  open(with_panel("Measure the hand"));
  session().settings.stiffnesses.chosen_tracking_ratio = 2.5;
  frames(2);
  press(key::z, modifier::control);
  click(start_button);
  ASSERT_TRUE(is_measuring(session()));
  EXPECT_EQ(session().undo_offer.redo, "");
  press(key::y, modifier::control);
  EXPECT_TRUE(is_measuring(session()));
}

TEST_F(ExperimentsWindow, CancelAndUndoRestoreRatioAndStrategy) {
  open(with_panel("Measure the hand"));
  session().settings.stiffnesses.chosen_tracking_ratio = 2.5;
  frames(2);
  const Settings before = session().settings;
  for (const bool by_undo : {false, true}) {
    click(start_button);
    ASSERT_TRUE(is_measuring(session()));
    press(key::equal);
    EXPECT_NE(session().settings, before);
    if (by_undo) {
      press(key::z, modifier::control);
    } else {
      click(cancel_button);
    }
    EXPECT_FALSE(is_measuring(session()));
    EXPECT_EQ(session().settings, before);
  }
  // No step was left behind: the next undo takes back the ratio of 2.5.
  press(key::z, modifier::control);
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
    expect_all_of_it_in_sight("Use this stiffness");
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

// Two hands that differ in nothing but their stiffness, before the wall: where it is not shown, the windows are the same.
TEST_F(ExperimentsWindow, NothingShowsTheAnswerWhileTheHandIsMeasured) {
  const auto picture_with = [this](double k_u, PlotTab tab, bool is_measuring, bool is_revealed) {
    ApplicationOptions options;
    for (const Panel& panel : panel_catalog()) options.folded_panels.emplace(panel.title);
    for (const char* const open_panel : {"Rendering", "Hand", "Measure the hand"}) {
      options.folded_panels.erase(open_panel);
    }
    open(options);
    session().settings.stiffnesses.k_u = k_u;
    session().goal = {-0.02, 0.02};
    session().plots.is_open = tab != PlotTab::time;  // the times in sight are no matter of the hand
    session().plots.tab = tab;
    frames(3);
    if (is_measuring) start_measuring(session());
    session().measurement.first_ratio = 5.0;
    session().settings.stiffnesses.chosen_tracking_ratio = 5.0;
    if (is_revealed) reveal_hand(session());
    // To a rest to the last pixel, and then at the same time.
    frames(20, ticks);
    session().options.trails = false;
    session().paused = true;
    // Words find their place anew, whichever way the devices came.
    session().appearance.scale = 1.25;
    frames(3, 0);
    session().appearance.scale = 1.0;
    frames(40, 0);
    frames(5, 0);
    return picture();
  };
  for (const PlotTab tab : {PlotTab::time, PlotTab::wall_angle, PlotTab::ratio, PlotTab::hand}) {
    SCOPED_TRACE(static_cast<int>(tab));
    EXPECT_NE(picture_with(200.0, tab, false, false), picture_with(310.0, tab, false, false));
    EXPECT_EQ(picture_with(200.0, tab, true, false), picture_with(310.0, tab, true, false));
    EXPECT_NE(picture_with(200.0, tab, true, true), picture_with(310.0, tab, true, true));
  }
}

TEST_F(ExperimentsWindow, TheGivenStiffnessIsShownWhenItIsAskedFor) {
  open(with_panel("Measure the hand"));
  EXPECT_FALSE(hides_answer(session()));
  start_measuring(session());
  frames(3, ticks);
  EXPECT_TRUE(hides_answer(session()));
  EXPECT_EQ(count_marks(Role::prediction), 0) << "theory knows the hand";
  take_readings(readings_wanted);
  ASSERT_EQ(measurement().stage, UserMeasurement::Stage::done);
  EXPECT_TRUE(measurement().was_blind);
  EXPECT_TRUE(hides_answer(session())) << "the result first";
  frames(3);
  click_button("Reveal the given stiffness");
  EXPECT_FALSE(hides_answer(session()));
  EXPECT_TRUE(measurement().was_blind);
  frames(2);
  EXPECT_GT(count_marks(Role::prediction), 0);

  start_measuring(session());
  EXPECT_TRUE(hides_answer(session()));
  frames(2);  // whose hand it is has been seen: revealing is offered
  reveal_hand(session());
  take_readings(readings_wanted);
  ASSERT_EQ(measurement().stage, UserMeasurement::Stage::done);
  EXPECT_FALSE(measurement().was_blind) << "it was shown on the way";
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
  act(OpenScene{"fig1"});
  frames(3);
  EXPECT_FALSE(is_measuring(session()));
  EXPECT_EQ(session().settings, load_scene("fig1").settings) << "nothing of the old scene comes back";
}

// The marks that a file of lines and letters would hold.
TEST_F(ExperimentsWindow, AFileShowsAndHidesWhatTheScreenDoes) {
  const auto roles_of = [](const std::vector<Pane>& panes) {
    std::multiset<Role> roles;
    for (const Mark& mark : panes.front().marks) {
      if (mark.role == Role::prediction || mark.role == Role::target || mark.role == Role::area)
        roles.insert(mark.role);
    }
    return roles;
  };
  const auto roles_in_file = [&] {
    return roles_of(screen().panes_for_file(session(), application_->shown(), application_->history(),
                                            application_->reading(), measure_with(window_->fonts())));
  };
  open_virtual_falcon(with_panel("Measure the hand"));
  EXPECT_GT(roles_in_file().count(Role::prediction), 0U);
  start_measuring(session());
  frames(40);  // words take a moment to find their place
  EXPECT_EQ(roles_in_file().count(Role::prediction), 0U) << "theory knows the hand";
  EXPECT_EQ(roles_in_file().count(Role::target), 4U) << "line, two rings and words";
  EXPECT_EQ(roles_in_file(), roles_of(screen().panes()));

  ApplicationOptions circling = with_panel("Round and round");
  circling.input = "circle";
  open(circling);
  frames(16, 500);
  EXPECT_GT(roles_in_file().count(Role::area), 0U) << "the loop of the last turn";
  EXPECT_EQ(roles_in_file(), roles_of(screen().panes()));
}

// Nobody was given the stiffness of a real hand.
TEST_F(ExperimentsWindow, NothingIsOfferedToBeRevealedOfARealHand) {
  const auto offers_to_reveal = [] {
    return std::ranges::any_of(words_on_screen(), [](const ScreenWords& words) { return words.text == "Reveal"; });
  };
  open_virtual_falcon(with_panel("Hand"));
  start_measuring(session());
  frames(3);
  EXPECT_TRUE(offers_to_reveal()) << "the hand at a virtual device is simulated";
  session().hand_is_simulated = false;
  frames(3);
  EXPECT_TRUE(hides_answer(session()));
  EXPECT_FALSE(offers_to_reveal());
  reveal_hand(session());
  EXPECT_TRUE(measurement().was_blind);
}

// A real device's driver with a simulated arm and hand behind it: its goal is not known, so it has a target to aim at.
TEST_F(ExperimentsWindow, AHandOnADeviceIsMeasuredAgainstATarget) {
  open_virtual_falcon(with_panel("Measure the hand"));
  lead_to({-0.015, 0.015});
  start_measuring(session());
  frames(40);  // words take a moment to find their place
  ASSERT_TRUE(measurement().target);
  EXPECT_LT(glm::length(*measurement().target), 1e-15) << "the foot of the scene's last waypoint";
  EXPECT_EQ(count_marks(Role::target), 4) << "line, two rings and words";
  EXPECT_EQ(measurement().step, MeasuringStep::arm);
  ++session().arms_asked;
  ASSERT_TRUE(frames_until(6.0, [&] { return application_->report().motors.state == SafetyState::on; }));
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

// Nobody knows the goal of a hand at a device. With a target to aim at there are numbers, of the strategy in the hand
// alone, and they are those of the hand that is behind the device, not of the one that is believed to be there.
TEST_F(ExperimentsWindow, AHandThatAimsAtATargetHasNumbersAgainstIt) {
  open_virtual_falcon(with_panel("Live values"));
  const auto numbers_known = [&](StrategyId id) {
    return is_known(quantity_catalog()[1], now(), id) && is_known(quantity_catalog()[2], now(), id);
  };
  session().settings.active = StrategyId::naive;
  lead_to({-0.015, 0.015});
  ++session().arms_asked;
  ASSERT_TRUE(frames_until(6.0, [&] { return application_->report().motors.state == SafetyState::on; }));
  lead_to({0.008, -0.008});
  frames(5, ticks);
  ASSERT_EQ(now().measured, StrategyId::naive);
  EXPECT_FALSE(numbers_known(StrategyId::naive));
  EXPECT_EQ(count_marks(Role::target), 0);
  EXPECT_EQ(count_marks(Role::proxy_drift), 0);

  session().aims_at_target = true;
  frames(40, ticks);  // words take a moment to find their place
  EXPECT_EQ(count_marks(Role::target), 4);
  ASSERT_TRUE(numbers_known(StrategyId::naive));
  EXPECT_FALSE(numbers_known(StrategyId::anisotropic)) << "it is only simulated beside the device";
  EXPECT_GT(count_marks(Role::proxy_drift), 0);
  ASSERT_FALSE(application_->report().motors.is_saturated);
  // What theory says of the hand behind the device, whose goal and stiffness this test knows.
  const auto expect_as_predicted = [&](StrategyId id) {
    const PredictedEquilibrium predicted = predicted_equilibria(session().settings, session().goal)[index_of(id)];
    const StrategySnapshot<2>& seen = now().strategies[index_of(id)];
    // Encoders and friction of the simulated arm: some tenths of a millimetre, and those times k_r/(1 + κ).
    EXPECT_NEAR(glm::distance(seen.proxy_drift, predicted.proxy_drift), 0.0, 0.0006);
    EXPECT_NEAR(glm::distance(seen.ghost_force, predicted.ghost_force), 0.0, 0.1);
    return glm::length(seen.ghost_force);
  };
  EXPECT_GT(expect_as_predicted(StrategyId::naive), 0.4);

  session().settings.active = StrategyId::anisotropic;
  frames(20, ticks);
  ASSERT_TRUE(numbers_known(StrategyId::anisotropic));
  EXPECT_LT(expect_as_predicted(StrategyId::anisotropic), 0.1);
  // The inferred goal would say that this is as good; the target says that it is not.
  session().settings.stiffnesses.believed_k_u = 800.0;
  frames(20, ticks);
  EXPECT_GT(glm::length(now().strategies[index_of(StrategyId::anisotropic)].ghost_force), 0.2);
  // In the plots too, and in the past.
  const PlotBucket* const newest = application_->history().plots().at(now().time_s);
  ASSERT_NE(newest, nullptr);
  EXPECT_GT(newest->least[1][index_of(StrategyId::anisotropic)], 0.2);
  EXPECT_TRUE(std::isnan(newest->least[1][index_of(StrategyId::naive)]));
  session().offs_asked++;
  frames(2);
}

}  // namespace
}  // namespace ghostforce::measurement_window_test
