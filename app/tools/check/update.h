// Goldens, written anew on purpose. Main thread only (it draws).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/tools/check/case_file.h"

namespace ghostforce {

// Draws these cases, and then writes NAME.png and the table [golden] of NAME.toml for each, all of them or none. A
// golden that is equal to what is drawn stays as it is. `renderer`: empty for the usual one. Returns a line per case
// about what was done. Throws Failure: wrong_call for a case without a golden, before anything is drawn; file_trouble;
// no_display; interrupted.
std::vector<std::string> update_goldens(const std::vector<Case>& all, const std::vector<const Case*>& chosen,
                                        std::optional<Renderer> renderer);

// The one command that stores a case's picture as it is drawn now.
std::string update_command(std::string_view folder, std::string_view name);

}  // namespace ghostforce
