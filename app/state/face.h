// The two faces of the window: the stage, for who looks and plays, and the workbench, for who changes and measures. The one
// list that the command line, files and the tests walk. Immutable, any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace ghostforce {

enum class Face : std::uint8_t { stage, workbench };

struct FaceEntry {
  Face id;
  std::string_view name;  // in files and on the command line
};
inline constexpr std::array face_catalog{FaceEntry{Face::stage, "stage"}, FaceEntry{Face::workbench, "workbench"}};

constexpr std::string_view face_name(Face id) noexcept {
  return face_catalog[static_cast<std::size_t>(id)].name;
}
// Empty when none has that name.
constexpr std::optional<Face> find_face(std::string_view name) noexcept {
  for (const FaceEntry& entry : face_catalog) {
    if (entry.name == name) return entry.id;
  }
  return std::nullopt;
}

}  // namespace ghostforce
