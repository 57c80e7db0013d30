#include "core/simulated_hand.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/tick.h"

namespace ghostforce {
namespace {

// Steele, Lea and Flood's SplitMix64: the distributions of the standard library differ from machine to machine.
class RandomShares {
 public:
  explicit RandomShares(std::uint64_t seed) noexcept : state_(seed) {}

  // From 0 up to 1, 1 excluded.
  double next() noexcept {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    z ^= z >> 31U;
    return static_cast<double>(z >> 11U) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

// So many that no beat between two of them is seen.
constexpr std::size_t wave_count = 24;

struct Wave {
  double turns_per_second;
  double phase;  // [turns]
};

// One in each of as many equal parts of the band.
std::array<Wave, wave_count> waves_of(const Tremor& tremor, RandomShares& random) {
  std::array<Wave, wave_count> waves{};
  const double part = (tremor.greatest_hz - tremor.least_hz) / static_cast<double>(wave_count);
  for (std::size_t i = 0; i < wave_count; ++i) {
    waves[i].turns_per_second = tremor.least_hz + part * (static_cast<double>(i) + random.next());
    waves[i].phase = random.next();
  }
  return waves;
}

}  // namespace

GoalPath simulated_hand(const GoalPath& aim, const Tremor& tremor, double duration_s, double rate) {
  GoalPath smooth = aim;
  smooth.motion = Motion::minimum_jerk;
  RandomShares random(tremor.seed);
  const std::array<std::array<Wave, wave_count>, 2> axes{waves_of(tremor, random), waves_of(tremor, random)};
  const double amplitude = tremor.rms * std::sqrt(2.0 / static_cast<double>(wave_count));

  GoalPath hand;
  const std::int64_t last = std::llround(duration_s * rate);
  for (std::int64_t tick = 0; tick <= last; ++tick) {
    const double time_s = time_of(tick, rate);
    Vector<2> at = goal_at(smooth, time_s);
    for (const glm::length_t axis : {0, 1}) {
      for (const Wave& wave : axes[static_cast<std::size_t>(axis)]) {
        const double turns = wave.turns_per_second * time_s + wave.phase;
        at[axis] += amplitude * std::sin(2.0 * std::numbers::pi * turns);
      }
    }
    hand.points.push_back(at);
    hand.times.push_back(time_s);
  }
  return hand;
}

}  // namespace ghostforce
