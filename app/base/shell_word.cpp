#include "app/base/shell_word.h"

#include <cstddef>
#include <optional>

#include <fmt/format.h>

namespace ghostforce {
namespace {

// More than any command of ours has; a text with more words is not a command.
constexpr std::size_t most_words = 10'000;

constexpr std::string_view blanks = " \t\r\n";

constexpr bool is_one_of(char c, std::string_view characters) noexcept {
  return characters.find(c) != std::string_view::npos;
}

// The line break that a backslash before it takes away; 0: there is none.
std::size_t length_of_break(std::string_view text) noexcept {
  if (text.starts_with("\r\n")) return 2;
  return text.starts_with('\n') ? 1 : 0;
}

class ShellSplitter {
 public:
  explicit ShellSplitter(std::string_view text) : rest_(text) {}

  ShellWords split() {
    while (!rest_.empty() && result_.problem.empty()) {
      if (is_one_of(rest_.front(), blanks)) {
        end_word();
        rest_.remove_prefix(1);
      } else {
        take_piece();
      }
    }
    end_word();
    return std::move(result_);
  }

 private:
  void end_word() {
    if (!word_) return;
    if (result_.words.size() == most_words) return refuse("there are too many words; give one command");
    result_.words.push_back(std::move(*word_));
    word_.reset();
  }

  void add(std::string_view piece) {
    if (!word_) word_.emplace();
    word_->append(piece);
  }

  void take_piece() {
    const char first = rest_.front();
    if (first == '\'') return take_single_quoted();
    if (first == '"') return take_double_quoted();
    if (first == '\\') return take_escaped();
    if (is_one_of(first, ";|&<>()`$") || (first == '#' && !word_)) return refuse_meaning(first);
    add(rest_.substr(0, 1));
    rest_.remove_prefix(1);
  }

  void take_escaped() {
    rest_.remove_prefix(1);
    if (rest_.empty()) return refuse("the text ends in a backslash; copy the whole command");
    if (const std::size_t gone = length_of_break(rest_)) return rest_.remove_prefix(gone);
    add(rest_.substr(0, 1));
    rest_.remove_prefix(1);
  }

  void take_single_quoted() {
    const std::size_t end = rest_.find('\'', 1);
    if (end == std::string_view::npos) return refuse_open('\'');
    add(rest_.substr(1, end - 1));
    rest_.remove_prefix(end + 1);
  }

  void take_double_quoted() {
    rest_.remove_prefix(1);
    add("");
    while (!rest_.empty() && rest_.front() != '"') {
      const char first = rest_.front();
      if (is_one_of(first, "`$")) return refuse_meaning(first);
      if (first == '\\' && rest_.size() > 1) {
        const std::size_t gone = length_of_break(rest_.substr(1));
        if (gone > 0 || is_one_of(rest_[1], "$`\"\\")) {
          if (gone == 0) add(rest_.substr(1, 1));
          rest_.remove_prefix(1 + (gone > 0 ? gone : 1));
          continue;
        }
      }
      add(rest_.substr(0, 1));
      rest_.remove_prefix(1);
    }
    if (rest_.empty()) return refuse_open('"');
    rest_.remove_prefix(1);
  }

  void refuse(std::string problem) {
    if (result_.problem.empty()) result_.problem = std::move(problem);
    word_.reset();
  }
  void refuse_open(char quote) { refuse(fmt::format("a quote ({}) is not closed; copy the whole command", quote)); }
  void refuse_meaning(char sign) {
    refuse(fmt::format("a shell would act on the '{}'; leave it out, or put it in single quotes", sign));
  }

  std::string_view rest_;
  std::optional<std::string> word_;  // that has begun
  ShellWords result_;
};

}  // namespace

std::string shell_word(std::string_view word) {
  constexpr std::string_view harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./,:@%+=";
  if (!word.empty() && word.find_first_not_of(harmless) == std::string_view::npos) return std::string(word);
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

ShellWords split_shell_words(std::string_view text) {
  return ShellSplitter(text).split();
}

}  // namespace ghostforce
