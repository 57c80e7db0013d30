// The program and its commands with all their options, as CLI11 parses them, made from command_catalog(); and the
// manual, made from that. All of it allocates; not for the servo thread.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "app/cli/manual.h"
#include "app/cli/overwrite_guard.h"

namespace ghostforce {

inline constexpr std::string_view program_name = "ghostforce";

// What is meant where no command is named.
inline constexpr std::string_view default_command = "run";

// What the program is for, in a few words.
inline constexpr std::string_view program_sentence =
    "See, feel and measure ghost forces on underactuated haptic devices";

struct CommandTree {
  struct Action {
    FileOptions files;
    std::function<int()> act;
  };

  CLI::App app;
  std::map<const CLI::App*, Action> actions;  // of each command
};

// A command's `act` looks at its options in the tree, so the tree must live as long.
std::shared_ptr<CommandTree> make_command_tree();

// Below the options in --help: what is to be known, and examples of calls.
struct HelpText {
  std::string notes;
  std::string examples;
};

// Of the program, without its exit codes.
HelpText program_help_text();
HelpText help_text_of(const CLI::App& command);

// The program's manual (manual.h), from what its commands tell CLI11.
Manual program_manual();

}  // namespace ghostforce
