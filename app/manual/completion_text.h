// Pieces that the completion scripts share. Pure, any thread.
#pragma once

#include <string>
#include <string_view>

#include "app/manual/manual.h"

namespace ghostforce {

// The beginning of a sentence, up to "; " or ". ": short enough to stand beside a name.
std::string_view first_clause(std::string_view sentence);

std::string with_replaced(std::string_view text, std::string_view what, std::string_view with);

// How the scripts call the kind.
std::string_view name_of(ManualPaths paths) noexcept;

// Where a person asked for the script.
std::string made_by(const Manual& manual, std::string_view shell);

}  // namespace ghostforce
