// The bar on top: which strategy is on the device, what is compared, and how time runs.
#include <fmt/format.h>

#include <array>

#include "app/keys.h"
#include "app/panels/controls.h"
#include "app/panels/panel_catalog.h"

namespace ghostforce {
namespace {

// Too narrow for captions in full: letters must do.
bool is_narrow(const PanelContext& context) {
  return ImGui::GetWindowWidth() < 960.0F * context.scale;
}

void draw_strategy_button(const PanelContext& context, const Strategy& entry, float height) {
  const std::size_t i = index_of(entry.id);
  const bool active = entry.id == context.session.settings.active;
  const std::string words =
      is_narrow(context) ? std::string(1, entry.letter) : fmt::format("{} {}", entry.letter, entry.title);
  const float glyph = 0.4F * ImGui::GetFontSize();
  const float key_width = 1.5F * ImGui::GetFontSize();
  ImGui::PushFont(active ? context.fonts.bold : context.fonts.regular, 0.0F);
  // As wide as the bold words, so that choosing does not make the bar jump.
  const float words_width = context.fonts.bold->CalcTextSizeA(ImGui::GetFontSize(), 1e9F, 0.0F, words.c_str()).x;
  const ImVec2 size{key_width + 2.6F * glyph + words_width + 1.4F * ImGui::GetFontSize(), height};
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::PushID(static_cast<int>(i));
  if (ImGui::InvisibleButton("strategy", size)) context.session.settings.active = entry.id;
  ImGui::PopID();
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const ImVec2 end{corner.x + size.x, corner.y + size.y};
  const float rounding = ImGui::GetStyle().FrameRounding;
  const double tint = active ? 0.22 : hovered ? 0.12 : 0.0;
  draw_list.AddRectFilled(corner, end, packed(mix(context.theme.panel_field, context.theme.strategy[i], tint)),
                          rounding);
  draw_list.AddRect(corner, end, packed(active ? context.theme.strategy[i] : context.theme.panel_border), rounding, 0,
                    (active ? 2.0F : 1.0F) * context.scale);
  const float text_y = corner.y + 0.5F * (size.y - ImGui::GetFontSize());
  const float pad = 0.5F * ImGui::GetFontSize();
  draw_list.AddText({corner.x + pad, text_y}, packed(context.theme.faint_text), fmt::format("{}", i + 1).c_str());
  draw_glyph(draw_list, {corner.x + key_width + glyph, corner.y + 0.5F * size.y}, glyph, strategy_style(entry.id).shape,
             context.theme.strategy[i]);
  draw_list.AddText({corner.x + key_width + 2.6F * glyph + 0.3F * pad, text_y},
                    packed(active ? context.theme.strategy_text[i] : context.theme.text), words.c_str());
  ImGui::PopFont();
  explain(entry.sentence);
  ImGui::SameLine();
}

// As wide as the wider of its two captions.
bool two_faced_button(const char* caption, const char* other, const char* id, float height) {
  const float width =
      std::max(ImGui::CalcTextSize(caption).x, ImGui::CalcTextSize(other).x) + 2.0F * ImGui::GetStyle().FramePadding.x;
  const bool pressed = ImGui::Button(fmt::format("{}###{}", caption, id).c_str(), {width, height});
  return pressed;
}

void draw_speed(Session& session, float height) {
  constexpr std::array speeds{1.0, 0.5, 0.2, 0.1, 0.02};
  ImGui::SetNextItemWidth(4.6F * ImGui::GetFontSize());
  const float pad = 0.5F * (height - ImGui::GetFontSize());
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, pad});
  if (ImGui::BeginCombo("##speed", fmt::format("{:g}×", session.speed).c_str())) {
    for (const double speed : speeds) {
      if (ImGui::Selectable(fmt::format("{:g}×", speed).c_str(), speed == session.speed)) session.speed = speed;
    }
    ImGui::EndCombo();
  }
  ImGui::PopStyleVar();
  explain("Speed of model time: fewer ticks per second, never longer ones.");
}

}  // namespace

void draw_strategy_bar(const PanelContext& context) {
  Session& session = context.session;
  const float height = 30.0F * context.scale;
  for (const Strategy& entry : strategy_catalog()) draw_strategy_button(context, entry, height);

  ImGui::SameLine(0.0F, 14.0F * context.scale);
  const bool overlay = session.compare == Compare::overlay;
  const bool narrow = is_narrow(context);
  const char* all = narrow ? "All" : "Compare: all";
  const char* active = narrow ? "Active" : "Compare: active";
  if (two_faced_button(overlay ? all : active, overlay ? active : all, "compare", height)) {
    toggle_compare(session);
  }
  explain("All strategies in one picture, or the active one only. Key 0.");
  ImGui::SameLine(0.0F, 14.0F * context.scale);
  if (two_faced_button(session.paused ? "Go on" : "Pause", session.paused ? "Pause" : "Go on", "pause", height)) {
    toggle_pause(session);
  }
  explain("Stops model time, and lets it go on. Space.");
  ImGui::SameLine();
  if (ImGui::Button("Step", {0.0F, height})) single_step(session);
  explain("One tick of the loop, then pause. The key is the full stop.");
  ImGui::SameLine();
  draw_speed(session, height);
  ImGui::SameLine();
  if (ImGui::Button("Reset", {0.0F, height})) restart(session);
  explain("Starts the motion again. Key R; Alt+R resets the settings too.");

  const char* no_motor = "no motor";
  const float width = ImGui::CalcTextSize(no_motor).x + 2.0F * ImGui::GetStyle().FramePadding.x;
  ImGui::SameLine();
  if (ImGui::GetContentRegionAvail().x < width) {
    ImGui::NewLine();
    return;  // it says nothing that one has to know
  }
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
  ImGui::BeginDisabled();
  ImGui::Button(no_motor, {width, height});
  ImGui::EndDisabled();
  explain("No device with a motor is in use: the forces on screen are the model's.");
}

}  // namespace ghostforce
