// The paper's experiment through the driver: a hand, a pantograph one motor of which pushes, and walls at several
// angles. Where the handle comes to rest and with which force is what the closed form says with the motor's line as it
// is there.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "core/prediction.h"
#include "tests/device/haply/held_haply.h"

namespace ghostforce::haply_closed_loop_test {
namespace {

struct Rest {
  Vector<2> handle{0.0};  // in truth
  Vector<2> force{0.0};   // of the motors, in the scene
  double line_angle = 0.0;
  double shake = 0.0;  // farthest from the mean
};

// The mean of a second, for a hand that holds quite still is asked now and then whether its encoders count.
Rest rest_of(HeldHaply& haply) {
  Rest rest;
  Vector<2> line(0.0);
  std::vector<Vector<2>> places;
  for (int i = 0; i < 1000; ++i) {
    haply.step();
    rest.handle += haply.tip() / 1000.0;
    rest.force += -haply.truth().force / 1000.0;
    line += direction_at(haply.motors().line_angle);
    places.push_back(haply.tip());
  }
  for (const Vector<2>& place : places) rest.shake = std::max(rest.shake, glm::length(place - rest.handle));
  rest.line_angle = std::atan2(line.y, line.x);
  return rest;
}

HeldHaply::Options options_for(double wall_deg, std::size_t motor, double counts) {
  HeldHaply::Options options;
  options.device.arms.friction = Vector<2>(0.0);
  options.device.counts_per_turn = Vector<2>(counts);
  for (HaplyArm& arm : options.calibration.arms) arm.counts_per_turn = counts;
  options.motor = motor;
  options.settings.wall_normal_angle = wall_deg * radians_per_degree;
  options.settings.stiffnesses.k_r = options.settings.stiffnesses.k_t = 300.0;
  return options;
}

// In front of the wall, armed there, and into it.
bool press(HeldHaply& haply, double wall_deg, double depth) {
  const Vector<2> normal = direction_at(wall_deg * radians_per_degree);
  if (!haply.set_zero_pose()) return false;
  haply.lead(0.01 * normal + Vector<2>(-0.008, -0.008), 0.3);
  haply.run(0.8);
  haply.lead(0.012 * normal, 0.3);
  haply.run(1.2);
  if (!haply.arm()) return false;
  haply.lead(-depth * normal, 0.5);
  haply.run(2.0);
  return haply.motors().state == SafetyState::on;
}

class ClosedLoopAtWall : public testing::TestWithParam<std::pair<double, std::size_t>> {};

// With encoders so fine that nothing but the theory is left: 100,000 counts a turn are 6 µm at the handle; a step of
// the duty is 30 µN·m, half a millinewton. What they misplace, k_r / k_u makes larger.
TEST_P(ClosedLoopAtWall, RestsWhereTheTheorySays) {
  const auto& [wall_deg, motor] = GetParam();
  HeldHaply haply(options_for(wall_deg, motor, 100'000.0));
  const double depth = 0.008;
  ASSERT_TRUE(press(haply, wall_deg, depth)) << haply.reason();
  const Vector<2> goal = -depth * direction_at(wall_deg * radians_per_degree);
  for (const StrategyId id : {StrategyId::full, StrategyId::naive, StrategyId::anisotropic}) {
    SCOPED_TRACE(strategy_catalog()[index_of(id)].name);
    haply.use(id);
    haply.run(1.5);
    const Rest rest = rest_of(haply);
    ASSERT_EQ(haply.motors().state, SafetyState::on) << haply.reason();
    ASSERT_LT(glm::length(rest.force), 1.7) << "no motor is at its end";
    Settings settings = haply.command().settings;
    settings.actuated_angle = rest.line_angle;
    const PredictedEquilibrium theory = predicted_equilibria(settings, goal)[index_of(id)];
    if (std::getenv("GHOSTFORCE_PRINT_HAPLY_FAULTS") != nullptr) {
      std::printf(
          "wall %3.0f motor %zu %-11s line %7.1f: handle (%7.3f %7.3f) theory (%7.3f %7.3f) mm; force (%6.3f %6.3f) "
          "theory (%6.3f %6.3f) N; shakes %.3f mm; ghost %.3f N\n",
          wall_deg, motor, std::string(strategy_catalog()[index_of(id)].name).c_str(),
          rest.line_angle * degrees_per_radian, mm_per_m * rest.handle.x, mm_per_m * rest.handle.y,
          mm_per_m * theory.at.device.x, mm_per_m * theory.at.device.y, rest.force.x, rest.force.y, theory.at.force.x,
          theory.at.force.y, mm_per_m * rest.shake, glm::length(theory.ghost_force));
    }
    const double k_r_over_k_u = settings.stiffnesses.k_r / settings.stiffnesses.k_u;
    EXPECT_LT(glm::length(rest.handle - theory.at.device), 10e-6 * (1.0 + k_r_over_k_u));
    EXPECT_LT(glm::length(rest.force - theory.at.force),
              10e-6 * (1.0 + k_r_over_k_u) * settings.stiffnesses.k_u + 2e-3);
    if (id == StrategyId::anisotropic) {
      EXPECT_LT(glm::length(theory.ghost_force), 1e-12);
      const Vector<2> line = direction_at(rest.line_angle);
      const Vector<2> full = predicted_equilibria(settings, goal)[index_of(StrategyId::full)].at.force;
      EXPECT_NEAR(glm::dot(rest.force - full, line), 0.0, 6e-3) << "the ghost force";
    }
    if (id != StrategyId::full) {
      const Vector<2> line = direction_at(rest.line_angle);
      EXPECT_NEAR(rest.force.x * line.y - rest.force.y * line.x, 0.0, 1e-3) << "one motor pushes along its line";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Walls, ClosedLoopAtWall,
                         testing::Values(std::pair{135.0, 0U}, std::pair{135.0, 1U}, std::pair{45.0, 0U},
                                         std::pair{45.0, 1U}, std::pair{90.0, 0U}, std::pair{90.0, 1U},
                                         std::pair{180.0, 1U}, std::pair{0.0, 0U}, std::pair{270.0, 0U},
                                         std::pair{225.0, 1U}));

// As sold: a step of 4880 counts a turn is 116 µm at the handle.
TEST(HaplyClosedLoop, TheUsualEncodersAreAsGoodAsTheirSteps) {
  for (const std::size_t motor : {0U, 1U}) {
    const double wall_deg = motor == 0 ? 45.0 : 135.0;
    HeldHaply haply(options_for(wall_deg, motor, 4880.0));
    const double depth = 0.008;
    ASSERT_TRUE(press(haply, wall_deg, depth)) << haply.reason();
    const Vector<2> goal = -depth * direction_at(wall_deg * radians_per_degree);
    for (const StrategyId id : {StrategyId::full, StrategyId::naive, StrategyId::anisotropic}) {
      haply.use(id);
      haply.run(1.5);
      const Rest rest = rest_of(haply);
      Settings settings = haply.command().settings;
      settings.actuated_angle = rest.line_angle;
      const PredictedEquilibrium theory = predicted_equilibria(settings, goal)[index_of(id)];
      const double k_r_over_k_u = settings.stiffnesses.k_r / settings.stiffnesses.k_u;
      if (std::getenv("GHOSTFORCE_PRINT_HAPLY_FAULTS") != nullptr) {
        std::printf("4880 counts, motor %zu %-11s: off by %.3f mm and %.3f N\n", motor,
                    std::string(strategy_catalog()[index_of(id)].name).c_str(),
                    mm_per_m * glm::length(rest.handle - theory.at.device), glm::length(rest.force - theory.at.force));
      }
      EXPECT_LT(glm::length(rest.handle - theory.at.device), 116e-6 * (1.0 + k_r_over_k_u))
          << motor << ' ' << index_of(id);
      EXPECT_LT(glm::length(rest.force - theory.at.force), 116e-6 * settings.stiffnesses.k_r)
          << motor << ' ' << index_of(id);
    }
  }
}

// Naive rendering slides along the wall, the cure does not.
TEST(HaplyClosedLoop, TheCureCures) {
  HeldHaply haply(options_for(180.0, 1, 100'000.0));
  ASSERT_TRUE(press(haply, 180.0, 0.012));
  const auto along_line = [&](StrategyId id) {
    haply.use(id);
    haply.run(1.5);
    const Rest rest = rest_of(haply);
    Settings settings = haply.command().settings;
    settings.actuated_angle = rest.line_angle;
    const Vector<2> full = predicted_equilibria(settings, {0.012, 0.0})[index_of(StrategyId::full)].at.force;
    return glm::dot(rest.force - full, direction_at(rest.line_angle));
  };
  const double naive = along_line(StrategyId::naive);
  const double cured = along_line(StrategyId::anisotropic);
  EXPECT_GT(std::abs(naive), 0.05);
  EXPECT_LT(std::abs(cured), 6e-3);
}

}  // namespace
}  // namespace ghostforce::haply_closed_loop_test
