// RandomShares: Steele, Lea and Flood's SplitMix64. The same numbers from the same seed on every machine: the
// distributions of the standard library differ from one to another. A plain value; never allocates or throws.
#pragma once

#include <cstdint>

namespace ghostforce {

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

}  // namespace ghostforce
