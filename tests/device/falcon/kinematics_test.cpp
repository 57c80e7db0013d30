// The Falcon's kinematics against published tables, and against a second formulation with numeric derivatives.
#include "device/falcon/kinematics.h"
#include "core/conventions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "tests/core/random_setting.h"
#include "tests/device/falcon/reference_kinematics.h"

namespace ghostforce::kinematics_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double counts_per_newton_metre = 6600.0;

std::string words(const Vector<3>& v) {
  std::ostringstream text;
  text << '(' << v.x << ", " << v.y << ", " << v.z << ')';
  return text.str();
}

double greatest(const Vector<3>& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

double greatest(const Matrix<3>& m) {
  return std::max({greatest(m[0]), greatest(m[1]), greatest(m[2])});
}

// Between two directions, good for small angles too [deg].
double degrees_between(const Vector<3>& a, const Vector<3>& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) / radians_per_degree;
}

class KinematicsTest : public testing::Test {
 protected:
  const FalconGeometry geometry_;
  const FalconKinematics kinematics_{geometry_};
};

// --- Angles of a position ---

TEST_F(KinematicsTest, AgreesWithThePublishedTableOnTheAxis) {
  struct Row {
    double z;             // [m]
    double angle;         // [deg]
    double half_a_digit;  // of the angle as it was printed
    long count;
  };
  const std::vector<Row> table{{.075, -18.32, .005, -1463}, {.080, -11.8, .05, -1284}, {.090, -1.1, .05, -990},
                               {.100, 8.01, .005, -741},    {.110, 16.19, .005, -516}, {.120, 23.92, .005, -304},
                               {.125, 27.7, .05, -200},     {.130, 31.5, .05, -96},    {.140, 39.17, .005, 115},
                               {.150, 47.24, .005, 336},    {.160, 56.14, .005, 580},  {.170, 66.76, .005, 872},
                               {.175, 73.46, .005, 1056},   {.180, 82.68, .005, 1309}};
  for (const Row& row : table) {
    SCOPED_TRACE(row.z);
    const auto angles = kinematics_.angles({0.0, 0.0, row.z});
    ASSERT_TRUE(angles);
    const Vector<3> counts = counts_of_angles(*angles, geometry_);
    for (glm::length_t i = 0; i < 3; ++i) {
      EXPECT_NEAR((*angles)[i] / radians_per_degree, row.angle, row.half_a_digit);
      EXPECT_EQ(std::lround(counts[i]), row.count);
    }
  }
}

TEST_F(KinematicsTest, AgreesWithStampersHalfAngleForm) {
  for (const GeometryPreset& preset : geometry_catalog()) {
    SCOPED_TRACE(preset.name);
    const FalconKinematics kinematics(preset.geometry);
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
      const Vector<3> p = random_position(random, preset.geometry);
      const auto angles = kinematics.angles(p);
      ASSERT_TRUE(angles) << words(p);
      // Rounding is magnified where a leg ends: the angle's error is that of a cosine (1e-15) over the sine of a
      // corner, which is above 1e-4 for all of these.
      ASSERT_LT(greatest(*angles - *reference_angles(p, preset.geometry)), 1e-10) << words(p);
    }
  }
}

TEST_F(KinematicsTest, SaysWhereNoLegReaches) {
  const std::vector<Vector<3>> places{{0.0, 0.0, 0.2},        {0.2, 0.0, 0.1},       {0.0, -0.2, 0.1},
                                      {0.0, 0.0, 0.0},        {nan, 0.0, 0.11},      {0.0, nan, 0.11},
                                      {0.0, 0.0, nan},        {infinity, 0.0, 0.11}, {0.0, 0.0, -1e300},
                                      {0.0, -infinity, 0.11}, {0.0, 0.0, infinity},  {1e300, 1e300, 1e300}};
  for (const Vector<3>& p : places) {
    EXPECT_FALSE(kinematics_.angles(p)) << words(p);
    EXPECT_FALSE(kinematics_.jacobian(p)) << words(p);
  }
}

// --- Its derivative ---

TEST_F(KinematicsTest, JacobianIsTheDerivativeOfTheAngles) {
  for (const GeometryPreset& preset : geometry_catalog()) {
    SCOPED_TRACE(preset.name);
    const FalconKinematics kinematics(preset.geometry);
    Random random(2);
    int compared = 0;
    while (compared < 10000) {
      const Vector<3> p = random_position(random, preset.geometry);
      const auto expected = reference_jacobian(p, preset.geometry);
      if (!expected) continue;  // a difference would step out of reach
      const auto jacobian = kinematics.jacobian(p);
      ASSERT_TRUE(jacobian) << words(p);
      // The differences' own error; see there. Closer to a leg's end they say nothing.
      if (greatest(*jacobian) > 100.0) continue;
      ASSERT_LT(greatest(*jacobian - *expected), 1e-6 * greatest(*expected)) << words(p);
      ++compared;
    }
  }
}

// What libnifalcon computes with: the sine of the parallelogram's angle is squared in the z column. Forces come out
// askew by this much, so no test of a force's direction could let it pass.
TEST_F(KinematicsTest, SquaredSineWouldTurnForcesByManyDegrees) {
  Random random(3);
  double sum_of_squares = 0.0;
  double worst = 0.0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const Vector<3> p = random_working_position(random);
    const Matrix<3> right = *kinematics_.jacobian(p);
    Matrix<3> wrong = right;
    for (glm::length_t leg = 0; leg < 3; ++leg) {
      const Vector<3> row(right[0][leg], right[1][leg], right[2][leg]);
      const Vector<3> rod = glm::normalize(row);
      const double phi = geometry_.azimuths[static_cast<std::size_t>(leg)];
      const double lean_cosine = std::cos(phi) * rod.y - std::sin(phi) * rod.x;
      wrong[2][leg] *= rod.z / std::sqrt(1.0 - lean_cosine * lean_cosine);
    }
    const Vector<3> force = random.direction<3>();
    const auto torques = joint_torques(force, wrong);
    ASSERT_TRUE(torques);
    const double error = degrees_between(*torques * right, force);
    sum_of_squares += error * error;
    worst = std::max(worst, error);
  }
  RecordProperty("rms_deg", std::to_string(std::sqrt(sum_of_squares / count)));
  RecordProperty("worst_deg", std::to_string(worst));
  EXPECT_GT(std::sqrt(sum_of_squares / count), 5.0);
  EXPECT_GT(worst, 15.0);
}

// --- Position of angles ---

// Newton stops with gaps below 1e-13 m; where the legs stand badly to each other the position is out by more.
constexpr double position_rounding = 1e-11;

TEST_F(KinematicsTest, FindsEveryPositionFromTheColdStart) {
  for (const GeometryPreset& preset : geometry_catalog()) {
    SCOPED_TRACE(preset.name);
    const FalconKinematics kinematics(preset.geometry);
    Random random(4);
    int most_iterations = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vector<3> p = random_position(random, preset.geometry);
      const auto found = kinematics.position(*kinematics.angles(p));
      ASSERT_TRUE(found.has_converged) << words(p);
      ASSERT_LT(glm::length(found.position - p), position_rounding) << words(p);
      most_iterations = std::max(most_iterations, found.iterations);
    }
    EXPECT_LE(most_iterations, 10);
  }
}

TEST_F(KinematicsTest, FindsEveryPositionFromOneNearbyInTwoSteps) {
  Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const Vector<3> p = random_position(random, geometry_);
    // As far as a handle at 1 m/s gets in a tick.
    const auto found = kinematics_.position(*kinematics_.angles(p), p + 0.001 * random.direction<3>());
    ASSERT_TRUE(found.has_converged) << words(p);
    ASSERT_LE(found.iterations, 2) << words(p);
    ASSERT_LT(glm::length(found.position - p), position_rounding) << words(p);
  }
}

// Homing makes the counts jump, and lost frames leave the last position far behind.
TEST_F(KinematicsTest, FindsEveryPositionFromAnyOther) {
  Random random(6);
  Vector<3> last = cold_start;
  for (int i = 0; i < 20000; ++i) {
    const Vector<3> p = random_position(random, geometry_);
    const auto found = kinematics_.position(*kinematics_.angles(p), last);
    ASSERT_TRUE(found.has_converged) << words(p) << " from " << words(last);
    ASSERT_LT(glm::length(found.position - p), position_rounding) << words(p) << " from " << words(last);
    last = p;
  }
}

TEST_F(KinematicsTest, FindsAPositionWhateverTheStart) {
  const Vector<3> p(0.01, -0.02, 0.13);
  const Vector<3> angles = *kinematics_.angles(p);
  for (const Vector<3>& start : {Vector<3>(nan), Vector<3>(infinity, 0.0, 0.0), Vector<3>(10.0), Vector<3>(0.0),
                                 Vector<3>(0.0, 0.0, -0.11), Vector<3>(1e300)}) {
    const auto found = kinematics_.position(angles, start);
    EXPECT_TRUE(found.has_converged) << words(start);
    EXPECT_LT(glm::length(found.position - p), position_rounding) << words(start);
  }
}

// Counts that are just homed, for the three zeros that people found.
TEST_F(KinematicsTest, AgreesWithThePublishedHeightsAtCountZero) {
  for (const auto& [zero, z] : {std::pair{35.0, 0.1346}, {40.0, 0.1411}, {50.0, 0.1532}}) {
    FalconGeometry geometry;
    geometry.angle_at_zero_count = zero * radians_per_degree;
    const auto found = FalconKinematics(geometry).position(angles_of_counts(Vector<3>(0.0), geometry));
    EXPECT_TRUE(found.has_converged);
    EXPECT_NEAR(found.position.z, z, 0.00005);  // half of the last digit published
  }
}

TEST_F(KinematicsTest, SaysWhenNoPositionHasTheseAngles) {
  const auto degrees = [](double a, double b, double c) { return Vector<3>(a, b, c) * radians_per_degree; };
  for (const Vector<3>& angles : {degrees(120, 120, 120),  // knees bent the other way
                                  degrees(170, -80, -80),  // arms too far apart for the legs
                                  degrees(-100, -100, -100)}) {
    EXPECT_FALSE(kinematics_.position(angles).has_converged) << words(angles);
    EXPECT_FALSE(kinematics_.position(angles, {0.0, 0.0, 0.15}).has_converged) << words(angles);
  }
}

// Whatever the encoders say: either a position that has these angles, or the word that there is none.
TEST_F(KinematicsTest, NeverTakesAnotherPositionForTheRightOne) {
  Random random(7);
  int converged = 0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const Vector<3> angles = random.in_box<3>(std::numbers::pi);
    const auto found = kinematics_.position(angles);
    if (!found.has_converged) continue;
    ++converged;
    const auto back = kinematics_.angles(found.position);
    ASSERT_TRUE(back) << words(angles);
    // Where a leg is stretched, a gap of 1e-13 m is an angle of its square root.
    ASSERT_LT(greatest(*back - angles), 1e-5) << words(angles);
  }
  EXPECT_GT(converged, count / 100);
  EXPECT_LT(converged, count - count / 100);
}

TEST_F(KinematicsTest, WhatIsNotFiniteHasNoPosition) {
  for (const double bad : {nan, infinity, -infinity}) {
    for (glm::length_t i = 0; i < 3; ++i) {
      Vector<3> angles(0.3);
      angles[i] = bad;
      EXPECT_FALSE(kinematics_.position(angles).has_converged);
      EXPECT_FALSE(kinematics_.position(angles, {0.0, 0.0, 0.12}).has_converged);
    }
  }
}

TEST_F(KinematicsTest, RoundedCountsCostNoMoreThanTheEncodersResolution) {
  Random random(8);
  for (int i = 0; i < 10000; ++i) {
    const Vector<3> p = random_working_position(random);
    const auto angles = kinematics_.angles(p);
    const auto found =
        kinematics_.position(angles_of_counts(glm::round(counts_of_angles(*angles, geometry_)), geometry_));
    ASSERT_TRUE(found.has_converged);
    // Half a count off at each joint, in the worst combination.
    const Matrix<3> inverse = glm::inverse(*kinematics_.jacobian(p));
    double worst = 0.0;
    for (const double b : {-0.5, 0.5}) {
      for (const double c : {-0.5, 0.5}) {
        worst = std::max(worst, glm::length(inverse * (Vector<3>(0.5, b, c) * radians_per_count(geometry_))));
      }
    }
    // The twentieth is for the curvature over half a count.
    ASSERT_LE(glm::length(found.position - p), 1.05 * worst) << words(p);
  }
}

// --- Forces ---

TEST_F(KinematicsTest, AgreesWithThePublishedTorquesOnTheAxis) {
  struct Row {
    double z;
    Vector<3> x;  // torques of 1 N along x [N·m]
    Vector<3> y;
    double along_z;  // of each
  };
  const std::vector<Row> table{{.090, {.0119, -.0407, .0288}, {-.0401, .0097, .0304}, .0197},
                               {.110, {.0155, -.0527, .0372}, {-.0519, .0126, .0394}, .0242},
                               {.130, {.0186, -.0630, .0444}, {-.0620, .0148, .0471}, .0252},
                               {.150, {.0213, -.0709, .0496}, {-.0695, .0163, .0532}, .0228},
                               {.170, {.0224, -.0718, .0495}, {-.0700, .0156, .0544}, .0158}};
  constexpr double half_a_digit = 0.00005;
  for (const Row& row : table) {
    SCOPED_TRACE(row.z);
    const Matrix<3> jacobian = *kinematics_.jacobian({0.0, 0.0, row.z});
    EXPECT_LE(greatest(*joint_torques({1, 0, 0}, jacobian) - row.x), half_a_digit);
    EXPECT_LE(greatest(*joint_torques({0, 1, 0}, jacobian) - row.y), half_a_digit);
    EXPECT_LE(greatest(*joint_torques({0, 0, 1}, jacobian) - Vector<3>(row.along_z)), half_a_digit);
  }
}

// Numbers that the vendor's own driver sent, with the force that it had been asked for.
TEST_F(KinematicsTest, MotorsTurnTheWayTheVendorsDriverTurnsThem) {
  struct Capture {
    Vector<3> force;
    MotorNumbers counts;
  };
  const std::vector<Capture> captures{{{0.0, 0.0, -25.0}, {1311, 1453, 1526}},
                                      {{-12.5, 0.0, 0.0}, {399, -3087, 1135}},
                                      {{10.0, 0.0, 0.0}, {-679, 2529, -1862}},
                                      {{0.0, -12.5, 0.0}, {-2900, 27, 929}},
                                      {{0.0, 10.0, 0.0}, {2481, -669, -1691}}};
  const Matrix<3> jacobian = *kinematics_.jacobian({0.0, 0.0, 0.169});  // nearly all the way out
  for (const Capture& capture : captures) {
    const MotorCommand command = motor_counts(capture.force, jacobian, 3530.0);
    ASSERT_TRUE(command.is_valid);
    for (std::size_t i = 0; i < 3; ++i) {
      // The pose of the captures is only known roughly: numbers near 0 may have either sign.
      if (std::abs(capture.counts[i]) < 100) continue;
      EXPECT_GT(command.counts[i] * capture.counts[i], 0) << words(capture.force) << ' ' << i;
    }
  }
}

// The force that counts make, without anything of what is tested: −counts/K are torques, and work along numeric
// derivatives of the angles is force.
Vector<3> reference_force(const MotorNumbers& counts, const Vector<3>& p, const FalconGeometry& geometry) {
  const Matrix<3> jacobian = *reference_jacobian(p, geometry);
  Vector<3> force(0.0);
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    for (glm::length_t i = 0; i < 3; ++i) {
      force[axis] -= counts[static_cast<std::size_t>(i)] / counts_per_newton_metre * jacobian[axis][i];
    }
  }
  return force;
}

// The worst angle in degrees over many poses and directions [deg].
double worst_turn(const FalconKinematics& kinematics, const FalconGeometry& geometry, double least_N,
                  double greatest_N) {
  Random random(9);
  double worst = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const Vector<3> p = random_working_position(random);
    const Vector<3> force = random.uniform(least_N, greatest_N) * random.direction<3>();
    const MotorCommand command = motor_counts(force, *kinematics.jacobian(p), counts_per_newton_metre);
    EXPECT_TRUE(command.is_valid);
    worst = std::max(worst, degrees_between(reference_force(command.counts, p, geometry), force));
  }
  return worst;
}

TEST_F(KinematicsTest, ForcesKeepTheirDirection) {
  EXPECT_LT(worst_turn(kinematics_, geometry_, 3.0, 8.0), 0.1);
}

// A number that is rounded is off by up to a half, whatever the force: that turns a small force by more.
TEST_F(KinematicsTest, SmallForcesAreTurnedByTheRoundingOfNumbers) {
  const double worst = worst_turn(kinematics_, geometry_, 1.0, 1.0);
  EXPECT_GT(worst, 0.1);
  EXPECT_LT(worst, 0.3);
}

TEST_F(KinematicsTest, ForcesHaveTheirMagnitudeUnlessTheMotorsAreAtTheirEnd) {
  Random random(10);
  int saturated = 0;
  for (int i = 0; i < 10000; ++i) {
    const Vector<3> p = random_working_position(random);
    const Vector<3> force = random.uniform(1.0, 8.0) * random.direction<3>();
    const Matrix<3> jacobian = *kinematics_.jacobian(p);
    const MotorCommand command = motor_counts(force, jacobian, counts_per_newton_metre);
    const Vector<3> made = force_of_motor_counts(command.counts, jacobian, counts_per_newton_metre);
    // The rounding of the numeric derivatives.
    ASSERT_LT(glm::length(made - reference_force(command.counts, p, geometry_)), 1e-5);
    if (command.is_saturated) {
      ++saturated;
      ASSERT_LT(glm::length(made), glm::length(force));
    } else {
      // Half a number at each motor, on levers of 16 mm or more.
      ASSERT_LT(glm::length(made - force), 0.008) << words(p);
    }
  }
  EXPECT_LT(saturated, 1000);
}

TEST_F(KinematicsTest, MotorsAtTheirEndKeepTheDirection) {
  Random random(11);
  for (int i = 0; i < 10000; ++i) {
    const Vector<3> p = random_working_position(random);
    const Vector<3> force = random.over_decades(50.0, 1e12) * random.direction<3>();
    const MotorCommand command = motor_counts(force, *kinematics_.jacobian(p), counts_per_newton_metre);
    ASSERT_TRUE(command.is_valid);
    ASSERT_TRUE(command.is_saturated);
    int most = 0;
    for (const int number : command.counts) most = std::max(most, std::abs(number));
    ASSERT_EQ(most, 4095);
    ASSERT_LT(degrees_between(reference_force(command.counts, p, geometry_), force), 0.1) << words(p);
  }
}

TEST_F(KinematicsTest, ForceOfNumbersIsTheInverse) {
  Random random(12);
  for (int i = 0; i < 10000; ++i) {
    const Matrix<3> jacobian = *kinematics_.jacobian(random_working_position(random));
    MotorNumbers numbers;
    for (std::int16_t& number : numbers) number = static_cast<std::int16_t>(random.below(8191) - 4095);
    const Vector<3> force = force_of_motor_counts(numbers, jacobian, counts_per_newton_metre);
    const MotorCommand command = motor_counts(force, jacobian, counts_per_newton_metre);
    ASSERT_TRUE(command.is_valid);
    ASSERT_EQ(command.counts, numbers);
  }
}

TEST_F(KinematicsTest, WhatCannotBeCommandedIsNothing) {
  const Matrix<3> good = *kinematics_.jacobian({0.0, 0.0, 0.12});
  Matrix<3> flat = good;
  flat[2] = flat[0] + flat[1];
  Matrix<3> not_a_number = good;
  not_a_number[1][1] = nan;
  const auto expect_nothing = [](const MotorCommand& command) {
    EXPECT_FALSE(command.is_valid);
    EXPECT_FALSE(command.is_saturated);
    EXPECT_EQ(command.counts, MotorNumbers{});
  };
  const Vector<3> force(1.0, 2.0, 3.0);
  expect_nothing(motor_counts(force, flat, counts_per_newton_metre));
  expect_nothing(motor_counts(force, Matrix<3>(0.0), counts_per_newton_metre));
  expect_nothing(motor_counts(force, not_a_number, counts_per_newton_metre));
  expect_nothing(motor_counts(force, Matrix<3>(infinity), counts_per_newton_metre));
  expect_nothing(motor_counts(force, good, nan));
  expect_nothing(motor_counts(force, good, infinity));
  expect_nothing(motor_counts({nan, 0.0, 0.0}, good, counts_per_newton_metre));
  expect_nothing(motor_counts({0.0, infinity, 0.0}, good, counts_per_newton_metre));
  expect_nothing(motor_counts({0.0, 1e308, 0.0}, good, counts_per_newton_metre));
}

TEST_F(KinematicsTest, NoForceIsNoCounts) {
  const MotorCommand command = motor_counts(Vector<3>(0.0), *kinematics_.jacobian({0.0, 0.0, 0.12}), 6600.0);
  EXPECT_TRUE(command.is_valid);
  EXPECT_FALSE(command.is_saturated);
  EXPECT_EQ(command.counts, MotorNumbers{});
}

// The servo thread may not be left by an exception.
static_assert(noexcept(FalconKinematics(FalconGeometry{})));
static_assert(noexcept(std::declval<const FalconKinematics&>().position(Vector<3>(), Vector<3>())));
static_assert(noexcept(motor_counts(Vector<3>(), Matrix<3>(), 1.0)));

}  // namespace
}  // namespace ghostforce::kinematics_test
