// A tick makes no system call: a child process that may make none but exit ticks, and a call that is not allowed kills
// it. A program of its own, without anything that would make calls beside the tick.
#include <cmath>
#include <csignal>
#include <functional>
#include <numbers>

#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "core/belief.h"
#include "core/hand_measurement.h"
#include "core/latest_value.h"
#include "core/ring.h"
#include "core/sampled_device.h"
#include "core/settings.h"
#include "core/tick.h"

namespace ghostforce::tick_system_calls_test {
namespace {

constexpr int cannot_be_forbidden = 2;  // an exit code

// How a child process ended that may call read, write and the plain exit only, and did `work`; it exits with what that
// returns.
int end_of(const std::function<bool()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT) != 0) _exit(cannot_be_forbidden);
    const int code = work() ? 0 : 1;
    // The C library's exit_group is not among the calls allowed.
    syscall(SYS_exit, code);
  }
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  return status;
}

bool could_forbid(int status) {
  return !WIFEXITED(status) || WEXITSTATUS(status) != cannot_be_forbidden;
}

Settings slanted_wall() {
  Settings settings;
  settings.wall_normal_angle = 0.75 * std::numbers::pi;
  settings.mass = 0.1;
  settings.damping = 5.0;
  settings.rate = 1000.0;
  settings.stiffnesses.k_u = 200.0;
  settings.stiffnesses.k_r = 600.0;
  settings.stiffnesses.k_t = 600.0;
  settings.stiffnesses.k_c = 1e5;
  return settings;
}

using Log = Ring<Snapshot, 64>;

// Works the coefficients out anew, ticks, publishes, logs and is read from, in and out of contact.
bool live(int ticks, Log& log) {
  Settings settings = slanted_wall();
  TickCoefficients<2> coefficients = coefficients_of(settings);
  TickState<2> state = state_at_start(Vector<2>(0.0));
  LatestValue<Snapshot> newest{Snapshot{}};
  int contacts = 0;
  for (int k = 1; k <= ticks; ++k) {
    if (k % 100 == 0) {
      settings.actuated_angle += 0.1;
      coefficients = coefficients_of(settings);
    }
    const double goal = 0.02 * std::sin(0.005 * k);
    if (k % 3 == 0) {
      tick_with_device(coefficients, StrategyId::naive, {goal, -goal}, Vector<2>(0.0), 200.0, state);
    } else {
      tick(coefficients, {goal, -goal}, state);
    }
    newest.publish(snapshot_of(coefficients, state));
    if (Snapshot* const slot = log.slot(); slot != nullptr) {
      take_snapshot(coefficients, state, *slot);
      log.push();
    }
    if (k % 100 == 0) {
      for (Snapshot taken; log.try_pop(taken);) {
      }
    }
    if (newest.latest().strategies[0].in_contact) ++contacts;
  }
  return contacts > ticks / 4 && contacts < ticks;
}

// Tones, samples, estimates and the belief that follows, for a hand at a wall of 400 N/m.
bool measure(int ticks) {
  constexpr double dt = 0.001;
  HandMeasurement measurement(1.0 / dt);
  BeliefFollower follower(60.0);
  const SampledDevice device = sampled_device(0.2, 5.0, 300.0, dt);
  DeviceMotion<2> motion{Vector<2>(0.0), Vector<2>(0.0)};
  Vector<2> force(0.0);
  double believed = 0.0;
  for (int k = 1; k <= ticks; ++k) {
    motion = step(device, motion, Vector<2>(0.02, 0.0), force);
    const double tone = measurement.sound(true, true, usual_tone_force);
    force.x = tone - 400.0 * motion.position.x;
    if (measurement.add({.position = motion.position.x, .force = force.x, .tone = tone, .in_contact = true}, k * dt)) {
      believed = follower.update(measurement.reading().estimate, 600.0, 300.0);
    }
  }
  return measurement.reading().estimate.is_known() && std::abs(believed - 300.0) < 10.0;
}

TEST(TickSystemCalls, MeasuringTheHandMakesNone) {
  const int status = end_of([] { return measure(20'000); });
  if (!could_forbid(status)) GTEST_SKIP() << "this kernel or container has no seccomp";
  ASSERT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(TickSystemCalls, ThereAreNone) {
  Log log;
  const int status = end_of([&] { return live(100'000, log); });
  if (!could_forbid(status)) GTEST_SKIP() << "this kernel or container has no seccomp";
  ASSERT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(TickSystemCalls, OneWouldBeSeen) {
  Log log;
  const int status = end_of([&] {
    const bool is_well = live(1000, log);
    syscall(SYS_getpid);
    return is_well;
  });
  if (!could_forbid(status)) GTEST_SKIP() << "this kernel or container has no seccomp";
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGKILL);
}

}  // namespace
}  // namespace ghostforce::tick_system_calls_test
