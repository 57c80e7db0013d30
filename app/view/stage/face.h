// The two faces of the window: the stage, for who looks and plays, and the workbench, for who changes and measures. The one
// list that the command line, files and the tests walk. Immutable, any thread.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace ghostforce {

enum class Face : std::uint8_t { stage, workbench };

struct FaceEntry {
  Face id;
  std::string_view name;  // in files and on the command line
};
inline constexpr std::array face_catalog{FaceEntry{Face::stage, "stage"}, FaceEntry{Face::workbench, "workbench"}};

}  // namespace ghostforce
