// Completion of what a person types after the program's name: a shell asks the program by `ghostforce __complete WORDS`
// and prints what it answers; a script in assets/completion does so for each shell. Not for the servo thread.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/cli/manual.h"

namespace ghostforce {

// What may follow these words, of which the last is being typed. In the first line the kind of paths that may stand
// there, "none", "any", "toml" or "folders", a blank, and what of the last word comes before the path. In each line
// below a whole word, and after a tab, if there is anything to say of it, a sentence. A word that ends in '=' or ':' is
// not finished. Reads the folders whose files are to be chosen from.
std::string completions(const Manual& manual, std::span<const std::string> words);

// A word that names an option: a lone "-" is a standard stream.
bool is_option(std::string_view word) noexcept;

inline constexpr std::string_view completing_command = "__complete";

}  // namespace ghostforce
