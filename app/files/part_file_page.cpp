#include <fcntl.h>

#include <cstdio>

#include <fmt/format.h>

#include "app/files/part_file.h"

namespace ghostforce {

PartFile make_part_file(const std::filesystem::path& folder) {
  static int number = 0;
  PartFile part{folder / fmt::format(".ghostforce-{}.part", number++), -1};
  part.descriptor = open(part.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  return part;
}

// There is no such call, but nobody looks meanwhile. And no file may be renamed to the name of another: Emscripten's file
// system would find that one again once the new one is removed.
bool exchange_names(const std::string& one, const std::string& other) noexcept {
  const std::string spare = one + ".old";
  return std::rename(other.c_str(), spare.c_str()) == 0 && std::rename(one.c_str(), other.c_str()) == 0 &&
         std::rename(spare.c_str(), one.c_str()) == 0;
}

void lock_part_file(int) noexcept {}

void remove_dead_part_files(const std::filesystem::path&) {}

}  // namespace ghostforce
