#include "app/paint/font_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "app/base/failure.h"
#include "ghostforce_paths.h"

namespace ghostforce {

std::string font_file(std::string_view name) {
  std::error_code unreadable;
  const std::filesystem::path executable = std::filesystem::read_symlink("/proc/self/exe", unreadable);
  for (const std::string_view directory : font_directories) {
    const std::filesystem::path path = executable.parent_path() / directory / name;
    if (std::filesystem::exists(path, unreadable)) return path.string();
  }
  throw Failure(ExitCode::file_trouble,
                fmt::format("the font {} is not where the program expects it, {}; build again with ./demo, or install "
                            "the program with cmake --install",
                            name, (executable.parent_path() / font_directories[0]).string()));
}

}  // namespace ghostforce
