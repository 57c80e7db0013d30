// Scripts that complete what a person types after the program's name, one for each shell: commands, options, words of
// options with a choice, scenes, lessons, keys and paths. They need nothing but the shell. Pure, any thread.
#pragma once

#include <string>

#include "app/manual/manual.h"

namespace ghostforce {

std::string bash_completion(const Manual& manual);
std::string zsh_completion(const Manual& manual);
std::string fish_completion(const Manual& manual);

}  // namespace ghostforce
