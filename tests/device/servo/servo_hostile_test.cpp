// The servo under whatever it may be sent: numbers that are none, states from nowhere, settings that blow up.
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/simulate.h"
#include "device/input/mouse_input.h"
#include "device/servo/servo.h"
#include "tests/device/servo/servo_scenes.h"
#include "tests/device/servo/servo_steps.h"

namespace ghostforce::servo_hostile_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Hostile {
  const char* what;
  void (*spoil)(ServoCommand&);
};

const Hostile hostile_settings[] = {
    {"rate zero", [](ServoCommand& c) { c.settings.rate = 0.0; }},
    {"rate negative", [](ServoCommand& c) { c.settings.rate = -1000.0; }},
    {"rate NaN", [](ServoCommand& c) { c.settings.rate = nan; }},
    {"rate inf", [](ServoCommand& c) { c.settings.rate = infinity; }},
    {"rate tiny", [](ServoCommand& c) { c.settings.rate = 1e-300; }},
    {"rate huge", [](ServoCommand& c) { c.settings.rate = 1e300; }},
    {"rate not whole", [](ServoCommand& c) { c.settings.rate = 1000.5; }},
    {"mass zero", [](ServoCommand& c) { c.settings.mass = 0.0; }},
    {"mass NaN", [](ServoCommand& c) { c.settings.mass = nan; }},
    {"damping negative", [](ServoCommand& c) { c.settings.damping = -5.0; }},
    {"damping inf", [](ServoCommand& c) { c.settings.damping = infinity; }},
    {"k_u zero", [](ServoCommand& c) { c.settings.stiffnesses.k_u = 0.0; }},
    {"believed k_u NaN", [](ServoCommand& c) { c.settings.stiffnesses.believed_k_u = nan; }},
    {"k_r NaN", [](ServoCommand& c) { c.settings.stiffnesses.k_r = nan; }},
    {"k_r negative", [](ServoCommand& c) { c.settings.stiffnesses.k_r = -1.0; }},
    {"k_t zero", [](ServoCommand& c) { c.settings.stiffnesses.k_t = 0.0; }},
    {"k_t inf", [](ServoCommand& c) { c.settings.stiffnesses.k_t = infinity; }},
    {"k_c zero", [](ServoCommand& c) { c.settings.stiffnesses.k_c = 0.0; }},
    {"k_c minus inf", [](ServoCommand& c) { c.settings.stiffnesses.k_c = -infinity; }},
    {"ratio zero", [](ServoCommand& c) { c.settings.stiffnesses.chosen_tracking_ratio = 0.0; }},
    {"wall point NaN", [](ServoCommand& c) { c.settings.wall_point.y = nan; }},
    {"wall point far", [](ServoCommand& c) { c.settings.wall_point.x = 1.5; }},
    {"wall angle NaN", [](ServoCommand& c) { c.settings.wall_normal_angle = nan; }},
    {"actuated angle inf", [](ServoCommand& c) { c.settings.actuated_angle = infinity; }},
    {"no such strategy", [](ServoCommand& c) { c.settings.active = static_cast<StrategyId>(200); }},
};

TEST(Servo, RefusesHostileSettingsAsAWhole) {
  const Scene scene = slanted_wall();
  const ServoCommand good = start_of(scene);
  for (const Hostile& hostile : hostile_settings) {
    SCOPED_TRACE(hostile.what);
    Servo servo(script_of(scene), good);
    step(servo, 600);
    ServoCommand bad = good;
    bad.settings.stiffnesses.k_r = 5.0;  // must not come through either
    hostile.spoil(bad);
    bad.settings_generation = 1;
    servo.send(bad);
    step(servo, 401);
    EXPECT_EQ(servo.newest().refused_commands, 1U);
    EXPECT_EQ(servo.newest().settings_generation, 0U);
    simulate(scene, 1000, [&](const Snapshot& wanted) {
      if (wanted.tick == 1000) expect_same(servo.newest().snapshot, wanted);
    });

    ServoCommand again = good;
    again.settings_generation = 2;
    servo.send(again);
    servo.step();
    EXPECT_EQ(servo.newest().settings_generation, 2U);
    EXPECT_EQ(servo.newest().refused_commands, 1U);

    EXPECT_THROW(Servo(script_of(scene), bad), std::invalid_argument);
  }
}

TEST(Servo, RefusesWhatIsNoSpeed) {
  const Scene scene = slanted_wall();
  for (const double speed : {0.0, -1.0, nan, infinity}) {
    ServoCommand command = start_of(scene);
    Servo servo(script_of(scene), command);
    command.speed = speed;
    servo.send(command);
    step(servo, 10);
    EXPECT_EQ(servo.newest().refused_commands, 1U) << speed;
    EXPECT_EQ(servo.newest().snapshot.tick, 9) << "goes on at the speed before";
    EXPECT_THROW(Servo(script_of(scene), command), std::invalid_argument);
  }
}

const Hostile hostile_states[] = {
    {"goal NaN", [](ServoCommand& c) { c.restart_state.goal.x = nan; }},
    {"device inf", [](ServoCommand& c) { c.restart_state.strategies[1].motion.position.y = infinity; }},
    {"velocity NaN", [](ServoCommand& c) { c.restart_state.strategies[2].motion.velocity.x = nan; }},
    {"proxy far", [](ServoCommand& c) { c.restart_state.strategies[0].proxy.x = 1e9; }},
    {"energy NaN", [](ServoCommand& c) { c.restart_state.strategies[0].energy = nan; }},
    {"tick negative", [](ServoCommand& c) { c.restart_state.tick = -1; }},
    {"tick at its end", [](ServoCommand& c) { c.restart_state.tick = std::numeric_limits<std::int64_t>::max(); }},
};

TEST(Servo, RefusesToRestartFromAHostileState) {
  const Scene scene = slanted_wall();
  for (const Hostile& hostile : hostile_states) {
    SCOPED_TRACE(hostile.what);
    ServoCommand command = start_of(scene);
    Servo servo(script_of(scene), command);
    step(servo, 10);
    hostile.spoil(command);
    command.restarts_asked = 1;
    servo.send(command);
    step(servo, 10);
    EXPECT_EQ(servo.newest().restarts, 0U);
    EXPECT_EQ(servo.newest().refused_commands, 1U);
    EXPECT_EQ(servo.newest().snapshot.tick, 19);
    EXPECT_THROW(Servo(script_of(scene), command), std::invalid_argument);
  }
}

TEST(Servo, StopsBeforeUnstableSettingsBlowUp) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  Servo servo(script_of(scene), command);
  step(servo, 1000);
  command.settings = unstable_settings();
  command.settings_generation = 1;
  servo.send(command);
  for (int i = 0; i < 1000; ++i) {
    servo.step();
    ASSERT_TRUE(is_finite(servo.newest().snapshot));
  }
  ASSERT_TRUE(servo.newest().diverged);
  const std::int64_t last = servo.newest().snapshot.tick;
  EXPECT_LT(last, 1999);
  EXPECT_EQ(take_samples(servo).back().snapshot.tick, last);

  command.settings = scene.settings;
  command.settings_generation = 2;
  command.restarts_asked = 1;
  servo.send(command);
  step(servo, 101);
  EXPECT_FALSE(servo.newest().diverged);
  simulate(scene, 100, [&](const Snapshot& wanted) {
    if (wanted.tick == 100) expect_same(servo.newest().snapshot, wanted);
  });
}

// Numbers of any size and kind, in range and out of it: every report is finite, and the servo comes back.
TEST(Servo, StaysFiniteWhateverItIsSent) {
  std::mt19937_64 random(20240607);
  const auto any_number = [&random]() -> double {
    switch (random() % 4) {
      case 0:
        return std::bit_cast<double>(random());  // NaN, infinities, denormals among them
      case 1:
        return std::ldexp(1.0, static_cast<int>(random() % 40) - 20);
      case 2:
        return static_cast<double>(random() % 20001);
      default:
        return 0.0;
    }
  };
  const Scene scene = slanted_wall();
  const ServoCommand good = start_of(scene);
  Servo servo(std::make_unique<MouseInput>(), good);
  auto& mouse = dynamic_cast<MouseInput&>(servo.input());
  ServoCommand command = good;
  for (int round = 0; round < 5000; ++round) {
    Settings& settings = command.settings;
    Stiffnesses& stiffnesses = settings.stiffnesses;
    double* const numbers[] = {&settings.wall_point.x,
                               &settings.wall_point.y,
                               &settings.wall_normal_angle,
                               &settings.actuated_angle,
                               &settings.mass,
                               &settings.damping,
                               &settings.rate,
                               &stiffnesses.k_u,
                               &stiffnesses.believed_k_u.emplace(stiffnesses.k_u),
                               &stiffnesses.k_r,
                               &stiffnesses.k_t,
                               &stiffnesses.k_c,
                               &stiffnesses.chosen_tracking_ratio.emplace(1.0),
                               &command.speed};
    if (round % 10 == 0) command.settings = good.settings;
    *numbers[random() % std::size(numbers)] = any_number();
    ++command.settings_generation;
    if (round % 7 == 0) ++command.restarts_asked;
    servo.send(command);
    mouse.move_to({any_number(), any_number()}, any_number());
    for (int i = 0; i < 20; ++i) {
      servo.step();
      ASSERT_TRUE(is_finite(servo.newest().snapshot)) << "round " << round;
    }
  }
  EXPECT_GT(servo.newest().refused_commands, 100U);

  const std::uint32_t generation = command.settings_generation + 1;
  const std::uint32_t restarts = command.restarts_asked + 1;
  command = good;
  command.settings_generation = generation;
  command.restarts_asked = restarts;
  servo.send(command);
  step(servo, 11);
  EXPECT_EQ(servo.newest().snapshot.tick, 10);
}

}  // namespace
}  // namespace ghostforce::servo_hostile_test
