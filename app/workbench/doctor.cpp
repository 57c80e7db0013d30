// F2: the readiness of the device, step by step, from nothing to motors that push: what is reached, what is next, and
// what to do.
#include <string>

#include "app/state/device_status.h"
#include "app/widgets/controls.h"
#include "app/workbench/dialogs.h"
#include "app/workbench/motor_control.h"

namespace ghostforce {
namespace {

// A tick, an arrow head or an empty ring: told apart by form.
void draw_sign(const PanelContext& context, const ReadinessStepState& step) {
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const float height = ImGui::GetTextLineHeight();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 middle{corner.x + 0.5F * height, corner.y + 0.5F * height};
  const float unit = 0.3F * height;
  const float stroke = 0.14F * height;
  const Colour colour = step.is_current ? context.theme.accent : context.theme.text;
  if (step.is_reached) {
    const ImVec2 knee{middle.x - 0.3F * unit, middle.y + 0.8F * unit};
    draw_list.AddLine({middle.x - unit, middle.y}, knee, packed(colour), stroke);
    draw_list.AddLine(knee, {middle.x + unit, middle.y - 0.8F * unit}, packed(colour), stroke);
  } else if (step.is_current) {
    draw_list.AddTriangleFilled({middle.x - 0.6F * unit, middle.y - unit}, {middle.x + unit, middle.y},
                                {middle.x - 0.6F * unit, middle.y + unit}, packed(colour));
  } else {
    draw_list.AddCircle(middle, 0.7F * unit, packed(context.theme.faint_text), 16, 0.6F * stroke);
  }
  ImGui::Dummy({height, height});
}

void draw_step(const PanelContext& context, const ReadinessStepState& step, float end) {
  draw_sign(context, step);
  ImGui::SameLine();
  text_in(step.is_current ? context.fonts.bold : context.fonts.regular, step.title);
  if (step.words.empty()) return;
  ImGui::SameLine(250.0F * context.scale);  // beside the longest title
  wrapped_text(step.words, end);
}

}  // namespace

void draw_doctor(const PanelContext& context) {
  const float width = dialog_field_width(560.0F, context);
  const float end = ImGui::GetCursorPosX() + width;
  ImGui::PushTextWrapPos(end);
  if (context.loop.readiness.empty()) {
    ImGui::TextUnformatted(why_no_readiness(context.loop).c_str());
  } else {
    text_in(context.fonts.bold, context.loop.device);
    ImGui::Spacing();
    for (const ReadinessStepState& step : context.loop.readiness) draw_step(context, step, end);
    draw_zero_pose(context);
    ImGui::Spacing();
    draw_motor_heat(context, end);
    if (!context.loop.device_remark.empty()) ImGui::TextUnformatted(context.loop.device_remark.c_str());
  }
  ImGui::PopTextWrapPos();
  ImGui::Dummy({width, 1.0F});
}

}  // namespace ghostforce
