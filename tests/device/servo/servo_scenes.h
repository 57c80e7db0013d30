// Scenes for the tests of the servo, as values, and how a servo starts on one.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/scene.h"
#include "core/tick.h"
#include "device/servo/servo.h"

namespace ghostforce {

// Figure 3, middle: into a wall of 45°, one motor along x. The goal enters the wall at 0.5 s.
inline Scene slanted_wall() {
  Scene scene;
  scene.settings.wall_normal_angle = 0.75 * std::numbers::pi;
  scene.settings.mass = 0.1;
  scene.settings.damping = 5.0;
  scene.settings.rate = 1000.0;
  scene.settings.stiffnesses = {100.0, {}, 1000.0, 1000.0, 1e5, {}};
  scene.settings.active = StrategyId::naive;
  scene.goal = {{{-0.04, 0.04}, {0.04, -0.04}}, {0.0, 1.0}, Motion::linear};
  scene.duration = 1.5;
  return scene;
}

// The explicit rendered force of so much k_r on so little mass is unstable once the device is in the wall.
inline Settings unstable_settings() {
  Settings settings = slanted_wall().settings;
  settings.mass = 0.001;
  settings.damping = 0.0;
  settings.stiffnesses.k_r = 1e6;
  settings.stiffnesses.k_t = 1e6;
  return settings;
}

// At rest at the start of the scene's path.
inline ServoCommand start_of(const Scene& scene) {
  ServoCommand command;
  command.settings = scene.settings;
  command.restart_state = state_at_start(scene.settings, goal_at(scene.goal, 0.0));
  return command;
}

// Bit for bit, not nearly: it is the same code on the same numbers.
inline void expect_same(const Snapshot& found, const Snapshot& wanted) {
  EXPECT_EQ(found.tick, wanted.tick);
  EXPECT_EQ(found.time_s, wanted.time_s);
  EXPECT_EQ(found.goal, wanted.goal);
  for (const Strategy& strategy : strategy_catalog()) {
    SCOPED_TRACE(strategy.title);
    const auto& a = found.strategies[index_of(strategy.id)];
    const auto& b = wanted.strategies[index_of(strategy.id)];
    EXPECT_EQ(a.device, b.device);
    EXPECT_EQ(a.proxy, b.proxy);
    EXPECT_EQ(a.contact, b.contact);
    EXPECT_EQ(a.force, b.force);
    EXPECT_EQ(a.ghost_force, b.ghost_force);
    EXPECT_EQ(a.proxy_drift, b.proxy_drift);
    EXPECT_EQ(a.energy, b.energy);
    EXPECT_EQ(a.in_contact, b.in_contact);
  }
}

inline bool is_finite(const Snapshot& snapshot) {
  const auto finite = [](const Vector<2>& v) { return std::isfinite(v.x) && std::isfinite(v.y); };
  bool all = std::isfinite(snapshot.time_s) && finite(snapshot.goal);
  for (const auto& strategy : snapshot.strategies) {
    all = all && finite(strategy.device) && finite(strategy.proxy) && finite(strategy.contact) &&
          finite(strategy.force) && finite(strategy.ghost_force) && finite(strategy.proxy_drift) &&
          std::isfinite(strategy.energy);
  }
  return all;
}

inline std::vector<Sample> take_samples(Servo& servo) {
  std::vector<Sample> samples;
  for (Sample sample; servo.take_sample(sample);) samples.push_back(sample);
  return samples;
}

}  // namespace ghostforce
