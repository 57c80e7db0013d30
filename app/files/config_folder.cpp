#include "app/files/config_folder.h"

#include <cstdlib>

namespace ghostforce {

std::filesystem::path config_folder() {
  namespace fs = std::filesystem;
  const char* const given = std::getenv("XDG_CONFIG_HOME");
  if (given != nullptr && fs::path(given).is_absolute()) return fs::path(given) / "ghostforce";
  const char* const home = std::getenv("HOME");
  if (home != nullptr && fs::path(home).is_absolute()) return fs::path(home) / ".config/ghostforce";
  return {};
}

}  // namespace ghostforce
