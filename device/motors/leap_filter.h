// LeapFilter: whether what encoders tell can be believed. A reading that is farther from the last one that was believed
// than a hand can move is odd: one odd reading is no loss of a position, and no proof of one. Three in a row that say
// the same are believed. A plain value; never allocates or throws; any one thread. Angles or counts, whichever the
// encoders tell, in an array; times in ns.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ghostforce {

template <typename Numbers>
class LeapFilter {
 public:
  static constexpr int readings_to_believe = 3;

  // How far an encoder may have moved since it was believed: `least`, `per_s` more with time, and at most `greatest`.
  // After a gap more would be possible than can be told from a mistake; then three readings tell.
  struct Reach {
    double least;
    double per_s;
    double greatest;
  };

  enum class Verdict : std::uint8_t {
    believed,
    odd,    // not believed
    leapt,  // believed, because others before it said so too
  };

  constexpr explicit LeapFilter(const Reach& reach) noexcept : reach_(reach) {}

  // The next reading is believed.
  void reset() noexcept { believed_ns_ = odd_readings_ = 0; }

  Verdict add(const Numbers& numbers, std::int64_t heard_ns) noexcept {
    const double passed_s = static_cast<double>(heard_ns - believed_ns_) * 1e-9;
    const double reach = std::min(reach_.least + reach_.per_s * passed_s, reach_.greatest);
    Verdict verdict = Verdict::believed;
    if (believed_ns_ != 0 && !are_near(numbers, believed_, reach)) {
      odd_readings_ = odd_readings_ > 0 && are_near(numbers, odd_, reach_.greatest) ? odd_readings_ + 1 : 1;
      odd_ = numbers;
      if (odd_readings_ < readings_to_believe) return Verdict::odd;
      verdict = Verdict::leapt;
    }
    odd_readings_ = 0;
    believed_ = numbers;
    believed_ns_ = heard_ns;
    return verdict;
  }

 private:
  static bool are_near(const Numbers& some, const Numbers& others, double reach) noexcept {
    return std::ranges::equal(some, others,
                              [reach](double one, double other) { return std::abs(one - other) <= reach; });
  }

  Reach reach_;
  Numbers believed_{};            // the newest that were
  Numbers odd_{};                 // and the newest that were not
  int odd_readings_ = 0;          // like these, in a row
  std::int64_t believed_ns_ = 0;  // 0: none yet
};

}  // namespace ghostforce
