#include "app/console/wrapped.h"

#include <algorithm>

namespace ghostforce {

std::string wrapped(std::string_view text, std::size_t longest_line) {
  std::string lines;
  std::size_t length = 0;  // of the last line
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (length > 0) {
      const bool fits = length + 1 + end <= longest_line;
      lines += fits ? ' ' : '\n';
      length = fits ? length + 1 : 0;
    }
    lines += text.substr(0, end);
    length += end;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace ghostforce
