// What kept files (kept_file.h) are made of, wherever they lie. Any thread.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/read_error.h"

namespace ghostforce {

// What each begins with: who wrote it, what it is (the `comment`, one line), and the number of its format.
std::string kept_beginning(std::string_view comment);

// Whether this program cannot know what its values mean.
bool is_of_newer_format(std::string_view text);

// What is wrong with one, on one line.
std::string damage_words(const std::vector<ReadProblem>& problems);

// What of one stands under other keys than these and the format's, values first. Nothing where it is no TOML.
std::string without_named_keys(std::string_view text, std::span<const std::string_view> keys);

}  // namespace ghostforce
