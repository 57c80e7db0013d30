// What the vector pictures of the tests show: scenes as they are composed without OpenGL. For tests.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/files/scene_file.h"
#include "app/paint/vector/vector_painter.h"
#include "app/shell/desktop/offscreen.h"

namespace ghostforce {

inline constexpr int width = 904;  // of the pictures that are compared [px]; three panes of whole pixels and their gaps
inline constexpr int height = 600;
inline constexpr Vector<2> size{static_cast<double>(width), static_cast<double>(height)};
inline const Theme& light = *find_theme("light");

// Of the scripted hand, while its trails have not faded yet.
inline constexpr double moment_with_trails_s = 1.0;

inline std::vector<Pane> panes_of(std::string_view scene, Compare compare, const Theme& theme, bool has_trails = true) {
  PictureRequest request;
  request.scene = load_scene(std::string(scene));
  request.options.compare = compare;
  request.options.trails = has_trails;
  request.appearance.theme = &theme;
  request.at_s = moment_with_trails_s;
  return compose_moment(request, simulate_to_moment(request), size, measure_vector_text);
}

}  // namespace ghostforce
