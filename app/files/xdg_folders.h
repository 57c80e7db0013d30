// Where a person's settings and the program's own notes are kept, by the XDG specification. Allocates; not for the servo
// thread.
#pragma once

#include <filesystem>
#include <optional>

namespace ghostforce {

// $XDG_CONFIG_HOME/ghostforce, or ~/.config/ghostforce; relative paths are ignored, as the specification wants it.
// Empty: nowhere. Whether the folder exists is another question.
std::filesystem::path config_folder();

// $XDG_STATE_HOME/ghostforce, or ~/.local/state/ghostforce; else as above.
std::filesystem::path state_folder();

// The Falcon's firmware to take: the one asked for, else $GHOSTFORCE_FIRMWARE, whether or not those exist; else
// falcon/firmware.bin in the settings' folder if that does. Empty: nothing is known.
std::optional<std::filesystem::path> firmware_path(const std::optional<std::filesystem::path>& asked_for);

}  // namespace ghostforce
