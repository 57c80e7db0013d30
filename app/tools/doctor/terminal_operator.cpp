#include "app/tools/doctor/terminal_operator.h"

#include <algorithm>

#include <fmt/format.h>
#include <termios.h>
#include <unistd.h>

#include "app/base/interruption.h"
#include "app/base/words.h"

namespace ghostforce {
namespace {

constexpr std::size_t widest_line = 78;

// Broken between words; what begins with spaces goes on with as many.
std::string broken_for_terminal(std::string_view words) {
  const std::size_t begin = std::min(words.find_first_not_of("\n "), words.size());
  const std::string_view blanks = words.substr(0, begin);
  const std::string_view indent = blanks.substr(blanks.rfind('\n') + 1);  // after no line's end: npos + 1 is 0
  return fmt::format("{}{}", blanks, wrapped(words.substr(begin), widest_line - indent.size(), indent));
}

}  // namespace

void tell_on_terminal(std::string_view words) {
  say("{}\n", broken_for_terminal(words));
}

std::optional<std::string> ask_on_terminal(std::string_view words, const std::optional<std::string>& simulated) {
  say("\n");
  tell_on_terminal(words);
  if (simulated) {
    tell_on_terminal(simulated->empty() ? "(Rehearsal: the simulated hand does it.)"
                                        : fmt::format("(Rehearsal: press Enter to answer {}.)", *simulated));
  }
  say("> ");
  // A key pressed before the question is no answer to it. From a file or a program every line is one.
  if (!simulated) tcflush(STDIN_FILENO, TCIFLUSH);
  // What somebody has begun to type and never sent is no answer: motors may follow it.
  const InputLine line = read_line(STDIN_FILENO);
  if (!line.is_whole) return std::nullopt;
  return line.text.empty() ? simulated.value_or("") : line.text;
}

}  // namespace ghostforce
