// F1: what mouse and keys do, from the one table of each, in two columns.
#include <algorithm>
#include <string>
#include <vector>

#include "app/keys.h"
#include "app/panels/controls.h"
#include "app/panels/dialogs.h"

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

void draw_lines(const char* id, std::span<const HelpLine> lines, const PanelContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {6.0F * context.scale, 2.0F * context.scale});
  if (ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoHostExtendX)) {
    for (const HelpLine& line : lines) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::PushFont(context.fonts.bold, 0.0F);
      ImGui::TextUnformatted(line.press.data(), line.press.data() + line.press.size());
      ImGui::PopFont();
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
  // One above the other where the window is too narrow for both.
  const bool is_wide = ImGui::GetIO().DisplaySize.x > 980.0F * context.scale;
  draw_lines("left", all.first(half), context);
  if (is_wide) ImGui::SameLine(0.0F, 18.0F * context.scale);
  draw_lines("right", all.subspan(half), context);
  ImGui::PushStyleColor(ImGuiCol_Text, unpacked(context.theme.faint_text));
  ImGui::TextUnformatted("Every name and every mark explains itself when the pointer rests on it.");
  ImGui::PopStyleColor();
}

}  // namespace ghostforce
