#include "core/actuation.h"

#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/core/dimensions.h"
#include "tests/core/random_setting.h"
#include "tests/core/reference_model.h"

namespace ghostforce::actuation_test {
namespace {

// Entries of a projector are at most 1 and sums of D products of D of them.
constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();

template <glm::length_t D>
double trace(const Matrix<D>& m) {
  double sum = 0.0;
  for (glm::length_t i = 0; i < D; ++i) sum += m[i][i];
  return sum;
}

template <glm::length_t D>
double difference(const Matrix<D>& a, const Matrix<D>& b) {
  return distance(reference(a), reference(b));
}

template <glm::length_t D>
Actuation<D> along_all(const std::vector<Vector<D>>& directions) {
  return actuated_along<D>(std::span<const Vector<D>>(directions));
}

template <typename Dimension>
class ActuationTest : public testing::Test {};
TYPED_TEST_SUITE(ActuationTest, Dimensions, DimensionName);

TYPED_TEST(ActuationTest, ProjectorsAreIdempotentSymmetricAndComplete) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    std::vector<Vector<D>> directions;  // any lengths, not orthogonal
    const int count = 1 + random.below(D - 1);
    for (int j = 0; j < count; ++j) directions.push_back(random.over_decades(1e-6, 1e6) * random.direction<D>());
    const Actuation<D> actuation = along_all(directions);
    for (const Matrix<D>& P : {actuation.actuated, actuation.unactuated}) {
      EXPECT_LE(difference(P * P, P), rounding);
      EXPECT_EQ(glm::transpose(P), P);
    }
    EXPECT_LE(difference(actuation.actuated + actuation.unactuated, Matrix<D>(1.0)), rounding);
    EXPECT_LE(difference(actuation.actuated * actuation.unactuated, Matrix<D>(0.0)), rounding);
    EXPECT_NEAR(trace(actuation.actuated), count, rounding);  // the trace of a projector is its rank
    for (const Vector<D>& direction : directions) {
      // Directions that are nearly alike leave a small remainder to be scaled up: 1000 covers one in a thousand.
      EXPECT_LE(glm::length(actuation.unactuated * direction), 1000.0 * rounding * glm::length(direction));
    }
  }
}

TYPED_TEST(ActuationTest, IsTheProjectorOfTheBasis) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const std::vector<Vector<D>> basis = random_basis<D>(random, 1 + random.below(D - 1));
    EXPECT_LE(distance(along_all(basis).actuated, reference_projector<D>(basis)), rounding);
  }
}

// Two directions that differ by a part in 10 million still span a plane, and what comes out is still a projector: the
// small remainder of the second one, which is mostly rounding along the first, is made orthogonal again.
TYPED_TEST(ActuationTest, NearlyParallelDirectionsGiveAProjector) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(6);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const Vector<D> first = random.direction<D>();
    const Vector<D> second = first + random.over_decades(1e-9, 1e-5) * random.direction<D>();
    const Actuation<D> actuation = along_all<D>({first, second});
    EXPECT_LE(difference(actuation.actuated * actuation.actuated, actuation.actuated), rounding);
    EXPECT_NEAR(trace(actuation.actuated), 2.0, rounding);
  }
}

TYPED_TEST(ActuationTest, DirectionsThatAddNothingArePassedOver) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const std::vector<Vector<D>> basis = random_basis<D>(random, 1 + random.below(D - 1));
    std::vector<Vector<D>> more = basis;
    more.insert(more.begin(), Vector<D>(0.0));
    more.push_back(-3.0 * basis[0]);
    Vector<D> sum(0.0);
    for (const Vector<D>& b : basis) sum += random.uniform(-1.0, 1.0) * b;
    more.push_back(sum);
    EXPECT_LE(difference(along_all(more).actuated, along_all(basis).actuated), rounding);
  }
}

TYPED_TEST(ActuationTest, NoDirectionIsNoMotorAndAllAreEveryMotor) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(4);
  const Actuation<D> none = along_all<D>({});
  EXPECT_EQ(none.actuated, Matrix<D>(0.0));
  EXPECT_EQ(none.unactuated, Matrix<D>(1.0));
  const Actuation<D> every = along_all(random_basis<D>(random, D));
  EXPECT_LE(difference(every.actuated, Matrix<D>(1.0)), rounding);
  EXPECT_LE(difference(every.unactuated, Matrix<D>(0.0)), rounding);
}

TYPED_TEST(ActuationTest, OneMotorIsTheSpanOfOneDirection) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(5);
  const Vector<D> motor = random.direction<D>();
  EXPECT_EQ(actuated_along(2.5 * motor).actuated, along_all<D>({2.5 * motor}).actuated);
  EXPECT_LE(glm::length(actuated_along(2.5 * motor).actuated * motor - motor), rounding);
}

TEST(Actuation, AHorizontalMotorPushesAlongX) {
  const Actuation<2> actuation = actuated_along(Vector<2>{-2.0, 0.0});
  EXPECT_EQ(actuation.actuated * Vector<2>(3.0, 4.0), Vector<2>(3.0, 0.0));
  EXPECT_EQ(actuation.unactuated * Vector<2>(3.0, 4.0), Vector<2>(0.0, 4.0));
}

static_assert(noexcept(actuated_along(Vector<3>{})));
static_assert(std::is_trivially_copyable_v<Actuation<2>>);

}  // namespace
}  // namespace ghostforce::actuation_test
