// ghostforce help: the help of a command, its manual page, or a script that completes what is typed.
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/cli/command.h"
#include "app/cli/command_tree.h"
#include "app/cli/man_page.h"
#include "app/cli/option.h"
#include "embedded_completion.h"

namespace ghostforce {
namespace {

struct HelpOptions {
  std::string command;  // empty: the program
  std::string format = "text";
};

// As --help prints it.
std::string text_of(const std::string& command) {
  const std::shared_ptr<CommandTree> tree = make_command_tree();
  return command.empty() ? tree->app.help() : tree->app.get_subcommand(command)->help(std::string(program_name));
}

std::string page_of(const std::string& command) {
  const Manual manual = program_manual();
  if (command.empty()) return man_page(manual);
  return man_page(manual, *std::ranges::find(manual.commands, command, &ManualCommand::name));
}

template <std::size_t number>
std::string script_of(const std::string& command) {
  if (command.empty()) return std::string(embedded_completion[number].contents);
  throw Failure(ExitCode::wrong_call,
                fmt::format("a completion script is for all commands; leave out {}", quoted_text(command)));
}

struct HelpFormat {
  std::string_view name;
  std::string (*print)(const std::string& command);
};

// The scripts are in the order of CMakeLists.txt.
constexpr std::array help_formats{
    HelpFormat{"text", text_of},     HelpFormat{"man", page_of},       HelpFormat{"bash", script_of<0>},
    HelpFormat{"zsh", script_of<1>}, HelpFormat{"fish", script_of<2>},
};

}  // namespace

std::function<int()> attach_help(CLI::App& command, FileOptions&) {
  const auto options = std::make_shared<HelpOptions>();
  add_option(command, "COMMAND", options->command, "The command to describe; default: the program as a whole")
      ->check(one_of(names_of(command_catalog())));
  add_option(command, "--format NAME", options->format,
             "text, as --help prints it; man, a manual page; or bash, zsh or fish, a script with which that shell "
             "completes commands, options, scenes, lessons and keys; default: text")
      ->check(one_of(names_of(help_formats)));
  return [options] {
    print(std::ranges::find(help_formats, options->format, &HelpFormat::name)->print(options->command));
    return static_cast<int>(ExitCode::done);
  };
}

}  // namespace ghostforce
