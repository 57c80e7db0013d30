#include "app/files/xml_text.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "app/console/unicode.h"

namespace ghostforce {
namespace {

struct Escape {
  char character;
  std::string_view reference;
};
// Line breaks and tabs too: else an attribute would lose them.
constexpr std::array<Escape, 8> escapes{{{'&', "&amp;"},
                                         {'<', "&lt;"},
                                         {'>', "&gt;"},
                                         {'"', "&quot;"},
                                         {'\'', "&#39;"},
                                         {'\n', "&#10;"},
                                         {'\r', "&#13;"},
                                         {'\t', "&#9;"}}};

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
    const auto* const escape = std::ranges::find(escapes, text[0], &Escape::character);
    if (length == 0) {
      result += "\xEF\xBF\xBD";
    } else {
      result += escape == escapes.end() ? text.substr(0, length) : escape->reference;
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

}  // namespace ghostforce
