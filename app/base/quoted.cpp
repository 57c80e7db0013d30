#include "app/base/quoted.h"

#include <algorithm>

#include <fmt/core.h>
#include <fmt/format.h>

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

Character first_character(std::string_view text) noexcept {
  if (text.empty()) return {};
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return {first, 1};
  const std::size_t length = first >= 0xC2 && first <= 0xDF   ? 2
                             : first >= 0xE0 && first <= 0xEF ? 3
                             : first >= 0xF0 && first <= 0xF4 ? 4
                                                              : 0;
  if (length == 0 || length > text.size()) return {};
  char32_t code = first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    code = code << 6U | (byte(i) & 0x3FU);
  }
  const bool is_longer_than_need_be = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool is_half_of_a_pair = code >= 0xD800 && code <= 0xDFFF;  // of UTF-16
  if (is_longer_than_need_be || is_half_of_a_pair || code > 0x10FFFF) return {};
  return {code, length};
}

bool is_control(char32_t code) noexcept {
  return code < 0x20 || (code >= 0x7F && code <= 0x9F);
}

bool is_noncharacter(char32_t code) noexcept {
  return (code >= 0xFDD0 && code <= 0xFDEF) || (code & 0xFFFEU) == 0xFFFEU;
}

std::optional<std::string> unshowable_in(std::string_view text, bool may_have_lines) {
  while (!text.empty()) {
    const auto [code, length] = first_character(text);
    if (length == 0) return fmt::format("the byte 0x{:02X}, which is not UTF-8", static_cast<unsigned char>(text[0]));
    const bool is_layout = code == '\n' || code == '\t' || text.starts_with("\r\n");
    if (is_control(code) && !(is_layout && may_have_lines)) {
      return fmt::format("the control character U+{:04X}", static_cast<unsigned>(code));
    }
    if (is_noncharacter(code)) return fmt::format("U+{:04X}, which is not a character", static_cast<unsigned>(code));
    text.remove_prefix(length);
  }
  return std::nullopt;
}

}  // namespace ghostforce
