// What is wrong with a text that a person wrote, in the order in which a person reads. A file that is wrong from end to
// end is best read from its beginning: words are made, and memory taken, for the first problems alone, so that a
// million of them take no longer than the file is to read. One thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace ghostforce {

// `Place` is where a problem stands, and is ordered.
template <typename Place, typename Words = std::string>
class ProblemList {
 public:
  static constexpr std::size_t most_told = 20;

  // `words` is called when the problems are told, if this one is among the first: what it refers to must live as long.
  void add(const Place& place, std::function<Words()> words) {
    ++count_;
    const auto after = std::upper_bound(first_.begin(), first_.end(), place,
                                        [](const Place& a, const Problem& b) { return a < b.place; });
    if (after == first_.end() && first_.size() == most_told) return;
    first_.insert(after, {place, std::move(words)});
    if (first_.size() > most_told) first_.pop_back();
  }
  void add(const Place& place, Words words) {
    add(place, [words = std::move(words)] { return words; });
  }

  bool empty() const noexcept { return count_ == 0; }

  // Calls tell(place, words) for each of the first, in their order. Returns how many more there are.
  template <typename Tell>
  std::size_t tell(Tell&& tell) const {
    for (const Problem& problem : first_) tell(problem.place, problem.words());
    return count_ - first_.size();
  }

 private:
  struct Problem {
    Place place;
    std::function<Words()> words;
  };
  std::vector<Problem> first_;  // in order
  std::size_t count_ = 0;
};

}  // namespace ghostforce
