#include "app/cli/command_tree.h"

#include <fmt/format.h>

#include "app/base/exit_code_catalog.h"
#include "app/base/quoted.h"
#include "app/base/words.h"
#include "app/cli/command.h"
#include "app/files/scene_file.h"
#include "ghostforce_version.h"

namespace ghostforce {
namespace {

constexpr std::string_view description =
    "See, feel and measure the ghost forces that ordinary rendering of virtual walls makes on underactuated\nhaptic "
    "devices, and the anisotropic tracking stiffness that removes them.\n";

constexpr std::string_view notes =
    "The default command is run: 'ghostforce fig1' opens the window with the scene fig1.\n"
    "'ghostforce help COMMAND' describes a command.\n"
    "\n"
    "SCENE is the path of a scene file, or the name of a shipped scene:\n"
    "{}\n"
    "\n"
    "Data go to standard output, messages to standard error.";

constexpr std::string_view examples =
    "  ghostforce equilibrium fig3-normal\n"
    "  ghostforce simulate wall45 --strategy all -o run.csv";

constexpr std::size_t longest_line = 120;

constexpr std::string_view examples_begin = "Examples:\n";

// As CLI11 writes help, but with our words, and no line longer than 120 characters.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() {
    label("SUBCOMMAND", "COMMAND");
    label("Positionals", "Arguments");
    label("REQUIRED", "(required)");
    label("Excludes", "not with");
    label("Needs", "only with");
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    return wrapped(Formatter::make_option_desc(option), longest_line - get_column_width());
  }
};

std::string program_footer() {
  const HelpText text = program_help_text();
  std::string codes;
  for (const ExitCodeEntry& entry : exit_code_catalog) {
    codes += fmt::format("{:3}  {}\n", static_cast<int>(entry.code), entry.meaning);
  }
  return fmt::format("{} Exit codes:\n{}\n{}{}", text.notes, codes, examples_begin, text.examples);
}

}  // namespace

std::shared_ptr<CommandTree> make_command_tree() {
  auto tree = std::make_shared<CommandTree>();
  CLI::App& app = tree->app;
  app.name(std::string(program_name));
  app.description(std::string(description));
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.set_version_flag("--version", "", "Print the version, how it was built and what draws pictures, and exit");
  app.formatter(std::make_shared<HelpFormatter>());
  app.require_subcommand(1);
  app.footer(program_footer());
  for (const Command& command : command_catalog()) {
    CLI::App* const subcommand = app.add_subcommand(std::string(command.name), std::string(command.sentence));
    subcommand->group("Commands");
    CommandTree::Action& action = tree->actions[subcommand];
    action.act = command.attach(*subcommand, action.files);
  }
  return tree;
}

HelpText program_help_text() {
  // Narrow: a manual page leaves these lines as they are.
  std::string scenes = "  ";
  for (const char c : wrapped(listed(shipped_scene_names()), 70)) {
    scenes += c;
    if (c == '\n') scenes += "  ";
  }
  return {fmt::format(notes, scenes), std::string(examples)};
}

HelpText help_text_of(const CLI::App& command) {
  const std::string footer = command.get_footer();
  const std::size_t at = footer.find(examples_begin);
  if (at == std::string::npos) return {footer, ""};
  return {footer.substr(0, at), footer.substr(at + examples_begin.size())};
}

}  // namespace ghostforce
