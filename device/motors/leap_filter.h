// LeapFilter: whether what encoders tell can be believed. A reading that is farther from where the last motion leads than
// a hand can move is odd: one odd reading is no loss of a position, and no proof of one. Three in a row that say the same
// are believed. A plain value; never allocates or throws; any one thread. Angles or counts, whichever the encoders tell,
// in an array; times in ns.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>

namespace ghostforce {

template <typename Numbers>
class LeapFilter {
 public:
  static constexpr int readings_to_believe = 3;

  // How far an encoder may be from where its motion leads: `least`, what it may move and change its speed by with time,
  // and at most `greatest`. After a gap more would be possible than can be told from a mistake; then three readings tell.
  struct Reach {
    double least;
    double per_s;
    double per_s_squared;
    double greatest;
  };

  enum class Verdict : std::uint8_t {
    believed,
    odd,    // not believed
    leapt,  // believed, because others before it said so too
  };

  constexpr explicit LeapFilter(const Reach& reach) noexcept : reach_(reach) {}

  // The next reading is believed.
  void reset() noexcept { *this = LeapFilter(reach_); }

  Verdict add(const Numbers& numbers, std::int64_t at_ns) noexcept {
    const double passed_s = seconds_between(believed_ns_, at_ns);
    // Whoever waited until time alone allows a leap would take it for a motion.
    const bool says_the_same = odd_readings_ > 0 && are_near(numbers, odd_, {}, seconds_between(odd_ns_, at_ns));
    Verdict verdict = Verdict::believed;
    if (believed_ns_ != 0 && (says_the_same || !are_near(numbers, believed_, speeds_, passed_s))) {
      odd_readings_ = says_the_same ? odd_readings_ + 1 : 1;
      odd_ = numbers;
      odd_ns_ = at_ns;
      if (odd_readings_ < readings_to_believe) return Verdict::odd;
      verdict = Verdict::leapt;
    }
    speeds_ = {};
    // Readings that come together are not as old as each other.
    constexpr double shortest_s = 0.001;
    for (std::size_t i = 0; i < numbers.size() && believed_ns_ != 0 && verdict == Verdict::believed; ++i) {
      speeds_[i] =
          (static_cast<double>(numbers[i]) - static_cast<double>(believed_[i])) / std::max(passed_s, shortest_s);
    }
    odd_readings_ = 0;
    believed_ = numbers;
    believed_ns_ = at_ns;
    return verdict;
  }

 private:
  using Speeds = std::array<double, std::tuple_size_v<Numbers>>;  // of each number [1/s]

  static double seconds_between(std::int64_t then_ns, std::int64_t now_ns) noexcept {
    return static_cast<double>(now_ns - then_ns) * 1e-9;
  }

  // Where the others lead at these speeds, after this time. A motion says nothing about what is much later.
  bool are_near(const Numbers& some, const Numbers& others, const Speeds& speeds, double passed_s) const noexcept {
    const double reach =
        std::min(reach_.least + (reach_.per_s + 0.5 * reach_.per_s_squared * passed_s) * passed_s, reach_.greatest);
    constexpr double longest_lead_s = 0.010;
    for (std::size_t i = 0; i < some.size(); ++i) {
      const double expected = static_cast<double>(others[i]) + speeds[i] * std::min(passed_s, longest_lead_s);
      if (!(std::abs(static_cast<double>(some[i]) - expected) <= reach)) return false;
    }
    return true;
  }

  Reach reach_;
  Numbers believed_{};            // the newest that were
  Numbers odd_{};                 // and the newest that were not
  Speeds speeds_{};               // of what was believed
  int odd_readings_ = 0;          // like the odd ones, in a row
  std::int64_t odd_ns_ = 0;       // when the newest of them came
  std::int64_t believed_ns_ = 0;  // 0: none yet
};

}  // namespace ghostforce
