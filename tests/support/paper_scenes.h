// The shipped scenes that the paper's loop runs: those that the workbench shows, and that a file of format 1 can tell.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/files/scene_file.h"

namespace ghostforce {

inline std::vector<std::string_view> paper_scene_names() {
  std::vector<std::string_view> names = shipped_scene_names();
  std::erase_if(names, [](std::string_view name) { return is_general(load_scene(std::string(name)).settings); });
  return names;
}

}  // namespace ghostforce
