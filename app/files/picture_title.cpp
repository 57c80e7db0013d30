#include "app/files/picture_title.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "app/base/typed_text.h"

namespace ghostforce {
namespace {

constexpr std::array<std::pair<std::string_view, char>, 5> xml_names{
    {{"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}}};

// What "&NAME;" stands for; empty: none of plain letters.
std::optional<char> letter_of(std::string_view name) noexcept {
  const auto* const known = std::ranges::find(xml_names, name, &std::pair<std::string_view, char>::first);
  if (known != xml_names.end()) return known->second;
  std::optional<unsigned> code;
  if (name.starts_with("#x")) {
    code = number_in<unsigned>(name.substr(2), 16);
  } else if (name.starts_with('#')) {
    code = number_in<unsigned>(name.substr(1));
  }
  return code && *code > 0 && *code < 0x80 ? std::optional(static_cast<char>(*code)) : std::nullopt;
}

std::string without_references(std::string_view xml) {
  constexpr std::size_t longest_name = 8;
  std::string text;
  while (!xml.empty()) {
    const std::size_t end = xml.front() == '&' ? xml.substr(0, longest_name + 2).find(';') : std::string_view::npos;
    const auto letter = end == std::string_view::npos ? std::nullopt : letter_of(xml.substr(1, end - 1));
    text += letter.value_or(xml.front());
    xml.remove_prefix(letter ? end + 1 : 1);
  }
  return text;
}

}  // namespace

std::string svg_title(std::string_view file) {
  constexpr std::string_view tag = "<title";
  std::size_t at = file.find(tag);
  if (at == std::string_view::npos) return {};
  at = file.find('>', at + tag.size());
  if (at == std::string_view::npos) return {};
  const std::size_t end = file.find("</title", at);
  if (end == std::string_view::npos) return {};
  return without_references(file.substr(at + 1, end - at - 1));
}

namespace {

// "(…)" with its escapes, from behind the first parenthesis (ISO 32000, 7.3.4.2); empty: it does not end.
std::string literal_string(std::string_view text) {
  constexpr std::string_view escapes = "nrtbf";
  constexpr std::string_view meanings = "\n\r\t\b\f";
  std::string bytes;
  int depth = 1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '(') ++depth;
    if (c == ')' && --depth == 0) return bytes;
    if (c != '\\') {
      bytes += c;
      continue;
    }
    if (++i == text.size()) break;
    std::size_t digits = 0;
    while (digits < 3 && i + digits < text.size() && text[i + digits] >= '0' && text[i + digits] <= '7') ++digits;
    if (digits > 0) {
      bytes += static_cast<char>(number_in<unsigned>(text.substr(i, digits), 8).value_or(0) & 0xFFU);
      i += digits - 1;
    } else if (const std::size_t known = escapes.find(text[i]); known != std::string_view::npos) {
      bytes += meanings[known];
    } else if (text[i] != '\n' && text[i] != '\r') {
      bytes += text[i];
    }
  }
  return {};
}

// "<…>", from behind the first bracket; empty: it does not end, or is none.
std::string hexadecimal_string(std::string_view text) {
  std::string bytes;
  text = text.substr(0, text.find('>'));
  for (; text.size() >= 2; text.remove_prefix(2)) {
    const auto byte = number_in<unsigned>(text.substr(0, 2), 16);
    if (!byte) return {};
    bytes += static_cast<char>(*byte);
  }
  return bytes;
}

// Of UTF-16 with its mark, or of a code in which ASCII is what it is.
std::string ascii_of(std::string_view bytes) {
  const bool is_wide = bytes.starts_with("\xFE\xFF");
  if (is_wide) bytes.remove_prefix(2);
  std::string text;
  const std::size_t step = is_wide ? 2 : 1;
  for (; bytes.size() >= step; bytes.remove_prefix(step)) {
    const bool is_ascii = static_cast<unsigned char>(bytes[step - 1]) < 0x80 && (!is_wide || bytes[0] == '\0');
    text += is_ascii ? bytes[step - 1] : '?';
  }
  return text;
}

}  // namespace

std::string pdf_title(std::string_view file) {
  // Who saves a file anew adds to its end.
  constexpr std::string_view key = "/Title";
  const std::size_t at = file.rfind(key);
  if (at == std::string_view::npos) return {};
  const std::size_t begins = file.find_first_not_of(" \r\n\t", at + key.size());
  if (begins == std::string_view::npos) return {};
  const std::string_view value = file.substr(begins);
  if (value.starts_with('(')) return ascii_of(literal_string(value.substr(1)));
  if (value.starts_with('<')) return ascii_of(hexadecimal_string(value.substr(1)));
  return {};
}

}  // namespace ghostforce
