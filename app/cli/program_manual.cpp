#include "app/cli/program_manual.h"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "app/base/exit_code_catalog.h"
#include "app/cli/command.h"
#include "app/cli/command_tree.h"
#include "ghostforce_version.h"

namespace ghostforce {
namespace {

struct Row {
  const char* name;
  const char* meaning;
};

constexpr std::array environment{
    Row{"GHOSTFORCE_FIRMWARE", "The Falcon's firmware file, where --firmware names none."},
    Row{"LC_ALL, LC_MESSAGES, LANG", "The language of the stage and of lessons, until one is chosen."},
    Row{"XDG_CONFIG_HOME, XDG_STATE_HOME", "Where ~/.config and ~/.local/state are, for the files below."},
    Row{"SPEECHD_ADDRESS", "The socket of speech-dispatcher, for --speak: unix_socket:PATH."},
};

constexpr std::array files{
    Row{"~/.config/ghostforce/preferences.toml", "What was chosen in the window."},
    Row{"~/.config/ghostforce/falcon/", "The Falcon's firmware, firmware.bin, and a calibration for each Falcon."},
    Row{"~/.local/state/ghostforce/layout.toml", "The window's size, and which panels are folded."},
    Row{"~/.local/state/ghostforce/lessons.toml", "What has been done of each lesson."},
    Row{"/usr/share/ghostforce/scenes/",
        "Copies of the shipped scenes, to start your own from. The program itself does not read them. Below another "
        "prefix, if the program is not installed in /usr."},
    Row{"/usr/share/doc/ghostforce/docs/", "The guides that messages name, such as docs/falcon.md."},
};

std::vector<ManualRow> rows_of(std::span<const Row> rows) {
  std::vector<ManualRow> all;
  for (const Row& row : rows) all.push_back({row.name, row.meaning});
  return all;
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

// By name: CLI11 keeps them in whatever order they lie in memory.
std::vector<std::string> sorted_names(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* const option : options) names.push_back("--" + option->get_lnames().front());
  std::ranges::sort(names);
  return names;
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
                .environment = rows_of(environment),
                .files = rows_of(files)};
  const std::string purpose = std::exchange(manual.program.sentence, std::string(program_sentence));
  manual.program.notes = fmt::format("{}\n{}", purpose, manual.program.notes);
  for (const Command& row : command_catalog()) {
    CLI::App* const command = tree->app.get_subcommand(std::string(row.name));
    manual.commands.push_back(describe(*command, help_text_of(*command), &tree->actions.at(command).files));
  }
  return manual;
}

}  // namespace ghostforce
