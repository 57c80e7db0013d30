// Programs that a bench runs to their end, silent.
#pragma once

#include <string>
#include <vector>

namespace ghostforce::bench {

// `words[0]` is looked for in PATH. Returns the exit code; throws std::runtime_error where it does not start.
int run_to_end(std::vector<std::string> words);

}  // namespace ghostforce::bench
