#include "core/proxy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <gtest/gtest.h>

#include "tests/core/dimensions.h"
#include "tests/core/random_setting.h"
#include "tests/core/reference_model.h"

namespace ghostforce::proxy_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

template <glm::length_t D>
Coupling<D> coupling_of(const Setting<D>& setting) {
  return underactuated_coupling(setting.stiffnesses.k_r, setting.stiffnesses.k_t, setting.ratio, setting.actuation());
}

// C = K_t⁻¹ n is good to ε (1 + ρ)/k_t, and so is s = n·C; a gain of length |C|/s ≤ √((1 + ρ)/(k_t s)) times the way to
// the wall, each with a few roundings.
template <glm::length_t D>
double rounding(const Setting<D>& setting) {
  const double alpha = glm::dot(setting.wall.normal, setting.actuation().actuated * setting.wall.normal);
  const double g = (1.0 + setting.ratio) / (alpha + setting.ratio * (1.0 - alpha));
  const double reach = glm::length(setting.goal - setting.wall.point);
  return 32.0 * epsilon *
         (glm::length(setting.goal) + glm::length(setting.wall.point) + reach * g * (1.0 + std::sqrt(g)));
}

template <typename Dimension>
class ProxyTest : public testing::Test {};
TYPED_TEST_SUITE(ProxyTest, Dimensions, DimensionName);

// (22)(25) as a system that Eigen solves; the device stands where the setting has its goal, inside the wall.
TYPED_TEST(ProxyTest, BalancesWallAndTracking) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    const Vector<D> gain = proxy_gain(setting.wall.normal, coupling_of(setting), setting.stiffnesses.k_c);
    const Proxy<D> proxy = proxy_of(setting.goal, setting.wall, gain);
    EXPECT_TRUE(proxy.in_contact);
    EXPECT_LE(distance(proxy.position,
                       reference_proxy(underactuated_reference(setting, setting.ratio), reference(setting.goal))),
              rounding(setting));
  }
}

// The proxy is where the energy of wall and tracking spring, ½ k_c (n·(o − q))² + ½ (q_h − q)ᵀK_t (q_h − q), is least.
TYPED_TEST(ProxyTest, HasTheLeastEnergy) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE(i);
    Setting<D> setting = random_setting<D>(random);
    if (std::isinf(setting.stiffnesses.k_c)) setting.stiffnesses.k_c = 1e5;
    const Coupling<D> coupling = coupling_of(setting);
    const Vector<D>& device = setting.goal;
    const auto energy = [&](const Vector<D>& q) {
      const double d = depth(setting.wall, q);
      return 0.5 * setting.stiffnesses.k_c * d * d + 0.5 * glm::dot(device - q, coupling.tracking * (device - q));
    };
    const Vector<D> proxy =
        proxy_of(device, setting.wall, proxy_gain(setting.wall.normal, coupling, setting.stiffnesses.k_c)).position;
    for (int j = 0; j < 10; ++j) EXPECT_LT(energy(proxy), energy(proxy + 1e-4 * random.direction<D>()));
  }
}

TYPED_TEST(ProxyTest, LiesOnAHardWall) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    const Vector<D> gain = proxy_gain(setting.wall.normal, coupling_of(setting), infinity);
    EXPECT_NEAR(depth(setting.wall, proxy_of(setting.goal, setting.wall, gain).position), 0.0, rounding(setting));
  }
}

// Infinity is no special case: the gain of stiffer and stiffer walls runs into that of the hard one, at first order in
// 1/k_c, from below.
TYPED_TEST(ProxyTest, HardWallIsTheLimitOfStiffOnes) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(4);
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    const Coupling<D> coupling = coupling_of(setting);
    const Vector<D>& n = setting.wall.normal;
    const double s = glm::dot(n, coupling.tracking_compliance * n);
    const Vector<D> hard = proxy_gain(n, coupling, infinity);
    EXPECT_NEAR(glm::dot(n, hard), 1.0, 4.0 * epsilon);
    for (const double softness : {1e-2, 1e-4, 1e-6, 1e-8}) {  // 1/(k_c s)
      const Vector<D> soft = proxy_gain(n, coupling, 1.0 / (softness * s));
      EXPECT_LE(glm::length(soft * (1.0 + softness) - hard), 8.0 * epsilon * glm::length(hard));
      EXPECT_LT(glm::length(soft), glm::length(hard));
    }
  }
}

TYPED_TEST(ProxyTest, IsTheDeviceInFreeSpace) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    const Vector<D> gain = proxy_gain(setting.wall.normal, coupling_of(setting), setting.stiffnesses.k_c);
    const Vector<D> outside = setting.wall.point + along(setting.wall, random.in_box<D>(0.1)) +
                              random.over_decades(1e-9, 0.1) * setting.wall.normal;
    const Proxy<D> proxy = proxy_of(outside, setting.wall, gain);
    EXPECT_EQ(proxy.position, outside);
    EXPECT_FALSE(proxy.in_contact);
  }
}

// n·(q_h − o) < 0 is contact, n·(q_h − o) = 0 is not; crossing the wall makes no jump.
TYPED_TEST(ProxyTest, ContactBeginsInsideTheWallWithoutAJump) {
  constexpr glm::length_t D = TypeParam::value;
  Wall<D> wall{Vector<D>(0.0), Vector<D>(0.0)};
  wall.normal[0] = 1.0;
  const Vector<D> gain = proxy_gain(wall.normal, fully_actuated_coupling<D>(1000.0, 1000.0), 1e5);
  Vector<D> device(0.01);
  device[0] = 0.0;
  EXPECT_FALSE(proxy_of(device, wall, gain).in_contact);
  EXPECT_EQ(proxy_of(device, wall, gain).position, device);
  device[0] = -1e-12;
  EXPECT_TRUE(proxy_of(device, wall, gain).in_contact);
  EXPECT_LE(glm::length(proxy_of(device, wall, gain).position - device), 1e-12);
}

// Tracking that is softer where there is no motor lets the proxy go further that way.
TEST(Proxy, SlidesFurtherAcrossTheMotorWithALargerRatio) {
  const Wall<2> wall{{0.0, 0.0}, direction_at(0.75 * 3.141592653589793)};
  const Actuation<2> actuation = actuated_along(Vector<2>{1.0, 0.0});
  const Vector<2> isotropic = proxy_gain(wall.normal, underactuated_coupling(1e3, 1e3, 1.0, actuation), infinity);
  const Vector<2> anisotropic = proxy_gain(wall.normal, underactuated_coupling(1e3, 1e3, 11.0, actuation), infinity);
  EXPECT_LE(glm::length(isotropic - wall.normal), 4.0 * epsilon);  // straight out
  EXPECT_NEAR(std::abs(anisotropic.y / anisotropic.x), 11.0, 1e-14);
}

static_assert(noexcept(proxy_gain(Vector<2>{}, Coupling<2>{}, 1.0)));
static_assert(noexcept(proxy_of(Vector<2>{}, Wall<2>{}, Vector<2>{})));
static_assert(std::is_trivially_copyable_v<Proxy<3>>);

}  // namespace
}  // namespace ghostforce::proxy_test
