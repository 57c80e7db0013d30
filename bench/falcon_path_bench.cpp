// The Falcon's kinematics, of which the servo thread computes each once per tick: how long they take and how true they
// are. Writes section 7 of RESULTS.md.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "bench/support/contest.h"
#include "bench/support/report.h"
#include "core/conventions.h"
#include "device/falcon/kinematics.h"
#include "tests/core/random_setting.h"
#include "tests/device/falcon/reference_kinematics.h"

namespace ghostforce::bench {
namespace {

constexpr double counts_per_newton_metre = 6600.0;
// Enough that no branch can be learnt by heart, few enough for the cache; a power of two.
constexpr std::size_t pose_count = 1024;

// Turns shorter than the time slices of a machine that others use too: most of them are interrupted by nobody.
constexpr Contest::Length many_short_turns{.rounds = 201, .seconds_per_turn = 0.001};

struct Pose {
  Vector<3> position;
  Vector<3> nearby;  // 1 mm away: as far as a handle at 1 m/s, the fastest that may be armed, gets in a tick
  Vector<3> near;    // 0.1 mm away: 0.1 m/s, a hand that feels its way
  Vector<3> angles;
  Vector<3> force;  // 1 to 8 N
};

std::vector<Pose> random_poses(const FalconKinematics& kinematics) {
  Random random(1);
  std::vector<Pose> poses(pose_count);
  for (Pose& pose : poses) {
    pose.position = random_working_position(random);
    const Vector<3> way = random.direction<3>();
    pose.nearby = pose.position + 0.001 * way;
    pose.near = pose.position + 0.0001 * way;
    pose.angles = *kinematics.angles(pose.position);
    pose.force = random.uniform(1.0, 8.0) * random.direction<3>();
  }
  return poses;
}

template <typename Work>
Contestant contestant(std::string name, const std::vector<Pose>& poses, Work work) {
  return {std::move(name), [&poses, work](std::int64_t calls) {
            for (std::int64_t k = 0; k < calls; ++k) {
              const auto result = work(poses[static_cast<std::size_t>(k) % pose_count]);
              keep(&result);
            }
          }};
}

void time_them(Report& report, const FalconKinematics& kinematics) {
  const std::vector<Pose> poses = random_poses(kinematics);
  const Contest contest(
      {
          contestant("inverse", poses, [&](const Pose& pose) { return kinematics.angles(pose.position); }),
          contestant("warm", poses, [&](const Pose& pose) { return kinematics.position(pose.angles, pose.nearby); }),
          contestant("near", poses, [&](const Pose& pose) { return kinematics.position(pose.angles, pose.near); }),
          contestant("there", poses, [&](const Pose& pose) { return kinematics.position(pose.angles, pose.position); }),
          contestant("cold", poses, [&](const Pose& pose) { return kinematics.position(pose.angles); }),
          // The worst that encoders can do: no position has these angles, and both searches go to their end.
          contestant("impossible", poses,
                     [&](const Pose& pose) {
                       return kinematics.position(Vector<3>(3.0, -1.4, -1.4) + 0.01 * pose.angles, pose.nearby);
                     }),
          contestant("torques", poses,
                     [&](const Pose& pose) {
                       return motor_counts(pose.force, *kinematics.jacobian(pose.position), counts_per_newton_metre);
                     }),
      },
      many_short_turns);
  const auto row = [&](std::string what, std::string_view name, std::optional<double> limit) {
    const double ns = 1e9 * contest.median_seconds(name);
    report.row(std::move(what), fmt::format("{:.0f} ns", ns),
               limit ? std::optional(at_most(ns, *limit, "ns")) : std::nullopt);
  };
  row("inverse: angles of a position", "inverse", 65.0);
  row("forward: position of angles, from 1 mm away", "warm", 140.0);
  row("forward, from 0.1 mm away", "near", std::nullopt);
  row("forward, of a handle at rest", "there", std::nullopt);
  row("forward, from the cold start", "cold", std::nullopt);
  row("forward, for angles that no position has", "impossible", std::nullopt);
  row("torques: motor numbers of a force, Jacobian included", "torques", 70.0);
}

// How far rounding the encoders' counts puts the position off, as a share of what half a count at each joint can do to
// it at worst: the greatest over many poses.
double position_error(const FalconKinematics& kinematics, const FalconGeometry& geometry) {
  Random random(8);
  double greatest = 0.0;
  for (int i = 0; i < 15000; ++i) {
    const Vector<3> p = random_working_position(random);
    const Vector<3> counts = glm::round(counts_of_angles(*kinematics.angles(p), geometry));
    const double error = glm::length(kinematics.position(angles_of_counts(counts, geometry)).position - p);
    const Matrix<3> inverse = glm::inverse(*reference_jacobian(p, geometry));
    double worst = 0.0;
    for (const double b : {-0.5, 0.5}) {
      for (const double c : {-0.5, 0.5}) {
        worst = std::max(worst, glm::length(inverse * (Vector<3>(0.5, b, c) * radians_per_count(geometry))));
      }
    }
    greatest = std::max(greatest, error / worst);
  }
  return greatest;
}

// Between a force and what its motor numbers make, by numeric derivatives: the greatest over many poses [deg].
double direction_error(const FalconKinematics& kinematics, const FalconGeometry& geometry, double least_N,
                       double most_N) {
  Random random(9);
  double greatest = 0.0;
  for (int i = 0; i < 15000; ++i) {
    const Vector<3> p = random_working_position(random);
    const Vector<3> force = random.uniform(least_N, most_N) * random.direction<3>();
    const MotorCommand command = motor_counts(force, *kinematics.jacobian(p), counts_per_newton_metre);
    const Vector<3> made =
        force_of_motor_counts(command.counts, *reference_jacobian(p, geometry), counts_per_newton_metre);
    const double angle = std::atan2(glm::length(glm::cross(made, force)), glm::dot(made, force));
    greatest = std::max(greatest, angle / radians_per_degree);
  }
  return greatest;
}

}  // namespace

int run(int argc, char** argv) {
  const FalconGeometry geometry;
  const FalconKinematics kinematics(geometry);
  Report report("7. The Falcon path");
  report.paragraph(
      "Random poses inside the workspace, 1024 of them in turn for the times, 15,000 for the errors, which are the "
      "worst and are told against a second formulation with numeric derivatives.");
  time_them(report, kinematics);
  const double error = position_error(kinematics, geometry);
  report.row("position error, in errors of the encoders' resolution", fmt::format("{:.3f} times", error),
             at_most(error, 1.05));
  const double strong = direction_error(kinematics, geometry, 3.0, 8.0);
  report.row("force direction, 3 to 8 N", fmt::format("{:.3f}°", strong), at_most(strong, 0.1, "°"));
  const double weak = direction_error(kinematics, geometry, 1.0, 1.0);
  report.row("force direction, 1 N", fmt::format("{:.3f}°", weak), at_most(weak, 0.1, "°"));
  report.note(
      "Motor numbers are whole: rounding them adds up to 5 mN across a force, however small that is, and so turns 1 N "
      "by more than 0.1°. Tried: of the eight whole numbers around, those of the truest direction turn it by up to "
      "0.13°, with twice the error of the magnitude (7 instead of 3 mN); scaling the force by up to a percent before "
      "rounding, by 0.12°. Both miss 0.1°, and need more than the time that torques have left, so plain rounding "
      "stays.");
  report.note(
      "Forward: the parallelogram's short sides make each leg's surface a torus, not a sphere, so that there is no "
      "closed form. From wherever a handle can come from in a tick, up to 1 mm, it takes two steps of some 50 ns, "
      "after three sines and cosines of 30 ns: the first allows for how the legs' surfaces bend, which leaves the cube "
      "of its length instead of its square and makes the third step of Newton's method needless.");
  return report.finish(argc, argv);
}

}  // namespace ghostforce::bench
