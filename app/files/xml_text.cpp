#include "app/files/xml_text.h"

#include <algorithm>
#include <cstddef>

#include "app/console/unicode.h"

namespace ghostforce {
namespace {

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
    if (length == 0) {
      result += "\xEF\xBF\xBD";
    } else {
      switch (text[0]) {
        case '&':
          result += "&amp;";
          break;
        case '<':
          result += "&lt;";
          break;
        case '>':
          result += "&gt;";
          break;
        case '"':
          result += "&quot;";
          break;
        case '\'':
          result += "&#39;";
          break;
        case '\n':  // else an attribute would lose it, as it would the next two
          result += "&#10;";
          break;
        case '\r':
          result += "&#13;";
          break;
        case '\t':
          result += "&#9;";
          break;
        default:
          result += text.substr(0, length);
      }
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

}  // namespace ghostforce
