// A general scene under the mouse, stepped by hand.
#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "core/general_equilibrium.h"
#include "device/input/mouse_input.h"
#include "device/servo/servo.h"
#include "tests/core/general_scenes.h"

namespace ghostforce::general_servo_test {
namespace {

ServoCommand command_for(const Settings& settings, const Vector<2>& start) {
  ServoCommand command;
  command.settings = settings;
  command.restart_state = state_at_start(settings, start);
  return command;
}

TEST(GeneralServo, TheMouseMovesTheHandOfAGeneralScene) {
  for (Settings (*settings)() : {arm_settings, pantograph_settings, string_settings, corner_settings}) {
    const Vector<2> start(-0.006, 0.024);
    const Vector<2> goal(0.004, -0.016);
    const ServoCommand command = command_for(settings(), start);
    Servo servo(std::make_unique<MouseInput>(), command);
    servo.send(command);
    auto& mouse = dynamic_cast<MouseInput&>(servo.input());
    for (int frame = 0; frame < 250; ++frame) {
      mouse.move_to(glm::mix(start, goal, std::min(1.0, frame / 60.0)), 0.016);
      for (int i = 0; i < 16; ++i) servo.step();
    }
    const auto predicted = predicted_general_equilibria(general_scene_of(command.settings), goal);
    const ServoReport& report = servo.newest();
    EXPECT_EQ(report.refused_commands, 0U);
    for (std::size_t i = 0; i < strategy_count; ++i) {
      ASSERT_TRUE(predicted[i]);
      const StrategySnapshot<2>& shown = report.snapshot.strategies[i];
      EXPECT_LT(glm::length(shown.device - predicted[i]->rest.at.device), 1e-9);
      EXPECT_LT(glm::length(shown.force - predicted[i]->rest.at.force), 1e-6);
      EXPECT_LT(glm::length(shown.ghost_force - predicted[i]->ghost_force), 1e-6);
      EXPECT_EQ(report.contacts[i].active, predicted[i]->rest.active);
      EXPECT_NEAR(report.contacts[i].efforts[0], predicted[i]->rest.efforts[0], 1e-6);
    }
    Sample sample;
    ASSERT_TRUE(servo.take_sample(sample));
    EXPECT_EQ(sample.settings, command.settings) << "the general part too";
  }
}

TEST(GeneralServo, GoesFromThePapersSceneToAGeneralOneAndBack) {
  const Settings paper = common_general_settings();
  ServoCommand command = command_for(paper, Vector<2>(0.01, -0.01));
  Servo servo(std::make_unique<MouseInput>(), command);
  const auto use = [&](const Settings& settings) {
    command.settings = settings;
    ++command.settings_generation;
    servo.send(command);
    for (int i = 0; i < 100; ++i) servo.step();
  };
  use(paper);
  const Snapshot before = servo.newest().snapshot;
  use(corner_settings());
  for (const StrategySnapshot<2>& strategy : servo.newest().snapshot.strategies) EXPECT_TRUE(strategy.in_contact);
  EXPECT_GT(servo.newest().contacts[index_of(StrategyId::naive)].active, 0);
  use(paper);
  for (int i = 0; i < 5000; ++i) servo.step();
  // The paper's loop is as if nothing had been: it remembers only where things are.
  for (std::size_t i = 0; i < strategy_count; ++i) {
    EXPECT_EQ(servo.newest().snapshot.strategies[i].in_contact, before.strategies[i].in_contact);
  }
  Sample sample;
  while (servo.take_sample(sample)) {
  }
  EXPECT_EQ(sample.settings, paper);
}

TEST(GeneralServo, TonesDoNotMeasureItsHand) {
  ServoCommand command = command_for(arm_settings(), Vector<2>(0.004, -0.016));
  command.measures_hand = true;
  Servo servo(std::make_unique<MouseInput>(), command);
  servo.send(command);
  for (int i = 0; i < 500; ++i) {
    servo.step();
    Sample sample;
    ASSERT_TRUE(servo.take_sample(sample));
    EXPECT_EQ(sample.tone, Vector<2>(0.0));
  }
}

TEST(GeneralServo, WhatIsOutOfRangeIsRefused) {
  ServoCommand command = command_for(arm_settings(), Vector<2>(0.0));
  Servo servo(std::make_unique<MouseInput>(), command);
  command.settings.general.arm.links[0] = -0.1;
  ++command.settings_generation;
  servo.send(command);
  servo.step();
  EXPECT_EQ(servo.newest().refused_commands, 1U);
}

}  // namespace
}  // namespace ghostforce::general_servo_test
