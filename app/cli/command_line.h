// The command line: from the words that a person typed to the command that runs. Called once, by main().
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace ghostforce {

// `words` are the arguments without the program's name. Returns what they ask for, not begun yet: it returns the exit
// code or throws Failure. Throws Failure(wrong_call) for a call that is wrong.
std::function<int()> parse_command_line(std::vector<std::string> words);

}  // namespace ghostforce
