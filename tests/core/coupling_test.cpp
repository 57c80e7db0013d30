#include "core/actuation.h"

#include <limits>
#include <type_traits>

#include <gtest/gtest.h>

#include "tests/core/dimensions.h"
#include "tests/core/random_setting.h"
#include "tests/core/reference_model.h"

namespace ghostforce::coupling_test {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

template <typename Dimension>
class CouplingTest : public testing::Test {};
TYPED_TEST_SUITE(CouplingTest, Dimensions, DimensionName);

// K_r and K_t on each direction: what the motors do along A, what is left across it.
TYPED_TEST(CouplingTest, StiffnessesAreThoseOfTheSubspaces) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    const Stiffnesses& k = setting.stiffnesses;
    const ReferenceModel expected = underactuated_reference(setting, setting.ratio);
    const Coupling<D> coupling = underactuated_coupling(k.k_r, k.k_t, setting.ratio, setting.actuation());
    // Projectors are good to a dozen roundings; entries are as large as the largest stiffness.
    EXPECT_LE(distance(coupling.rendering, expected.K_r), 16.0 * epsilon * k.k_r);
    EXPECT_LE(distance(coupling.tracking, expected.K_t), 16.0 * epsilon * k.k_t * (1.0 + 1.0 / setting.ratio));
  }
}

// K_t K_t⁻¹ = I, though nothing is inverted. One factor's rounding is scaled by the other's size: ρ + 1/ρ.
TYPED_TEST(CouplingTest, ComplianceIsTheInverseOfTheTrackingStiffness) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    const Stiffnesses& k = setting.stiffnesses;
    for (const double ratio : {1.0, setting.ratio}) {
      const Coupling<D> coupling = underactuated_coupling(k.k_r, k.k_t, ratio, setting.actuation());
      const double rounding = 32.0 * epsilon * (ratio + 1.0 / ratio);
      const ReferenceMatrix I = reference_identity(D);
      EXPECT_LE(distance(coupling.tracking * coupling.tracking_compliance, I), rounding);
      EXPECT_LE(distance(coupling.tracking_compliance * coupling.tracking, I), rounding);
    }
  }
}

TYPED_TEST(CouplingTest, EveryMotorIsTheSameInAllDirections) {
  constexpr glm::length_t D = TypeParam::value;
  const Coupling<D> coupling = fully_actuated_coupling<D>(300.0, 500.0);
  EXPECT_EQ(coupling.rendering, Matrix<D>(300.0));
  EXPECT_EQ(coupling.tracking, Matrix<D>(500.0));
  EXPECT_EQ(coupling.tracking_compliance, Matrix<D>(1.0 / 500.0));
}

// (16): softer by ρ where there is no motor, and only there.
TEST(Coupling, IsAnisotropicAcrossTheMotor) {
  const Coupling<2> coupling = underactuated_coupling(300.0, 500.0, 10.0, actuated_along(Vector<2>{1.0, 0.0}));
  EXPECT_EQ(coupling.rendering, Matrix<2>(300.0, 0.0, 0.0, 0.0));
  EXPECT_EQ(coupling.tracking, Matrix<2>(500.0, 0.0, 0.0, 50.0));
  EXPECT_EQ(coupling.tracking_compliance, Matrix<2>(1.0 / 500.0, 0.0, 0.0, 10.0 / 500.0));
}

static_assert(std::is_trivially_copyable_v<Coupling<4>>);
static_assert(noexcept(fully_actuated_coupling<2>(1.0, 1.0)));
static_assert(noexcept(underactuated_coupling(1.0, 1.0, 1.0, Actuation<2>{})));

}  // namespace
}  // namespace ghostforce::coupling_test
