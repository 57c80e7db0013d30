// F1: what mouse and keys do, from the one table of each, in two columns.
#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "app/session/key_bindings.h"
#include "app/ui/panels/dialogs.h"
#include "app/ui/widgets/controls.h"

namespace ghostforce {
namespace {

struct HelpLine {
  std::string_view press;
  std::string_view sentence;
};

std::vector<HelpLine> help_lines() {
  std::vector<HelpLine> lines;
  for (const MouseGesture& gesture : mouse_table()) lines.push_back({gesture.shown, gesture.sentence});
  for (const KeyBinding& binding : key_table()) {
    if (!binding.shown.empty()) lines.push_back({binding.shown, binding.sentence});
  }
  return lines;
}

constexpr std::string_view subject =
    "A hand (the goal) presses a handle (the device) into a virtual wall. The device senses both directions, but its "
    "motor pushes "
    "in one only. Rendered as usual, the device follows its one motor sideways, the proxy follows the device along the "
    "wall, and the motor pulls after it: a ghost force. The cure lets the proxy follow more softly across the motor, "
    "by the ratio ρ*, so that it stays straight in front of the goal, and the motor has nothing more to pull than it "
    "should.";

void draw_lines(const char* id, std::span<const HelpLine> lines, float first_column, const PanelContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {6.0F * context.scale, 2.0F * context.scale});
  if (ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoHostExtendX)) {
    ImGui::TableSetupColumn("press", ImGuiTableColumnFlags_WidthFixed, first_column);
    for (const HelpLine& line : lines) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      text_in(context.fonts.bold, line.press);
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(line.sentence.data(), line.sentence.data() + line.sentence.size());
    }
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
}

}  // namespace

void draw_help(const PanelContext& context) {
  const std::vector<HelpLine> lines = help_lines();
  const std::span<const HelpLine> all(lines);
  const std::size_t half = (all.size() + 1) / 2;
  // The same in both, so that they read as one list where they stand above each other.
  const float first_column =
      context.fonts.bold->CalcTextSizeA(ImGui::GetFontSize(), 1e9F, 0.0F, "Ctrl+click a slider").x;
  // One above the other where the window is too narrow for both.
  const bool is_wide = ImGui::GetIO().DisplaySize.x > 980.0F * context.scale;
  const float widest = ImGui::GetIO().DisplaySize.x - 80.0F * context.scale;
  wrapped_text(subject, std::min((is_wide ? 930.0F : 520.0F) * context.scale, widest));
  ImGui::Spacing();
  draw_lines("left", all.first(half), first_column, context);
  if (is_wide) ImGui::SameLine(0.0F, 18.0F * context.scale);
  draw_lines("right", all.subspan(half), first_column, context);
  text_in(context.theme.faint_text,
          "On the workbench every name and every mark explains itself when the pointer rests on it.");
}

}  // namespace ghostforce
