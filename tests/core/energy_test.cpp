#include "core/energy.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/proxy.h"
#include "core/strategy.h"
#include "core/tick.h"
#include "tests/core/random_setting.h"

namespace ghostforce::energy_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Signed area of the polygon through the points, counter-clockwise positive (shoelace).
class Area {
 public:
  void add(const Vector<2>& from, const Vector<2>& to) { twice_ += from.x * to.y - from.y * to.x; }
  double value() const { return 0.5 * twice_; }

 private:
  double twice_ = 0.0;
};

TEST(EnergyTest, WorkIsForceTimesWay) {
  EXPECT_EQ(work(Vector<2>(3.0, -2.0), Vector<2>(0.5, 0.25)), 1.0);
  EXPECT_EQ(work(Vector<3>(1.0, 2.0, 3.0), Vector<3>(-1.0, 0.0, 0.0)), -1.0);
}

// --- Without time: a device led round a polygon, infinitely slowly ---------------------------------------------------

// The rendered force is linear in the device's position while it is inside the wall, so the mean of both ends times the
// way is the exact work along an edge; what remains is rounding.
double slow_work(const Wall<2>& wall, const Coupling<2>& coupling, double k_c, const std::vector<Vector<2>>& corners) {
  const Vector<2> gain = proxy_gain(wall.normal, coupling, k_c);
  const auto force = [&](const Vector<2>& device) {
    const Proxy<2> proxy = proxy_of(device, wall, gain);
    EXPECT_TRUE(proxy.in_contact);
    return coupling.rendering * (proxy.position - device);
  };
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector<2>& from = corners[i];
    const Vector<2>& to = corners[(i + 1) % corners.size()];
    sum += work(0.5 * (force(from) + force(to)), to - from);
  }
  return sum;
}

struct SlowLoop {
  Wall<2> wall;
  double theta;
  Stiffnesses k;
  double ratio;
  std::vector<Vector<2>> corners;
  double area;

  Actuation<2> actuation() const {
    return actuated_along(direction_at(std::atan2(wall.normal.y, wall.normal.x) + theta));
  }
  // Products of force and way, added up over the corners.
  double rounding() const { return 1000.0 * epsilon * k.k_r * 0.01; }
};

SlowLoop random_slow_loop(Random& random) {
  SlowLoop loop;
  loop.wall = {random.in_box<2>(0.05), direction_at(random.uniform(-4.0, 4.0))};
  loop.theta = random.uniform(-4.0, 4.0);
  loop.k = make_stiffnesses(100.0, random.over_decades(10.0, 1e4), random.over_decades(10.0, 1e4),
                            random.once_in(3) ? infinity : random.over_decades(100.0, 1e6));
  loop.ratio = random.over_decades(0.1, 30.0);
  // A polygon of any shape, of which some cross themselves, 10 to 90 mm inside.
  Area area;
  for (int i = 0; i < 7; ++i) {
    loop.corners.push_back(loop.wall.point + along(loop.wall, random.in_box<2>(0.05)) -
                           random.uniform(0.01, 0.09) * loop.wall.normal);
  }
  for (std::size_t i = 0; i < loop.corners.size(); ++i) {
    area.add(loop.corners[i], loop.corners[(i + 1) % loop.corners.size()]);
  }
  loop.area = area.value();
  return loop;
}

TEST(EnergyTest, SlowLoopOfUnderactuatedRenderingHasTheEnergyOfItsArea) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const SlowLoop loop = random_slow_loop(random);
    for (const double ratio : {1.0, loop.ratio}) {
      const Coupling<2> coupling = underactuated_coupling(loop.k.k_r, loop.k.k_t, ratio, loop.actuation());
      EXPECT_NEAR(slow_work(loop.wall, coupling, loop.k.k_c, loop.corners),
                  energy_per_loop(loop.k.k_r, loop.k.k_t, loop.k.k_c, ratio, loop.theta, loop.area),
                  loop.rounding() * (1.0 + 1.0 / ratio));
    }
  }
}

TEST(EnergyTest, OneSenseMakesWhatTheOtherTakes) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    SlowLoop loop = random_slow_loop(random);
    const Coupling<2> coupling = underactuated_coupling(loop.k.k_r, loop.k.k_t, loop.ratio, loop.actuation());
    const double one = slow_work(loop.wall, coupling, loop.k.k_c, loop.corners);
    std::reverse(loop.corners.begin(), loop.corners.end());
    const double other = slow_work(loop.wall, coupling, loop.k.k_c, loop.corners);
    EXPECT_NEAR(one, -other, loop.rounding() * (1.0 + 1.0 / loop.ratio));
    EXPECT_EQ(energy_per_loop(loop.k.k_r, loop.k.k_t, loop.k.k_c, loop.ratio, loop.theta, loop.area),
              -energy_per_loop(loop.k.k_r, loop.k.k_t, loop.k.k_c, loop.ratio, loop.theta, -loop.area));
  }
}

// The fully actuated force is that of a spring along n: a potential, hence no energy from any loop.
TEST(EnergyTest, SlowLoopOfFullyActuatedRenderingHasNone) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const SlowLoop loop = random_slow_loop(random);
    EXPECT_NEAR(slow_work(loop.wall, fully_actuated_coupling<2>(loop.k.k_r, loop.k.k_t), loop.k.k_c, loop.corners), 0.0,
                loop.rounding());
  }
}

// A horizontal motor and a wall at 45°, θ = −135°: a device led counter-clockwise loses k_r S/2/(1 + …). By hand, for a
// square of 20 mm, hard wall, k_r = 1000 N/m: 1000 × ½ × 4e-4 / 1 = 0.2 J.
TEST(EnergyTest, HasTheSignOfTheExample) {
  constexpr double theta = -0.75 * std::numbers::pi;
  EXPECT_NEAR(energy_per_loop(1000.0, 1000.0, infinity, 1.0, theta, 4e-4), -0.2, 1e-15);
  EXPECT_NEAR(energy_per_loop(1000.0, 1000.0, infinity, 1.0, theta, -4e-4), 0.2, 1e-15);
  // The cure makes less of it, by (1 + 11)/2, and a motor along or across the wall makes none.
  EXPECT_NEAR(energy_per_loop(1000.0, 1000.0, infinity, 11.0, theta, -4e-4), 0.2 / 6.0, 1e-15);
  EXPECT_EQ(energy_per_loop(1000.0, 1000.0, infinity, 1.0, 0.0, 4e-4), 0.0);
  EXPECT_NEAR(energy_per_loop(1000.0, 1000.0, infinity, 1.0, std::numbers::pi / 2.0, 4e-4), 0.0, 1e-16);
}

// --- With time: the sampled loop, the hand going round slowly inside the wall ----------------------------------------

constexpr double wall_angle = 2.2;
constexpr double theta = 0.6;

// What one lap of each strategy gave, and the integrals that its first-order losses are made of.
struct Lap {
  double energy = 0.0;                  // W [J]
  double area = 0.0;                    // S [m²]
  double along_motor = 0.0;             // ∫(A·v)² dt [m²/s]
  double along_motor_and_normal = 0.0;  // ∫(A·v)(n·v) dt [m²/s]
  double along_normal = 0.0;            // ∫(n·v)² dt [m²/s]
  double all = 0.0;                     // ∫v² dt [m²/s]
};

PerStrategy<Lap> second_lap(const Stiffnesses& k, double rate, double sense) {
  const Wall<2> wall{{0.01, 0.02}, direction_at(wall_angle)};
  const Vector<2> motor = direction_at(wall_angle + theta);
  const TickCoefficients<2> coefficients = coefficients_of(wall, actuated_along(motor), k, 0.1, 5.0, rate);
  constexpr double lap_s = 2.0;
  const auto ticks = static_cast<std::int64_t>(lap_s * rate);
  const Vector<2> center = wall.point - 0.06 * wall.normal;
  const auto goal = [&](std::int64_t tick) {
    return center + 0.02 * direction_at(sense * 2.0 * std::numbers::pi * static_cast<double>(tick % ticks) /
                                        static_cast<double>(ticks));
  };
  TickState<2> state = state_at_start(goal(0));
  while (state.tick < ticks) tick(coefficients, goal(state.tick + 1), state);  // a lap to forget the start

  PerStrategy<Lap> laps;
  PerStrategy<Area> areas;
  const TickState<2> start = state;
  while (state.tick < 2 * ticks) {
    const TickState<2> before = state;
    tick(coefficients, goal(state.tick + 1), state);
    for (std::size_t i = 0; i < strategy_count; ++i) {
      EXPECT_TRUE(state.strategies[i].in_contact);
      areas[i].add(before.strategies[i].motion.position, state.strategies[i].motion.position);
      const Vector<2>& v = state.strategies[i].motion.velocity;
      const double dt = coefficients.device.period;
      const double along_motor = glm::dot(motor, v);
      const double along_normal = glm::dot(wall.normal, v);
      laps[i].along_motor += along_motor * along_motor * dt;
      laps[i].along_motor_and_normal += along_motor * along_normal * dt;
      laps[i].along_normal += along_normal * along_normal * dt;
      laps[i].all += glm::dot(v, v) * dt;
    }
  }
  for (std::size_t i = 0; i < strategy_count; ++i) {
    laps[i].energy = state.strategies[i].energy - start.strategies[i].energy;
    laps[i].area = areas[i].value();
    // The loop is closed: the start has been forgotten.
    EXPECT_LE(glm::length(state.strategies[i].motion.position - start.strategies[i].motion.position), 1e-12);
  }
  return laps;
}

// The held force of tick k − 1 is K_r (q_p(q_h,k−2) − q_h,k−1): the wall's force of 1.5 ticks before the middle of the
// step, less K_r dt v. With the wall's force
//     F(q) = −g A (n·q) + const.,   g = k_r cosθ/(cos²θ + ρ sin²θ + k_t/k_c)
// the work of a lap is therefore, up to second order in dt,
//     formula + dt (1.5 g ∫(A·v)(n·v) dt − k_r ∫(A·v)² dt)
// and for the fully actuated device, with g = k_r/(1 + k_t/k_c) along n,
//     0 + dt (1.5 g ∫(n·v)² dt − k_r ∫v² dt)
struct Expected {
  double slow;         // [J]
  double first_order;  // [J]
};

PerStrategy<Expected> expected_of(const PerStrategy<Lap>& laps, const Stiffnesses& k, double rate) {
  PerStrategy<Expected> expected;
  for (const Strategy& strategy : strategy_catalog()) {
    const Lap& lap = laps[index_of(strategy.id)];
    Expected& e = expected[index_of(strategy.id)];
    const double dt = 1.0 / rate;
    if (strategy.has_every_motor) {
      const double g = k.k_r / (1.0 + k.k_t / k.k_c);
      e = {0.0, dt * (1.5 * g * lap.along_normal - k.k_r * lap.all)};
    } else {
      const double ratio = strategy.tracking_ratio(k);
      const double c = std::cos(theta);
      const double s = std::sin(theta);
      const double g = k.k_r * c / (c * c + ratio * s * s + k.k_t / k.k_c);
      e = {energy_per_loop(k.k_r, k.k_t, k.k_c, ratio, theta, lap.area),
           dt * (1.5 * g * lap.along_motor_and_normal - k.k_r * lap.along_motor)};
    }
  }
  return expected;
}

// Twice the rate, half the difference from the slow formula and a quarter of what the delay does not explain.
TEST(EnergyTest, SampledLoopHasTheEnergyOfTheFormulaLessTheDelay) {
  for (const double k_c : {2000.0, 1e5, infinity}) {
    for (const double sense : {1.0, -1.0}) {
      const Stiffnesses k = make_stiffnesses(100.0, 300.0, 400.0, k_c);
      PerStrategy<double> difference_before{};
      PerStrategy<double> remainder_before{};
      for (const double rate : {1000.0, 2000.0, 4000.0}) {
        const PerStrategy<Lap> laps = second_lap(k, rate, sense);
        const PerStrategy<Expected> expected = expected_of(laps, k, rate);
        for (std::size_t i = 0; i < strategy_count; ++i) {
          SCOPED_TRACE(testing::Message() << strategy_catalog()[i].name << ", k_c " << k_c << ", sense " << sense
                                          << ", " << rate << " Hz");
          const double difference = laps[i].energy - expected[i].slow;
          const double remainder = difference - expected[i].first_order;
          // At 1 kHz and π rad/s the orders are 1.5 ticks × π/s = 0.5 % apart.
          EXPECT_LT(std::abs(remainder), 0.005 * std::abs(difference));
          if (!strategy_catalog()[i].has_every_motor) {
            EXPECT_LT(std::abs(difference), 0.01 * std::abs(laps[i].energy));
            EXPECT_EQ(laps[i].energy > 0.0, sense < 0.0);  // sinθ cosθ > 0: clockwise makes energy
          }
          if (rate > 1000.0) {
            EXPECT_NEAR(difference_before[i] / difference, 2.0, 0.02);  // the next order, again
            EXPECT_GT(remainder_before[i] / remainder, 3.9);            // 4, or 8 where the second order vanishes
          }
          difference_before[i] = difference;
          remainder_before[i] = remainder;
        }
      }
    }
  }
}

// In free space the held force is −K_r dt v of the tick before: only a loss, of k_r dt ∫v² dt along the motors.
TEST(EnergyTest, FreeSpaceOnlyLoses) {
  const Wall<2> wall{{0.0, -1.0}, {0.0, 1.0}};
  const TickCoefficients<2> coefficients = coefficients_of(
      wall, actuated_along(Vector<2>{1.0, 0.0}), make_stiffnesses(100.0, 300.0, 400.0, 1e5), 0.1, 5.0, 1000.0);
  TickState<2> state = state_at_start(Vector<2>(0.0));
  PerStrategy<double> lost{};
  for (int k = 1; k <= 2000; ++k) {
    const TickState<2> before = state;
    tick(coefficients, 0.05 * direction_at(0.005 * k), state);
    for (std::size_t i = 0; i < strategy_count; ++i) {
      const Vector<2> held = coefficients.strategies[i].rendering * before.strategies[i].motion.velocity;
      lost[i] += 1e-6 * glm::dot(held, state.strategies[i].motion.velocity);
    }
  }
  for (std::size_t i = 0; i < strategy_count; ++i) {
    SCOPED_TRACE(strategy_catalog()[i].name);
    EXPECT_GT(lost[i], 1e-4);
    // 2000 terms; a force is k_r times a difference of positions that are 1000 times larger.
    EXPECT_NEAR(state.strategies[i].energy, -lost[i], 1e-12);
  }
}

}  // namespace
}  // namespace ghostforce::energy_test
