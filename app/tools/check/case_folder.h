// A folder of cases: what it holds, and its goldens, written anew on purpose. Main thread only: that draws.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/tools/check/case_file.h"

namespace ghostforce {

// Every NAME.toml in the folder, by name; files whose name begins with a dot are left alone. Throws ReadError: wrong
// with all that is wrong with all of them (a pipe or a folder of such a name is wrong too); unreadable. And
// Failure(wrong_call) where there is no such folder or no case in it.
std::vector<Case> read_case_folder(const std::string& folder);

// The case of that name; null where there is none.
const Case* find_case(const std::vector<Case>& cases, std::string_view name) noexcept;

// The cases of these names, in the folder's order; all of them where there is no name. Throws Failure(wrong_call) for a
// name that no case has; `option` is where it was given, for the message.
std::vector<const Case*> chosen_cases(const std::vector<Case>& cases, const std::vector<std::string>& names,
                                      std::string_view option);

// A line for each case whose scene or lesson is in one of these files, whatever links lead there: who writes to them
// would lose it.
std::vector<std::string> sources_overwritten_by(const std::vector<Case>& cases, const std::vector<std::string>& paths);

struct StoredGoldens {
  std::vector<std::string> lines;  // per case, about what was done
  bool has_wrong_numbers = false;  // that a case states: no golden mends them
};

// Draws these cases, and then writes NAME.png and the table [golden] of NAME.toml for each, all of them or none. A
// golden that is equal to what is drawn stays as it is. `renderer`: empty for the usual one. Throws Failure: wrong_call
// for a case without a golden, before anything is drawn; file_trouble; no_display; interrupted.
StoredGoldens update_goldens(const std::vector<Case>& all, const std::vector<const Case*>& chosen,
                             std::optional<Renderer> renderer);

// The one command that stores a case's picture as it is drawn now.
std::string update_command(std::string_view folder, std::string_view name);

}  // namespace ghostforce
