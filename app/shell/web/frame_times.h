// How long something took in each of the last frames. One thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ghostforce {

class FrameTimes {
 public:
  static constexpr std::size_t capacity = 300;

  void add(double seconds) {
    if (times_.size() < capacity) {
      times_.push_back(seconds);
    } else {
      times_[next_] = seconds;
      next_ = (next_ + 1) % capacity;
    }
  }

  // The time that this share of them did not exceed: 0.5 is the median [s]. 0 where there are none.
  double quantile(double share) const {
    if (times_.empty()) return 0.0;
    std::vector<double> sorted = times_;
    std::ranges::sort(sorted);
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  }

 private:
  std::vector<double> times_;  // a ring, once it is full
  std::size_t next_ = 0;
};

}  // namespace ghostforce
