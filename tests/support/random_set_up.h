// Set-ups as a person may have them on the screen after much playing: near a shipped scene or far from all of them, with
// any settings, goal, face and mode, and with a path of their own or without.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <variant>

#include "app/files/scene_file.h"
#include "app/state/set_up.h"
#include "tests/support/any_value.h"
#include "tests/support/paper_scenes.h"

namespace ghostforce {

inline double random_coordinate(Random& random) {
  constexpr std::array odd{0.0, -0.0, 1.0, -1.0, 1e-9, 0.1 + 0.2, 5e-324, 0.0005};
  if (random.once_in(4)) return odd[static_cast<std::size_t>(random.below(static_cast<int>(odd.size())))];
  return random.uniform(-1.0, 1.0);
}

inline GoalPath random_path(Random& random) {
  GoalPath path;
  const int count = 1 + random.below(6);
  double time = 0.0;
  for (int i = 0; i < count; ++i) {
    path.points.emplace_back(random_coordinate(random), random_coordinate(random));
    path.times.push_back(time);
    time += random.over_decades(1e-6, 1e3);
  }
  return path;
}

inline SetUp random_set_up(Random& random) {
  const std::vector<std::string_view> names = paper_scene_names();
  SetUp set_up;
  Scene& scene = set_up.scene;
  scene = load_scene(std::string(names[static_cast<std::size_t>(random.below(static_cast<int>(names.size())))]));
  const int one_key_in = 1 << random.below(6);  // from all keys to hardly any
  for (const SceneKey& key : scene_keys()) {
    if (key.format > 1) continue;  // general scenes have a test of their own
    if (random.once_in(one_key_in)) std::visit(AnyValue{scene, random}, key.value);
  }
  if (random.once_in(one_key_in)) {
    const Motion motion = scene.goal.motion;
    scene.goal = random_path(random);
    scene.goal.motion = motion;
  }
  // Turns that nobody makes by hand, and that a file holds all the same.
  constexpr std::array turns{1e300, -1e-300, 5e-324, std::numeric_limits<double>::max() / 60.0};
  if (random.once_in(10)) scene.settings.wall_normal_angle = turns[static_cast<std::size_t>(random.below(4))];
  if (scene.duration * scene.settings.rate > most_ticks) scene.duration = most_ticks / scene.settings.rate / 2.0;
  if (random.once_in(2)) scene.goal.points.back() = {random_coordinate(random), random_coordinate(random)};
  scene.settings.active = strategy_catalog()[static_cast<std::size_t>(random.below(3))].id;
  scene = rounded_to_file(scene);
  set_up.goal = scene.goal.points.back();
  set_up.face = random.once_in(2) ? Face::workbench : Face::stage;
  if (set_up.face == Face::stage && random.once_in(2)) {
    const auto modes = stage_mode_catalog();
    set_up.mode = modes[static_cast<std::size_t>(random.below(static_cast<int>(modes.size())))].id;
  }
  return set_up;
}

}  // namespace ghostforce
