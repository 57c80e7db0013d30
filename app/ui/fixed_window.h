// Windows of Dear ImGui that stand still: the pieces that the screen is divided into.
#pragma once

#include <imgui.h>

namespace ghostforce {

inline constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                                 ImGuiWindowFlags_NoBringToFrontOnFocus;

struct Rect {
  ImVec2 corner;
  ImVec2 size;
};

inline void begin_fixed(const char* name, const Rect& rect, ImGuiWindowFlags more = 0) {
  ImGui::SetNextWindowPos(rect.corner);
  ImGui::SetNextWindowSize(rect.size);
  ImGui::Begin(name, nullptr, fixed_window | more);
}

}  // namespace ghostforce
