// The words of a call, one per line: parsed, and not obeyed.
#include <string>
#include <vector>

#include "app/base/failure.h"
#include "app/cli/command.h"
#include "tests/fuzz/fuzz.h"

using namespace ghostforce;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::string> words(1);
  for (const char c : text_of({data, size})) {
    if (c == '\0') continue;  // no word of a call holds one
    if (c == '\n') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  if (words.back().empty()) words.pop_back();
  try {
    require(parse_command_line(words) != nullptr, "a call that is right asks for something");
  } catch (const Failure& failure) {
    require(failure.code() == ExitCode::wrong_call && *failure.what() != '\0', "it is said what is wrong");
    for (const char c : std::string_view(failure.what())) {
      require(c == '\n' || (static_cast<unsigned char>(c) >= 0x20 && c != 0x7F), "no message moves a cursor");
    }
  }
  return 0;
}
