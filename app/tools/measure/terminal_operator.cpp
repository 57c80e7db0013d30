#include "app/tools/measure/terminal_operator.h"

#include <unistd.h>

#include <array>
#include <cerrno>

#include <fmt/format.h>

#include "app/base/interruption.h"
#include "app/base/words.h"

namespace ghostforce {
namespace {

constexpr std::size_t widest_line = 78;

// Broken between words; what begins with spaces goes on with as many.
std::string wrapped(std::string_view words) {
  const std::size_t begin = std::min(words.find_first_not_of("\n "), words.size());
  std::string text(words.substr(0, begin));
  const std::string indent(begin - (text.find_last_of('\n') + 1), ' ');  // after no line's end: npos + 1 is 0
  std::size_t column = indent.size();
  for (std::size_t at = begin; at < words.size();) {
    const std::size_t end = std::min(words.find(' ', at), words.size());
    const std::string_view word = words.substr(at, end - at);
    if (column > indent.size() && column + 1 + word.size() > widest_line) {
      text += "\n" + indent;
      column = indent.size();
    } else if (at > begin) {
      text += ' ';
      ++column;
    }
    text += word;
    column += word.size();
    at = end + 1;
  }
  return text;
}

}  // namespace

void TerminalOperator::tell(std::string_view words) {
  say("{}\n", wrapped(words));
}

std::optional<std::string> TerminalOperator::ask(const OperatorAction& action, std::string_view words) {
  say("\n");
  tell(words);
  const std::string answer = simulated_ == nullptr ? "" : simulated_->act(action);
  if (!answer.empty()) {
    tell(fmt::format("(Rehearsal: press Enter to answer {}.)", answer));
  } else if (simulated_ != nullptr) {
    tell("(Rehearsal: the simulated hand does it.)");
  }
  say("> ");
  std::optional<std::string> line = read_line();
  if (line && line->empty()) line = answer;
  return line;
}

void TerminalOperator::cue(const OperatorAction& action) {
  if (simulated_ != nullptr) simulated_->act(action);
}

std::optional<std::string> TerminalOperator::read_line() {
  for (;;) {
    if (const std::size_t end = typed_.find('\n'); end != std::string::npos) {
      std::string line = typed_.substr(0, end);
      typed_.erase(0, end + 1);
      return line;
    }
    wait_to_read(STDIN_FILENO);
    std::array<char, 4096> piece;
    const ssize_t count = read(STDIN_FILENO, piece.data(), piece.size());
    stop_if_interrupted();
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count <= 0) return std::nullopt;
    typed_.append(piece.data(), static_cast<std::size_t>(count));
    constexpr std::size_t longest_answer = 65536;
    if (typed_.size() > longest_answer) return std::nullopt;
  }
}

}  // namespace ghostforce
