#include "app/cli/command_options.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <CLI/CLI.hpp>

namespace ghostforce {

CommandOption CommandOption::type_name(std::string name) const {
  option_->type_name(std::move(name));
  return *this;
}

CommandOption CommandOption::required() const {
  option_->required();
  return *this;
}

CommandOption CommandOption::default_text(std::string text) const {
  option_->default_str(std::move(text));
  return *this;
}

CommandOption CommandOption::check(WordCheck check) const {
  option_->check(std::move(check), "");
  return *this;
}

CommandOption CommandOption::repeatable() const {
  option_->expected(1)->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  return *this;
}

CommandOption CommandOption::divided_by(char delimiter) const {
  option_->delimiter(delimiter);
  return *this;
}

CommandOption CommandOption::excludes(CommandOption other) const {
  option_->excludes(other.option_);
  return *this;
}

CommandOption CommandOption::hidden() const {
  option_->group("");
  return *this;
}

CommandOption CommandOption::reads(FilesOf files) const {
  return names(FileOption::Use::input, std::move(files));
}

CommandOption CommandOption::writes(FilesOf files) const {
  return names(FileOption::Use::output, std::move(files));
}

CommandOption CommandOption::names(FileOption::Use use, FilesOf files) const {
  files_->push_back({use, option_->get_name(), [option = option_, files = std::move(files)] {
                       if (!files) return option->results();
                       std::vector<std::string> paths;
                       for (const std::string& word : option->results())
                         std::ranges::copy(files(word), std::back_inserter(paths));
                       return paths;
                     }});
  return *this;
}

bool CommandOption::is_given() const {
  return option_->count() > 0;
}

CommandOption CommandOptions::add_flag(const std::string& names, bool& is_set, const std::string& help) const {
  return CommandOption(*command_->add_flag(names, is_set, help), *files_);
}

CommandOption CommandOptions::add_option(const std::string& names, std::string& value, const std::string& help) const {
  return CommandOption(*command_->add_option(names, value, help), *files_);
}

CommandOption CommandOptions::add_option(const std::string& names, std::optional<std::string>& value,
                                         const std::string& help) const {
  return CommandOption(*command_->add_option(names, value, help), *files_);
}

CommandOption CommandOptions::add_option(const std::string& names, std::optional<double>& value,
                                         const std::string& help) const {
  return CommandOption(*command_->add_option(names, value, help), *files_);
}

CommandOption CommandOptions::add_option(const std::string& names, std::vector<std::string>& values,
                                         const std::string& help) const {
  return CommandOption(*command_->add_option(names, values, help), *files_);
}

void CommandOptions::footer(std::string text) const {
  command_->footer(std::move(text));
}

}  // namespace ghostforce
