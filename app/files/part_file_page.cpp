#include <fcntl.h>

#include <fmt/format.h>

#include "app/files/part_file.h"

namespace ghostforce {

PartFile make_part_file(const std::filesystem::path& folder) {
  static int number = 0;
  PartFile part{folder / fmt::format(".ghostforce-{}.part", number++), -1};
  part.descriptor = open(part.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  return part;
}

// The memory file system has no such call.
bool exchange_names(const std::string&, const std::string&) noexcept {
  return false;
}

void lock_part_file(int) noexcept {}

void remove_dead_part_files(const std::filesystem::path&) {}

}  // namespace ghostforce
