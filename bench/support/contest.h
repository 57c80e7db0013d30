// Two or more ways to do the same, timed in turn: on a machine that others use too, only what ran next to each other
// can be compared. One thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace ghostforce::bench {

// Does its work so many times. The loop is the contestant's own, so that nothing stands between two pieces of work.
struct Contestant {
  std::string name;
  std::function<void(std::int64_t calls)> run;
  std::function<void()> before = [] {};  // each run, outside of the time: clears away what the last one left
};

// The middle of the sorted values, or the mean of the two in the middle. At least one value.
double median(std::vector<double> values);

class Contest {
 public:
  struct Length {
    int rounds = 9;                  // each contestant runs once per round, each round in the other direction
    double seconds_per_turn = 0.05;  // how often each does its work in a turn is found beforehand
  };

  // Runs it. Names must differ.
  explicit Contest(std::vector<Contestant> contestants) : Contest(std::move(contestants), Length{}) {}
  Contest(std::vector<Contestant> contestants, Length length);

  // Of all rounds: one piece of work [s].
  double median_seconds(std::string_view name) const;

  // The median over the rounds of the ratio within each [1].
  double ratio(std::string_view name, std::string_view to) const;

 private:
  const std::vector<double>& seconds(std::string_view name) const;

  std::vector<std::string> names_;
  std::vector<std::vector<double>> seconds_;  // per contestant, per round
};

// What is computed into `value` must be computed: the compiler has to believe that somebody reads it.
template <typename T>
void keep(const T& value) {
  asm volatile("" : : "r,m"(value) : "memory");
}

}  // namespace ghostforce::bench
