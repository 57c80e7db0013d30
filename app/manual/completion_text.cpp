#include "app/manual/completion_text.h"

#include <algorithm>

#include <fmt/format.h>

namespace ghostforce {

std::string_view first_clause(std::string_view sentence) {
  return sentence.substr(0, std::min(sentence.find("; "), sentence.find(". ")));
}

std::string with_replaced(std::string_view text, std::string_view what, std::string_view with) {
  std::string result;
  while (true) {
    const std::size_t at = text.find(what);
    result += text.substr(0, at);
    if (at == std::string_view::npos) return result;
    result += with;
    text.remove_prefix(at + what.size());
  }
}

std::string_view name_of(ManualPaths paths) noexcept {
  switch (paths) {
    case ManualPaths::none:
      return "none";
    case ManualPaths::any:
      return "any";
    case ManualPaths::toml:
      return "toml";
    case ManualPaths::folders:
      return "folders";
  }
  return "none";
}

std::string made_by(const Manual& manual, std::string_view shell) {
  return fmt::format("# Completion for {0} {1}, printed by: {0} help --format {2}\n", manual.program.name,
                     manual.version, shell);
}

}  // namespace ghostforce
