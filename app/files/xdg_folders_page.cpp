#include "app/files/xdg_folders.h"

namespace ghostforce {

// Names only: what is kept there, the browser keeps (kept_file.h).
std::filesystem::path config_folder() {
  return "/settings";
}

std::filesystem::path state_folder() {
  return "/state";
}

std::optional<std::filesystem::path> firmware_path(const std::optional<std::filesystem::path>& asked_for) {
  return asked_for;
}

}  // namespace ghostforce
