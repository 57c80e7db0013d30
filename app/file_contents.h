// A small file as text. Not for the servo thread.
#pragma once

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

namespace ghostforce {

// All of a file, which should be a plain one (file_kind.h). Empty: it cannot be read, and errno may say why.
inline std::optional<std::string> file_contents(const std::filesystem::path& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file.is_open() || file.bad()) return std::nullopt;
  return text;
}

}  // namespace ghostforce
