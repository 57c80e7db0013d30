// Scenes by name or path, and as text: read strictly, and written so that they read back bit for bit. The shipped
// scenes are part of the program. Not for the servo thread.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/read_error.h"
#include "core/scene.h"

namespace ghostforce {

// From TOML to a scene. Whatever is not said, not known or out of range is told with file, line and column, all of it
// at once. `overrides` are the arguments of --set, KEY=VALUE each: KEY as in the file with its table
// (rendering.k_r_N_per_m), VALUE as in TOML or, for a text, as it is; the last of equals holds, and all of them hold
// before the file. `shown_path` is what messages call the file. Throws ReadError(wrong), one line per problem:
//     FILE:LINE:COLUMN: the key KEY: what is wrong; what to do
//     --set KEY=VALUE: the key KEY: what is wrong; what to do
//
// A general scene is of format 2; a file that says nothing of it is of format 1. Overrides may make a general scene of
// either. Where one of them chooses another kind, the file's keys of its own kind say nothing.
enum class SceneChecks : std::uint8_t {
  all,
  all_but_workspace,  // whether the hand's way lies where the device can be: settings that change as people drag them
};
Scene read_scene(std::string_view text, std::string_view shown_path, std::span<const std::string> overrides = {},
                 SceneChecks asks = SceneChecks::all);

// "wall45", "fig1" …, sorted by name; their texts are in embedded_scenes.h.
std::vector<std::string_view> shipped_scene_names();

// What commands take where none is named.
inline constexpr std::string_view default_scene_name = "wall45";

// Whether it can only mean a file, or is one, or is a shipped scene: what tells a scene from a mistyped command.
bool may_be_scene(const std::string& name_or_path);

// A shipped scene or a file. A word without '/' that names a shipped scene is that one. Throws ReadError: wrong where
// there is none, or where its text is wrong; unreadable.
Scene load_scene(const std::string& name_or_path, std::span<const std::string> overrides = {});

// The number of the format that scene_text() writes.
int format_of(const Scene& scene);

// The scene as a file. Reads back bit for bit, each number in the shortest decimal that does so in the file's unit,
// provided that the scene came from a file or from rounded_to_file().
std::string scene_text(const Scene& scene);

// The value of a key alone, as scene_text() writes it and --set takes it; empty: to be left out.
std::string value_text(Scene scene, const SceneKey& key);

// The number of mm that reads back as exactly this [m], in as few digits as possible; the nearest where there is none.
double file_millimetres(double metres);

// The nearest scene that a file can hold. Files hold mm and degrees, and not every metre or radian is the quotient of
// some number of those: such a value moves to the next one, by its last bit. Scenes that were read stay as they are.
Scene rounded_to_file(Scene scene);

}  // namespace ghostforce
