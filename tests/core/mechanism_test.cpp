#include "core/mechanism.h"

#include <cmath>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/core/random_setting.h"

namespace ghostforce::mechanism_test {
namespace {

static_assert(std::is_trivially_copyable_v<Mechanism>);
static_assert(std::is_trivially_copyable_v<ActuationMatrix<2>>);
static_assert(noexcept(actuation_at(std::declval<const Mechanism&>(), std::declval<const Vector<2>&>())));
static_assert(noexcept(pose_at(std::declval<const Mechanism&>(), std::declval<const Vector<2>&>())));

// Where the handle of an arm is, from its joint angles.
Vector<2> handle_of(const TwoLinkArm& arm, double base, double elbow) {
  return arm.base + arm.links[0] * Vector<2>(std::cos(base), std::sin(base)) +
         arm.links[1] * Vector<2>(std::cos(base + elbow), std::sin(base + elbow));
}

TwoLinkArm random_arm(Random& random) {
  return {random.in_box<2>(0.1), {random.uniform(0.05, 0.3), random.uniform(0.05, 0.3)}, {}, {}};
}

// The columns of J by differences of the handle's place: no formula is shared with the mechanism.
TEST(Mechanism, ArmPushesAsTheDifferencesOfItsHandleSay) {
  constexpr double h = 1e-6;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    TwoLinkArm arm = random_arm(random);
    const double base = random.uniform(-3.0, 3.0);
    const double elbow = random.uniform(0.3, 2.8) * (random.once_in(2) ? 1.0 : -1.0);
    // A positive elbow angle bends to the left, so the elbow lies to the right of the way to the handle.
    arm.elbow = elbow > 0.0 ? TwoLinkArm::Elbow::right : TwoLinkArm::Elbow::left;
    const Vector<2> q = handle_of(arm, base, elbow);
    const Vector<2> by_base = (handle_of(arm, base + h, elbow) - handle_of(arm, base - h, elbow)) / (2.0 * h);
    const Vector<2> by_elbow = (handle_of(arm, base, elbow + h) - handle_of(arm, base, elbow - h)) / (2.0 * h);
    for (const auto motor : {TwoLinkArm::Motor::base, TwoLinkArm::Motor::elbow}) {
      arm.motor = motor;
      const auto actuation = actuation_at(arm, q);
      ASSERT_TRUE(actuation) << seed;
      ASSERT_EQ(actuation->count, 1U);
      const bool is_base = motor == TwoLinkArm::Motor::base;
      const Vector<2>& column = actuation->columns[0];
      // Jᵀ A is the identity's column: a torque of 1 at this motor, 0 at the joint without one.
      EXPECT_NEAR(glm::dot(column, is_base ? by_base : by_elbow), 1.0, 1e-7) << seed;
      EXPECT_NEAR(glm::dot(column, is_base ? by_elbow : by_base), 0.0, 1e-7) << seed;
      EXPECT_LT(glm::length(actuation->commands[0] - (is_base ? by_base : by_elbow)), 1e-8) << seed;
    }
  }
}

// Where two circles meet: the handle of a five-bar from its motors' angles, on the upper side.
Vector<2> handle_of(const FiveBar& linkage, double left, double right) {
  const Vector<2> a = linkage.bases[0] + linkage.proximal * Vector<2>(std::cos(left), std::sin(left));
  const Vector<2> b = linkage.bases[1] + linkage.proximal * Vector<2>(std::cos(right), std::sin(right));
  const Vector<2> half = 0.5 * (b - a);
  const double rise = std::sqrt(linkage.distal * linkage.distal - glm::dot(half, half));
  return a + half + rise * glm::normalize(Vector<2>(-half.y, half.x));
}

TEST(Mechanism, PantographPushesAsTheDifferencesOfItsHandleSay) {
  constexpr double h = 1e-6;
  int poses = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    FiveBar linkage;
    linkage.bases = {Vector<2>(-random.uniform(0.0, 0.06), 0.0), Vector<2>(random.uniform(0.0, 0.06), 0.01)};
    linkage.proximal = random.uniform(0.08, 0.14);
    linkage.distal = random.uniform(0.12, 0.18);
    const double left = random.uniform(1.7, 2.9);
    const double right = random.uniform(0.2, 1.4);
    const Vector<2> q = handle_of(linkage, left, right);
    if (!std::isfinite(q.x)) continue;  // no handle reaches both
    const Vector<2> by_left = (handle_of(linkage, left + h, right) - handle_of(linkage, left - h, right)) / (2.0 * h);
    const Vector<2> by_right = (handle_of(linkage, left, right + h) - handle_of(linkage, left, right - h)) / (2.0 * h);
    for (const auto motor : {FiveBar::Motor::left, FiveBar::Motor::right}) {
      linkage.motor = motor;
      const auto pose = pose_at(linkage, q);
      ASSERT_TRUE(pose) << seed;
      const bool is_left = motor == FiveBar::Motor::left;
      const Vector<2> elbow =
          linkage.bases[is_left ? 0 : 1] +
          linkage.proximal * Vector<2>(std::cos(is_left ? left : right), std::sin(is_left ? left : right));
      if (glm::length(pose->joints[2] - elbow) > 1e-9) continue;  // this pose has that elbow inward
      const auto actuation = actuation_at(linkage, q);
      if (!actuation) continue;  // nearly singular
      ++poses;
      EXPECT_NEAR(glm::dot(actuation->columns[0], is_left ? by_left : by_right), 1.0, 1e-6) << seed;
      EXPECT_NEAR(glm::dot(actuation->columns[0], is_left ? by_right : by_left), 0.0, 1e-6) << seed;
      EXPECT_LT(glm::length(actuation->commands[0] - (is_left ? by_left : by_right)), 1e-6) << seed;
    }
  }
  EXPECT_GT(poses, 300) << "most poses are inside the workspace";
}

TEST(Mechanism, StringsPullTowardsTheirAnchors) {
  Strings strings;
  strings.anchors = {Vector<2>(0.3, 0.4), Vector<2>(-0.5, 0.0), Vector<2>(0.0, -0.2)};
  strings.most = 7.0;
  for (std::uint32_t count = 1; count <= 3; ++count) {
    strings.count = count;
    const auto actuation = actuation_at(strings, Vector<2>(0.0));
    ASSERT_TRUE(actuation);
    ASSERT_EQ(actuation->count, count);
    EXPECT_LT(glm::length(actuation->columns[0] - Vector<2>(0.6, 0.8)), 1e-15);
    EXPECT_EQ(actuation->least[0], 0.0);
    EXPECT_EQ(actuation->greatest[0], 7.0);
    // B is A⁺: A B A = A, and B A = I while there are no more strings than directions.
    for (std::size_t i = 0; i < count; ++i) {
      Vector<2> again(0.0);
      for (std::size_t k = 0; k < count; ++k) {
        const double through = glm::dot(actuation->commands[k], actuation->columns[i]);
        again += actuation->columns[k] * through;
        EXPECT_TRUE(count > 2 || std::abs(through - (i == k ? 1.0 : 0.0)) < 1e-15);
      }
      EXPECT_LT(glm::length(again - actuation->columns[i]), 1e-15);
    }
  }
  EXPECT_FALSE(actuation_at(strings, Vector<2>(0.3, 0.4))) << "at its anchor a string has no direction";
}

TEST(Mechanism, SingularPosesAreOutsideTheWorkspace) {
  const TwoLinkArm arm{{0.0, 0.0}, {0.16, 0.16}, {}, {}};
  EXPECT_FALSE(actuation_at(arm, Vector<2>(0.33, 0.0))) << "out of reach";
  EXPECT_FALSE(actuation_at(arm, Vector<2>(0.31999, 0.0))) << "nearly stretched";
  EXPECT_FALSE(actuation_at(arm, Vector<2>(0.001, 0.0))) << "nearly folded";
  EXPECT_FALSE(actuation_at(arm, Vector<2>(0.0, 0.0))) << "on its base";
  EXPECT_TRUE(actuation_at(arm, Vector<2>(0.2, 0.1)));
  const FiveBar linkage{{Vector<2>(-0.035, 0.0), Vector<2>(0.035, 0.0)}, 0.11, 0.14, FiveBar::Motor::left};
  EXPECT_FALSE(actuation_at(linkage, Vector<2>(0.0, 0.3))) << "out of reach";
  EXPECT_FALSE(actuation_at(linkage, Vector<2>(0.0, std::sqrt(0.24995 * 0.24995 - 0.035 * 0.035)))) << "stretched";
  EXPECT_TRUE(actuation_at(linkage, Vector<2>(0.0, 0.17)));
  EXPECT_TRUE(pose_at(arm, Vector<2>(0.31999, 0.0))) << "it can be drawn there";
  EXPECT_FALSE(pose_at(arm, Vector<2>(0.33, 0.0)));
}

TEST(Mechanism, PosesHaveLinksOfTheRightLengths) {
  const TwoLinkArm arm{{-0.1, 0.02}, {0.12, 0.2}, TwoLinkArm::Elbow::right, TwoLinkArm::Motor::elbow};
  const Vector<2> q(0.1, 0.05);
  const auto pose = pose_at(arm, q);
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->motor_count, 1U);
  EXPECT_EQ(pose->joints[pose->joint_count - 1], q);
  const Vector<2> elbow = pose->joints[0];  // the motor's
  EXPECT_NEAR(glm::length(elbow - arm.base), 0.12, 1e-15);
  EXPECT_NEAR(glm::length(q - elbow), 0.2, 1e-15);
  const Vector<2> way = q - arm.base;
  EXPECT_LT(way.x * (elbow - arm.base).y - way.y * (elbow - arm.base).x, 0.0) << "right of the way to the handle";
}

}  // namespace
}  // namespace ghostforce::mechanism_test
