// What happens at a deadline, and what the window does with the servo while it runs, never touches the heap.
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "app/cli/desktop_inputs.h"
#include "device/input/mouse_input.h"
#include "device/servo/servo.h"
#include "tests/core/general_scenes.h"
#include "tests/device/servo/servo_scenes.h"
#include "tests/support/heap_guard.h"

namespace ghostforce::servo_heap_test {
namespace {

TEST(ServoHeap, IsNotTouchedInAGeneralScene) {
  for (Settings (*settings)() : {arm_settings, pantograph_settings, string_settings, corner_settings, curve_settings}) {
    ServoCommand command;
    command.settings = settings();
    command.restart_state = state_at_start(command.settings, Vector<2>(0.0));
    Servo servo(std::make_unique<MouseInput>(), command);
    auto& mouse = dynamic_cast<MouseInput&>(servo.input());
    std::int64_t contacts = 0;
    {
      HeapGuard guard;
      for (int round = 0; round < 3000; ++round) {
        if (round % 16 == 0) mouse.move_to(0.04 * direction_at(0.003 * round), 0.016);
        if (round % 50 == 0) ++command.settings_generation;
        command.settings.wall_normal_angle = 0.01 * round;
        servo.send(command);
        servo.step();
        if (servo.newest().snapshot.strategies[0].in_contact) ++contacts;
      }
    }
    EXPECT_GT(contacts, 500);
  }
}

// Walks everything that a servo can be asked for, until its samples overflow.
TEST(ServoHeap, IsNotTouchedByAnyInputOrStrategy) {
  const Scene scene = slanted_wall();
  for (const InputEntry& kind : desktop_inputs()) {
    // Those with motors have a clock of their own: see driver_heap_test.cpp.
    if (kind.make(scene, {}).input->haptic_device() != nullptr) continue;
    for (const Strategy& strategy : strategy_catalog()) {
      SCOPED_TRACE(kind.name);
      SCOPED_TRACE(strategy.name);
      ServoCommand command = start_of(scene);
      command.settings.active = strategy.id;
      Servo servo(kind.make(scene, {}).input, command);
      auto* const mouse = dynamic_cast<MouseInput*>(&servo.input());
      std::int64_t contacts = 0;
      {
        HeapGuard guard;
        for (int round = 0; round < 12'000; ++round) {
          if (mouse != nullptr && round % 16 == 0) mouse->move_to(goal_at(scene.goal, round % 1500 * 1e-3), 0.016);
          if (round % 50 == 0) {
            command.settings.actuated_angle += 0.1;
            if (round % 5000 == 0) command.settings.rate = command.settings.rate == 1000.0 ? 500.0 : 1000.0;
            ++command.settings_generation;
          }
          command.paused = round % 500 > 450;
          if (command.paused) ++command.steps_asked;
          command.speed = round % 2 == 0 ? 1.0 : 0.1;
          command.measures_hand = round % 4000 > 500;
          command.belief_follows_hand = round % 4000 > 1000;
          if (round % 3000 == 2999) ++command.restarts_asked;
          command.recording = round < 11'000 ? 1 : 0;
          servo.send(command);
          servo.step();
          if (servo.newest().snapshot.strategies[index_of(strategy.id)].in_contact) ++contacts;
        }
        for (Sample sample; servo.take_sample(sample);) {
        }
        for (Sample sample; servo.take_record(sample);) {
        }
      }
      // A SpaceMouse that is not there leaves the goal where it was.
      if (kind.name != "spacemouse") {
        EXPECT_GT(contacts, 1000);
      }
      EXPECT_EQ(servo.newest().restarts, 4U);
      EXPECT_GT(servo.newest().loop.dropped_samples, 0U);
      EXPECT_GT(servo.newest().loop.dropped_records, 0U);
      EXPECT_LT(servo.newest().loop.dropped_records, servo.newest().loop.dropped_samples);
      EXPECT_EQ(servo.newest().refused_commands, 0U);
    }
  }
}

// The scene's hand trembles, drifts and changes its grip, seen through an encoder, measured by tones and followed.
TEST(ServoHeap, IsNotTouchedByAHandThatIsNotStill) {
  Scene scene = slanted_wall();
  scene.stiffness_path = {{100.0, 800.0, 150.0}, {0.0, 0.6, 1.1}};
  scene.tremor_and_drift = {.tremor_rms = 0.0004, .drift_speed = 0.01, .seed = 5.0};
  scene.settings.encoder_step = 60e-6;
  ServoCommand command = start_of(scene);
  command.measures_hand = true;
  command.belief_follows_hand = true;
  for (const InputEntry& kind : desktop_inputs()) {
    if (kind.make(scene, {}).input->haptic_device() != nullptr) continue;
    SCOPED_TRACE(kind.name);
    Servo servo(make_in_hand_of(scene, kind, {}).input, command);
    HeapGuard guard;
    for (int round = 0; round < 6000; ++round) {
      if (round % 1000 == 999) {
        ++command.restarts_asked;
        servo.send(command);
      }
      servo.step();
    }
  }
}

TEST(ServoHeap, IsNotTouchedByWhatIsRefusedOrUnstable) {
  const Scene scene = slanted_wall();
  const Settings unstable = unstable_settings();
  ServoCommand command = start_of(scene);
  Servo servo(std::make_unique<MouseInput>(), command);
  auto& mouse = dynamic_cast<MouseInput&>(servo.input());
  {
    HeapGuard guard;
    mouse.move_to({0.04, -0.04}, 0.1);
    for (int round = 0; round < 1000; ++round) servo.step();
    mouse.move_to({NAN, 0.0}, 0.1);
    command.settings = unstable;
    ++command.settings_generation;
    servo.send(command);
    for (int round = 0; round < 1000; ++round) servo.step();
    command.settings.rate = 0.0;
    ++command.settings_generation;
    command.speed = std::numeric_limits<double>::quiet_NaN();
    command.restart_state.goal.x = std::numeric_limits<double>::quiet_NaN();
    ++command.restarts_asked;
    servo.send(command);
    servo.step();
  }
  EXPECT_TRUE(servo.newest().diverged);
  EXPECT_EQ(servo.newest().refused_commands, 1U);
}

}  // namespace
}  // namespace ghostforce::servo_heap_test
