#include "app/cli/command_tree.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/base/words.h"
#include "app/cli/command.h"
#include "app/files/scene_file.h"
#include "embedded_help.h"
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
    "A strategy is full (fully actuated: two motors), naive (one motor, rendered as if both were there)\n"
    "or anisotropic (one motor, and the proxy follows softly in the direction without a motor).\n"
    "\n"
    "SCENE is the path of a scene file, or the name of a shipped scene:\n"
    "  {}\n"
    "\n"
    "Data go to standard output, messages to standard error.";

constexpr std::string_view examples =
    "  ghostforce equilibrium fig3-normal\n"
    "  ghostforce simulate wall45 --strategy all -o run.csv";

constexpr std::size_t longest_line = 120;

constexpr std::string_view examples_begin = "Examples:\n";

// By name: CLI11 keeps them in whatever order they lie in memory.
std::vector<std::string> sorted_names(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* const option : options) {
    names.push_back(option->get_positional() ? option->get_name() : "--" + option->get_lnames().front());
  }
  std::ranges::sort(names);
  return names;
}

// As CLI11 writes help, but with our words, and no line longer than 120 characters.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() {
    label("SUBCOMMAND", "COMMAND");
    label("Positionals", "Arguments");
    label("REQUIRED", "(required)");
  }

  // Its name, its value and whether it must be there; which others it needs or excludes is the sentence's end.
  std::string make_option_opts(const CLI::Option* option) const override {
    if (option->get_type_size() == 0) return "";
    return fmt::format(" {}{}", option->get_type_name(), option->get_required() ? " " + get_label("REQUIRED") : "");
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    std::string sentence = Formatter::make_option_desc(option);
    const auto add = [&](std::string_view how, const std::set<CLI::Option*>& others) {
      if (!others.empty()) sentence += fmt::format(". {} {}", how, fmt::join(sorted_names(others), ", "));
    };
    add("Only with", option->get_needs());
    add("Not with", option->get_excludes());
    return wrapped(sentence, longest_line - get_column_width());
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

// Below a command's options: its file, without the end of the last line.
std::string command_footer(std::string_view command) {
  const auto text = std::ranges::find(embedded_help, fmt::format("{}.txt", command), &EmbeddedText::name);
  return std::string(text->contents.substr(0, text->contents.size() - 1));
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
    subcommand->footer(command_footer(command.name));
    CommandTree::Action& action = tree->actions[subcommand];
    action.act = command.attach(*subcommand, action.files);
  }
  return tree;
}

HelpText program_help_text() {
  // Narrow: a manual page leaves these lines as they are.
  return {fmt::format(notes, wrapped(listed(shipped_scene_names()), 70, "  ")), std::string(examples)};
}

HelpText help_text_of(const CLI::App& command) {
  const std::string footer = command.get_footer();
  const std::size_t at = footer.find(examples_begin);
  if (at == std::string::npos) return {footer, ""};
  return {footer.substr(0, at), footer.substr(at + examples_begin.size())};
}

namespace {

std::vector<ManualRow> environment_rows() {
  return {{"GHOSTFORCE_FIRMWARE", "The Falcon's firmware file, where --firmware names none."},
          {"LC_ALL, LC_MESSAGES, LANG", "The language of the stage and of lessons, until one is chosen."},
          {"XDG_CONFIG_HOME, XDG_STATE_HOME", "Where ~/.config and ~/.local/state are, for the files below."},
          {"SPEECHD_ADDRESS", "The socket of speech-dispatcher, for --speak: unix_socket:PATH."}};
}

std::vector<ManualRow> file_rows() {
  return {
      {"~/.config/ghostforce/preferences.toml", "What was chosen in the window."},
      {"~/.config/ghostforce/falcon/", "The Falcon's firmware, firmware.bin, and a calibration for each Falcon."},
      {"~/.local/state/ghostforce/layout.toml", "The window's size, and which panels are folded."},
      {"~/.local/state/ghostforce/lessons.toml", "What has been done of each lesson."},
      {"/usr/share/ghostforce/scenes/",
       "Copies of the shipped scenes, to start your own from. The program itself does not read them. Below another "
       "prefix, if the program is not installed in /usr."},
      {"/usr/share/doc/ghostforce/docs/", "The guides that messages name, such as docs/falcon.md."},
  };
}

std::vector<ManualRow> exit_code_rows() {
  std::vector<ManualRow> rows;
  for (const ExitCodeEntry& entry : exit_code_catalog) {
    rows.push_back({std::to_string(static_cast<int>(entry.code)), std::string(entry.meaning)});
  }
  return rows;
}

// What completion offers as a path for this option. What comes with the program comes as TOML, and so do its like.
ManualPaths paths_of(const CLI::Option& option, const ManualOption& described, const FileOptions* files_named) {
  if (described.value == "DIR") return ManualPaths::folders;
  if (described.value == "CASE") return ManualPaths::toml_names;
  const bool is_word_first = std::ranges::any_of(described.words, [](const auto& word) { return word.ends_with(':'); });
  if (is_word_first || files_named == nullptr) return ManualPaths::none;
  if (std::ranges::find(files_named->list(), &option, &FileOption::option) == files_named->list().end()) {
    return ManualPaths::none;
  }
  return described.words.empty() ? ManualPaths::any : ManualPaths::toml;
}

ManualOption describe(CLI::Option& option, const FileOptions* files_named) {
  ManualOption described;
  for (const std::string& name : option.get_snames()) described.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) described.names.push_back("--" + name);
  const bool is_argument = described.names.empty();
  if (is_argument) described.names.push_back(option.get_name());
  const bool has_value = option.get_items_expected_max() > 0;
  if (has_value) described.value = is_argument ? option.get_name() : option.get_type_name();
  described.sentence = option.get_description();
  if (const std::string usual = option.get_default_str(); !usual.empty()) described.sentence += "; default: " + usual;
  described.is_required = option.get_required();
  described.takes_many = option.get_items_expected_max() > 1;
  described.may_repeat = option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
  described.is_list = option.get_delimiter() != '\0';
  described.excluded = sorted_names(option.get_excludes());
  described.needed = sorted_names(option.get_needs());
  described.words = offered_words(option);
  described.paths = paths_of(option, described, files_named);
  return described;
}

// `files_named`: null for the program's own options.
ManualCommand describe(CLI::App& command, HelpText text, const FileOptions* files_named) {
  ManualCommand described{.name = command.get_name(),
                          .sentence = command.get_description(),
                          .notes = std::move(text.notes),
                          .examples = std::move(text.examples)};
  for (CLI::Option* const option : command.get_options()) {
    if (option->get_group().empty()) continue;  // hidden
    (option->get_positional() ? described.arguments : described.options).push_back(describe(*option, files_named));
  }
  return described;
}

}  // namespace

Manual program_manual() {
  const std::shared_ptr<CommandTree> tree = make_command_tree();
  Manual manual{.version = std::string(version),
                .program = describe(tree->app, program_help_text(), nullptr),
                .default_command = std::string(default_command),
                .exit_codes = exit_code_rows(),
                .environment = environment_rows(),
                .files = file_rows()};
  const std::string purpose = std::exchange(manual.program.sentence, std::string(program_sentence));
  manual.program.notes = fmt::format("{}\n{}", purpose, manual.program.notes);
  for (const Command& row : command_catalog()) {
    CLI::App* const command = tree->app.get_subcommand(std::string(row.name));
    manual.commands.push_back(describe(*command, help_text_of(*command), &tree->actions.at(command).files));
  }
  return manual;
}

}  // namespace ghostforce
