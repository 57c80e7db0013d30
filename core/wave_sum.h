// WaveSum: random motion of the plane within a band of frequencies, as a sum of sines: any moment of it is known
// without those before. RandomShares draws the waves. Plain values; never allocate or throw; any thread. SI units.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/conventions.h"
#include "core/settings.h"
#include "core/sine.h"

namespace ghostforce {

// Steele, Lea and Flood's SplitMix64. The same seed gives the same numbers on every machine; the distributions of the
// standard library differ from one to another.
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

struct Wave {
  double turns_per_second = 0.0;
  double phase = 0.0;      // [turns]
  double amplitude = 0.0;  // [m]
};

template <std::size_t count>
struct WaveSum {
  std::array<std::array<Wave, count>, 2> axes{};

  void add_to(Vector<2>& place, double time_s) const noexcept {
    for (const glm::length_t axis : {0, 1}) {
      for (const Wave& wave : axes[static_cast<std::size_t>(axis)]) {
        const double turns = wave.turns_per_second * time_s + wave.phase;
        place[axis] += wave.amplitude * sine_of_turns(turns);
      }
    }
  }
};

// On each axis one wave in each of `count` equal parts of the band [Hz]. `amplitude_of`: of a wave of a frequency [m].
template <std::size_t count, typename AmplitudeOf>
WaveSum<count> random_waves(const NumberRange& band, const AmplitudeOf& amplitude_of, RandomShares& random) noexcept {
  WaveSum<count> waves;
  const double part = (band.greatest - band.least) / static_cast<double>(count);
  for (auto& axis : waves.axes) {
    for (std::size_t i = 0; i < count; ++i) {
      axis[i].turns_per_second = band.least + part * (static_cast<double>(i) + random.next());
      axis[i].phase = random.next();
      axis[i].amplitude = amplitude_of(axis[i].turns_per_second);
    }
  }
  return waves;
}

// So many that no beat between two of them is seen.
inline constexpr std::size_t tremor_wave_count = 24;
using TremorWaves = WaveSum<tremor_wave_count>;

// `rms`: of each axis [m].
inline TremorWaves tremor_waves(const NumberRange& band, double rms, RandomShares& random) noexcept {
  const double amplitude = rms * std::sqrt(2.0 / static_cast<double>(tremor_wave_count));
  return random_waves<tremor_wave_count>(
      band, [amplitude](double) { return amplitude; }, random);
}

}  // namespace ghostforce
