// The bar at the bottom: where the goal comes from, how the loop keeps time, which scene.
#include <fmt/format.h>

#include "app/panels/controls.h"
#include "app/panels/panel_catalog.h"

namespace ghostforce {

void draw_status_bar(const PanelContext& context) {
  const LoopReading& loop = context.loop;
  std::string words =
      fmt::format("{}   ·   {:5.0f} ticks/s   ·   {} late", loop.input_title, loop.rate_hz, loop.late_ticks);
  if (loop.dropped_samples > 0) words += fmt::format("   ·   {} samples dropped", loop.dropped_samples);
  if (loop.diverged) words += "   ·   unstable: these settings let the device run away; change one, or press R";
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(words.c_str());
  if (!loop.remark.empty()) {
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, unpacked(context.theme.faint_text));
    ImGui::TextUnformatted(fmt::format("  ·   {}", loop.remark).c_str());
    ImGui::PopStyleColor();
  }
  const std::string scene = fmt::format("{}", context.session.scene.title);
  const float width = ImGui::CalcTextSize(scene.c_str()).x;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
  ImGui::TextUnformatted(scene.c_str());
  explain(context.session.scene.about);
}

}  // namespace ghostforce
