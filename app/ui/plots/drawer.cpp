#include "app/ui/plots/drawer.h"

#include <array>

#include "app/session/measurement_guide.h"
#include "app/ui/widgets/controls.h"

namespace ghostforce {
namespace {

struct Tab {
  PlotTab id;
  const char* title;
  const char* short_title;  // where there is no room for all
  std::string_view sentence;
  void (*draw)(const PanelContext& context, const PlotHistory& history);
};

constexpr std::array tabs{
    Tab{PlotTab::time, "Time", "Time",
        "The recent past. Turn the wheel to show more or less time, drag to look back, and click to see a moment "
        "again.",
        draw_time_plots},
    Tab{PlotTab::wall_angle, "Wall angle", "Angle",
        "Where everything would come to rest with the wall at another angle and the goal at the same depth. Drag to "
        "turn the wall and the goal with it; hold Ctrl for steps of less than a degree.",
        [](const PanelContext& context, const PlotHistory&) { draw_wall_angle_plots(context); }},
    Tab{PlotTab::ratio, "Ratio ρ", "ρ",
        "Where everything would come to rest at another tracking ratio. Drag to change the ratio.",
        [](const PanelContext& context, const PlotHistory&) { draw_ratio_plots(context); }},
};

void draw_buttons(const PanelContext& context) {
  PlotView& view = context.session.plots;
  const float pad = 2.0F * ImGui::GetStyle().FramePadding.x;
  const float live = ImGui::CalcTextSize("Live").x + pad;
  const float save = ImGui::CalcTextSize("Save…").x + pad;
  const float close = ImGui::CalcTextSize("×").x + pad;
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - live - save - close - 2.0F * spacing);
  std::optional<double>& looks_back_to_s = context.session.stage.looks_back_to_s;
  ImGui::BeginDisabled((view.follows && !looks_back_to_s) || view.tab != PlotTab::time);
  if (ImGui::Button("Live")) {
    view.follows = true;
    looks_back_to_s.reset();
  }
  ImGui::EndDisabled();
  tooltip("Back to the newest moment, at the right edge.");
  ImGui::SameLine();
  if (ImGui::Button("Save…")) context.session.dialog = Dialog::save_plots;
  tooltip("Saves what is shown, as numbers (CSV) or as a picture (PNG, SVG, PDF).");
  ImGui::SameLine();
  if (ImGui::Button("×")) view.is_open = false;
  tooltip("Closes the plots. F3 opens them again.");
}

}  // namespace

void draw_plots(const PanelContext& context, const PlotHistory& history) {
  PlotView& view = context.session.plots;
  const bool has_room = ImGui::GetContentRegionAvail().x > 29.0F * ImGui::GetFontSize();
  for (const Tab& tab : tabs) {
    const bool is_chosen = tab.id == view.tab;
    const char* const title = has_room ? tab.title : tab.short_title;
    // As wide as the bold words, so that choosing does not make them jump.
    const float words = context.fonts.bold->CalcTextSizeA(ImGui::GetFontSize(), 1e9F, 0.0F, title).x;
    const float width = words + 2.0F * ImGui::GetStyle().FramePadding.x;
    ImGui::PushFont(is_chosen ? context.fonts.bold : context.fonts.regular, 0.0F);
    if (is_chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    if (ImGui::Button(title, {width, 0.0F})) view.tab = tab.id;
    if (is_chosen) ImGui::PopStyleColor();
    ImGui::PopFont();
    tooltip(tab.sentence);
    ImGui::SameLine();
  }
  draw_buttons(context);
  // Curves of theory know the hand.
  if (view.tab != PlotTab::time && (hides_answer(context.session) || is_measuring(context.session))) {
    wrapped_text("These curves are hidden while the hand is measured: they would show the answer.");
    return;
  }
  tabs[static_cast<std::size_t>(view.tab)].draw(context, history);
}

}  // namespace ghostforce
