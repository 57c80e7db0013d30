// Words of a file or of the command line as they may stand in a message: short, and with nothing in them that moves a
// terminal's cursor; and the characters of UTF-8 that can be shown. Pure, any thread.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ghostforce {

inline constexpr std::size_t longest_quote = 80;
inline constexpr std::size_t longest_path = 4096;  // Linux opens no longer one

// Control characters, what Unicode calls no character and bytes that are no UTF-8 become \xNN; what is longer than
// `longest` bytes ends in "…".
std::string quoted_text(std::string_view text, std::size_t longest = longest_quote);

// The names of a catalog's entries, in their order.
template <typename Catalog>
std::vector<std::string_view> names_of(const Catalog& catalog) {
  std::vector<std::string_view> names;
  for (const auto& entry : catalog) names.push_back(entry.name);
  return names;
}

// "full, naive, anisotropic"
std::string listed(std::span<const std::string_view> words);

// The first character of a text, and where it ends.
struct Character {
  char32_t code = 0;
  std::size_t length = 0;  // in bytes; 0: the text is empty, or begins with a byte that is no UTF-8
};

Character first_character(std::string_view text) noexcept;

// Of the C0 and C1 sets, and DEL: they move a terminal's cursor, and end C's strings.
bool is_control(char32_t code) noexcept;

// One of the 66 numbers that Unicode promises never to give to a character. Cairo refuses them.
bool is_noncharacter(char32_t code) noexcept;

// What stands in a text of one line, or of several, and can never be shown, as in "the control character U+0000"; the
// first of them. Line breaks and tabs are fine where there may be several lines. Empty: all can be shown.
std::optional<std::string> unshowable_in(std::string_view text, bool may_have_lines);

}  // namespace ghostforce
