// While something is dragged slowly, the words of the workbench go with what they name, and legend and scale bars stand
// still.
#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "core/conventions.h"
#include "tests/app/picture/label_unrest.h"
#include "tests/app/picture/workbench_case.h"

namespace ghostforce::workbench_drag_test {
namespace {

const MeasureText measure = measure_vector_text;
constexpr double frame_s = 1.0 / 60.0;
const Vector<2> usual_goal{0.02, -0.02};

WorkbenchCase usual(StrategyId active, const Vector<2>& window) {
  WorkbenchCase shown;
  shown.settings.wall_normal_angle = 0.75 * std::numbers::pi;
  shown.settings.stiffnesses = {
      .k_u = 200.0, .believed_k_u = {}, .k_r = 600.0, .k_t = 600.0, .k_c = 1e5, .chosen_tracking_ratio = {}};
  shown.settings.active = active;
  shown.size = scene_size_in(window, 1.0, false);
  shown.shown.width = 0.12;
  return shown;
}

Unrest drag(WorkbenchCase shown, int steps, const std::function<void(WorkbenchCase&, int)>& move_to) {
  Unrest unrest;
  PictureMemory memory;
  std::vector<std::optional<Seen>> before(strategy_count);
  for (int step = 0; step <= steps; ++step) {
    move_to(shown, step);
    const std::vector<Pane> panes = shown.compose(memory, frame_s);
    // They do not follow what is dragged.
    if (step == 0) shown.pane_views = fitted_pane_views(shown.content());
    for (std::size_t i = 0; i < panes.size(); ++i) {
      Seen now(panes[i], measure, shown.text_scale());
      const double bound = 3.0 * shown.text_scale() + 1.0;
      if (before[i]) add_unrest(*before[i], now, bound, fmt::format("step {} of pane {}", step, i), unrest);
      before[i].emplace(std::move(now));
    }
  }
  return unrest;
}

struct Sum {
  int drags = 0;
  int changes = 0;
  int most = 0;

  void add(const Unrest& unrest) {
    ++drags;
    changes += unrest.sum();
    most = std::max(most, unrest.most());
  }
  double mean() const { return static_cast<double>(changes) / drags; }
};

TEST(WorkbenchDrag, OfTheGoalMovesWordsSmoothly) {
  constexpr double far = 0.04;
  constexpr int steps = 400;  // 0.2 mm each
  Sum sum;
  for (const Strategy& strategy : strategy_catalog()) {
    for (const double angle : {0.0, 45.0, 90.0, 135.0, 200.0, 290.0}) {
      WorkbenchCase shown =
          usual(strategy.id, sum.drags % 2 == 0 ? Vector<2>(1280.0, 800.0) : Vector<2>(1024.0, 640.0));
      if (sum.drags % 3 == 0) shown.options.compare = Compare::side_by_side;
      const Vector<2> way = direction_at(angle / degrees_per_radian) * far;
      const Unrest unrest = drag(shown, steps, [&](WorkbenchCase& now, int step) {
        now.snapshot = snapshot_at_rest_of_all(now.settings, usual_goal + way * (2.0 * step / steps - 1.0));
      });
      EXPECT_EQ(unrest.jumps, 0);
      EXPECT_LE(unrest.most(), 10) << strategy.name << " " << angle << "\n" << unrest.words();
      sum.add(unrest);
    }
  }
  fmt::print("goal: {:.1f} changes of place a drag, {} of one label at most\n", sum.mean(), sum.most);
  EXPECT_LE(sum.mean(), 18.0);
}

void turn(const char* what, double Settings::*angle) {
  constexpr double step_deg = 0.5;
  constexpr int steps = 720;
  Sum sum;
  for (const Strategy& strategy : strategy_catalog()) {
    for (const double way : {1.0, -1.0}) {
      const WorkbenchCase shown = usual(strategy.id, way > 0.0 ? Vector<2>(1280.0, 800.0) : Vector<2>(1024.0, 640.0));
      const double start = shown.settings.*angle;
      const Unrest unrest = drag(shown, steps, [&](WorkbenchCase& now, int step) {
        now.settings.*angle = start + way * step * step_deg / degrees_per_radian;
        now.snapshot = snapshot_at_rest_of_all(now.settings, usual_goal);
      });
      EXPECT_EQ(unrest.jumps, 0);
      EXPECT_LE(unrest.most(), 20) << what << " " << strategy.name << "\n" << unrest.words();
      sum.add(unrest);
    }
  }
  fmt::print("{}: {:.1f} changes of place a full turn, {} of one label at most\n", what, sum.mean(), sum.most);
  EXPECT_LE(sum.mean(), 60.0);
}

TEST(WorkbenchDrag, OfTheWallsAngleMovesWordsSmoothly) {
  turn("wall", &Settings::wall_normal_angle);
}

TEST(WorkbenchDrag, OfTheActuatedDirectionMovesWordsSmoothly) {
  turn("actuated direction", &Settings::actuated_angle);
}

// A label that has gone to a worse place comes back when there is room again, and then stands still.
TEST(WorkbenchDrag, EndsAtRest) {
  PictureDice dice(3);
  for (int i = 0; i < 40; ++i) {
    WorkbenchCase shown = workbench_case_by(dice);
    const Vector<2> goal = shown.snapshot.goal;
    shown.pane_views = fitted_pane_views(shown.content());
    PictureMemory memory;
    for (int step = 0; step < 40; ++step) {
      shown.snapshot = snapshot_at_rest_of_all(shown.settings, goal + Vector<2>(0.0005, 0.0003) * (1.0 * step));
      shown.compose(memory, frame_s);
    }
    const auto is_moving = [&] { return std::ranges::any_of(memory, &PaneMemory::is_moving); };
    int frames = 0;
    while (is_moving() && frames < 300) {
      shown.compose(memory, frame_s);
      ++frames;
    }
    EXPECT_LT(frames, 300) << i;
    const auto rest = shown.compose(memory, frame_s);
    const auto later = shown.compose(memory, 10.0);
    for (std::size_t pane = 0; pane < rest.size(); ++pane) {
      const Seen before(rest[pane], measure, shown.text_scale());
      const Seen after(later[pane], measure, shown.text_scale());
      ASSERT_EQ(before.words.size(), after.words.size()) << i;
      for (const auto& [name, words] : before.words) {
        const auto found = after.words.find(name);
        ASSERT_NE(found, after.words.end()) << name;
        EXPECT_EQ(found->second.box.least, words.box.least) << name;
        EXPECT_EQ(found->second.alpha, 1.0) << name;
      }
    }
  }
}

TEST(WorkbenchDrag, PanesThatAreGoneLeaveNothingBehind) {
  WorkbenchCase shown = usual(StrategyId::naive, {1280.0, 800.0});
  shown.options.compare = Compare::side_by_side;
  PictureMemory memory;
  for (int step = 0; step < 60; ++step) {
    shown.snapshot = snapshot_at_rest_of_all(shown.settings, usual_goal * (1.0 - step / 40.0));
    shown.compose(memory, frame_s);
  }
  ASSERT_TRUE(std::ranges::any_of(memory, &PaneMemory::is_moving));
  shown.options.compare = Compare::overlay;
  shown.compose(memory, frame_s);
  EXPECT_FALSE(std::ranges::any_of(memory, &PaneMemory::is_moving)) << "the one picture is new";
}

}  // namespace
}  // namespace ghostforce::workbench_drag_test
