// Options that make no sense beside another one.
#pragma once

#include <span>
#include <string_view>

namespace CLI {
class App;
}

namespace ghostforce {

struct Contradiction {
  std::string_view option;  // its name, "SCENE" or "--set"
  std::string_view value;   // its beginning; empty: any
  std::string_view reason;  // goes on after "contradict each other: "
};

// For the option with that name, which is given. Throws Failure(wrong_call) for the first of these that is given too.
void refuse_contradictions(const CLI::App& command, std::string_view given,
                           std::span<const Contradiction> contradictions);

}  // namespace ghostforce
