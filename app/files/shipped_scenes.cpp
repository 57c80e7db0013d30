#include "app/files/shipped_scenes.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace ghostforce {

const std::vector<ShippedScene>& shipped_scenes() {
  static const std::vector<ShippedScene> scenes = [] {
    std::vector<ShippedScene> list;
    for (const std::string_view name : shipped_scene_names()) {
      list.push_back({std::string(name), load_scene(std::string(name))});
    }
    // fig4-ratio5 comes before fig4-ratio10.
    std::ranges::sort(list, {}, [](const ShippedScene& scene) {
      const std::size_t digits = scene.name.find_last_not_of("0123456789") + 1;
      const std::string number = scene.name.substr(digits);
      return std::pair(scene.name.substr(0, digits), number.empty() ? 0 : std::stoi(number));
    });
    return list;
  }();
  return scenes;
}

}  // namespace ghostforce
