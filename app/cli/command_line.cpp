
#include <algorithm>
#include <cctype>
#include <iterator>
#include <memory>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/cli/command.h"
#include "app/cli/command_tree.h"
#include "app/cli/manual.h"
#include "app/cli/version.h"
#include "app/files/scene_file.h"
#include "app/shell/desktop/offscreen.h"

namespace ghostforce {
namespace {

bool is_command(std::string_view word) {
  return std::ranges::find(command_catalog(), word, &Command::name) != command_catalog().end();
}

// Options that are the program's own rather than a command's.
bool is_program_option(std::string_view word) noexcept {
  return word == "--help" || word == "-h" || word == "--version";
}

// The first word is a command, a scene for `run`, or a slip of the keyboard.
void insert_default_command(std::vector<std::string>& words) {
  const auto first_name = std::find_if_not(words.begin(), words.end(), is_option);
  if (first_name != words.end() && is_command(*first_name)) return;
  if (!words.empty() && is_program_option(words.front())) return;
  if (!words.empty() && !is_option(words.front()) && !may_be_scene(words.front())) {
    const std::string& word = words.front();
    std::vector<std::string_view> all = names_of(command_catalog());
    std::ranges::copy(shipped_scene_names(), std::back_inserter(all));
    const auto near = nearest_name(word, all);
    throw Failure(ExitCode::wrong_call, fmt::format("no command or scene named '{}'{}", quoted_text(word),
                                                    near ? fmt::format("; did you mean the {} '{}'?",
                                                                       is_command(*near) ? "command" : "scene", *near)
                                                         : "; 'ghostforce --help' lists the commands"));
  }
  words.emplace(words.begin(), default_command);
}

// The command that the words named; null: none.
CLI::App* named_command(const CLI::App& app) {
  const std::vector<CLI::App*> named = app.get_subcommands();
  return named.empty() ? nullptr : named.front();
}

std::string help_call(const CLI::App* command) {
  return command == nullptr ? fmt::format("{} --help", program_name)
                            : fmt::format("{} {} --help", program_name, command->get_name());
}

// A word that no option and no argument of the command is for.
std::string words_about_extra(const CLI::App& app, const CLI::App* command, const std::string& extra) {
  const std::string name = extra.substr(0, extra.find('='));
  std::string words = fmt::format("unexpected argument '{}'", quoted_text(extra));
  if (is_option(extra)) {
    std::vector<std::string> options;
    for (const CLI::Option* const option : (command == nullptr ? app : *command).get_options()) {
      for (const std::string& long_name : option->get_lnames()) options.push_back("--" + long_name);
      for (const std::string& short_name : option->get_snames()) options.push_back("-" + short_name);
    }
    const std::vector<std::string_view> candidates(options.begin(), options.end());
    const std::string near = did_you_mean(name, candidates);
    words = fmt::format("no option {}{}", quoted_text(name), near);
    if (!near.empty()) return words;
    const bool is_number = std::isdigit(static_cast<unsigned char>(extra[1])) != 0;
    if (is_number && std::ranges::find(candidates, "--goal-mm") != candidates.end()) {
      words += "; join the numbers of one option with commas, as in --goal-mm=5,-12";
    }
  } else if (command == nullptr) {
    words = fmt::format("no command '{}'{}", quoted_text(extra), did_you_mean(extra, names_of(command_catalog())));
  }
  return fmt::format("{}; see '{}'", words, help_call(command));
}

[[noreturn]] void refuse(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* const command = named_command(app);
  // An unknown option often drags other errors behind it: tell of it alone.
  for (const std::string& extra : app.remaining(true)) {
    throw Failure(ExitCode::wrong_call, words_about_extra(app, command, extra));
  }
  const std::string what = error.what();
  if (const std::size_t at = what.find(" excludes "); error.get_name() == "ExcludesError" && at != std::string::npos) {
    throw Failure(ExitCode::wrong_call,
                  fmt::format("{} and {} contradict each other; leave out one of them", what.substr(0, at),
                              what.substr(at + std::string_view(" excludes ").size())));
  }
  if (what.ends_with('?')) throw Failure(ExitCode::wrong_call, what);
  throw Failure(ExitCode::wrong_call, fmt::format("{}; see '{}'", what, help_call(command)));
}

std::function<int()> printing(std::string text) {
  return [text = std::move(text)] {
    print(text);
    return static_cast<int>(ExitCode::done);
  };
}

}  // namespace

std::function<int()> parse_command_line(std::vector<std::string> words) {
  if (!words.empty() && words.front() == completing_command) {
    return printing(completions(program_manual(), std::span(words).subspan(1)));
  }
  insert_default_command(words);

  const std::shared_ptr<CommandTree> tree = make_command_tree();
  CLI::App& app = tree->app;
  std::reverse(words.begin(), words.end());  // as CLI11 wants them
  try {
    app.parse(words);
  } catch (const CLI::CallForHelp&) {
    const CLI::App* const command = named_command(app);
    return printing(command == nullptr ? app.help() : command->help(std::string(program_name)));
  } catch (const CLI::CallForVersion&) {
    return [] {
      print(version_words(default_renderer_words()));
      return static_cast<int>(ExitCode::done);
    };
  } catch (const CLI::ParseError& error) {
    refuse(app, error);
  }
  return [tree] {
    const CommandTree::Action& action = tree->actions.at(named_command(tree->app));
    refuse_to_overwrite(action.files.list());
    return action.act();
  };
}

}  // namespace ghostforce
