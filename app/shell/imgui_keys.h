// What Dear ImGui calls a key. Pure, any thread.
#pragma once

#include <imgui.h>

namespace ghostforce {

// Of one of keys.h; ImGuiKey_None where it has no name for it.
ImGuiKey imgui_key(int key) noexcept;

}  // namespace ghostforce
