#include "core/sampled_device.h"

#include <cmath>
#include <complex>
#include <limits>
#include <type_traits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/core/dimensions.h"
#include "tests/core/random_setting.h"

namespace ghostforce::sampled_device_test {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

template <typename Dimension>
class SampledDeviceTest : public testing::Test {};
TYPED_TEST_SUITE(SampledDeviceTest, Dimensions, DimensionName);

// (23)(24) as the paper prints them, one component at a time.
TYPED_TEST(SampledDeviceTest, IsOneImplicitStep) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const double mass = random.over_decades(0.001, 100.0);
    const double damping = random.over_decades(0.01, 1e3);
    const double user_stiffness = random.over_decades(0.1, 1e4);
    const SampledDevice device = sampled_device(mass, damping, user_stiffness, 1.0 / random.over_decades(10.0, 2e4));
    const DeviceMotion<D> before{random.in_box<D>(0.1), random.in_box<D>(1.0)};
    const Vector<D> goal = random.in_box<D>(0.1);
    const Vector<D> held_force = random.in_box<D>(10.0);
    const DeviceMotion<D> after = step(device, before, goal, held_force);
    for (glm::length_t j = 0; j < D; ++j) {
      const double m = device.mass;
      const double b = device.damping;
      const double k_u = device.user_stiffness;
      const double dt = device.period;
      const double left = (m + dt * b + dt * dt * k_u) * after.velocity[j];
      const double right = m * before.velocity[j] + dt * (k_u * goal[j] + held_force[j] - k_u * before.position[j]);
      const double largest = m + dt * (k_u * 0.2 + 10.0);
      EXPECT_NEAR(left, right, 8.0 * epsilon * largest);
      EXPECT_NEAR(after.position[j], before.position[j] + dt * after.velocity[j],
                  2.0 * epsilon * (0.1 + dt * std::abs(after.velocity[j])));
    }
  }
}

TYPED_TEST(SampledDeviceTest, RestsWhereHandAndRenderingBalance) {
  constexpr glm::length_t D = TypeParam::value;
  const SampledDevice device = sampled_device(0.1, 5.0, 128.0, 0.001);  // powers of two: the balance is exact
  const Vector<D> goal(0.25);
  const Vector<D> force(-16.0);
  const DeviceMotion<D> rest{goal + force / 128.0, Vector<D>(0.0)};
  const DeviceMotion<D> after = step(device, rest, goal, force);
  EXPECT_EQ(after.position, rest.position);
  EXPECT_EQ(after.velocity, Vector<D>(0.0));
}

// m ẍ + b ẋ + k x = k x_g + f from x(0), ẋ(0), in closed form through the roots of m λ² + b λ + k = 0.
double exact_position(double m, double b, double k, double goal, double force, double x0, double v0, double time) {
  const double rest = goal + force / k;
  const std::complex<double> root = std::sqrt(std::complex<double>(b * b - 4.0 * m * k));
  const std::complex<double> l1 = (-b + root) / (2.0 * m);
  const std::complex<double> l2 = (-b - root) / (2.0 * m);
  const std::complex<double> c1 = (v0 - l2 * (x0 - rest)) / (l1 - l2);
  const std::complex<double> c2 = (x0 - rest) - c1;
  return rest + (c1 * std::exp(l1 * time) + c2 * std::exp(l2 * time)).real();
}

struct Oscillator {
  const char* name;
  double mass, damping, stiffness;
};

// Greatest error over one second at a period.
double greatest_error(const Oscillator& o, double period) {
  const SampledDevice device = sampled_device(o.mass, o.damping, o.stiffness, period);
  const Vector<2> goal{0.02, -0.01};
  const Vector<2> force{1.0, 0.5};
  DeviceMotion<2> motion{{-0.03, 0.02}, {0.1, 0.2}};
  const DeviceMotion<2> start = motion;
  double worst = 0.0;
  for (int k = 1; k * period <= 1.0; ++k) {
    motion = step(device, motion, goal, force);
    for (glm::length_t j = 0; j < 2; ++j) {
      worst = std::max(worst,
                       std::abs(motion.position[j] - exact_position(o.mass, o.damping, o.stiffness, goal[j], force[j],
                                                                    start.position[j], start.velocity[j], k * period)));
    }
  }
  return worst;
}

// Half the period, half the error: the method is of first order, and what it converges to is the mass on a spring and a
// damper.
TEST(SampledDevice, ConvergesToTheMassSpringDamperAtFirstOrder) {
  for (const Oscillator& o : {Oscillator{"underdamped", 0.1, 1.0, 100.0}, Oscillator{"as shipped", 0.1, 5.0, 100.0},
                              Oscillator{"overdamped", 0.1, 20.0, 100.0}, Oscillator{"no damping", 0.5, 0.0, 50.0}}) {
    SCOPED_TRACE(o.name);
    double before = greatest_error(o, 1.0 / 4096.0);
    EXPECT_LT(before, 0.002);  // of motions of 50 mm: a few periods' worth of the greatest velocity
    for (const double period : {1.0 / 8192.0, 1.0 / 16384.0, 1.0 / 32768.0}) {
      const double error = greatest_error(o, period);
      // Second-order remains are below a tenth of the first order at these periods (20 rad/s × 1/4096 s and smaller).
      EXPECT_NEAR(before / error, 2.0, 0.1) << period;
      before = error;
    }
  }
}

// Implicit: stable at any period, however stiff the hand.
TEST(SampledDevice, StaysBoundedAtAnyPeriod) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const SampledDevice device = sampled_device(random.over_decades(0.001, 100.0), random.over_decades(1e-3, 1e4),
                                                random.over_decades(0.1, 1e6), 1.0 / random.over_decades(10.0, 2e4));
    DeviceMotion<2> motion{{0.1, -0.1}, {0.0, 0.0}};
    for (int k = 0; k < 2000; ++k) {
      motion = step(device, motion, Vector<2>(0.0), Vector<2>(0.0));
      // Energy of hand and mass never grows.
      ASSERT_LE(glm::length(motion.position), 0.15);
    }
  }
}

static_assert(noexcept(step(SampledDevice{}, DeviceMotion<2>{}, Vector<2>{}, Vector<2>{})));
static_assert(std::is_trivially_copyable_v<SampledDevice> && std::is_trivially_copyable_v<DeviceMotion<4>>);

}  // namespace
}  // namespace ghostforce::sampled_device_test
