// What `ghostforce --version` prints: all that a report of a fault needs. Pure.
#pragma once

#include <string>
#include <string_view>

namespace ghostforce {

// The first line is "ghostforce VERSION", for scripts; then a line each: commit, build, libraries, renderer. `renderer`
// is what draws pictures without a display, or why nothing does.
std::string version_words(std::string_view renderer);

}  // namespace ghostforce
