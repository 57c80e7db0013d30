// What mouse and keys do, from the one table of keys.
#include "app/keys.h"
#include "app/panels/controls.h"
#include "app/panels/panel_catalog.h"

namespace ghostforce {
namespace {

void draw_row(const PanelContext& context, std::string_view press, std::string_view sentence) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushFont(context.fonts.bold, 0.0F);
  ImGui::TextUnformatted(press.data(), press.data() + press.size());
  ImGui::PopFont();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(sentence.data(), sentence.data() + sentence.size());
}

}  // namespace

void draw_keys(const PanelContext& context) {
  // Close rows: the whole table fits below the other panels at the window's usual size.
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {ImGui::GetStyle().CellPadding.x, 0.5F * context.scale});
  if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
    if (context.session.pointer_moves_goal) draw_row(context, "Drag", "The goal of your hand follows the pointer");
    for (const KeyBinding& binding : key_table()) draw_row(context, binding.shown, binding.sentence);
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
}

}  // namespace ghostforce
