// Where a person's settings of this program are kept, by the XDG specification. Allocates; not for the servo thread.
#pragma once

#include <filesystem>

namespace ghostforce {

// $XDG_CONFIG_HOME/ghostforce, or ~/.config/ghostforce; relative paths are ignored, as the specification wants it.
// Empty: nowhere. Whether the folder exists is another question.
std::filesystem::path config_folder();

}  // namespace ghostforce
