// What a command can be told on the command line. All that commands need of CLI11, whose headers take longer to compile
// than everything that includes this one. UI thread.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace ghostforce {

// What is wrong with a word that a person typed, as a sentence; empty: nothing.
using WordCheck = std::function<std::string(const std::string& word)>;

// One option or argument, to be described further. A handle: copies are the same option.
class CommandOption {
 public:
  explicit CommandOption(CLI::Option& option) : option_(&option) {}

  // What --help calls its value.
  CommandOption type_name(std::string name) const;
  CommandOption required() const;
  CommandOption default_text(std::string text) const;
  CommandOption check(WordCheck check) const;
  // May be given again and again, with one value each time.
  CommandOption repeatable() const;
  // One word may hold several values.
  CommandOption divided_by(char delimiter) const;
  CommandOption excludes(CommandOption other) const;
  // Not in --help.
  CommandOption hidden() const;

  // Once the command line was parsed.
  bool is_given() const;

 private:
  CLI::Option* option_;
};

// A command's options and arguments, in the order in which --help lists them. What they are parsed into must outlive
// the parsing. `names` are "-o,--output" for an option and a word without dashes for an argument.
class CommandOptions {
 public:
  explicit CommandOptions(CLI::App& command) : command_(&command) {}

  CommandOption add_flag(const std::string& names, bool& is_set, const std::string& help) const;
  CommandOption add_option(const std::string& names, std::string& value, const std::string& help) const;
  CommandOption add_option(const std::string& names, std::optional<std::string>& value, const std::string& help) const;
  CommandOption add_option(const std::string& names, std::optional<double>& value, const std::string& help) const;
  CommandOption add_option(const std::string& names, std::vector<std::string>& values, const std::string& help) const;

  // Below the options in --help.
  void footer(std::string text) const;

 private:
  CLI::App* command_;
};

}  // namespace ghostforce
