// Options with a value, and arguments, of a command. UI thread.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>

namespace ghostforce {

// `names` are CLI11's; after a blank stands what the manual calls the value: "-o,--output FILE". An argument's name,
// "SCENE", says that already.
template <typename Value>
CLI::Option* add_option(CLI::App& command, std::string_view names, Value& value, std::string sentence) {
  const std::size_t end = names.find(' ');
  const std::string_view shown = end == std::string_view::npos ? "" : names.substr(end + 1);
  return command.add_option(std::string(names.substr(0, end)), value, std::move(sentence))
      ->type_name(std::string(shown));
}

}  // namespace ghostforce
