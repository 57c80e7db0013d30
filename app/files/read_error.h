// What the readers of files throw: which file, where in it, what is wrong and what to do about it; and the list in
// which they gather that (ProblemList). How the program ends after that is for the command line to say
// (app/cli/command.h). Not for the servo thread, which never throws.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ghostforce {

struct ReadProblem {
  std::string file{};      // as messages call it, or the option that stands for it; empty: about no file alone
  std::size_t line = 0;    // from 1; 0: it is about the file as a whole
  std::size_t column = 0;  // from 1
  std::string what{};
  std::string remedy{};           // may be empty
  std::string_view joint = ": ";  // " " where the file is the subject of `what`
  std::string suggestion{};       // what may have been meant, as it would be given; empty: nothing is known
};

// "FILE:LINE:COLUMN", as far as it is known.
std::string place_words(const ReadProblem& problem);

// "FILE:LINE:COLUMN: what is wrong; what to do"
std::string words_of(const ReadProblem& problem);

class ReadError : public std::runtime_error {
 public:
  enum class Kind : std::uint8_t {
    wrong,       // what is read says something wrong, or is not there at all
    unreadable,  // it is there, and the system does not let it be read
  };

  // what() has a line per problem, in their order.
  ReadError(Kind kind, std::vector<ReadProblem> problems);

  Kind kind() const noexcept { return kind_; }
  const std::vector<ReadProblem>& problems() const noexcept { return problems_; }

 private:
  Kind kind_;
  std::vector<ReadProblem> problems_;
};

// What is wrong with a text that a person wrote, in the order in which a person reads. A file that is wrong from end to
// end is best read from its beginning: words are made, and memory taken, for the first problems alone, so that a
// million of them take no longer than the file is to read. `Place`: where a problem stands; it is ordered. One thread.
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
