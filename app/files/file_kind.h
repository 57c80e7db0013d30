// What is at a path where a plain file is wanted: opening a pipe waits for its other end, and that may never come. Not
// for the servo thread.
#pragma once

#include <filesystem>
#include <string_view>

namespace ghostforce {

// "a folder", "a pipe", "a link that leads nowhere", …. Empty: a file or a link to one, nothing at all, or what cannot
// be looked at.
std::string_view kind_instead_of_file(const std::filesystem::path& path);

}  // namespace ghostforce
