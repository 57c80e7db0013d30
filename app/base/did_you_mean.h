// "Did you mean …": the name of a list that a mistyped word was probably meant to be. Pure, any thread.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ghostforce {

// The candidate with the fewest slips of the keyboard (a letter wrong, missing, too many, or two swapped; case does not
// count) between it and `word`; the first of equals. Empty when all are so far away that naming one would only confuse.
// A word that a candidate begins with is near, however much follows: k_r and k_r_N_per_m.
std::optional<std::string_view> nearest_name(std::string_view word, std::span<const std::string_view> candidates);

// "'WORD' is not one of A, B, C; did you mean 'A'?"; empty: it is one of them.
std::string not_one_of(std::string_view word, std::span<const std::string_view> words);

// "; did you mean 'CANDIDATE'?", or nothing.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace ghostforce
