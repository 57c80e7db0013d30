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
#include "app/cli/manual.h"
#include "app/cli/option.h"
#include "embedded_completion.h"

namespace ghostforce {
namespace {

struct HelpOptions {
  std::string command;  // empty: the program
  std::string format = "text";
};

// As --help prints it.
std::string text_of(const HelpOptions& options) {
  const std::shared_ptr<CommandTree> tree = make_command_tree();
  if (options.command.empty()) return tree->app.help();
  return tree->app.get_subcommand(options.command)->help(std::string(program_name));
}

std::string page_of(const HelpOptions& options) {
  const Manual manual = program_manual();
  if (options.command.empty()) return man_page(manual);
  return man_page(manual, *std::ranges::find(manual.commands, options.command, &ManualCommand::name));
}

std::string script_of(const HelpOptions& options) {
  if (!options.command.empty()) {
    throw Failure(ExitCode::wrong_call,
                  fmt::format("a completion script is for all commands; leave out {}", quoted_text(options.command)));
  }
  const std::string name = fmt::format("ghostforce.{}", options.format);
  return std::string(std::ranges::find(embedded_completion, name, &EmbeddedText::name)->contents);
}

struct HelpFormat {
  std::string_view name;
  std::string (*print)(const HelpOptions& options);
};

constexpr std::array help_formats{
    HelpFormat{"text", text_of},  HelpFormat{"man", page_of},    HelpFormat{"bash", script_of},
    HelpFormat{"zsh", script_of}, HelpFormat{"fish", script_of},
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
    print(std::ranges::find(help_formats, options->format, &HelpFormat::name)->print(*options));
    return static_cast<int>(ExitCode::done);
  };
}

}  // namespace ghostforce
