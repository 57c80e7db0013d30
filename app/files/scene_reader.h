// From TOML to a scene. Strict: whatever is not said, not known or out of range
// is told with file, line and column, all of it at once. Not for the servo
// thread.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/files/read_error.h"
#include "core/scene.h"

namespace ghostforce {

// `overrides` are the arguments of --set, KEY=VALUE each: KEY as in the file
// with its table (rendering.k_r_N_per_m), VALUE as in TOML or, for a text, as it
// is; the last of equals holds, and all of them hold before the file.
// `shown_path` is what messages call the file. Throws ReadError(wrong), one line
// per problem:
//     FILE:LINE:COLUMN: the key KEY: what is wrong; what to do
//     --set KEY=VALUE: the key KEY: what is wrong; what to do
Scene read_scene(std::string_view text, std::string_view shown_path, std::span<const std::string> overrides = {});

}  // namespace ghostforce
