#include "app/workbench/drawer.h"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "app/files/file_exchange.h"
#include "app/state/front_keys.h"
#include "app/state/user_measurement_guide.h"
#include "app/widgets/controls.h"

namespace ghostforce {
namespace {

struct Tab {
  PlotTab id;
  const char* title;
  const char* short_title;  // where there is no room for all
  std::string_view sentence;
  void (*draw)(const PanelContext& context, const History& history);
};

constexpr std::array tabs{
    Tab{PlotTab::time, "Time", "Time",
        "The last minute. Turn the wheel to show more or less time, and drag. Click to look back at a moment.",
        [](const PanelContext& context, const History& history) { draw_time_plots(context, history.plots()); }},
    Tab{PlotTab::wall_angle, "Wall angle", "Angle",
        "Where everything would come to rest with the wall at another angle and the goal at the same depth. Drag to "
        "turn the wall; a goal that the mouse leads turns with it. Hold Ctrl for steps of less than a degree.",
        [](const PanelContext& context, const History&) { draw_wall_angle_plots(context); }},
    Tab{PlotTab::ratio, "Ratio ρ", "ρ",
        "Where everything would come to rest at another tracking ratio. Drag to change the ratio.",
        [](const PanelContext& context, const History&) { draw_ratio_plots(context); }},
    Tab{PlotTab::hand, "Hand", "Hand",
        "How stiff the hand has been found to be, with a band of one standard deviation to either side, what was "
        "believed of it, and what a simulated hand was given. Wheel, drag and click as over time.",
        draw_hand_plot},
};

constexpr const char* live_words = "Live";
constexpr const char* save_words = "Save…";
constexpr const char* close_words = "×";

float width_of(ImFont* font, const char* words) {
  return font->CalcTextSizeA(ImGui::GetFontSize(), 1e9F, 0.0F, words).x + 2.0F * ImGui::GetStyle().FramePadding.x;
}

float width_of(const char* words) {
  return width_of(ImGui::GetFont(), words);
}

// As wide as the bold words, so that choosing does not make them jump.
float width_of_tabs(const PanelContext& context, const char* Tab::*title) {
  float width = 0.0F;
  for (const Tab& tab : tabs) width += width_of(context.fonts.bold, tab.*title) + ImGui::GetStyle().ItemSpacing.x;
  return width - ImGui::GetStyle().ItemSpacing.x;
}

std::string words_of_span(double span_s) {
  return fmt::format("{:.3g} s", span_s);
}

float width_of_span() {
  return width_of("0.02 s") + ImGui::GetFrameHeight();
}

float width_of_buttons(PlotTab tab) {
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float others = width_of(live_words) + width_of(save_words) + width_of(close_words) + 2.0F * spacing;
  return is_over_time(tab) ? width_of_span() + spacing + others : others;
}

void draw_tabs(const PanelContext& context, const char* Tab::*title) {
  PlotView view = context.session.plots;
  for (const Tab& tab : tabs) {
    if (&tab != tabs.data()) ImGui::SameLine();
    const bool is_chosen = tab.id == view.tab;
    ImGui::PushFont(is_chosen ? context.fonts.bold : context.fonts.regular, 0.0F);
    if (is_chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    if (ImGui::Button(tab.*title, {width_of(context.fonts.bold, tab.*title), 0.0F})) {
      view.tab = tab.id;
      context.apply(ChangePlots{view});
    }
    if (is_chosen) ImGui::PopStyleColor();
    ImGui::PopFont();
    tooltip(tab.sentence);
  }
}

// The wheel's choice once more, for the keyboard.
void draw_span(const PanelContext& context) {
  PlotView view = context.session.plots;
  constexpr std::array spans_s{0.1, 0.5, 1.0, 2.0, 4.0, 10.0, 30.0, 60.0};
  ImGui::SetNextItemWidth(width_of_span());
  const std::string shown = words_of_span(view.span_s());
  if (ImGui::BeginCombo("##span", shown.c_str())) {
    close_popup_on_escape();
    for (const double span_s : spans_s) {
      const std::string words = words_of_span(span_s);
      if (ImGui::Selectable(words.c_str(), words == shown)) {
        view.set_span(span_s);
        context.apply(ChangePlots{view});
      }
      if (words == shown) ImGui::SetItemDefaultFocus();
    }
    ImGui::EndCombo();
  }
  tooltip("How long a time is in sight. The wheel changes it too.");
}

// At the right edge of the line.
void draw_buttons(const PanelContext& context) {
  const PlotView& view = context.session.plots;
  const float first = ImGui::GetContentRegionMax().x - width_of_buttons(view.tab);
  ImGui::SetCursorPosX(std::max(first, ImGui::GetCursorPosX()));
  if (is_over_time(view.tab)) {
    draw_span(context);
    ImGui::SameLine();
  }
  ImGui::BeginDisabled((view.follows && !context.session.stage.looks_back_to_s) || !is_over_time(view.tab));
  if (ImGui::Button(live_words)) context.apply(FollowNewest{});
  ImGui::EndDisabled();
  tooltip("Back to the newest moment, at the right edge.");
  ImGui::SameLine();
  if (ImGui::Button(save_words)) context.apply(OpenDialog{Dialog::save_plots});
  tooltip(save_place().paints_files ? "Saves what is shown, as numbers (CSV) or as a picture (PNG, SVG, PDF)."
                                    : "Saves what is shown, as numbers (CSV).");
  ImGui::SameLine();
  if (ImGui::Button(close_words)) context.apply(TogglePlots{});
  tooltip(fmt::format("Closes the plots. {} opens them again.", front_keys().plots.shown));
}

}  // namespace

void draw_plots(const PanelContext& context, const History& history) {
  const PlotView& view = context.session.plots;
  const float room = ImGui::GetContentRegionAvail().x;
  const float gap = 2.0F * ImGui::GetStyle().ItemSpacing.x;
  // Short words first; then a line of their own for the buttons.
  const float beside = room - gap - width_of_buttons(PlotTab::time);
  const bool has_one_line = width_of_tabs(context, &Tab::short_title) <= beside;
  const bool has_long_words = width_of_tabs(context, &Tab::title) <= (has_one_line ? beside : room);
  draw_tabs(context, has_long_words ? &Tab::title : &Tab::short_title);
  if (has_one_line) ImGui::SameLine();
  draw_buttons(context);
  if (hides_curves(context.session)) {
    wrapped_text("These curves are hidden while the hand is measured: they would show the answer.");
    return;
  }
  if (!is_over_time(view.tab) && is_general(context.session.settings)) {
    wrapped_text(english_stage.refusals.not_with_this_device);
    return;
  }
  tabs[static_cast<std::size_t>(view.tab)].draw(context, history);
}

}  // namespace ghostforce
