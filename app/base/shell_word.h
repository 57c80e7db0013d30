// Words as a POSIX shell takes them, so that a person can copy a command from the program into a terminal, and back.
// Pure, any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ghostforce {

// The word as it is where a shell takes it for itself, else in quotes.
std::string shell_word(std::string_view word);

struct ShellWords {
  std::vector<std::string> words;
  std::string problem;  // what is wrong, and what to do; empty: nothing, and `words` is all of it
};

// The words of one command: quotes and backslashes are taken away, and nothing is expanded. Line breaks separate words,
// since mail programs wrap long lines. What a shell would run, expand or redirect is a problem.
ShellWords split_shell_words(std::string_view text);

}  // namespace ghostforce
