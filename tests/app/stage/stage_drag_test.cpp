// While something is dragged slowly, words go with what they name: none jumps from side to side, and none flickers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/conventions.h"
#include "tests/app/picture/label_unrest.h"
#include "tests/app/stage/stage_dice.h"

namespace ghostforce::stage_drag_test {
namespace {

const MeasureText measure = measure_vector_text;
constexpr double frame_s = 1.0 / 60.0;

Unrest drag(StageCase shown, int steps, const std::function<void(StageCase&, int)>& move_to) {
  Unrest unrest;
  LabelMemory memory;
  std::optional<Seen> before;
  for (int step = 0; step <= steps; ++step) {
    move_to(shown, step);
    const StagePicture picture = shown.compose(memory, frame_s);
    Seen now(picture.pane, measure, 1.0);
    if (before) add_unrest(*before, now, 3.0 * picture.unit + 1.0, fmt::format("step {}", step), unrest);
    before.emplace(std::move(now));
  }
  return unrest;
}

StageCase usual(StrategyId active) {
  StageCase shown = stage_case_at(wall45(active), wall45_goal);
  shown.may_turn_motor = shown.may_turn_wall = true;
  return shown;
}

// Through the point where the hand is at rest, all across the window, 0.2 mm at a time.
std::vector<std::pair<Vector<2>, Vector<2>>> ways() {
  constexpr double far = 0.04;
  const Vector<2> middle = wall45_goal;
  std::vector<std::pair<Vector<2>, Vector<2>>> all;
  for (const double angle : {0.0, 45.0, 90.0, 135.0, 20.0, 110.0}) {
    const Vector<2> direction = direction_at(angle / degrees_per_radian);
    all.emplace_back(middle - far * direction, middle + far * direction);
    all.emplace_back(middle + far * direction, middle - far * direction);
  }
  return all;
}

TEST(StageDrag, OfTheHandMovesWordsSmoothly) {
  constexpr double step_length = 0.0002;
  int most = 0;
  int sum = 0;
  int drags = 0;
  for (const Strategy& strategy : strategy_catalog()) {
    for (const auto& [from, to] : ways()) {
      // Every other way in another window.
      for (const Vector<2>& size : {drags % 2 == 0 ? Vector<2>(1280.0, 720.0) : Vector<2>(1024.0, 640.0)}) {
        StageCase shown = usual(strategy.id);
        shown.size = size;
        const int steps = static_cast<int>(glm::distance(from, to) / step_length);
        const Unrest unrest = drag(shown, steps, [&](StageCase& now, int step) {
          const Vector<2> goal = from + (to - from) * (static_cast<double>(step) / steps);
          now.moment = stage_moment_at_rest(now.settings, goal);
        });
        EXPECT_EQ(unrest.jumps, 0);
        EXPECT_LE(unrest.most(), 10) << size.x << " " << strategy.name << " from " << from.x << ", " << from.y << "\n"
                                     << unrest.words();
        most = std::max(most, unrest.most());
        sum += unrest.sum();
        ++drags;
      }
    }
  }
  fmt::print("hand: {:.1f} changes of place a drag, {} of one label at most\n", static_cast<double>(sum) / drags, most);
  EXPECT_LE(sum, 18 * drags);
}

void turn(const char* what, double Settings::*angle) {
  constexpr double step_deg = 0.5;
  constexpr int steps = 720;
  int most = 0;
  int sum = 0;
  int drags = 0;
  for (const Vector<2>& size : {Vector<2>(1280.0, 720.0), Vector<2>(1024.0, 640.0)}) {
    for (const Strategy& strategy : strategy_catalog()) {
      for (const double way : {1.0, -1.0}) {
        StageCase shown = usual(strategy.id);
        shown.size = size;
        const double start = shown.settings.*angle;
        const Unrest unrest = drag(shown, steps, [&](StageCase& now, int step) {
          now.settings.*angle = start + way * step * step_deg / degrees_per_radian;
          now.moment = stage_moment_at_rest(now.settings, wall45_goal);
        });
        EXPECT_EQ(unrest.jumps, 0);
        EXPECT_LE(unrest.most(), 20) << what << " " << size.x << " " << strategy.name << "\n" << unrest.words();
        most = std::max(most, unrest.most());
        sum += unrest.sum();
        ++drags;
      }
    }
  }
  fmt::print("{}: {:.1f} changes of place a full turn, {} of one label at most\n", what,
             static_cast<double>(sum) / drags, most);
  EXPECT_LE(sum, 60 * drags);
}

TEST(StageDrag, OfTheWallsAngleMovesWordsSmoothly) {
  turn("wall", &Settings::wall_normal_angle);
}

TEST(StageDrag, OfTheMotorsAngleMovesWordsSmoothly) {
  turn("motor", &Settings::actuated_angle);
}

// Also where it is not the shipped picture.
TEST(StageDrag, OfTheHandMovesWordsSmoothlyWithAnySettings) {
  PictureDice dice(17);
  int most = 0;
  int sum = 0;
  constexpr int drags = 30;
  for (int i = 0; i < drags; ++i) {
    const Settings settings = dice.settings();
    StageCase shown = stage_case_at(settings, dice.goal(settings));
    shown.size = dice.size();
    shown.scale = dice.scale();
    const Camera camera = camera_on(shown.shown.center, shown.shown.width, shown.size);
    const auto anywhere = [&] {
      return to_world(camera, shown.size * Vector<2>(dice.between(0.05, 0.95), dice.between(0.05, 0.95)));
    };
    const Vector<2> from = anywhere();
    const Vector<2> to = anywhere();
    constexpr int steps = 300;
    const Unrest unrest = drag(shown, steps, [&](StageCase& now, int step) {
      now.moment = stage_moment_at_rest(now.settings, from + (to - from) * (static_cast<double>(step) / steps));
    });
    EXPECT_EQ(unrest.jumps, 0) << i;
    most = std::max(most, unrest.most());
    sum += unrest.sum();
  }
  fmt::print("any hand: {:.1f} changes of place a drag, {} of one label at most\n", static_cast<double>(sum) / drags,
             most);
  EXPECT_LE(sum, 18 * drags);
}

// A label that has gone to a worse place comes back when there is room again, and then stands still.
TEST(StageDrag, EndsAtRest) {
  PictureDice dice(3);
  for (int i = 0; i < 40; ++i) {
    StageCase shown = stage_case_by(dice);
    const Settings settings = shown.settings;
    shown.mode = StageMode::none;
    LabelMemory memory;
    const Vector<2> goal = shown.moment.goal;
    for (int step = 0; step < 40; ++step) {
      shown.moment = stage_moment_at_rest(settings, goal + Vector<2>(0.0005, 0.0003) * static_cast<double>(step));
      shown.compose(memory, frame_s);
    }
    int frames = 0;
    while (memory.is_moving() && frames < 300) {
      shown.compose(memory, frame_s);
      ++frames;
    }
    EXPECT_LT(frames, 300) << i;
    const Seen rest(shown.compose(memory, frame_s).pane, measure, 1.0);
    const Seen later(shown.compose(memory, 10.0).pane, measure, 1.0);
    ASSERT_EQ(rest.words.size(), later.words.size()) << i;
    for (const auto& [name, words] : rest.words) {
      const auto found = later.words.find(name);
      ASSERT_NE(found, later.words.end()) << name;
      EXPECT_EQ(found->second.box.least, words.box.least) << name;
      EXPECT_EQ(found->second.alpha, 1.0) << name;
    }
  }
}

}  // namespace
}  // namespace ghostforce::stage_drag_test
