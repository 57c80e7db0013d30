// A recording of everything that can be done at the window, by dice. For tests.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/run.h"
#include "app/files/scene_file.h"
#include "app/runs/recording.h"
#include "core/simulate.h"
#include "device/input/mouse_input.h"
#include "device/input/unsteady_input.h"
#include "device/servo/servo.h"

namespace ghostforce {

inline Settings as_in_file(const Settings& settings) {
  Scene scene;
  scene.settings = settings;
  return rounded_to_file(scene).settings;
}

// A minute at the window, by dice: every setting, pause, single steps, speed, reset, other rates, tones and a belief that
// follows them.
inline std::string recorded_by_dice(unsigned seed, int rounds, int gap_every = 0,
                                    const Scene& scene = load_scene("wall45")) {
  std::mt19937 random(seed);
  const auto between = [&](double least, double greatest) {
    return std::uniform_real_distribution<double>(least, greatest)(random);
  };
  ServoCommand command;
  command.settings = scene.settings;
  command.recording = 1;
  command.restart_state = simulate(scene, last_tick(scene), [](const Snapshot&) {});
  auto input = std::make_unique<MouseInput>();
  MouseInput& mouse = *input;
  Servo servo(in_hand_of(scene, std::move(input), false), command);
  SampleText text(scene.settings);
  fmt::memory_buffer lines;
  for (int round = 0; round < rounds; ++round) {
    mouse.move_to({between(-0.05, 0.05), between(-0.05, 0.05)}, 0.016);
    Settings& settings = command.settings;
    switch (random() % 16) {
      case 0:
        settings.stiffnesses.k_r = between(0.0, 2000.0);
        break;
      case 1:
        settings.wall_normal_angle = between(-7.0, 7.0);
        break;
      case 2:
        settings.actuated_angle = between(-7.0, 7.0);
        break;
      case 3:
        settings.stiffnesses.believed_k_u = between(20.0, 500.0);
        break;
      case 4:
        settings.stiffnesses.believed_k_u.reset();
        settings.stiffnesses.k_u = between(20.0, 500.0);
        break;
      case 5:
        settings.stiffnesses.chosen_tracking_ratio = between(0.5, 20.0);
        break;
      case 6:
        settings.stiffnesses.chosen_tracking_ratio.reset();
        break;
      case 7:
        settings.active = strategy_catalog()[random() % strategy_count].id;
        settings.wall_point = {between(-0.02, 0.02), between(-0.02, 0.02)};
        break;
      case 8:
        settings.rate = std::floor(between(500.0, 4000.0));
        break;
      case 9:
        ++command.restarts_asked;
        command.restart_state = state_at_start(Vector<2>(between(-0.02, 0.02), between(0.0, 0.02)));
        command.restart_state.tick = static_cast<std::int64_t>(random() % 5000);
        break;
      case 10:
        command.paused = true;
        command.steps_asked += 2;
        break;
      case 11:
        settings.stiffnesses.k_c = random() % 2 == 0 ? std::numeric_limits<double>::infinity() : between(100.0, 1e6);
        settings.mass = between(0.05, 0.5);
        settings.damping = between(2.0, 20.0);
        break;
      case 12:
        command.speed = between(0.01, 2.0);
        break;
      default:
        command.paused = false;
    }
    command.measures_hand = round % 4 != 0;
    command.belief_follows_hand = round % 100 > 30;
    settings = as_in_file(settings);
    ++command.settings_generation;
    servo.send(command);
    for (int k = 0; k < 16; ++k) servo.step();
    if (gap_every > 0 && round % gap_every == gap_every - 1) {
      Sample lost;
      servo.take_record(lost);
    }
    for (Sample sample; servo.take_record(sample);) text.append(lines, sample);
    for (Sample sample; servo.take_sample(sample);) {
    }
  }
  EXPECT_EQ(servo.newest().refused_commands, 0U);
  EXPECT_EQ(servo.newest().loop.dropped_records, 0U);
  return run_header(scene, recording_columns) + std::string(lines.data(), lines.size());
}

}  // namespace ghostforce
