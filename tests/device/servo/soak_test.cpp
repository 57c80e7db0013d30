// A long day with people who never sit still and devices that go wrong: random settings over all that a scene may hold,
// other strategies, every fault of the virtual Falcon, readings that are none, leap or stand still. Nothing that leaves
// the servo is no number, the motors get no more than they may and get it no faster, and the memory does not grow.
//
// A million ticks, or as many as GHOSTFORCE_SOAK_TICKS says. Stepped by hand: no time passes.
#include <gtest/gtest.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <memory>
#include <string>

#include "core/scene.h"
#include "device/input/mouse_input.h"
#include "device/servo/servo.h"
#include "device/virtual_falcon/virtual_falcon_input.h"
#include "tests/core/random_setting.h"
#include "tests/device/servo/servo_scenes.h"
#include "tests/support/any_value.h"
#include "tests/support/heap_guard.h"

namespace ghostforce::soak_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::int64_t soak_ticks() {
  const char* const asked = std::getenv("GHOSTFORCE_SOAK_TICKS");
  return asked == nullptr ? 1'000'000 : std::stoll(asked);
}

// --- Settings ---

// One of them changes, or all do.
void change(Settings& settings, Random& random) {
  Scene scene;
  scene.settings = settings;
  const bool all = random.once_in(20);
  const auto which = random.below(static_cast<int>(scene_keys().size()));
  for (int i = 0; i < static_cast<int>(scene_keys().size()); ++i) {
    const SceneKey& key = scene_keys()[static_cast<std::size_t>(i)];
    if (is_setting(key) && key.format == 1 && (all || i == which)) std::visit(AnyValue{scene, random}, key.value);
  }
  settings = scene.settings;
}

// --- Memory ---

struct Memory {
  std::size_t heap = 0;      // in use [bytes]; 0 under sanitizers, which have a heap of their own
  std::size_t resident = 0;  // [bytes]
};

Memory memory() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages >> pages;
  return {mallinfo2().uordblks, pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE))};
}

// Runs `round` until so many ticks have gone by; a round returns how many it made. From a tenth of them on, the memory
// stays what it is.
template <typename Round>
void soak(std::int64_t ticks, Round&& round) {
  Memory early;
  bool has_looked = false;
  for (std::int64_t done = 0; done < ticks; done += round()) {
    if (testing::Test::HasFatalFailure()) return;
    if (!has_looked && done >= ticks / 10) {
      early = memory();
      has_looked = true;
    }
  }
  const Memory late = memory();
  EXPECT_LE(late.heap, early.heap + 4096);
  EXPECT_LE(late.resident, early.resident + (std::size_t{1} << 20));
}

// What nobody took is lost, and what is taken is sound.
void take_all(Servo& servo) {
  for (Sample sample; servo.take_sample(sample);) ASSERT_TRUE(is_finite(sample.snapshot));
  for (Sample sample; servo.take_record(sample);) ASSERT_TRUE(is_finite(sample.snapshot));
}

void expect_sound(const ServoReport& report) {
  ASSERT_TRUE(is_finite(report.snapshot));
  ASSERT_TRUE(std::isfinite(report.motors.sent.x) && std::isfinite(report.motors.sent.y));
  ASSERT_LE(glm::length(report.motors.sent), force_ceiling + 1e-12);
}

// --- The mouse ---

TEST(Soak, MouseWithAnySettings) {
  Random random(20200417);
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  Servo servo(std::make_unique<MouseInput>(), command);
  auto& mouse = dynamic_cast<MouseInput&>(servo.input());
  std::int64_t contacts = 0;
  std::int64_t divergences = 0;
  soak(soak_ticks() / 2, [&] {
    constexpr int ticks = 50;
    if (random.once_in(8)) change(command.settings, random), ++command.settings_generation;
    if (random.once_in(20)) command.settings = scene.settings, ++command.settings_generation;
    if (random.once_in(50)) command.settings.mass = nan, ++command.settings_generation;
    if (random.once_in(50)) command.speed = random.once_in(2) ? nan : random.over_decades(1e-4, 100.0);
    if (random.once_in(30)) command.paused = !command.paused;
    if (command.paused) command.steps_asked += static_cast<std::uint32_t>(random.below(3));
    if (random.once_in(30) || (servo.newest().diverged && random.once_in(3))) {
      ++command.restarts_asked;
      command.restart_state = state_at_start(random.in_box<2>(random.once_in(9) ? 1e9 : 0.1));
      if (random.once_in(9)) command.restart_state.goal.x = nan;
    }
    if (random.once_in(10)) command.recording = static_cast<std::uint32_t>(random.below(3));
    {
      const HeapGuard guard;
      if (random.once_in(2)) mouse.move_to(random.in_box<2>(0.06), random.uniform(0.0, 0.1));
      if (random.once_in(20))
        mouse.move_to({random.once_in(2) ? nan : infinity, 1e300}, random.once_in(2) ? nan : -1.0);
      servo.send(command);
      for (int i = 0; i < ticks; ++i) {
        servo.step();
        const ServoReport& report = servo.newest();
        expect_sound(report);
        contacts += report.snapshot.strategies[0].in_contact ? 1 : 0;
      }
      divergences += servo.newest().diverged ? 1 : 0;
    }
    if (random.once_in(3)) take_all(servo);
    return ticks;
  });
  // It was about something.
  EXPECT_GT(contacts, soak_ticks() / 100);
  EXPECT_GT(divergences, 0);
  EXPECT_GT(servo.newest().refused_commands, 0U);
}

// --- The Falcon ---

Scene held_softly() {
  Scene scene;
  scene.settings.stiffnesses.k_u = 100.0;
  return scene;
}

// Between the driver and the servo: what no driver should ever say.
class SpoiledFalcon final : public Input, public HapticDevice {
 public:
  enum class Spoilt { not_at_all, not_a_number, far_away, leaping, stale, nonsense };

  explicit SpoiledFalcon(Random& random)
      : falcon_({}, {}, held_softly(), VirtualFalconInput::Clock::stepped), random_(random) {}

  void restart(const Vector<2>& goal) noexcept override { falcon_.restart(goal); }
  Vector<2> goal(std::int64_t tick, double rate) noexcept override { return falcon_.goal(tick, rate); }
  HapticDevice* haptic_device() noexcept override { return this; }

  std::int64_t now_ns() const noexcept override { return falcon_.now_ns(); }
  void wait_until(std::int64_t deadline_ns) noexcept override { falcon_.wait_until(deadline_ns); }
  HandleReading read() noexcept override {
    HandleReading reading = falcon_.read();
    switch (spoilt) {
      case Spoilt::not_at_all:
        break;
      case Spoilt::not_a_number:
        reading.position.y = nan;
        break;
      case Spoilt::far_away:
        reading.position = {1e300, -1e300};
        break;
      case Spoilt::leaping:
        reading.position += random_.in_box<2>(0.02);
        break;
      case Spoilt::stale:
        return before_;
      case Spoilt::nonsense:
        reading.speed = random_.once_in(2) ? nan : 1e9;
        reading.time_ns += static_cast<std::int64_t>(random_.uniform(-1e9, 1e9));
        reading.trouble = static_cast<OffReason>(random_.below(12));
        break;
    }
    return before_ = reading;
  }
  double force_at_handle() const noexcept override { return falcon_.force_at_handle(); }
  Vector<2> set_force(const Vector<2>& force, bool is_armed) noexcept override {
    pushed = force;
    armed = is_armed;
    falcon_.set_force(force, is_armed);
    return force;
  }
  double force_uncertainty() const noexcept override { return falcon_.force_uncertainty(); }
  void shut_down() noexcept override { falcon_.shut_down(); }

  VirtualFalconInput& falcon() { return falcon_; }

  Spoilt spoilt = Spoilt::not_at_all;
  Vector<2> pushed{0.0};
  bool armed = false;

 private:
  VirtualFalconInput falcon_;
  Random& random_;
  HandleReading before_;
};

TEST(Soak, FalconThatGoesWrong) {
  Random random(20200418);
  Random of_readings(1);
  constexpr Vector<2> outside{-0.02, 0.02};
  Settings usual = slanted_wall().settings;
  usual.stiffnesses.k_r = 500.0;
  usual.stiffnesses.k_t = 500.0;
  ServoCommand command = start_of(slanted_wall());
  command.settings = usual;
  command.restart_state = state_at_start(outside);
  auto input = std::make_unique<SpoiledFalcon>(of_readings);
  SpoiledFalcon& device = *input;
  Servo servo(std::move(input), command);
  const std::span<const InjectedFaultKind> faults = injected_fault_catalog();
  std::int64_t pushing = 0;
  int quiet_rounds = 0;  // still to come, in which nobody does anything wrong
  soak(soak_ticks() / 2, [&] {
    constexpr int ticks = 200;
    bool window_lives = true;
    if (quiet_rounds > 0) {
      --quiet_rounds;
    } else {
      if (random.once_in(4)) change(command.settings, random), ++command.settings_generation;
      // Each tick of a slow loop is many exchanges of the device's.
      command.settings.rate = std::clamp(command.settings.rate, 500.0, 4000.0);
      if (random.once_in(4)) {
        InjectedFault wrong;
        for (int i = random.below(3); i > 0; --i) {
          faults[static_cast<std::size_t>(random.below(static_cast<int>(faults.size())))].add(wrong);
        }
        device.falcon().inject(wrong);
      }
      if (random.once_in(3)) device.spoilt = static_cast<SpoiledFalcon::Spoilt>(random.below(6));
      if (random.once_in(20)) ++command.offs_asked;
      if (random.once_in(20)) command.has_focus = !command.has_focus;
      if (random.once_in(20)) command.paused = !command.paused;
      if (random.once_in(10)) command.safety.force_limit = random.once_in(8) ? nan : random.uniform(-1.0, 12.0);
      if (random.once_in(10)) command.safety.greatest_k_r = random.once_in(8) ? nan : random.over_decades(1.0, 1e6);
      if (random.once_in(10)) command.safety.needs_button = random.once_in(2);
      if (random.once_in(20)) ++command.restarts_asked, command.restart_state = state_at_start(random.in_box<2>(0.1));
      window_lives = !random.once_in(20);
      // And then somebody puts it all right, homes the device and arms it.
      if (random.once_in(12)) {
        quiet_rounds = 60;
        device.spoilt = SpoiledFalcon::Spoilt::not_at_all;
        device.falcon().inject({});
        command.settings = usual;
        command.settings.active = static_cast<StrategyId>(random.below(3));
        ++command.settings_generation;
        command.safety = {};
        command.has_focus = true;
        command.paused = false;
        ++command.restarts_asked;
        command.restart_state = state_at_start(outside);
      }
    }
    const HeapGuard guard;
    const bool gets_ready = quiet_rounds > 8;
    device.falcon().move_to(gets_ready ? outside : random.in_box<2>(0.03), random.uniform(0.1, 1.0));
    if (random.once_in(30)) device.falcon().move_to({nan, infinity}, nan);
    device.falcon().press(random.once_in(3) ? ReplyFrame::button_centre : std::uint8_t{0});
    if (servo.newest().motors.state == SafetyState::off && servo.newest().motors.is_ready) {
      ++command.acknowledgements;
      ++command.arms_asked;
    }
    for (int i = 0; i < ticks; ++i) {
      if (window_lives) ++command.heartbeats;
      servo.send(command);
      const Vector<2> before = device.pushed;
      servo.step();
      expect_sound(servo.newest());
      EXPECT_EQ(servo.newest().motors.sent, device.pushed);
      if (device.pushed != Vector<2>(0.0)) {
        EXPECT_TRUE(device.armed);
        EXPECT_LE(glm::length(device.pushed - before), ForceLimiter::slew * ForceLimiter::longest_step_s + 1e-9);
        ++pushing;
      }
      for (const std::int16_t count : device.falcon().link().motors()) EXPECT_LE(std::abs(int{count}), 4095);
    }
    take_all(servo);
    return ticks;
  });
  EXPECT_GT(pushing, soak_ticks() / 1000);  // it was about something
}

}  // namespace
}  // namespace ghostforce::soak_test
