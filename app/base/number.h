// Real numbers as files and people write them: what std::from_chars makes of a whole text. The standard library of a page
// has it for whole numbers only. Any thread.
#pragma once

#include <optional>
#include <string_view>

namespace ghostforce {

// The nearest to what is written; also inf and nan. Empty: the text is no number or has something besides (blanks and a
// plus before it too), or it is too large, or too near to 0.
std::optional<double> read_number(std::string_view text) noexcept;

}  // namespace ghostforce
