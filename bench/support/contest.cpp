#include "bench/support/contest.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace ghostforce::bench {
namespace {

double seconds_for(const Contestant& contestant, std::int64_t calls) {
  contestant.before();
  const auto began = std::chrono::steady_clock::now();
  contestant.run(calls);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

// The first call warms up and may take any time; the number grows until it fills a good part of the turn.
std::int64_t calls_for(const Contestant& contestant, double seconds_per_turn) {
  seconds_for(contestant, 1);
  std::int64_t calls = 1;
  for (;;) {
    const double took = seconds_for(contestant, calls);
    if (took >= 0.3 * seconds_per_turn) {
      return std::max<std::int64_t>(
          1, static_cast<std::int64_t>(std::llround(static_cast<double>(calls) * seconds_per_turn / took)));
    }
    calls *= 2;
  }
}

}  // namespace

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values.at(middle) : 0.5 * (values.at(middle - 1) + values.at(middle));
}

Contest::Contest(std::vector<Contestant> contestants, Length length) : seconds_(contestants.size()) {
  std::vector<std::int64_t> calls;
  for (const Contestant& contestant : contestants) {
    names_.push_back(contestant.name);
    calls.push_back(calls_for(contestant, length.seconds_per_turn));
  }
  for (int round = 0; round < length.rounds; ++round) {
    for (std::size_t turn = 0; turn < contestants.size(); ++turn) {
      const std::size_t i = round % 2 == 0 ? turn : contestants.size() - 1 - turn;
      seconds_[i].push_back(seconds_for(contestants[i], calls[i]) / static_cast<double>(calls[i]));
    }
  }
}

double Contest::median_seconds(std::string_view name) const {
  return median(seconds(name));
}

double Contest::ratio(std::string_view name, std::string_view to) const {
  const std::vector<double>& first = seconds(name);
  const std::vector<double>& second = seconds(to);
  std::vector<double> ratios;
  for (std::size_t round = 0; round < first.size(); ++round) ratios.push_back(first[round] / second[round]);
  return median(std::move(ratios));
}

const std::vector<double>& Contest::seconds(std::string_view name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) throw std::invalid_argument("no contestant is called " + std::string(name));
  return seconds_[static_cast<std::size_t>(found - names_.begin())];
}

}  // namespace ghostforce::bench
