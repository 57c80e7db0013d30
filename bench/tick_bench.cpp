// What a tick costs, against the same equations written by hand, and what it costs to log and publish it. Writes
// section 1 of RESULTS.md.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "bench/general_tick.h"
#include "bench/support/contest.h"
#include "bench/support/report.h"
#include "core/latest_value.h"
#include "core/ring.h"
#include "core/tick.h"
#include "device/input/scripted_input.h"
#include "device/servo/servo.h"

namespace ghostforce::bench {
namespace {

// Turns shorter than the time slices of a machine that others use too: most of them are interrupted by nobody.
constexpr Contest::Length many_short_turns{.rounds = 201, .seconds_per_turn = 0.001};

template <glm::length_t D>
Vector<D> along_axes(double first, double others) {
  Vector<D> v(others);
  v[0] = first;
  return v;
}

// A wall at 45°, one motor, stiffnesses as in the scene wall45.
template <glm::length_t D>
TickCoefficients<D> slanted_coefficients() {
  const Wall<D> wall{Vector<D>(0.0), glm::normalize(along_axes<D>(-1.0, 1.0))};
  Stiffnesses stiffnesses;
  stiffnesses.k_u = 200.0;
  stiffnesses.k_r = 600.0;
  stiffnesses.k_t = 600.0;
  stiffnesses.k_c = 1e5;
  return coefficients_of<D>(wall, actuated_along(along_axes<D>(1.0, 0.0)), stiffnesses, 0.1, 5.0, 1000.0);
}

// Into the wall and out of it again, about once a second of model time. A power of two.
constexpr std::size_t goal_count = 1024;

template <glm::length_t D>
std::vector<Vector<D>> goals_in_and_out() {
  std::vector<Vector<D>> goals;
  for (std::size_t k = 0; k < goal_count; ++k) {
    const double depth = 0.02 * std::sin(2.0 * std::numbers::pi * static_cast<double>(k) / goal_count);
    goals.push_back(along_axes<D>(depth, -depth));
  }
  return goals;
}

// One strategy on plain numbers, all that a setting decides worked out beforehand.
template <std::size_t D>
class ByHand {
 public:
  using Numbers = std::array<double, D>;
  struct State {
    Numbers position{};
    Numbers velocity{};
    Numbers proxy{};
    double energy = 0.0;
  };

  ByHand(const TickCoefficients<D>& coefficients, std::size_t strategy) : dt_(coefficients.device.period) {
    for (std::size_t i = 0; i < D; ++i) {
      const auto row = static_cast<glm::length_t>(i);
      point_[i] = coefficients.wall.point[row];
      normal_[i] = coefficients.wall.normal[row];
      proxy_gain_[i] = coefficients.strategies[strategy].proxy_gain[row];
      for (std::size_t j = 0; j < D; ++j) {
        rendering_[i][j] = coefficients.strategies[strategy].rendering[static_cast<glm::length_t>(j)][row];
      }
    }
    const double user_stiffness = coefficients.device.user_stiffness;
    const double effective_mass =
        coefficients.device.mass + dt_ * coefficients.device.damping + dt_ * dt_ * user_stiffness;
    keeps_ = coefficients.device.mass / effective_mass;
    hand_ = dt_ * user_stiffness / effective_mass;
    held_ = dt_ / effective_mass;
  }

  void tick(const Vector<D>& goal, State& s) const {
    double distance = 0.0;
    Numbers force{};
    for (std::size_t i = 0; i < D; ++i) {
      distance += normal_[i] * (s.position[i] - point_[i]);
      for (std::size_t j = 0; j < D; ++j) force[i] += rendering_[i][j] * (s.proxy[j] - s.position[j]);
    }
    double work = 0.0;
    for (std::size_t i = 0; i < D; ++i) {
      const double before = s.position[i];
      const double reach = goal[static_cast<glm::length_t>(i)] - before;
      s.velocity[i] = keeps_ * s.velocity[i] + hand_ * reach + held_ * force[i];
      s.position[i] = before + dt_ * s.velocity[i];
      s.proxy[i] = distance < 0.0 ? before - proxy_gain_[i] * distance : before;
      work += force[i] * (s.position[i] - before);
    }
    s.energy += work;
  }

 private:
  std::array<Numbers, D> rendering_{};
  Numbers proxy_gain_{};
  Numbers normal_{};
  Numbers point_{};
  double dt_;
  double keeps_ = 0.0;
  double hand_ = 0.0;
  double held_ = 0.0;
};

std::string ns(double seconds) {
  return fmt::format("{:.1f} ns", 1e9 * seconds);
}

// A loop over ticks of so many strategies; the state is the loop's own until it ends.
template <std::size_t count, typename State, typename Goals, typename Tick>
Contestant loop(std::string name, State start, const Goals& goals, Tick tick) {
  std::array<State, count> states;
  states.fill(start);
  return {std::move(name), [=, &goals](std::int64_t calls) mutable {
            std::array<State, count> own = states;
            for (std::int64_t k = 0; k < calls; ++k) {
              const auto& goal = goals[static_cast<std::size_t>(k) % goal_count];
              for (std::size_t i = 0; i < count; ++i) tick(i, goal, own[i]);
            }
            states = own;
            keep(&states);
          }};
}

template <glm::length_t D>
void compare(Report& report) {
  constexpr auto size = static_cast<std::size_t>(D);
  const TickCoefficients<D> coefficients = slanted_coefficients<D>();
  const auto goals = goals_in_and_out<D>();
  using Hand = ByHand<size>;
  const std::array<Hand, 3> hands{{{coefficients, 0}, {coefficients, 1}, {coefficients, 2}}};
  const auto one_by_hand = [=](std::size_t, const Vector<D>& goal, auto& s) { hands[2].tick(goal, s); };
  const auto all_by_hand = [=](std::size_t i, const Vector<D>& goal, auto& s) { hands[i].tick(goal, s); };
  const auto ours = [=](std::size_t, const Vector<D>& goal, auto& s) {
    tick_strategy<D>(coefficients, coefficients.strategies[2], goal, s);
  };

  TickState<D> state = state_at_start(Vector<D>(0.0));
  std::array<typename Hand::State, 3> same{};
  for (std::size_t k = 0; k < 4 * goal_count; ++k) {
    tick(coefficients, goals[k % goal_count], state);
    for (std::size_t i = 0; i < 3; ++i) hands[i].tick(goals[k % goal_count], same[i]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t axis = 0; axis < size; ++axis) {
      const double there = state.strategies[i].motion.position[static_cast<glm::length_t>(axis)];
      // glm adds four products in another order.
      if (!(std::abs(same[i].position[axis] - there) < 1e-12)) throw std::runtime_error("the loops differ");
    }
  }

  const Contest contest({loop<1>("one", state.strategies[2], goals, ours),
                         loop<1>("one by hand", typename Hand::State{}, goals, one_by_hand),
                         {"all",
                          [&](std::int64_t calls) {
                            for (std::int64_t k = 0; k < calls; ++k)
                              tick(coefficients, goals[static_cast<std::size_t>(k) % goal_count], state);
                            keep(&state);
                          }},
                         loop<3>("all by hand", typename Hand::State{}, goals, all_by_hand)},
                        many_short_turns);
  const auto row = [&](std::string_view what, std::string_view name, std::optional<double> limit) {
    const std::string by_hand = std::string(name) + " by hand";
    const double ratio = contest.ratio(name, by_hand);
    report.row(fmt::format("D = {}: {}, against {} by hand", D, what, ns(contest.median_seconds(by_hand))),
               fmt::format("{}, {:.2f} times", ns(contest.median_seconds(name)), ratio),
               limit ? std::optional(at_most(ratio, *limit)) : std::nullopt);
  };
  row("one strategy", "one", 1.25);
  row("all three, by tick()", "all", std::nullopt);
}

// As the servo does it at each deadline. Another thread takes the samples out of the ring; here that happens between
// turns, which must therefore be short enough for the ring to hold all of one.
void log_and_publish(Report& report) {
  const TickCoefficients<2> coefficients = slanted_coefficients<2>();
  const auto goals = goals_in_and_out<2>();
  TickState<2> state = state_at_start(Vector<2>(0.0));
  ServoReport newest;
  const Settings settings;
  LatestValue<ServoReport> reports{newest};
  Servo::SampleRing samples;
  std::uint64_t serial = 0;
  bool was_full = false;
  const auto tick_once = [&](std::int64_t k) {
    tick(coefficients, goals[static_cast<std::size_t>(k) % goal_count], state);
    take_snapshot(coefficients, state, newest.snapshot);
  };
  const auto log = [&] {
    Sample* const sample = samples.slot();
    if (sample == nullptr) {
      was_full = true;
      return;
    }
    copy_whole(newest.snapshot, sample->snapshot);
    for (std::size_t i = 0; i < strategy_count; ++i) sample->velocity[i] = state.strategies[i].motion.velocity;
    copy_settings(settings, sample->settings);
    sample->serial = serial++;
    sample->restarts = newest.restarts;
    sample->recording = 0;
    sample->loop_s = 0.001;
    sample->sent = newest.motors.sent;
    sample->is_saturated = newest.motors.is_saturated;
    samples.push();
  };
  const auto take_all = [&] {
    for (Sample taken; samples.try_pop(taken);) keep(&taken);
  };
  constexpr Contest::Length turns_that_fit{.rounds = 201, .seconds_per_turn = 0.0002};
  const Contest contest({{"tick and snapshot",
                          [&](std::int64_t calls) {
                            for (std::int64_t k = 0; k < calls; ++k) {
                              tick_once(k);
                              keep(&newest);
                            }
                          }},
                         {"published too",
                          [&](std::int64_t calls) {
                            for (std::int64_t k = 0; k < calls; ++k) {
                              tick_once(k);
                              reports.publish(newest);
                            }
                          }},
                         {"logged too",
                          [&](std::int64_t calls) {
                            for (std::int64_t k = 0; k < calls; ++k) {
                              tick_once(k);
                              log();
                              reports.publish(newest);
                            }
                          },
                          take_all}},
                        turns_that_fit);
  if (was_full) throw std::runtime_error("the ring was full");
  report.row("D = 2: all three and their snapshot", ns(contest.median_seconds("tick and snapshot")));
  report.row(fmt::format("and published, {} bytes", sizeof(ServoReport)), ns(contest.median_seconds("published too")));
  const double all = contest.median_seconds("logged too");
  report.row(fmt::format("and logged, {} bytes into the ring", sizeof(Sample)), ns(all),
             at_most(1e9 * all, 60.0, "ns"));
}

// The whole of what a tick does, at the wall, with and without tones that measure the hand.
void measure_hand(Report& report) {
  ServoCommand command;
  command.settings.wall_normal_angle = 0.75 * std::numbers::pi;
  command.settings.mass = 0.1;
  command.settings.damping = 5.0;
  command.settings.rate = 1000.0;
  command.settings.stiffnesses.k_u = 200.0;
  command.settings.stiffnesses.k_r = 600.0;
  command.settings.stiffnesses.k_t = 600.0;
  command.settings.stiffnesses.k_c = 1e5;
  const Vector<2> goal = -0.02 * wall_of(command.settings).normal;
  command.restart_state = state_at_start(goal);
  const auto servo_of = [&](bool measures, bool follows) {
    command.measures_hand = measures;
    command.belief_follows_hand = follows;
    auto servo =
        std::make_unique<Servo>(std::make_unique<ScriptedInput>(GoalPath{.points = {goal}, .times = {0.0}}), command);
    servo->send(command);
    return servo;
  };
  struct Stepped {
    std::string name;
    std::unique_ptr<Servo> servo;
  };
  std::array<Stepped, 3> all{Stepped{"idle", servo_of(false, false)}, Stepped{"measures", servo_of(true, false)},
                             Stepped{"follows", servo_of(true, true)}};
  std::vector<Contestant> contestants;
  const auto take_all = [](Servo& servo) {
    for (Sample taken; servo.take_sample(taken);) keep(&taken);
  };
  for (Stepped& one : all) {
    Servo& servo = *one.servo;
    for (int i = 0; i < 4000; ++i) {
      servo.step();
      take_all(servo);
    }
    if (servo.newest().hand.estimate.is_known() != (one.name != "idle"))
      throw std::runtime_error(one.name + ": " + std::string(sentence_of(servo.newest().hand.estimate.why)));
    contestants.push_back({one.name,
                           [&servo](std::int64_t calls) {
                             for (std::int64_t k = 0; k < calls; ++k) servo.step();
                           },
                           [&servo, take_all] { take_all(servo); }});
  }
  // As many ticks as the ring holds, or fewer, and an estimate in each.
  const Contest contest(std::move(contestants), {.rounds = 201, .seconds_per_turn = 0.0002});
  if (all[1].servo->newest().loop.dropped_samples > 0) throw std::runtime_error("the ring was full");
  const auto row = [&](std::string_view what, std::string_view name, std::optional<double> limit) {
    const double ratio = contest.ratio(name, "idle");
    report.row(std::string(what), fmt::format("{}, {:.2f} times", ns(contest.median_seconds(name)), ratio),
               limit ? std::optional(at_most(ratio, *limit)) : std::nullopt);
  };
  report.row("Servo::step() at the wall", ns(contest.median_seconds("idle")));
  row("… with tones and estimator", "measures", 2.0);
  row("… and a belief that follows", "follows", std::nullopt);
}

void publish(Report& report) {
  struct alignas(64) Bytes {
    std::array<std::uint64_t, 32> numbers;
  };
  Bytes source{};
  LatestValue<Bytes> value{source};
  // Three places in turn, as the exchange has them: a copy over the last one would have to wait for it.
  std::array<Bytes, 3> copies{};
  const Contest contest({{"published",
                          [&](std::int64_t calls) {
                            for (std::int64_t k = 0; k < calls; ++k) {
                              keep(&source);
                              value.publish(source);
                            }
                          }},
                         {"copied",
                          [&](std::int64_t calls) {
                            std::size_t place = 0;
                            for (std::int64_t k = 0; k < calls; ++k) {
                              keep(&source);
                              copy_whole(source, copies[place]);
                              keep(&copies);
                              place = place == 2 ? 0 : place + 1;
                            }
                          }}},
                        many_short_turns);
  const double ratio = contest.ratio("published", "copied");
  report.row(fmt::format("256 bytes published, against {} for a bare copy", ns(contest.median_seconds("copied"))),
             fmt::format("{}, {:.2f} times", ns(contest.median_seconds("published")), ratio), at_most(ratio, 1.5));
}

}  // namespace

int run(int argc, char** argv) {
  Report report("1. The tick");
  report.paragraph(
      "Ticks under a goal that goes into the wall and out again. By hand: the same equations on plain numbers, all "
      "that the settings decide worked out beforehand, which leaves no division, the state in registers. One strategy "
      "has its state in registers, too; tick() is called as the servo calls it, with its state in memory.");
  compare<2>(report);
  compare<3>(report);
  compare<4>(report);
  log_and_publish(report);
  compare_general(report);
  measure_hand(report);
  publish(report);
  report.note(fmt::format(
      "Logged is what the servo's thread pays: the samples are taken out of the ring by another thread, here between "
      "the turns. The ring's {} samples are {:.1f} MB, more than a second-level cache keeps, so that writing them "
      "waits for memory, here as in the program. A sample is written in the ring itself and a snapshot where it is "
      "published from; to copy each three times and to go through a ring with semaphores was seen to take 97 ns.",
      Servo::sample_capacity, 1e-6 * static_cast<double>(Servo::sample_capacity * sizeof(Sample))));
  report.note(
      "What publishing costs beyond the copy is one atomic exchange, which is what lets neither side wait. Tests show "
      "that nothing is torn (core_latest_value_test, under the thread sanitizer too) and that a tick makes no system "
      "call (core_tick_system_calls_test).");
  return report.finish(argc, argv);
}

}  // namespace ghostforce::bench
