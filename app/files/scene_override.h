// One argument of --set: a key of the scene and the value that it shall have instead of the file's. Pure, any thread.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include <toml++/toml.h>

namespace ghostforce {

struct SceneOverride {
  std::string key;    // dotted, as in find_scene_key(); or "format"
  toml::table value;  // under the name "value"; its type is not checked yet
};

// KEY=VALUE, blanks around both allowed. VALUE is TOML, save that a text may come without quotes. Returns what is wrong
// if something is.
std::variant<SceneOverride, std::string> parse_override(std::string_view argument);

}  // namespace ghostforce
