// A line that a person types or a script hands in. Waiting for it ends as interruption.h says. Nothing beyond the line
// is taken, so that whoever reads the same input next, in this program or after it, finds the rest. Any thread.
#pragma once

#include <cstddef>
#include <string>

namespace ghostforce {

inline constexpr std::size_t longest_input_line = 65536;  // [bytes]

struct InputLine {
  std::string text;  // without its newline
  // False: the newline never came, because the input had ended or could not be read, or because the line is too long.
  // Whether that is an answer is for the caller to say; no text at all is none.
  bool is_whole = false;
};

// Throws Failure: interrupted.
InputLine read_line(int descriptor);

}  // namespace ghostforce
