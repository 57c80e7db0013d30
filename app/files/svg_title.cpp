#include "app/files/svg_title.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "app/console/typed_text.h"

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

}  // namespace ghostforce
