// Words of a file or of the command line as they may stand in a message: short, and with nothing in them that moves a
// terminal's cursor. Pure, any thread.
#pragma once

#include <cstddef>
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

}  // namespace ghostforce
