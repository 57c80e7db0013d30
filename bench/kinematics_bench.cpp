// The Falcon's kinematics, of which the servo thread computes each once per tick. Run with
// --benchmark_repetitions=9 --benchmark_report_aggregates_only=true and read the medians.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <vector>

#include "device/falcon/kinematics.h"
#include "tests/core/random_setting.h"
#include "tests/device/falcon/reference_kinematics.h"

namespace ghostforce {
namespace {

// Enough that no branch can be learnt by heart, few enough for the cache; a power of two.
constexpr std::size_t count = 1024;

struct Pose {
  Vector<3> position;
  Vector<3> nearby;  // 1 mm away
  Vector<3> angles;
  Vector<3> force;  // 1 to 8 N
};

std::vector<Pose> random_poses(const FalconKinematics& kinematics) {
  Random random(1);
  std::vector<Pose> poses(count);
  for (Pose& pose : poses) {
    pose.position = random_working_position(random);
    pose.nearby = pose.position + 0.001 * random.direction<3>();
    pose.angles = *kinematics.angles(pose.position);
    pose.force = random.uniform(1.0, 8.0) * random.direction<3>();
  }
  return poses;
}

template <typename Work>
void repeat(benchmark::State& state, const Work& work) {
  const FalconKinematics kinematics{FalconGeometry{}};
  const std::vector<Pose> poses = random_poses(kinematics);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(work(kinematics, poses[i]));
    i = (i + 1) % count;
  }
}

void position_nearby(benchmark::State& state) {
  repeat(state, [](const FalconKinematics& k, const Pose& pose) { return k.position(pose.angles, pose.nearby); });
}
BENCHMARK(position_nearby);

void position_from_the_cold_start(benchmark::State& state) {
  repeat(state, [](const FalconKinematics& k, const Pose& pose) { return k.position(pose.angles); });
}
BENCHMARK(position_from_the_cold_start);

// The worst that encoders can do: no position has these angles, and both searches go to their end.
void position_of_impossible_angles(benchmark::State& state) {
  repeat(state, [](const FalconKinematics& k, const Pose& pose) {
    return k.position(Vector<3>(3.0, -1.4, -1.4) + 0.01 * pose.angles, pose.nearby);
  });
}
BENCHMARK(position_of_impossible_angles);

void angles(benchmark::State& state) {
  repeat(state, [](const FalconKinematics& k, const Pose& pose) { return k.angles(pose.position); });
}
BENCHMARK(angles);

void jacobian_and_motor_counts(benchmark::State& state) {
  repeat(state, [](const FalconKinematics& k, const Pose& pose) {
    return motor_counts(pose.force, *k.jacobian(pose.position), 6600.0);
  });
}
BENCHMARK(jacobian_and_motor_counts);

}  // namespace
}  // namespace ghostforce
