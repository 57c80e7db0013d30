#include "app/cli/manual.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace ghostforce {

bool is_option(std::string_view word) noexcept {
  return word.size() > 1 && word.starts_with('-');
}

namespace {

// What stands before the word that is being typed.
struct Typed {
  const ManualCommand* command = nullptr;
  const ManualOption* open = nullptr;  // the option whose value may come next; null: none
  std::vector<const ManualOption*> options{};
  std::vector<std::string> arguments{};
};

// The paths that may come next, and words.
struct Offer {
  ManualPaths paths = ManualPaths::none;
  std::string before{};  // what of the typed word is kept
  std::string lines{};

  void add(std::string_view typed, std::string_view word, std::string_view sentence) {
    if (!word.starts_with(typed)) return;
    lines += fmt::format("{}{}{}{}\n", before, word, sentence.empty() ? "" : "\t", sentence);
  }
};

constexpr std::array path_kinds{
    std::pair{ManualPaths::none, "none"},       std::pair{ManualPaths::any, "any"},
    std::pair{ManualPaths::toml, "toml"},       std::pair{ManualPaths::folders, "folders"},
    std::pair{ManualPaths::toml_names, "none"},  // which shells cannot know
};

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

const ManualOption* option_named(const ManualCommand& command, std::string_view name) {
  const auto found =
      std::ranges::find_if(command.options, [&](const ManualOption& option) { return contains(option.names, name); });
  return found == command.options.end() ? nullptr : &*found;
}

// A first word that names no command belongs to the default one.
Typed read(const Manual& manual, std::span<const std::string> words) {
  const auto command_named = [&](std::string_view name) {
    return std::ranges::find(manual.commands, name, &ManualCommand::name);
  };
  auto command = words.empty() ? manual.commands.end() : command_named(words.front());
  if (command != manual.commands.end()) {
    words = words.subspan(1);
  } else {
    command = command_named(manual.default_command);
  }
  Typed typed{.command = &*command};
  for (const std::string& word : words) {
    if (typed.open != nullptr && !typed.open->takes_many) {
      typed.open = nullptr;
    } else if (is_option(word)) {
      const std::size_t divider = word.find('=');
      const ManualOption* const option = option_named(*command, word.substr(0, divider));
      typed.open = option != nullptr && option->has_value() && divider == std::string::npos ? option : nullptr;
      if (option != nullptr) typed.options.push_back(option);
    } else if (typed.open == nullptr) {
      typed.arguments.push_back(word);
    }
  }
  return typed;
}

// The beginning of a sentence, up to "; " or ". ": short enough to stand beside a name.
std::string_view first_clause(std::string_view sentence) {
  return sentence.substr(0, std::min(sentence.find("; "), sentence.find(". ")));
}

void offer_names(Offer& offer, const ManualOption& option, std::string_view value) {
  for (const std::string& name : option.names) offer.add(value, name, first_clause(option.sentence));
}

// Not those that are there and may not be repeated, nor those that exclude what is there.
void offer_options(Offer& offer, const Typed& typed, std::string_view value) {
  for (const ManualOption& option : typed.command->options) {
    const bool is_out = std::ranges::any_of(typed.options, [&](const ManualOption* given) {
      if (given == &option) return !option.may_repeat && !option.takes_many;
      return std::ranges::any_of(given->names, [&](const auto& name) { return contains(option.excluded, name); }) ||
             std::ranges::any_of(option.names, [&](const auto& name) { return contains(given->excluded, name); });
    });
    if (!is_out) offer_names(offer, option, value);
  }
}

// Without their extension.
void offer_toml_names(Offer& offer, const Typed& typed, std::string_view value) {
  for (const std::string& folder : typed.arguments) {
    std::error_code error;  // ends the loop: what cannot be read is not offered
    for (std::filesystem::directory_iterator file(folder, error), end; !error && file != end; file.increment(error)) {
      const std::string name = file->path().stem().string();
      const bool is_plain = std::ranges::none_of(name, [](unsigned char letter) { return letter < ' '; });
      if (is_plain && !name.starts_with('.') && file->path().extension() == ".toml") offer.add(value, name, "");
    }
  }
}

void offer_values(Offer& offer, const Typed& typed, const ManualOption& option, std::string_view value) {
  if (const std::size_t comma = value.rfind(','); option.is_list && comma != std::string_view::npos) {
    offer.before += value.substr(0, comma + 1);
    value.remove_prefix(comma + 1);
  }
  for (const std::string& word : option.words) {
    if (word.ends_with(':') && value.starts_with(word)) {
      offer = {.paths = ManualPaths::any, .before = offer.before + word};
      return;
    }
    offer.add(value, word, "");
  }
  offer.paths = option.paths;
  if (option.paths == ManualPaths::toml_names) offer_toml_names(offer, typed, value);
}

// The option to which the typed word is a value, and where in the word that begins: after "--name=" or after "-n".
std::pair<const ManualOption*, std::size_t> joint_option(const ManualCommand& command, std::string_view word) {
  const bool is_long = word.starts_with("--");
  const std::size_t name_length = is_long ? word.find('=') : 2;
  if (name_length >= word.size()) return {nullptr, 0};
  const ManualOption* const option = option_named(command, word.substr(0, name_length));
  if (option == nullptr || !option->has_value()) return {nullptr, 0};
  return {option, is_long ? name_length + 1 : name_length};
}

}  // namespace

std::string completions(const Manual& manual, std::span<const std::string> words) {
  const std::string_view value = words.empty() ? std::string_view() : words.back();
  const bool is_first = words.size() <= 1;
  const Typed typed = read(manual, is_first ? std::span<const std::string>() : words.first(words.size() - 1));
  Offer offer;
  const std::vector<ManualOption>& arguments = typed.command->arguments;
  if (is_first) {
    for (const ManualCommand& command : manual.commands) offer.add(value, command.name, command.sentence);
    for (const ManualOption& option : manual.program.options) offer_names(offer, option, value);
  }
  if (typed.open != nullptr && !(typed.open->takes_many && is_option(value))) {
    offer_values(offer, typed, *typed.open, value);
  } else if (const auto [option, begin] = joint_option(*typed.command, value); is_option(value) && option != nullptr) {
    offer.before = value.substr(0, begin);
    offer_values(offer, typed, *option, value.substr(begin));
  } else if (value.starts_with('-')) {
    offer_options(offer, typed, value);
  } else if (typed.arguments.size() < arguments.size()) {
    offer_values(offer, typed, arguments[typed.arguments.size()], value);
  } else if (!arguments.empty() && arguments.back().takes_many) {
    offer_values(offer, typed, arguments.back(), value);
  }
  const auto* const kind = std::ranges::find(path_kinds, offer.paths, &std::pair<ManualPaths, const char*>::first);
  return fmt::format("{} {}\n{}", kind->second, offer.before, offer.lines);
}

}  // namespace ghostforce
