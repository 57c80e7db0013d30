#include "app/panels/controls.h"

#include <cmath>
#include <numbers>

namespace ghostforce {

ImU32 packed(Colour colour) {
  return IM_COL32(colour.red, colour.green, colour.blue, colour.alpha);
}

ImVec4 unpacked(Colour colour) {
  return ImGui::ColorConvertU32ToFloat4(packed(colour));
}

void draw_glyph(ImDrawList& draw_list, ImVec2 center, float radius, Shape shape, Colour fill) {
  const ImU32 colour = packed(fill);
  switch (shape) {
    case Shape::disc:
      draw_list.AddCircleFilled(center, radius, colour, 24);
      break;
    case Shape::diamond:
      draw_list.AddNgonFilled(center, 1.25F * radius, colour, 4);
      break;
    case Shape::triangle: {
      const float side = 1.2F * radius;
      draw_list.AddTriangleFilled({center.x, center.y - 1.1F * radius}, {center.x + side, center.y + 0.95F * radius},
                                  {center.x - side, center.y + 0.95F * radius}, colour);
      break;
    }
  }
}

void explain(std::string_view sentence) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip | ImGuiHoveredFlags_AllowWhenDisabled)) return;
  if (!ImGui::BeginTooltip()) return;
  ImGui::PushTextWrapPos(24.0F * ImGui::GetFontSize());
  ImGui::TextUnformatted(sentence.data(), sentence.data() + sentence.size());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

bool begin_rows(const char* id, const PanelContext& context) {
  if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingFixedFit)) return false;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 128.0F * context.scale);
  ImGui::TableSetupColumn("control", ImGuiTableColumnFlags_WidthStretch);
  return true;
}

void row(const char* name, std::string_view sentence) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(name);
  explain(sentence);
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1.0F);
}

void end_rows() {
  ImGui::EndTable();
}

bool stiffness_slider(const char* id, double& newton_per_metre, const SliderLimits& limits) {
  return ImGui::SliderScalar(id, ImGuiDataType_Double, &newton_per_metre, &limits.least, &limits.greatest, "%.0f N/m",
                             ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
}

bool angle_slider(const char* id, double& radians) {
  constexpr double degrees = 180.0 / std::numbers::pi;
  constexpr double least = -180.0;
  constexpr double greatest = 180.0;
  double shown = std::remainder(radians, 2.0 * std::numbers::pi) * degrees;
  if (!ImGui::SliderScalar(id, ImGuiDataType_Double, &shown, &least, &greatest, "%.1f°",
                           ImGuiSliderFlags_AlwaysClamp)) {
    return false;
  }
  radians = shown / degrees;
  return true;
}

}  // namespace ghostforce
