// Where the workspace ends: the force goes to nothing before the arms come in line, without a jump, and comes back with
// the handle.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/device/haply/held_haply.h"

namespace ghostforce::haply_edges_test {
namespace {

struct Edge {
  const char* name;
  double wall_normal_deg;  // the wall is entered on the way
  Vector<2> wall_point;
  Vector<2> edge;  // goal of the hand: beyond the edge [m]
};

constexpr std::array edges{
    Edge{"arms stretched forwards", 90.0, {0.0, -0.035}, {0.0, -0.080}},
    Edge{"arms stretched to the left", 90.0, {0.0, -0.020}, {-0.060, -0.060}},
    Edge{"arms stretched to the right", 90.0, {0.0, -0.020}, {0.060, -0.060}},
    Edge{"distal links in line", 270.0, {0.0, 0.035}, {0.0, 0.085}},
    Edge{"towards motor 1", 270.0, {0.0, 0.030}, {0.040, 0.080}},
    Edge{"towards motor 2", 270.0, {0.0, 0.030}, {-0.040, 0.080}},
};

struct Findings {
  double greatest_force = 0.0;
  double greatest_jump = 0.0;         // of the force from tick to tick [N]
  double greatest_torque_step = 0.0;  // of a motor [N·m]
  double least_share = 1.0;
  double torque_without_share = 0.0;
};

void follow(HeldHaply& haply, double seconds, Findings& found) {
  Vector<2> force_before = haply.truth().force;
  std::array<double, 2> torques_before = haply.haply().torques;
  int ticks_without_share = 0;
  for (double t = 0.0; t < seconds; t += 0.001) {
    haply.step();
    const HaplyReport& report = haply.haply();
    const Vector<2> force = haply.truth().force;
    found.greatest_force = std::max(found.greatest_force, glm::length(force));
    found.greatest_jump = std::max(found.greatest_jump, glm::length(force - std::exchange(force_before, force)));
    // The report is that of before this tick's command, which may wait for a reply.
    ticks_without_share = report.workspace_share == 0.0 ? ticks_without_share + 1 : 0;
    for (std::size_t arm = 0; arm < 2; ++arm) {
      ASSERT_TRUE(std::isfinite(report.torques[arm]));
      found.greatest_torque_step =
          std::max(found.greatest_torque_step, std::abs(report.torques[arm] - torques_before[arm]));
      if (ticks_without_share > 3) {
        found.torque_without_share = std::max(found.torque_without_share, std::abs(report.torques[arm]));
      }
    }
    torques_before = report.torques;
    found.least_share = std::min(found.least_share, report.workspace_share);
  }
}

TEST(HaplyEdges, TheForceGoesToNothingWithoutAJump) {
  for (const Edge& edge : edges) {
    for (const StrategyId active : {StrategyId::naive, StrategyId::full}) {
      for (const std::size_t motor : {0U, 1U}) {
        if (active == StrategyId::full && motor == 1) continue;
        SCOPED_TRACE(std::string(edge.name) + ' ' + std::string(strategy_catalog()[index_of(active)].name) + ' ' +
                     std::to_string(motor));
        HeldHaply::Options options;
        options.settings = haply_settings(active);
        options.settings.wall_normal_angle = edge.wall_normal_deg * radians_per_degree;
        options.settings.wall_point = edge.wall_point;
        options.settings.stiffnesses.k_r = options.settings.stiffnesses.k_t = 100.0;
        options.device.hand.stiffness = 400.0;
        options.motor = motor;
        HeldHaply haply(options);
        ASSERT_TRUE(haply.set_zero_pose());
        haply.lead({-0.005, -0.005}, 0.3);
        haply.run(0.8);
        haply.lead({0.005, 0.005}, 0.3);
        haply.run(1.2);
        ASSERT_TRUE(haply.arm()) << haply.reason() << entry_of(haply.motors().obstacle).sentence;
        haply.lead(edge.edge, 1.5);
        Findings found;
        ASSERT_NO_FATAL_FAILURE(follow(haply, 2.5, found));
        const SafetyState at_edge = haply.motors().state;
        const std::string why(haply.reason());
        haply.lead({0.0, 0.0}, 1.0);
        ASSERT_NO_FATAL_FAILURE(follow(haply, 1.5, found));
        if (std::getenv("GHOSTFORCE_PRINT_HAPLY_FAULTS") != nullptr) {
          std::printf(
              "%-28s %-5s motor %zu: share down to %.3f, up to %.2f N, jumps up to %.2f N and %.4f N·m; %s %s\n",
              edge.name, std::string(strategy_catalog()[index_of(active)].name).c_str(), motor, found.least_share,
              found.greatest_force, found.greatest_jump, found.greatest_torque_step, name_of(at_edge).data(),
              why.c_str());
        }
        EXPECT_EQ(found.torque_without_share, 0.0);
        // The limiter lets a force grow by 0.5 N a tick, and coarse encoders and a question about them add to it.
        EXPECT_LT(found.greatest_jump, 1.0);
        EXPECT_LT(found.greatest_force, haply.motors().limit + 0.01);
        EXPECT_LT(found.least_share, 0.9) << "else it was not near an edge";
        EXPECT_TRUE(haply.motors().state == SafetyState::on || !haply.pushes());
      }
    }
  }
}

}  // namespace
}  // namespace ghostforce::haply_edges_test
