// While something is dragged slowly, words go with what they name: none jumps from side to side, and none flickers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/units.h"
#include "tests/app/view/picture_extents.h"
#include "tests/app/view/stage/stage_dice.h"

namespace ghostforce {
namespace {

const MeasureText measure = measure_vector_text;
constexpr double frame_s = 1.0 / 60.0;

// Two labels of two pictures are the same one: its role, and its words without the numbers in them.
std::string name_of(const LabelExtent& label) {
  std::string name = fmt::format("{} ", role_name(label.role));
  if (label.role == Role::number) return name;
  if (label.role == Role::motor_axis) return name;  // "left and right" turns into an angle
  for (const char letter : label.words) {
    if (letter != '.' && (letter < '0' || letter > '9')) name += letter;
  }
  return name;
}

bool stands_still_by_itself(Role role) {
  return role == Role::sentence || role == Role::button || role == Role::hint;
}

struct Words {
  ScreenBox box;  // of all lines
  double alpha = 0.0;
  Role role{};
};

// What was seen of one frame.
struct Seen {
  std::map<std::string, Words> words;
  PictureExtents extents;

  explicit Seen(const StagePicture& picture) : extents(picture.pane, measure) {
    const LabelExtent* above = nullptr;
    std::string key;
    for (const LabelExtent& label : extents.labels) {
      if (stands_still_by_itself(label.role) || label.alpha == 0.0) continue;
      // A line below another belongs to it.
      const bool goes_on = above != nullptr && above->mark + 1 == label.mark && above->role == label.role &&
                           label.role != Role::number && std::abs(label.box.least.y - above->box.most.y) < 0.01;
      if (goes_on) {
        words[key].box.include(label.box.least);
        words[key].box.include(label.box.most);
      } else {
        key = name_of(label);
        // The numbers are a block; the first of it stands for all.
        if (label.role == Role::number && words.contains(key)) {
          words[key].box.include(label.box.least);
          words[key].box.include(label.box.most);
          continue;
        }
        words[key] = {label.box, label.alpha, label.role};
      }
      above = &label;
    }
  }

  // What a label's thing has moved by since then [points].
  double moved(Role role, const Seen& before) const {
    if (role == Role::number) return 0.0;
    double most = 0.0;
    std::size_t i = 0;
    for (const Extent& mark : extents.marks) {
      if (mark.role != role) continue;
      while (i < before.extents.marks.size() && before.extents.marks[i].role != role) ++i;
      if (i == before.extents.marks.size()) return most;
      const std::vector<Vector<2>>& was = before.extents.marks[i++].corners;
      for (std::size_t corner = 0; corner < std::min(was.size(), mark.corners.size()); ++corner) {
        most = std::max(most, glm::distance(was[corner], mark.corners[corner]));
      }
    }
    return most;
  }
};

// How often a label changed its place, or came and went.
struct Unrest {
  std::map<std::string, int> changes;
  int jumps = 0;

  int most() const {
    int found = 0;
    for (const auto& [name, count] : changes) found = std::max(found, count);
    return found;
  }
  int sum() const {
    int found = 0;
    for (const auto& [name, count] : changes) found += count;
    return found;
  }
  std::string words() const {
    std::string all;
    for (const auto& [name, count] : changes) all += fmt::format("  {}: {}\n", name, count);
    return all;
  }
};

Unrest drag(StageCase shown, int steps, const std::function<void(StageCase&, int)>& move_to) {
  Unrest unrest;
  LabelMemory memory;
  std::optional<Seen> before;
  for (int step = 0; step <= steps; ++step) {
    move_to(shown, step);
    const StagePicture picture = shown.compose(memory, frame_s);
    Seen now(picture);
    if (before) {
      // Words are as wide as their numbers, and letters stand on whole points.
      const double bound = 3.0 * picture.unit + 1.0;
      for (const auto& [name, words] : now.words) {
        const auto was = before->words.find(name);
        if (was == before->words.end()) {
          ++unrest.changes[name];
          EXPECT_LE(words.alpha, 0.2) << name << " is there at once at step " << step;
          continue;
        }
        const Vector<2> grown = words.box.extent() - was->second.box.extent();
        const double moved = std::max(glm::distance(words.box.least, was->second.box.least),
                                      glm::distance(words.box.most, was->second.box.most));
        const double allowed = now.moved(words.role, *before) + glm::length(grown) + bound;
        if (moved <= allowed) continue;
        if (++unrest.jumps <= 10) {
          ADD_FAILURE() << name << " moves by " << moved << ", " << allowed << " allowed, at step " << step;
        }
      }
    }
    before.emplace(std::move(now));
  }
  return unrest;
}

StageCase usual(StrategyId active) {
  StageCase shown = stage_case_at(wall45(active), wall45_goal);
  shown.has_grips = true;
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
    const Camera camera = stage_camera(shown.shown, shown.size, 0.86 * shown.size.y);
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
    const Seen rest(shown.compose(memory, frame_s));
    const Seen later(shown.compose(memory, 10.0));
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
}  // namespace ghostforce
