
#include <imgui.h>

#include "app/widgets/controls.h"

namespace ghostforce {

void apply_style(const Theme& theme, float scale) {
  constexpr float font_height = 15.0F;
  ImGuiStyle style;
  if (theme.dark) {
    ImGui::StyleColorsDark(&style);
  } else {
    ImGui::StyleColorsLight(&style);
  }
  style.WindowRounding = 0.0F;
  style.WindowBorderSize = 0.0F;
  style.ChildBorderSize = 0.0F;
  style.FrameRounding = 4.0F;
  style.GrabRounding = 4.0F;
  style.FrameBorderSize = 1.0F;
  style.FramePadding = {8.0F, 4.0F};
  style.ItemSpacing = {8.0F, 5.0F};
  style.CellPadding = {5.0F, 3.0F};
  style.WindowPadding = {12.0F, 8.0F};
  style.GrabMinSize = 14.0F;
  style.DisabledAlpha = 0.75F;
  style.AntiAliasedLinesUseTex = false;
  style.ScaleAllSizes(scale);
  style.FontSizeBase = font_height;
  style.FontScaleMain = scale;

  const auto set = [&](ImGuiCol which, Colour colour) { style.Colors[which] = unpacked(colour); };
  const Colour hovered = mix(theme.panel_field, theme.accent, 0.16);
  const Colour pressed = mix(theme.panel_field, theme.accent, 0.32);
  set(ImGuiCol_Text, theme.text);
  set(ImGuiCol_TextDisabled, theme.faint_text);
  set(ImGuiCol_WindowBg, theme.panel);
  set(ImGuiCol_ChildBg, theme.panel);
  set(ImGuiCol_PopupBg, theme.panel_field);
  set(ImGuiCol_Border, theme.panel_border);
  set(ImGuiCol_FrameBg, theme.panel_field);
  set(ImGuiCol_FrameBgHovered, hovered);
  set(ImGuiCol_FrameBgActive, pressed);
  set(ImGuiCol_Button, theme.panel_field);
  set(ImGuiCol_ButtonHovered, hovered);
  set(ImGuiCol_ButtonActive, pressed);
  set(ImGuiCol_Header, hovered);
  set(ImGuiCol_HeaderHovered, hovered);
  set(ImGuiCol_HeaderActive, pressed);
  // Pale enough to read the slider's number through it.
  set(ImGuiCol_SliderGrab, mix(theme.panel_field, theme.accent, 0.3));
  set(ImGuiCol_SliderGrabActive, mix(theme.panel_field, theme.accent, 0.42));
  set(ImGuiCol_CheckMark, theme.accent);
  set(ImGuiCol_NavCursor, theme.accent.with_alpha(0));  // the ring is drawn by draw_focus_ring()
  set(ImGuiCol_TitleBg, theme.panel_border);
  set(ImGuiCol_TitleBgActive, theme.panel_border);
  set(ImGuiCol_TextSelectedBg, mix(theme.panel_field, theme.accent, 0.4));
  set(ImGuiCol_ScrollbarBg, theme.panel);
  set(ImGuiCol_ScrollbarGrab, theme.panel_border);
  set(ImGuiCol_ScrollbarGrabHovered, mix(theme.panel_border, theme.text, 0.3));
  set(ImGuiCol_ScrollbarGrabActive, mix(theme.panel_border, theme.text, 0.5));
  set(ImGuiCol_Separator, theme.panel_border);
  set(ImGuiCol_TableBorderLight, theme.panel_border);
  ImGui::GetStyle() = style;
}

}  // namespace ghostforce
