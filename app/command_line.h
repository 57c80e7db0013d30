// The command line: from the words that a person typed to the command that
// runs. Called once, by main().
#pragma once

#include <string>
#include <vector>

namespace ghostforce {

// `words` are the arguments without the program's name. Returns the exit code;
// throws Failure for a call that is wrong.
int run_command_line(std::vector<std::string> words);

}  // namespace ghostforce
