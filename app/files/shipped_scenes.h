// The scenes that come with the program, as values. Each is read once. Any thread.
#pragma once

#include <string>
#include <vector>

#include "app/files/scene_file.h"

namespace ghostforce {

struct ShippedScene {
  std::string name;
  Scene scene;
};

// By name, and where names end in numbers by these.
const std::vector<ShippedScene>& shipped_scenes();

}  // namespace ghostforce
