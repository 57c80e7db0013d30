// The words that completion offers for an option's value, kept with the option. One that ends in '=' is not finished;
// after one that ends in ':' comes a path.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class Option;
class Validator;
}  // namespace CLI

namespace ghostforce {

// An option's value must be one of these words; if not, the nearest is named.
CLI::Validator one_of(std::vector<std::string_view> words);

// An option's value may be one of these words, or anything else.
CLI::Validator suggests(const std::vector<std::string_view>& words);

// Those of both, of all checks of the option.
std::vector<std::string> offered_words(CLI::Option& option);

}  // namespace ghostforce
