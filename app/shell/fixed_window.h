// Windows of Dear ImGui that stand still: the whole screen, and the pieces that it is divided into. Tab goes through all
// pieces of a screen, in the order in which they are drawn.
#pragma once

#include <imgui_internal.h>

namespace ghostforce {

inline constexpr ImGuiWindowFlags fixed_window =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
inline constexpr ImGuiWindowFlags fixed_bar = fixed_window | ImGuiWindowFlags_NoScrollWithMouse;

struct Rect {
  ImVec2 corner;
  ImVec2 size;
};

// Ends with ImGui::End().
inline void begin_screen(const char* name) {
  ImGui::SetNextWindowPos({0.0F, 0.0F});
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
  ImGui::Begin(name, nullptr, fixed_bar | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PopStyleVar();
}

// Within a screen; ends with ImGui::EndChild(). ImGui::BeginChild() would make a name of its own for it.
inline void begin_piece(const char* name, const Rect& rect, ImGuiWindowFlags flags) {
  ImGui::SetCursorScreenPos(rect.corner);
  ImGui::SetNextWindowSize(rect.size);
  ImGuiNextWindowData& next = ImGui::GetCurrentContext()->NextWindowData;
  next.HasFlags |= ImGuiNextWindowDataFlags_HasChildFlags;
  next.ChildFlags = ImGuiChildFlags_NavFlattened | ImGuiChildFlags_AlwaysUseWindowPadding;
  ImGui::Begin(name, nullptr, flags | ImGuiWindowFlags_ChildWindow);
}

}  // namespace ghostforce
