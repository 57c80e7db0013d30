#include "app/files/xdg_folders.h"

#include <cstdlib>

namespace ghostforce {

namespace {

namespace fs = std::filesystem;

fs::path own_folder(const char* variable, const char* below_home) {
  const char* const given = std::getenv(variable);
  if (given != nullptr && fs::path(given).is_absolute()) return fs::path(given) / "ghostforce";
  const char* const home = std::getenv("HOME");
  if (home != nullptr && fs::path(home).is_absolute()) return fs::path(home) / below_home / "ghostforce";
  return {};
}

}  // namespace

std::filesystem::path config_folder() {
  return own_folder("XDG_CONFIG_HOME", ".config");
}

std::filesystem::path state_folder() {
  return own_folder("XDG_STATE_HOME", ".local/state");
}

std::optional<std::filesystem::path> firmware_path(const std::optional<std::filesystem::path>& asked_for) {
  if (asked_for) return asked_for;
  const char* const named = std::getenv("GHOSTFORCE_FIRMWARE");
  if (named != nullptr && *named != '\0') return std::filesystem::path(named);
  const std::filesystem::path folder = config_folder();
  if (folder.empty()) return std::nullopt;
  std::error_code error;
  std::filesystem::path usual = folder / "falcon/firmware.bin";
  if (!std::filesystem::exists(usual, error)) return std::nullopt;
  return usual;
}

}  // namespace ghostforce
