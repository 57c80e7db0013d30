#include "app/check/shell_word.h"

#include <fmt/format.h>

namespace ghostforce {

std::string shell_word(std::string_view word) {
  constexpr std::string_view harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./,:@%+=";
  if (!word.empty() && word.find_first_not_of(harmless) == std::string_view::npos) return std::string(word);
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string update_command(std::string_view folder, std::string_view name) {
  // What begins with a dash would be taken for an option.
  const std::string from_here = folder.starts_with('-') ? fmt::format("./{}", folder) : std::string(folder);
  return fmt::format("ghostforce check {} --update{}{}", shell_word(from_here), name.starts_with('-') ? "=" : " ",
                     shell_word(name));
}

}  // namespace ghostforce
