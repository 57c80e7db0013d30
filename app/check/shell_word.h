// Words for a shell, so that a person can copy a command from a message. Pure, any thread.
#pragma once

#include <string>
#include <string_view>

namespace ghostforce {

// The word as it is where a POSIX shell takes it for itself, else in quotes.
std::string shell_word(std::string_view word);

// The one command that stores a case's picture as it is drawn now.
std::string update_command(std::string_view folder, std::string_view name);

}  // namespace ghostforce
