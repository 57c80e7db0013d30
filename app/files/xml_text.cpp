#include "app/files/xml_text.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "app/base/quoted.h"

namespace ghostforce {
namespace {

// What stands for these in XML; for line breaks and tabs too, else an attribute would lose them.
constexpr std::string_view escaped = "&<>\"'\n\r\t";
constexpr std::array<std::string_view, escaped.size()> references{"&amp;", "&lt;",  "&gt;",  "&quot;",
                                                                  "&#39;", "&#10;", "&#13;", "&#9;"};

// The length of the character that a text begins with; 0: it begins with none that XML allows.
std::size_t allowed_length(std::string_view text) {
  const auto [code, length] = first_character(text);
  const bool is_layout = code == '\n' || code == '\r' || code == '\t';
  return (code < 0x20 && !is_layout) || code == 0xFFFE || code == 0xFFFF ? 0 : length;
}

}  // namespace

std::string xml_text(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = allowed_length(text);
    const std::size_t escape = escaped.find(text[0]);
    if (length == 0) {
      result += "\xEF\xBF\xBD";
    } else {
      result += escape == std::string_view::npos ? text.substr(0, length) : references[escape];
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

}  // namespace ghostforce
