#include "app/files/file_kind.h"

#include <system_error>

namespace ghostforce {

std::string_view kind_instead_of_file(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_type type = fs::status(path, error).type();
  switch (type) {
    case fs::file_type::regular:
      return "";
    case fs::file_type::directory:
      return "a folder";
    case fs::file_type::fifo:
      return "a pipe";
    case fs::file_type::socket:
      return "a socket";
    case fs::file_type::block:
    case fs::file_type::character:
      return "a device";
    case fs::file_type::not_found:
      break;
    default:
      if (error != std::errc::too_many_symbolic_link_levels) return "";
  }
  std::error_code none;
  return fs::is_symlink(fs::symlink_status(path, none)) ? "a link that leads nowhere" : "";
}

}  // namespace ghostforce
