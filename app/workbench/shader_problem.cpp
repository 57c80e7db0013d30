// What an author of shaders needs to see: what the driver said, and which line it meant.
#include "app/widgets/controls.h"
#include "app/workbench/dialogs.h"

namespace ghostforce {

void draw_shader_problem(const PanelContext& context, ImVec2 corner, ImVec2 size) {
  const std::string_view problem = context.loop.shader_problem;
  if (problem.empty()) return;
  const float margin = 14.0F * context.scale;
  ImGui::SetNextWindowPos({corner.x + margin, corner.y + 0.45F * size.y});
  ImGui::SetNextWindowSize({size.x - 2.0F * margin, 0.55F * size.y - margin});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 2.0F * context.scale);
  ImGui::PushStyleColor(ImGuiCol_Border, unpacked(context.theme.problem));
  ImGui::Begin("The shaders do not compile; the previous ones are in use", nullptr,
               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoFocusOnAppearing);
  text_in(context.fonts.number, problem);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace ghostforce
