// What the readers of files throw: which file, where in it, what is wrong and what to do about it. How the program ends
// after that is for the command line to say (app/cli/exit_code.h). Not for the servo thread, which never throws.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
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

}  // namespace ghostforce
