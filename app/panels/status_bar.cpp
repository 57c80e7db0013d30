// The bar at the bottom: where the goal comes from, how the loop keeps time, which scene.
#include <fmt/format.h>

#include "app/panels/controls.h"
#include "app/panels/panel_catalog.h"

namespace ghostforce {

void draw_status_bar(const PanelContext& context) {
  const LoopReading& loop = context.loop;
  std::string words = fmt::format("{}   ·   t = {:.3f} s   ·   {:5.0f} ticks/s   ·   {} late", loop.input_title,
                                  context.snapshot.time_s, loop.rate_hz, loop.late_ticks);
  if (loop.dropped_samples > 0) words += fmt::format("   ·   {} samples dropped", loop.dropped_samples);
  if (loop.diverged) words += "   ·   unstable: the device runs away; change a setting, or press Alt+R";
  const std::string remark = loop.remark.empty() ? "" : fmt::format("   ·   {}", loop.remark);
  const std::string& title = context.session.scene.title;
  const auto width = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };

  // What does not fit is left out, least important first.
  const float room = ImGui::GetContentRegionAvail().x - width(words);
  const bool title_fits = width(title) + 2.0F * ImGui::GetFontSize() <= room;
  const bool remark_fits = width(remark) + (title_fits ? width(title) + 2.0F * ImGui::GetFontSize() : 0.0F) <= room;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(words.c_str());
  if (remark_fits) {
    ImGui::SameLine(0.0F, 0.0F);
    ImGui::PushStyleColor(ImGuiCol_Text, unpacked(context.theme.faint_text));
    ImGui::TextUnformatted(remark.c_str());
    ImGui::PopStyleColor();
  }
  if (title_fits) {
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width(title));
    ImGui::TextUnformatted(title.c_str());
    explain(context.session.scene.about);
  }
}

}  // namespace ghostforce
