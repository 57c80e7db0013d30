// The texture that Dear ImGui keeps its letters in. UI thread.
#pragma once

#include <imgui.h>

namespace ghostforce {

// Makes the empty texels of new textures white and transparent, where Dear ImGui leaves them black and transparent.
// Letters between pixels blend with the texels around them: black ones darkened a letter's edges, and a pale halo had
// grey lines and dots beside it. Between ImGui::Render() and the backend's drawing, which uploads the textures.
void whiten_empty_texels(const ImDrawData& drawing);

}  // namespace ghostforce
