// Words and numbers as a person reads them: words broken into lines that are about as long as each other, so that no
// word is left alone; numbers with a real minus sign (U+2212), and never "−0". Pure, any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/picture/view.h"

namespace ghostforce {

// As few lines as can be that are no wider than this, but for a single word that is.
std::vector<std::string> broken_into_lines(std::string_view words, double width, const TextStyle& style,
                                           const MeasureText& measure);

// How many lines those are.
std::size_t line_count(std::string_view words, double width, const TextStyle& style, const MeasureText& measure);

// Two lines; a single word stays one.
std::vector<std::string> broken_in_two(std::string_view words, const TextStyle& style, const MeasureText& measure);

// "−19.4", "0.0", "3.6".
std::string decimal_text(double value, int decimals);

// With a sign, but for zero: "−19.4", "0.0", "+3.6".
std::string signed_decimal_text(double value, int decimals);

// What stands behind a ±, in whole numbers: no less than "1", because "± 0" would claim that nothing can be wrong.
std::string deviation_text(double deviation);

}  // namespace ghostforce
