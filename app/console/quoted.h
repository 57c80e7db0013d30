// Words of a file or of the command line as they may stand in a message: short, and with nothing in them that moves a
// terminal's cursor. Pure, any thread.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace ghostforce {

inline constexpr std::size_t longest_quote = 80;
inline constexpr std::size_t longest_path = 4096;  // Linux opens no longer one

// Control characters, what Unicode calls no character and bytes that are no UTF-8 become \xNN; what is longer than
// `longest` bytes ends in "…".
std::string quoted_text(std::string_view text, std::size_t longest = longest_quote);

// "full, naive, anisotropic"
std::string listed(std::span<const std::string_view> words);

}  // namespace ghostforce
