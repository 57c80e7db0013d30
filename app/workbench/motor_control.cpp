// What shows from three metres away that motors may push, and turns them on and off: a button in the bar and a frame
// round the scene. And how warm they are.
#include "app/workbench/motor_control.h"

#include <algorithm>
#include <string>
#include <variant>

#include <fmt/format.h>

#include "app/state/front_keys.h"
#include "app/state/stage_action.h"
#include "app/state/stage_language.h"
#include "app/widgets/controls.h"
#include "core/motor_heat.h"

namespace ghostforce {
namespace {

constexpr float large_letters = 1.25F;  // of the panels'
constexpr float widest_words = 15.5F;   // large letters of "MOTORS ON. Esc: off" [heights]
constexpr float least_width = 7.0F;     // of the button [heights of a letter]
constexpr float frame_width = 8.0F;     // [points]

bool may_push(const MotorReport& motors) noexcept {
  const bool are_on = motors.state != SafetyState::off && motors.state != SafetyState::arming;
  return motors.has_motors && (are_on || motors.may_still_push);
}

}  // namespace

float motor_button_room(const PanelContext& context) {
  return context.loop.motors.has_motors ? widest_words * ImGui::GetFontSize() : 0.0F;
}

void draw_motor_button(const PanelContext& context, float height) {
  const MotorReport& motors = context.loop.motors;
  const Theme& theme = context.theme;
  const bool is_on = may_push(motors);
  const std::string words = motor_words(motors, english_stage);
  ImFont* const font = is_on ? context.fonts.bold : context.fonts.regular;
  const float padding = ImGui::GetStyle().FramePadding.x;
  const float usual = ImGui::GetFontSize();
  const float wanted =
      motors.has_motors ? motor_button_room(context) : ImGui::CalcTextSize(words.c_str()).x + 2.0F * padding;
  ImGui::SameLine();
  const float room = ImGui::GetContentRegionAvail().x;
  const bool fits = room >= wanted;
  if (!fits && !motors.has_motors) {
    ImGui::NewLine();
    return;  // it says nothing that one has to know
  }
  // With motors it is there, in smaller letters where there is little room.
  const float width = fits ? wanted : std::max(room, least_width * usual);
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
  const bool has_to_be_read = motors.reason != OffReason::none && motors.reason != OffReason::key;
  const bool stands_out = is_on || (motors.has_motors && has_to_be_read) || motors.state == SafetyState::arming;
  const Colour fill = is_on ? theme.problem : theme.panel_field;
  const Colour rim = is_on ? theme.problem : stands_out ? theme.accent : theme.panel_border;
  const std::optional<Action> action = action_of_motor_button(motors);
  ImGui::BeginDisabled(!action);
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, (stands_out ? 2.5F : 1.0F) * context.scale);
  ImGui::PushStyleColor(ImGuiCol_Border, unpacked(rim));
  ImGui::PushStyleColor(ImGuiCol_Button, unpacked(fill));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, unpacked(mix(fill, theme.text, 0.12)));
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, unpacked(mix(fill, theme.text, 0.24)));
  ImGui::PushStyleColor(ImGuiCol_Text, unpacked(is_on ? theme.background : theme.text));
  const float letters = letters_for(words, font, width - 2.0F * padding, (is_on ? large_letters : 1.0F) * usual);
  ImGui::PushFont(font, letters / ImGui::GetStyle().FontScaleMain);
  if (ImGui::Button((words + "###motors").c_str(), {width, height}) && action) context.apply(*action);
  ImGui::PopFont();
  ImGui::PopStyleColor(5);
  ImGui::PopStyleVar();
  ImGui::EndDisabled();
  if (!motors.has_motors) {
    tooltip("No device with a motor is in use: the forces on screen are the model's.");
  } else if (action && std::holds_alternative<OpenDialog>(*action)) {
    tooltip(fmt::format("Says what to do: {}.", front_keys().device_status.shown));
  } else if (motors.state == SafetyState::off && motors.reason != OffReason::none) {
    tooltip(remedy_words(motors, front_keys().device_status.shown));
  } else {
    tooltip(motors.has_focus ? "Lets the device push. Esc is the emergency stop." : "Lets the device push.");
  }
}

void draw_motor_frame(const PanelContext& context) {
  if (!may_push(context.loop.motors)) return;
  const float width = frame_width * context.scale;
  const float inset = 0.5F * width;
  const ImVec2 corner = ImGui::GetWindowPos();
  const ImVec2 end{corner.x + ImGui::GetWindowWidth(), corner.y + ImGui::GetWindowHeight()};
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  draw_list.PushClipRect(corner, end);
  draw_list.AddRect({corner.x + inset, corner.y + inset}, {end.x - inset, end.y - inset}, packed(context.theme.problem),
                    0.0F, 0, width);
  draw_list.PopClipRect();
}

void draw_motor_heat(const PanelContext& context, float end) {
  const Theme& theme = context.theme;
  const double heat = std::ranges::max(context.loop.motors.heat);
  const bool is_too_much = heat > 1.0;
  const float left = ImGui::GetCursorPosX();
  const float width = (end > 0.0F ? end : ImGui::GetContentRegionMax().x) - left;
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram,
                        unpacked(mix(theme.panel_field, is_too_much ? theme.problem : theme.accent, 0.42)));
  ImGui::ProgressBar(static_cast<float>(std::min(heat, 1.0)), {width, 0.0F},
                     fmt::format("Heat: {:.0f} %", 100.0 * heat).c_str());
  ImGui::PopStyleColor();
  tooltip(fmt::format(
      "Of the warmest motor, estimated from what it was told to give: the mean square over the last {:.0f} s or so. At "
      "100 % it is as warm as {:.0f} % of full power makes it in the end. Both numbers are assumed.",
      motor_heat_time_constant_s, 100.0 * motor_continuous_share));
  wrapped_text(is_too_much ? "The motors have given more than they may for long. Let them rest."
                           : "Estimated; no temperature is measured. Above 100 %, let the motors rest.",
               end);
}

void draw_motor_words(const PanelContext& context) {
  if (!may_push(context.loop.motors)) return;
  const std::string words = motor_words(context.loop.motors, stage_language(context.session.language));
  ImFont* const font = context.fonts.bold;
  const float height = 2.0F * ImGui::GetFontSize();
  const ImVec2 extent = font->CalcTextSizeA(height, 1e9F, 0.0F, words.c_str());
  const ImVec2 whole = ImGui::GetIO().DisplaySize;
  const ImVec2 at{0.5F * (whole.x - extent.x), 0.5F * (whole.y - extent.y)};
  ImGui::GetWindowDrawList()->AddText(font, height, at, packed(context.theme.problem), words.c_str());
}

void draw_zero_pose(const PanelContext& context) {
  if (!context.loop.motors.waits_for_zero_pose) return;
  // The sentence beside it is in English too.
  const std::string words(english_stage.motors.zero_pose);
  if (ImGui::Button(words.c_str())) context.apply(ConfirmZeroPose{});
}

}  // namespace ghostforce
