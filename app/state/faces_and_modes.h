// What the window can show: its two faces, and the modes of the stage, which are further things to do there, each on
// one key. The one list of either that the keys, the stage's buttons, the command line, files and the tests walk.
// Immutable, any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "app/state/stage_language.h"

namespace ghostforce {

// The stage is for who looks and plays, the workbench for who changes and measures.
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

enum class StageMode : std::uint8_t { none, predict, why, landscape, round, ribbon, measure };

struct StageModeEntry {
  StageMode id;
  std::string_view name;  // in files and on the command line
  std::string_view key;   // as printed on it
  bool is_in_menu;        // else it has a button of its own on the stage
  StageLanguage::Mode StageLanguage::Modes::*words;
};
// Without `none`.
std::span<const StageModeEntry> stage_mode_catalog() noexcept;
// Empty when none has that name.
std::optional<StageMode> find_stage_mode(std::string_view name) noexcept;
std::string_view stage_mode_name(StageMode id) noexcept;  // "none" for none

}  // namespace ghostforce
