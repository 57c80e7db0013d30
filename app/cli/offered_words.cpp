#include "app/cli/offered_words.h"

#include <iterator>
#include <sstream>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/console/did_you_mean.h"

namespace ghostforce {
namespace {

// CLI11 keeps a name with each check and shows it nowhere. Checks other than these two have none.
std::string name_with(const std::vector<std::string_view>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

}  // namespace

CLI::Validator one_of(std::vector<std::string_view> words) {
  std::string name = name_with(words);
  return {[words = std::move(words)](std::string& word) { return not_one_of(word, words); }, "", std::move(name)};
}

CLI::Validator suggests(const std::vector<std::string_view>& words) {
  return {[](std::string&) { return std::string(); }, "", name_with(words)};
}

std::vector<std::string> offered_words(CLI::Option& option) {
  std::string names;
  try {
    for (int i = 0;; ++i) names += option.get_validator(i)->get_name() + " ";
  } catch (const CLI::OptionNotFound&) {
    // CLI11 does not say how many checks there are.
  }
  std::istringstream words(names);
  return {std::istream_iterator<std::string>(words), {}};
}

}  // namespace ghostforce
