// The servo stepped by hand: one step() is one deadline.
#include "device/servo/servo.h"

#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "core/simulate.h"
#include "device/input/mouse_input.h"
#include "device/input/scripted_input.h"
#include "tests/device/servo/servo_scenes.h"
#include "tests/device/servo/servo_steps.h"

namespace ghostforce::servo_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// --- The numbers -----------------------------------------------------------------------------------------------------

TEST(Servo, MakesTheSameNumbersAsPlay) {
  std::vector<Scene> scenes(4, slanted_wall());
  scenes[1].settings.actuated_angle = 1.0;
  scenes[1].settings.stiffnesses.k_c = infinity;
  scenes[2].settings.rate = 250.0;
  scenes[2].settings.stiffnesses.believed_k_u = 50.0;
  scenes[2].goal.motion = Motion::minimum_jerk;
  scenes[3].settings.stiffnesses.chosen_tracking_ratio = 3.0;
  for (Scene scene : scenes) {
    for (const Strategy& active : strategy_catalog()) {
      scene.settings.active = active.id;
      Servo servo(script_of(scene), start_of(scene));
      Sample sample;
      simulate(scene, last_tick(scene), [&](const Snapshot& wanted) {
        servo.step();
        ASSERT_TRUE(servo.take_sample(sample));
        expect_same(sample.snapshot, wanted);
        expect_same(servo.newest().snapshot, wanted);
      });
      EXPECT_TRUE(sample.snapshot.strategies[index_of(active.id)].in_contact) << "the scene must reach the wall";
      EXPECT_FALSE(servo.take_sample(sample));
    }
  }
}

TEST(Servo, GoesOnFromAStateThatWasPlayedBefore) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  command.restart_state = simulate(scene, 700, [](const Snapshot&) {});
  Servo servo(script_of(scene), command);
  Sample sample;
  simulate(scene, last_tick(scene), [&](const Snapshot& wanted) {
    if (wanted.tick < 700) return;
    servo.step();
    ASSERT_TRUE(servo.take_sample(sample));
    expect_same(sample.snapshot, wanted);
  });
}

TEST(Servo, ReportsWhereItStartsBeforeItsFirstTick) {
  const Scene scene = slanted_wall();
  Servo servo(script_of(scene), start_of(scene));
  EXPECT_EQ(servo.newest().snapshot.goal, scene.goal.points.front());
  EXPECT_EQ(servo.newest().snapshot.strategies[0].device, scene.goal.points.front());
}

TEST(Servo, SpeedChangesNoNumber) {
  const Scene scene = slanted_wall();
  ServoCommand slow = start_of(scene);
  slow.speed = 0.05;
  Servo slow_servo(script_of(scene), slow);
  Servo servo(script_of(scene), start_of(scene));
  step(slow_servo, 900);
  step(servo, 900);
  expect_same(slow_servo.newest().snapshot, servo.newest().snapshot);
}

// --- Pause, step, restart --------------------------------------------------------------------------------------------

TEST(Servo, DoesNotTickWhilePaused) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  Servo servo(script_of(scene), command);
  step(servo, 600);
  const Snapshot before = servo.newest().snapshot;
  take_samples(servo);

  command.paused = true;
  servo.send(command);
  step(servo, 100);
  expect_same(servo.newest().snapshot, before);
  EXPECT_TRUE(take_samples(servo).empty());

  command.paused = false;
  servo.send(command);
  servo.step();
  EXPECT_EQ(servo.newest().snapshot.tick, before.tick + 1);
}

TEST(Servo, TakesTheStepsAskedForWhilePausedOneByOne) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  command.paused = true;
  command.steps_asked = 4'000'000'000U;  // whatever was asked for before it began
  Servo servo(script_of(scene), command);
  step(servo, 10);
  EXPECT_EQ(servo.newest().snapshot.tick, 0);

  command.steps_asked += 3;
  servo.send(command);
  for (const std::int64_t tick : {1, 2, 3, 3, 3}) {
    servo.step();
    EXPECT_EQ(servo.newest().snapshot.tick, tick);
  }
  EXPECT_EQ(take_samples(servo).size(), 4U);  // the start and three ticks
}

TEST(Servo, StepsAskedForWhileItRunsAreForgotten) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  Servo servo(script_of(scene), command);
  command.steps_asked = 5;
  servo.send(command);
  step(servo, 11);
  command.paused = true;
  servo.send(command);
  step(servo, 10);
  EXPECT_EQ(servo.newest().snapshot.tick, 10);
}

TEST(Servo, RestartsFromTheStateGiven) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  Servo servo(script_of(scene), command);
  step(servo, 1000);
  take_samples(servo);

  command.restarts_asked = 1;
  servo.send(command);
  simulate(scene, 800, [&](const Snapshot& wanted) {
    servo.step();
    Sample sample;
    ASSERT_TRUE(servo.take_sample(sample));
    EXPECT_EQ(sample.restarts, 1U);
    expect_same(sample.snapshot, wanted);
  });
  EXPECT_EQ(servo.newest().restarts, 1U);
}

TEST(Servo, RestartsWhilePaused) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  Servo servo(script_of(scene), command);
  step(servo, 1000);
  take_samples(servo);
  command.paused = true;
  command.restarts_asked = 7;
  servo.send(command);
  step(servo, 10);
  EXPECT_EQ(servo.newest().snapshot.tick, 0);
  EXPECT_EQ(take_samples(servo).size(), 1U);
}

TEST(Servo, RestartPutsTheMouseWhereTheRunStarts) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  Servo servo(std::make_unique<MouseInput>(), command);
  auto& mouse = dynamic_cast<MouseInput&>(servo.input());
  step(servo, 2);
  EXPECT_EQ(servo.newest().snapshot.goal, scene.goal.points.front());
  mouse.move_to({0.03, -0.01}, 0.005);
  step(servo, 5);
  EXPECT_EQ(servo.newest().snapshot.goal, Vector<2>(0.03, -0.01));

  command.restarts_asked = 1;
  command.restart_state = state_at_start(Vector<2>(-0.02, 0.03));
  servo.send(command);
  for (int i = 0; i < 10; ++i) {
    servo.step();
    EXPECT_EQ(servo.newest().snapshot.goal, Vector<2>(-0.02, 0.03));
  }
}

// --- Settings --------------------------------------------------------------------------------------------------------

TEST(Servo, TakesNewSettingsWholeWithTheirGeneration) {
  const Scene scene = slanted_wall();
  Settings other = scene.settings;
  other.wall_normal_angle = 2.0;
  other.actuated_angle = 0.5;
  other.stiffnesses.k_u = 300.0;
  other.stiffnesses.k_r = 500.0;

  ServoCommand command = start_of(scene);
  command.settings_generation = 40;
  Servo servo(script_of(scene), command);
  TickState<2> state = command.restart_state;
  servo.step();
  for (std::int64_t k = 1; k <= 1200; ++k) {
    if (k == 700) {
      command.settings = other;
      command.settings_generation = 41;
      servo.send(command);
    }
    servo.step();
    const TickCoefficients<2> coefficients = coefficients_of(k < 700 ? scene.settings : other);
    tick(coefficients, goal_at(scene.goal, time_of(k, coefficients.rate)), state);
    ASSERT_EQ(servo.newest().settings_generation, k < 700 ? 40U : 41U);
    expect_same(servo.newest().snapshot, snapshot_of(coefficients, state));
  }
}

TEST(Servo, ShowsNewSettingsWhilePaused) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  command.restart_state = simulate(scene, 1000, [](const Snapshot&) {});
  command.paused = true;
  Servo servo(script_of(scene), command);
  command.settings.stiffnesses.k_r *= 0.5;
  ++command.settings_generation;
  servo.send(command);
  servo.step();
  expect_same(servo.newest().snapshot, snapshot_of(coefficients_of(command.settings), command.restart_state));
}

TEST(Servo, LooksAtSettingsOnlyWhenTheirGenerationChanges) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  Servo servo(script_of(scene), command);
  command.settings.stiffnesses.k_r = nan;
  servo.send(command);
  step(servo, 10);
  EXPECT_EQ(servo.newest().refused_commands, 0U);
  EXPECT_TRUE(is_finite(servo.newest().snapshot));
}

TEST(Servo, OfSeveralCommandsTheNewestCounts) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  Servo servo(script_of(scene), command);
  for (command.settings_generation = 1; command.settings_generation < 20; ++command.settings_generation) {
    command.settings.wall_normal_angle += 0.01;
    servo.send(command);
  }
  servo.step();
  EXPECT_EQ(servo.newest().settings_generation, 19U);
}

TEST(Servo, ModelTimeGoesOnThroughAChangeOfRate) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  Servo servo(script_of(scene), command);
  step(servo, 601);
  for (const double rate : {500.0, 3000.0, 1000.0}) {
    const double before_s = servo.newest().snapshot.time_s;
    command.settings.rate = rate;
    ++command.settings_generation;
    servo.send(command);
    servo.step();
    const Snapshot& after = servo.newest().snapshot;
    // One new period on, from the new tick that is nearest to the old time.
    EXPECT_NEAR(after.time_s, before_s + 1.0 / rate, 0.5 / rate + 1e-12);
    EXPECT_EQ(after.goal, goal_at(scene.goal, after.time_s));
  }
}

// --- Samples ---------------------------------------------------------------------------------------------------------

TEST(Servo, CountsSamplesThatNobodyTook) {
  const Scene scene = slanted_wall();
  Servo servo(script_of(scene), start_of(scene));
  constexpr auto capacity = static_cast<std::int64_t>(Servo::sample_capacity);
  step(servo, capacity + 10);
  EXPECT_EQ(servo.newest().loop.dropped_samples, 10U);
  EXPECT_EQ(servo.newest().snapshot.tick, capacity + 9);
  std::vector<Sample> samples = take_samples(servo);
  ASSERT_EQ(samples.size(), Servo::sample_capacity);
  for (std::int64_t k = 0; k < capacity; ++k) ASSERT_EQ(samples[static_cast<std::size_t>(k)].snapshot.tick, k);

  servo.step();
  samples = take_samples(servo);
  ASSERT_EQ(samples.size(), 1U);
  EXPECT_EQ(samples.front().snapshot.tick, capacity + 10);
  EXPECT_EQ(servo.newest().loop.dropped_samples, 10U);
}

TEST(Servo, RecordsWhatIsNeededToGoOnExactly) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  Servo servo(std::make_unique<ScriptedInput>(scene.goal), command);
  const auto records = [&] {
    std::vector<Sample> taken;
    for (Sample sample; servo.take_record(sample);) taken.push_back(sample);
    return taken;
  };
  for (int k = 0; k < 700; ++k) servo.step();
  EXPECT_TRUE(records().empty()) << "nobody asked";
  command.recording = 3;
  servo.send(command);
  for (int k = 0; k < 50; ++k) servo.step();
  command.settings.stiffnesses.k_r = 700.0;
  ++command.settings_generation;
  servo.send(command);
  for (int k = 0; k < 50; ++k) servo.step();
  command.recording = 0;
  servo.send(command);
  servo.step();
  const std::vector<Sample> taken = records();
  ASSERT_EQ(taken.size(), 100U);

  // From the first of them, with what it holds, to the last.
  TickState<2> state;
  state.tick = taken[0].snapshot.tick;
  for (std::size_t s = 0; s < strategy_count; ++s) {
    const StrategySnapshot<2>& first = taken[0].snapshot.strategies[s];
    state.strategies[s] = {{first.device, taken[0].velocity[s]}, first.proxy, first.energy, first.in_contact};
  }
  for (std::size_t i = 1; i < taken.size(); ++i) {
    EXPECT_EQ(taken[i].serial, taken[0].serial + i);
    EXPECT_EQ(taken[i].recording, 3U);
    EXPECT_EQ(taken[i].settings.stiffnesses.k_r, i < 50 ? 1000.0 : 700.0);
    EXPECT_EQ(taken[i].loop_s, 0.0) << "stepped by hand";
    const TickCoefficients<2> coefficients = coefficients_of(taken[i].settings);
    tick(coefficients, taken[i].snapshot.goal, state);
    expect_same(taken[i].snapshot, snapshot_of(coefficients, state));
  }
}

TEST(Servo, CountsWhatTheRecorderWasTooSlowFor) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  command.recording = 1;
  Servo servo(std::make_unique<ScriptedInput>(scene.goal), command);
  for (std::size_t i = 0; i < Servo::sample_capacity + 10; ++i) servo.step();
  take_samples(servo);
  EXPECT_EQ(servo.newest().loop.dropped_records, 10U);
  Sample sample;
  for (std::size_t i = 0; i < Servo::sample_capacity; ++i) {
    ASSERT_TRUE(servo.take_record(sample));
    ASSERT_EQ(sample.serial, i);
  }
  servo.step();
  ASSERT_TRUE(servo.take_record(sample));
  EXPECT_EQ(sample.serial, Servo::sample_capacity + 10) << "the gap shows";
}

}  // namespace
}  // namespace ghostforce::servo_test
