// The names of a scene's keys as people write and mistype them. Pure, any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/toml_document.h"
#include "core/scene.h"

namespace ghostforce {

// Null when there is no such key. The dotted form is that of --set and --over.
const SceneKey* find_scene_key(std::string_view table, std::string_view name) noexcept;
const SceneKey* find_scene_key(std::string_view dotted) noexcept;

// Of which a message may propose one; empty: of all.
using SceneKeys = std::vector<const SceneKey*>;

// The end of a message about an unknown key: "; did you mean '…'?" with the same name in another table, else the nearest
// in this one, else the nearest of all; or "; TABLE has …".
std::string suggest_scene_key(std::string_view table, std::string_view name, const SceneKeys& among = {});
std::string suggest_scene_key(std::string_view dotted);

// "belongs to kind 'circle', and this wall is of kind 'plane'". `kind`: that of the key's table.
std::string wrong_kind_text(const SceneKey& key, std::string_view kind);

// "TABLE.NAME"
std::string dotted_name(const SceneKey& key);

// Of all keys, or of those that hold one number.
enum class KeyKind : std::uint8_t { any, number };
std::vector<std::string> dotted_names(KeyKind kind);

// The unit that a key's name ends in, as people write it: N/m for k_r_N_per_m; empty where there is none.
std::string_view unit_of(std::string_view key_name) noexcept;

// What the number of a key may be; empty: the key holds no number, or several.
std::optional<NumberLimits> limits_of(const SceneKey& key) noexcept;

// Sets a key to a number, to a word in quotes, or to points or a pair of numbers in brackets, as value_text() writes them,
// and some 100 times as fast as by reading TOML. False, and nothing is set: the text is none of these, is out of range,
// or decides which other keys or how many motors there are.
bool set_plain_value(Scene& scene, const SceneKey& key, std::string_view text);

}  // namespace ghostforce
