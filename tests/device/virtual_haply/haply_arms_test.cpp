// Where the handle is, how it moves, and that the arms give no energy.
#include "device/virtual_haply/haply_arms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <random>

#include "device/virtual_haply/virtual_haply_variant.h"

namespace ghostforce::haply_arms_test {
namespace {

constexpr double duration = 50e-6;

Vector<2> degrees(double first, double second) {
  return radians_per_degree * Vector<2>{first, second};
}

const VirtualHaplyVariant& variant(std::string_view name) {
  return *find_virtual_haply_variant(name);
}

void expect_near(const Vector<2>& value, const Vector<2>& wanted, double tolerance) {
  EXPECT_NEAR(value.x, wanted.x, tolerance);
  EXPECT_NEAR(value.y, wanted.y, tolerance);
}

TEST(ArmsGeometry, GivesTheWorkedExample) {
  const auto place = variant("v3").geometry.place(degrees(150.0, 50.0));
  ASSERT_TRUE(place);
  expect_near(place->elbow_1, {-0.06062, 0.03500}, 1e-5);
  expect_near(place->elbow_2, {0.08300, 0.05362}, 1e-5);
  expect_near(place->handle, {0.00431, 0.09732}, 1e-5);
  expect_near(place->jacobian[0], {-0.03415, -0.06150}, 1e-5);
  expect_near(place->jacobian[1], {-0.04980, 0.05189}, 1e-5);
  const Matrix<2> forces = glm::inverse(glm::transpose(place->jacobian));
  expect_near(forces[0], {-10.732, -10.300}, 1e-2);
  expect_near(forces[1], {-12.721, 7.064}, 1e-2);
}

TEST(ArmsGeometry, GivesTheZeroPoses) {
  for (const auto& [name, handle] :
       {std::pair{"2017", Vector<2>{0.0100, 0.0361}}, std::pair{"v2", Vector<2>{0.0, 0.0221}},
        std::pair{"v3", Vector<2>{0.0190, 0.1550}}, std::pair{"v3.1", Vector<2>{0.0190, 0.0357}}}) {
    SCOPED_TRACE(name);
    const auto place = variant(name).geometry.place(variant(name).zero_pose());
    ASSERT_TRUE(place);
    expect_near(place->handle, handle, 1e-4);
    EXPECT_GE(std::ranges::min(HaplyArms::room(variant(name).geometry, variant(name).zero_pose())), 0.0);
  }
}

TEST(ArmsGeometry, IsItsOwnInverse) {
  for (const VirtualHaplyVariant& each : virtual_haply_variants()) {
    for (const Vector<2>& aside : {Vector<2>{0.0}, {0.02, 0.01}, {-0.02, -0.01}}) {
      const Vector<2> handle = each.geometry.middle() + aside;
      const auto angles = each.geometry.angles_at(handle);
      ASSERT_TRUE(angles) << each.name;
      const auto place = each.geometry.place(*angles);
      ASSERT_TRUE(place);
      expect_near(place->handle, handle, 1e-12);
      constexpr double small = 1e-6;
      for (glm::length_t i = 0; i < 2; ++i) {
        Vector<2> step{0.0};
        step[i] = small;
        const Vector<2> slope =
            (each.geometry.place(*angles + step)->handle - each.geometry.place(*angles - step)->handle) / (2.0 * small);
        expect_near(place->jacobian[i], slope, 1e-8);
      }
    }
  }
  EXPECT_FALSE(variant("v3").geometry.angles_at({0.0, 0.3}));
}

HaplyArms arms_in_the_middle(const HaplyArms::Options& options = {}, std::string_view name = "v3.1") {
  const ArmsGeometry& geometry = variant(name).geometry;
  return {geometry, options, *geometry.angles_at(geometry.middle())};
}

TEST(HaplyArms, MoveAsTheirMotorsPush) {
  for (glm::length_t i = 0; i < 2; ++i) {
    HaplyArms arms = arms_in_the_middle();
    const Vector<2> before = arms.angles();
    Vector<2> torques{0.0};
    torques[i] = 0.015;
    for (int step = 0; step < 400; ++step) arms.step(duration, torques, {});
    EXPECT_GT(arms.angles()[i], before[i] + 0.005);
  }
}

TEST(HaplyArms, RestWhereTheHandHoldsTheForce) {
  HaplyArms arms = arms_in_the_middle({.friction = Vector<2>{0.0}});
  const HandPull hand{.goal = arms.geometry().middle(), .stiffness = 100.0, .damping = 3.0};
  const Vector<2> torques{0.05, -0.02};
  for (int step = 0; step < 100'000; ++step) arms.step(duration, torques, hand);
  expect_near(hand.stiffness * (arms.handle() - hand.goal), arms.force_of(torques), 1e-6);
  EXPECT_GT(glm::length(arms.handle() - hand.goal), 0.003);
}

TEST(HaplyArms, StickWhereFrictionHoldsThem) {
  HaplyArms arms = arms_in_the_middle();
  const Vector<2> before = arms.angles();
  for (int step = 0; step < 1000; ++step) arms.step(duration, {4e-4, -4e-4}, {});
  EXPECT_EQ(arms.angles(), before);
  for (int step = 0; step < 1000; ++step) arms.step(duration, {6e-4, -6e-4}, {});
  EXPECT_NE(arms.angles(), before);
}

// Without torque, the energy of the arms and of the hand's spring never grows. (In a step that ends at rest, what is
// bent about its way may be left in the spring.)
TEST(HaplyArms, GiveNoEnergy) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  for (const VirtualHaplyVariant& each : virtual_haply_variants()) {
    for (int trial = 0; trial < 20; ++trial) {
      HaplyArms arms = arms_in_the_middle({.damping = Vector<2>{0.0}, .friction = Vector<2>{0.0}}, each.name);
      // A push sets them off.
      const Vector<2> push{0.6 * share(random), 0.6 * share(random)};
      for (int step = 0; step < 200; ++step) arms.step(duration, push, {});
      HandPull hand{.goal = each.geometry.middle(), .stiffness = trial % 2 == 0 ? 0.0 : 400.0};
      const auto energy = [&] {
        const Vector<2> way = arms.handle() - hand.goal;
        return arms.kinetic_energy() + 0.5 * hand.stiffness * glm::dot(way, way);
      };
      const double first = energy();
      double least = first;
      for (int step = 0; step < 20'000; ++step) {
        arms.step(duration, Vector<2>{0.0}, hand);
        least = std::min(least, energy());
        ASSERT_LE(energy(), least + 1e-6 * first) << each.name << " " << step;
      }
      EXPECT_TRUE(std::isfinite(arms.handle().x));
    }
  }
}

TEST(HaplyArms, NeverLeaveTheirEnds) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  for (const VirtualHaplyVariant& each : virtual_haply_variants()) {
    HaplyArms arms = arms_in_the_middle({}, each.name);
    for (int push = 0; push < 100; ++push) {
      const Vector<2> torques{0.5 * share(random), 0.5 * share(random)};
      const HandPull hand{.goal = {0.4 * share(random), 0.4 * share(random)}, .stiffness = 500.0, .damping = 1.0};
      for (int step = 0; step < 500; ++step) {
        arms.step(duration, torques, hand);
        ASSERT_GE(std::ranges::min(HaplyArms::room(each.geometry, arms.angles())), 0.0) << each.name;
      }
    }
  }
}

TEST(HaplyArms, SlideAlongAnEnd) {
  HaplyArms arms = arms_in_the_middle();
  // Pulled beyond its reach to one side and then to the other, the handle goes along its longest reach.
  for (const double x : {-0.3, 0.3}) {
    const HandPull hand{.goal = {x, 0.3}, .stiffness = 300.0, .damping = 3.0};
    for (int step = 0; step < 40'000; ++step) arms.step(duration, Vector<2>{0.0}, hand);
    EXPECT_GT((arms.handle().x - 0.019) * x, 0.006) << x;
  }
}

TEST(HaplyArms, AreHeldInAPose) {
  for (const VirtualHaplyVariant& each : virtual_haply_variants()) {
    HaplyArms arms = arms_in_the_middle({}, each.name);
    const HandPull hand{.holds_pose = true, .pose = each.zero_pose()};
    for (int step = 0; step < 20'000; ++step) arms.step(duration, Vector<2>{0.0}, hand);
    expect_near(degrees_per_radian * arms.angles(), degrees_per_radian * each.zero_pose(), 0.02);
  }
}

}  // namespace
}  // namespace ghostforce::haply_arms_test
