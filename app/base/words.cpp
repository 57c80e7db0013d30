#include "app/base/words.h"

#include <unistd.h>

#include <climits>
#include <cstdio>

#include "app/base/interruption.h"
#include "app/base/typed_text.h"

namespace ghostforce {

void write_words(std::string_view words) noexcept {
  while (!words.empty() && wait_for_reader(STDERR_FILENO)) {
    // A pipe that can be written to takes this much at once.
    const std::string_view piece = words.substr(0, PIPE_BUF);
    std::fwrite(piece.data(), 1, piece.size(), stderr);
    words.remove_prefix(piece.size());
  }
}

std::string wrapped(std::string_view text, std::size_t longest_line, std::string_view indent) {
  std::string lines;
  std::size_t length = 0;  // of the last line
  while (!text.empty()) {
    const std::string_view word = take_until(text, ' ');
    if (length > 0) {
      const bool fits = length + 1 + word.size() <= longest_line;
      lines += fits ? " " : fmt::format("\n{}", indent);
      length = fits ? length + 1 : 0;
    }
    lines += word;
    length += word.size();
  }
  return lines;
}

}  // namespace ghostforce
