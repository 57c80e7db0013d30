#include "core/contact_solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "core/fixed_contact.h"
#include "tests/core/dimensions.h"
#include "tests/core/least_energy_oracle.h"
#include "tests/core/random_setting.h"

namespace ghostforce::contact_solver_test {
namespace {

static_assert(std::is_trivially_copyable_v<Contact<2>>);
static_assert(noexcept(solve_contact(std::declval<const Vector<2>&>(), std::declval<const Planes<2>&>(),
                                     std::declval<const ActuationMatrix<2>&>(), std::declval<const Compliances<2>&>(),
                                     1.0)));

// Symmetric and positive, with eigenvalues over a decade.
template <glm::length_t D>
Matrix<D> random_compliance(Random& random, double least, double greatest) {
  Matrix<D> turned(0.0);
  for (glm::length_t i = 0; i < D; ++i) turned[i] = random.in_box<D>(1.0);
  Matrix<D> result(0.0);
  std::vector<Vector<D>> axes;
  for (glm::length_t i = 0; i < D; ++i) {
    Vector<D> axis = turned[i];
    for (const Vector<D>& other : axes) axis -= other * glm::dot(other, axis);
    axis = glm::normalize(axis);
    axes.push_back(axis);
    result += random.over_decades(least, greatest) * glm::outerProduct(axis, axis);
  }
  for (glm::length_t i = 0; i < D; ++i) {
    for (glm::length_t k = 0; k < i; ++k) result[i][k] = result[k][i];
  }
  return result;
}

enum class Motors { any, strings, limited };

template <glm::length_t D>
struct RandomDevice {
  Compliances<D> compliances;
  Planes<D> planes;
  ActuationMatrix<D> actuation;
  OracleDevice oracle;
  ExactVector goal;
};

template <glm::length_t D>
ExactVector exact(const Vector<D>& v) {
  ExactVector result(D);
  for (glm::length_t i = 0; i < D; ++i) result(i) = v[i];
  return result;
}

template <glm::length_t D>
Vector<D> rounded(const ExactVector& v) {
  Vector<D> result;
  for (glm::length_t i = 0; i < D; ++i) result[i] = static_cast<double>(v(i));
  return result;
}

template <glm::length_t D>
RandomDevice<D> random_device(Random& random, Motors motors) {
  RandomDevice<D> made;
  const double scale = random.over_decades(0.3, 3.0);
  const Matrix<D> rendering = random_compliance<D>(random, 3e-4, 3e-3);
  const double softness = random.once_in(2) ? 0.0 : random.over_decades(1e-6, 1e-4);
  made.compliances = {random_compliance<D>(random, 1e-3, 1e-2), rendering / scale, 1.0 / scale, softness};
  made.planes.count = static_cast<std::size_t>(1 + random.below(2));
  for (std::size_t i = 0; i < made.planes.count; ++i) {
    made.planes.walls[i] = {random.in_box<D>(0.002), glm::normalize(random.in_box<D>(1.0))};
  }
  const int count = 1 + random.below(motors == Motors::any ? static_cast<int>(D) : 4);
  for (int i = 0; i < count; ++i) {
    const Vector<D> column = random.in_box<D>(1.0);
    add_motor(made.actuation, column, column / glm::dot(column, column));
    const auto motor = static_cast<std::size_t>(i);
    if (motors == Motors::strings) made.actuation.least[motor] = 0.0;
    if (motors == Motors::limited) {
      made.actuation.greatest[motor] = random.uniform(0.1, 2.0);
      made.actuation.least[motor] = -random.uniform(0.1, 2.0);
    }
  }
  OracleDevice& oracle = made.oracle;
  oracle.user.resize(D, D);
  oracle.rendering.resize(D, D);
  for (glm::length_t i = 0; i < D; ++i) {
    for (glm::length_t k = 0; k < D; ++k) {
      oracle.user(k, i) = made.compliances.user[i][k];
      // What the solver is told, so that rounding of a quotient is no difference.
      oracle.rendering(k, i) = static_cast<Exact>(made.compliances.tracking[i][k]) / made.compliances.force_share;
    }
  }
  oracle.scale = 1.0L / made.compliances.force_share;
  oracle.softness = softness;
  oracle.normals.resize(static_cast<Eigen::Index>(made.planes.count), D);
  oracle.offsets.resize(static_cast<Eigen::Index>(made.planes.count));
  for (std::size_t i = 0; i < made.planes.count; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    oracle.normals.row(row) = exact<D>(made.planes.walls[i].normal).transpose();
    oracle.offsets(row) = oracle.normals.row(row).dot(exact<D>(made.planes.walls[i].point));
  }
  oracle.actuation.resize(D, count);
  for (int i = 0; i < count; ++i) {
    const auto motor = static_cast<std::size_t>(i);
    oracle.actuation.col(i) = exact<D>(made.actuation.columns[motor]);
    oracle.least.push_back(made.actuation.least[motor]);
    oracle.greatest.push_back(made.actuation.greatest[motor]);
  }
  made.goal = exact<D>(random.in_box<D>(0.02));
  return made;
}

// How large a displacement is for the hand, and a force.
Exact energy_norm(const ExactMatrix& user, const ExactVector& force) {
  return std::sqrt(force.dot(user * force));
}

struct Worst {
  Exact force = 0;
  Exact proxy = 0;
  int cases = 0;
  int slack = 0;
  int corners = 0;
};

template <glm::length_t D>
void compare(std::uint64_t seed, Motors motors, Worst& worst) {
  Random random(seed);
  const RandomDevice<D> made = random_device<D>(random, motors);
  const OracleDevice& oracle = made.oracle;
  if (((oracle.normals * made.goal - oracle.offsets).array() >= 0).all()) return;
  const OracleRest rest = oracle_rest(oracle, made.goal);
  if (!rest.is_found) return;  // the walls leave no place
  const Exact size = energy_norm(oracle.user, rest.full_force);
  if (size < 1e-3L) return;  // so shallow that the rounding of the handle's place shows
  const Vector<D> device = rounded<D>(rest.device);
  const Contact<D> contact = solve_contact(device, made.planes, made.actuation, made.compliances, 1.0);
  ASSERT_EQ(contact.status, ContactStatus::contact) << seed;
  worst.force = std::max(worst.force, energy_norm(oracle.user, exact<D>(contact.force) - rest.force) / size);
  const ExactVector off = exact<D>(contact.proxy) - rest.proxy;
  worst.proxy = std::max(worst.proxy, std::sqrt(off.dot(oracle.user.inverse() * off)) / size);
  EXPECT_EQ(contact.active, rest.walls) << seed;
  ++worst.cases;
  worst.slack += rest.has_slack_motor ? 1 : 0;
  worst.corners += (rest.walls & (rest.walls - 1U)) != 0 ? 1 : 0;
  if (motors == Motors::any) {
    // Every motor stands where it would stand with all motors on.
    const ExactVector along = oracle.actuation.transpose() * (rest.device - rest.full_device);
    EXPECT_LT(along.norm(), 1e-15L) << seed;
  }
  // The fully actuated device is the same call with every axis a motor.
  const Contact<D> full =
      solve_full_contact(rounded<D>(rest.full_device), made.planes, made.actuation, made.compliances);
  EXPECT_LT((exact<D>(full.proxy) - rest.proxy).norm(), 1e-13L) << seed;
  EXPECT_LT((exact<D>(full.force) - rest.full_force).norm(), 1e-10L * (1 + rest.full_force.norm())) << seed;
}

Worst worst_of(Motors motors) {
  Worst worst;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    compare<2>(seed, motors, worst);
    compare<3>(seed, motors, worst);
    compare<4>(seed, motors, worst);
  }
  return worst;
}

// Rounding of the handle's place, 1e-18 m beside displacements of some mm, is divided by the compliance of the walls'
// normals among each other: nearly parallel walls cost digits.
TEST(ContactSolver, ObliqueMotorsAndCornersRestAsTheOracleSays) {
  const Worst worst = worst_of(Motors::any);
  EXPECT_LT(worst.force, 1e-11L);
  EXPECT_LT(worst.proxy, 1e-11L);
  EXPECT_GT(worst.cases, 600);
  EXPECT_GT(worst.corners, 100);
}

TEST(ContactSolver, StringsRestAsTheOracleSays) {
  const Worst worst = worst_of(Motors::strings);
  EXPECT_LT(worst.force, 1e-11L);
  EXPECT_LT(worst.proxy, 1e-11L);
  EXPECT_GT(worst.slack, 300);
}

TEST(ContactSolver, LimitedMotorsRestAsTheOracleSays) {
  const Worst worst = worst_of(Motors::limited);
  EXPECT_LT(worst.force, 1e-11L);
  EXPECT_LT(worst.proxy, 1e-11L);
  EXPECT_GT(worst.slack, 300);
}

// Off from the rest too: the problem's own conditions, whatever the handle.
TEST(ContactSolver, NoSmallChangeOfPushesAndEffortsIsBetter) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    RandomDevice<2> made = random_device<2>(random, Motors::strings);
    const Vector<2> q = random.in_box<2>(0.02);
    const Contact<2> contact = solve_contact(q, made.planes, made.actuation, made.compliances, 1.0);
    if (contact.status == ContactStatus::free) continue;
    ASSERT_EQ(contact.status, ContactStatus::contact) << seed;
    const double tau = 1.0 / made.compliances.force_share;
    const auto cost = [&](const PlaneNumbers& pushes, const Efforts& efforts) {
      Vector<2> push(0.0);
      double total = 0.0;
      for (std::size_t i = 0; i < made.planes.count; ++i) {
        push += made.planes.walls[i].normal * pushes[i];
        total += tau * pushes[i] * signed_distance(made.planes.walls[i], q) +
                 0.5 * tau * made.compliances.constraint * pushes[i] * pushes[i];
      }
      const Vector<2> missing = tau * force_of_efforts(made.actuation, efforts) - push;
      return total + 0.5 * glm::dot(push, tau * (made.compliances.tracking * push)) +
             0.5 * glm::dot(missing, made.compliances.user * missing);
    };
    const double least = cost(contact.multipliers, contact.efforts);
    for (int i = 0; i < 50; ++i) {
      PlaneNumbers pushes = contact.multipliers;
      Efforts efforts = contact.efforts;
      for (std::size_t k = 0; k < made.planes.count; ++k)
        pushes[k] = std::max(0.0, pushes[k] + random.uniform(-0.1, 0.1));
      for (std::size_t k = 0; k < made.actuation.count; ++k) {
        efforts[k] = std::max(0.0, efforts[k] + random.uniform(-0.1, 0.1));
      }
      EXPECT_GE(cost(pushes, efforts), least - 1e-12) << seed;
    }
  }
}

// More strings than directions: the force is the motors' only one, and of all efforts that make it these are the least.
TEST(ContactSolver, OfEqualEffortsTheLeastAreTaken) {
  int shared = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    ActuationMatrix<2> actuation;
    const int count = 3 + random.below(2);
    for (int i = 0; i < count; ++i) {
      const Vector<2> pull = glm::normalize(random.in_box<2>(1.0));
      add_motor(actuation, pull, pull);
      actuation.least[static_cast<std::size_t>(i)] = 0.0;
      if (random.once_in(2)) actuation.greatest[static_cast<std::size_t>(i)] = random.uniform(0.3, 2.0);
    }
    const Matrix<2> user = random_compliance<2>(random, 1e-3, 1e-2);
    const Vector<2> force = random.in_box<2>(2.0);
    const Efforts efforts = nearest_efforts(actuation, user, force);
    const Vector<2> made = force_of_efforts(actuation, efforts);
    double square = 0.0;
    int acting = 0;
    for (std::size_t i = 0; i < actuation.count; ++i) {
      EXPECT_GE(efforts[i], actuation.least[i]);
      EXPECT_LE(efforts[i], actuation.greatest[i]);
      square += efforts[i] * efforts[i];
      acting += efforts[i] > 0.0 ? 1 : 0;
    }
    shared += acting > 2 ? 1 : 0;
    // Any way to other efforts with the same force is longer.
    Eigen::MatrixXd columns(2, count);
    for (int i = 0; i < count; ++i) {
      const Vector<2>& column = actuation.columns[static_cast<std::size_t>(i)];
      columns.col(i) << column.x, column.y;
    }
    const Eigen::MatrixXd kernel = columns.fullPivLu().kernel();
    for (int k = 0; k < 40; ++k) {
      Eigen::VectorXd way = Eigen::VectorXd::Zero(count);
      for (Eigen::Index j = 0; j < kernel.cols(); ++j) way += random.uniform(-1.0, 1.0) * kernel.col(j);
      way *= 0.01 / way.norm();
      double other = 0.0;
      bool is_possible = true;
      for (int i = 0; i < count; ++i) {
        const auto motor = static_cast<std::size_t>(i);
        const double effort = efforts[motor] + way(i);
        is_possible &= effort >= actuation.least[motor] && effort <= actuation.greatest[motor];
        other += effort * effort;
      }
      if (!is_possible) continue;
      EXPECT_GE(other, square - 1e-9) << seed;
    }
    // And no other force of the motors is nearer.
    for (int k = 0; k < 40; ++k) {
      Efforts near = efforts;
      for (std::size_t i = 0; i < actuation.count; ++i) {
        near[i] = within_limits(actuation, i, near[i] + random.uniform(-0.1, 0.1));
      }
      const auto off = [&](const Vector<2>& v) { return glm::dot(v - force, user * (v - force)); };
      EXPECT_GE(off(force_of_efforts(actuation, near)), off(made) - 1e-14) << seed;
    }
  }
  EXPECT_GT(shared, 20) << "three strings share a force at times";
}

TEST(ContactSolver, DependentMotorsShareTheForce) {
  ActuationMatrix<2> twice;
  add_motor(twice, Vector<2>(1.0, 0.0), Vector<2>(0.5, 0.0));
  add_motor(twice, Vector<2>(1.0, 0.0), Vector<2>(0.5, 0.0));
  const Efforts efforts = nearest_efforts(twice, Matrix<2>(0.005), Vector<2>(3.0, 1.0));
  EXPECT_NEAR(efforts[0], 1.5, 1e-15);
  EXPECT_NEAR(efforts[1], 1.5, 1e-15);
}

// As a tick of a scene with straight motors and walls asks for it.
template <glm::length_t D>
void compare_fixed(std::uint64_t seed, std::array<int, 4>& cases) {
  Random random(seed);
  const RandomDevice<D> made = random_device<D>(random, Motors::any);
  for (const double share : {0.0, 0.5, 1.0, 1.5}) {
    for (const bool has_every_motor : {false, true}) {
      const FixedContact<D> fixed =
          fixed_contact(made.planes, made.actuation, made.compliances, has_every_motor, share);
      const Vector<D> q = random.in_box<D>(0.02);
      const Contact<D> anew = has_every_motor ? solve_full_contact(q, made.planes, made.actuation, made.compliances)
                                              : solve_contact(q, made.planes, made.actuation, made.compliances, share);
      const Contact<D> found = solve_fixed_contact(fixed, q);
      ASSERT_EQ(found.status, anew.status) << seed;
      ASSERT_EQ(found.active, anew.active) << seed;
      ++cases[found.active];
      const double size = 1e-11 * (1.0 + glm::length(anew.contact_force));
      EXPECT_LT(glm::length(found.contact_force - anew.contact_force), size) << seed;
      EXPECT_LT(glm::length(found.force - anew.force), size) << seed;
      EXPECT_LT(glm::length(found.proxy - anew.proxy), 1e-3 * size) << seed;
      for (std::size_t i = 0; i < made.planes.count; ++i) {
        EXPECT_NEAR(found.multipliers[i], anew.multipliers[i], size) << seed;
      }
      for (std::size_t i = 0; i < made.actuation.count; ++i) {
        EXPECT_NEAR(found.efforts[i], anew.efforts[i], size) << seed;
      }
    }
  }
}

TEST(ContactSolver, WhatIsWorkedOutBeforehandIsWhatIsSolvedAnew) {
  std::array<int, 4> cases{};
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    compare_fixed<2>(seed, cases);
    compare_fixed<3>(seed, cases);
  }
  for (const int of_each : cases) EXPECT_GT(of_each, 500);  // free, either wall, both
}

// κ_w of the law is at most that of full actuation: what is stable with all motors stays so.
TEST(ContactSolver, TheCureIsNoStifferThanFullActuation) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random random(seed);
    const RandomDevice<3> made = random_device<3>(random, Motors::any);
    const Matrix<3> projector =
        actuated_projection(made.actuation, all_motors(made.actuation.count), made.compliances.user).projector;
    const Vector<3>& n = made.planes.walls[0].normal;
    const auto stiffness = [&](const Matrix<3>& Pi) {
      return made.compliances.force_share * glm::dot(n, made.compliances.user * (Pi * n)) /
             (glm::dot(n, tracking_compliance(made.compliances, Pi, 1.0) * n) + made.compliances.constraint);
    };
    EXPECT_LE(stiffness(projector), stiffness(Matrix<3>(1.0)) * (1.0 + 1e-12)) << seed;
  }
}

// So it is a metric, and the proxy is one point: with a hand that is not as stiff all round Π is not symmetric, but C_uΠ
// is. Along the motors it is that of full actuation.
TEST(ContactSolver, TheTrackingComplianceIsSymmetricAndPositive) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random random(seed);
    const RandomDevice<3> made = random_device<3>(random, Motors::any);
    const Matrix<3> projector =
        actuated_projection(made.actuation, all_motors(made.actuation.count), made.compliances.user).projector;
    const Matrix<3> tracking = tracking_compliance(made.compliances, projector, 1.0);
    ExactMatrix yields(3, 3);
    for (glm::length_t i = 0; i < 3; ++i) yields.col(i) = exact<3>(tracking[i] - made.compliances.tracking[i]);
    const Exact size = made.oracle.user.norm() * made.compliances.force_share;
    EXPECT_LT((yields - yields.transpose()).norm(), 1e-13L * size) << seed;
    const ExactVector eigenvalues =
        Eigen::SelfAdjointEigenSolver<ExactMatrix>(0.5L * (yields + yields.transpose())).eigenvalues();
    EXPECT_GT(eigenvalues(0), -1e-13L * size) << seed;
    EXPECT_LT((yields * made.oracle.actuation).norm(), 1e-13L * size * made.oracle.actuation.norm()) << seed;
  }
}

// Paper: isotropic hand, orthonormal A.
TEST(ContactSolver, TheTrackingComplianceIsThePapersForAnIsotropicHand) {
  ActuationMatrix<3> actuation;
  const Vector<3> axis = glm::normalize(Vector<3>(1.0, 2.0, -1.0));
  add_motor(actuation, axis, axis);
  const double k_u = 200.0;
  const double k_r = 600.0;
  const double k_t = 500.0;
  const Compliances<3> compliances{Matrix<3>(1.0 / k_u), Matrix<3>(1.0 / k_t), k_r / k_t, 0.0};
  const Matrix<3> projector = actuated_projection(actuation, 1, compliances.user).projector;
  const Matrix<3> expected = (1.0 / k_t) * projector + ((1.0 + k_r / k_u) / k_t) * (Matrix<3>(1.0) - projector);
  const Matrix<3> difference = tracking_compliance(compliances, projector, 1.0) - expected;
  for (glm::length_t i = 0; i < 3; ++i) {
    EXPECT_LT(glm::length(projector[i] - glm::outerProduct(axis, axis)[i]), 1e-15);
    EXPECT_LT(glm::length(difference[i]), 1e-17);
  }
}

}  // namespace
}  // namespace ghostforce::contact_solver_test
