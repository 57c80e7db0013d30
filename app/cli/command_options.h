// What a command can be told on the command line. All that commands need of CLI11, whose headers take longer to compile
// than everything that includes this one. UI thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/own_inputs.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace ghostforce {

// What is wrong with a word that a person typed, as a sentence; empty: nothing.
using WordCheck = std::function<std::string(const std::string& word)>;

// The files that a word means.
using FilesOf = std::function<std::vector<std::string>(const std::string& word)>;

// One option or argument, to be described further. A handle: copies are the same option.
class CommandOption {
 public:
  CommandOption(CLI::Option& option, std::vector<FileOption>& files) : option_(&option), files_(&files) {}

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
  // Its value is the path of a file, or means files, that the command reads, or writes: what it reads it never writes.
  CommandOption reads(FilesOf files = nullptr) const;
  CommandOption writes(FilesOf files = nullptr) const;

  // Once the command line was parsed.
  bool is_given() const;

 private:
  CommandOption names(FileOption::Use use, FilesOf files) const;

  CLI::Option* option_;
  std::vector<FileOption>* files_;  // of the command
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

  // The options that name files.
  const std::vector<FileOption>& files() const { return *files_; }

 private:
  CLI::App* command_;
  std::shared_ptr<std::vector<FileOption>> files_ = std::make_shared<std::vector<FileOption>>();
};

}  // namespace ghostforce
