#include "app/base/quoted.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/base/unicode.h"

namespace ghostforce {
namespace {

// A byte in the middle of a UTF-8 character.
bool continues(char c) noexcept {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

}  // namespace

std::string quoted_text(std::string_view text, std::size_t longest) {
  const bool is_cut = text.size() > longest;
  if (is_cut) {
    std::size_t end = longest;
    while (end > 0 && continues(text[end])) --end;
    text = text.substr(0, end);
  }
  std::string result;
  while (!text.empty()) {
    const auto [code, length] = first_character(text);
    const std::string_view bytes = text.substr(0, std::max<std::size_t>(length, 1));
    if (length > 0 && !is_control(code) && !is_noncharacter(code)) {
      result += bytes;
    } else {
      for (const char c : bytes) result += fmt::format("\\x{:02X}", static_cast<unsigned char>(c));
    }
    text.remove_prefix(bytes.size());
  }
  return is_cut ? result + "…" : result;
}

std::string listed(std::span<const std::string_view> words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace ghostforce
