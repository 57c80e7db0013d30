// LatencyHistogram: how far behind their deadlines the ticks of a loop came, as a histogram, so that any percentile can
// be read to 1/32 of itself. A value; never allocates, locks or throws. Times in ns; one thread.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ghostforce {

class LatencyHistogram {
 public:
  // What comes too soon is not late. More than 17 s counts as 17 s, except in worst_ns().
  void add(std::int64_t late_ns, std::uint64_t ticks = 1) noexcept {
    const auto late = static_cast<std::uint64_t>(std::max<std::int64_t>(late_ns, 0));
    counts_[index_of(std::min(late, longest))] += ticks;
    ticks_ += ticks;
    worst_ns_ = std::max(worst_ns_, static_cast<std::int64_t>(late));
  }

  std::uint64_t ticks() const noexcept { return ticks_; }
  std::int64_t worst_ns() const noexcept { return worst_ns_; }

  // What a share of the ticks does not exceed; 0 without ticks.
  std::int64_t percentile_ns(double share) const noexcept {
    const auto rank = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(ticks_)));
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      seen += counts_[i];
      if (seen > 0 && seen >= rank) return std::min(greatest_of(i), worst_ns_);
    }
    return 0;
  }

 private:
  // The first 64 buckets are 1 ns wide, the next 32 2 ns, the next 32 4 ns …
  static constexpr std::size_t per_octave = 32;
  static constexpr std::size_t octaves = 30;
  static constexpr std::uint64_t longest = (std::uint64_t{1} << (octaves + 4)) - 1;

  static constexpr std::size_t index_of(std::uint64_t late) noexcept {
    const auto octave = static_cast<std::size_t>(std::bit_width(late | 63U)) - 6;
    return octave * per_octave + static_cast<std::size_t>(late >> octave);
  }
  static constexpr std::int64_t greatest_of(std::size_t index) noexcept {
    if (index < 2 * per_octave) return static_cast<std::int64_t>(index);
    const std::size_t octave = index / per_octave - 1;
    return (static_cast<std::int64_t>(index - octave * per_octave + 1) << octave) - 1;
  }

  std::array<std::uint64_t, octaves * per_octave> counts_{};
  std::uint64_t ticks_ = 0;
  std::int64_t worst_ns_ = 0;
};

}  // namespace ghostforce
