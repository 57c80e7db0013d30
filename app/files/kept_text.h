// What kept files (kept_file.h) are made of, wherever they lie. Any thread.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/read_error.h"

namespace ghostforce {

// What is wrong with one, on one line.
std::string damage_words(const std::vector<ReadProblem>& problems);

// What of one stands under other keys than these, values first. Nothing where it is no TOML.
std::string without_keys(std::string_view text, std::span<const std::string_view> keys);

}  // namespace ghostforce
