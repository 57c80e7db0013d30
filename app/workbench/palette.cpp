// Ctrl+P: every Action by its words. The field has the keyboard; the arrows move a mark through what is found, Enter
// does what is marked. What cannot be done at the moment is dimmed, and says why below the list while it is marked.
#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "app/state/palette_catalog.h"
#include "app/widgets/controls.h"
#include "app/widgets/symbol_text.h"
#include "app/workbench/dialogs.h"
#include "app/workbench/panel_catalog.h"

namespace ghostforce {
namespace {

constexpr float palette_width = 620.0F;    // [points]
constexpr float rest_of_palette = 170.0F;  // title, field, sentence and margins [points]
constexpr float lines_of_refusal = 2.0F;

// Closed first: what is done may open another dialog.
void choose(const PaletteEntry& entry, const PanelContext& context) {
  if (!entry.refusal.empty()) return;
  context.apply(CloseDialog{});
  if (std::holds_alternative<StartRecording>(entry.action)) {
    toggle_recording(context);  // which finds a new file's name
  } else {
    context.apply(entry.action);
  }
}

// True when it was pressed.
bool draw_entry(const PanelContext& context, const PaletteEntry& entry, int id, ImVec2 size, bool is_marked) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::PushID(id);
  const bool pressed = ImGui::InvisibleButton("entry", size);
  ImGui::PopID();
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const Theme& theme = context.theme;
  const ImVec2 end{corner.x + size.x, corner.y + size.y};
  if (is_marked) {
    draw_list.AddRectFilled(corner, end, packed(mix(theme.panel_field, theme.accent, 0.2)));
    draw_list.AddRectFilled(corner, {corner.x + 3.0F * context.scale, end.y}, packed(theme.accent));
  }
  const float padding = 8.0F * context.scale;
  const float y = corner.y + 0.5F * (size.y - ImGui::GetFontSize());
  const float key_width = entry.key.empty() ? 0.0F : ImGui::CalcTextSize(entry.key.c_str()).x + padding;
  const std::string words =
      as_much_as_fits(entry.words, {size.x - 2.0F * padding - key_width, ImGui::GetTextLineHeight()});
  const Colour colour = entry.refusal.empty() ? theme.text : theme.faint_text;
  draw_symbol_text(draw_list, {corner.x + padding, y}, packed(colour), words);
  draw_list.AddText({end.x - key_width, y}, packed(theme.faint_text), entry.key.c_str());
  return pressed;
}

// By the arrows; true when it has moved.
bool move_palette_mark(std::size_t& mark, std::size_t count) {
  const std::size_t before = mark;
  if (ImGui::IsKeyPressed(ImGuiKey_DownArrow) && mark + 1 < count) ++mark;
  if (ImGui::IsKeyPressed(ImGuiKey_UpArrow) && mark > 0) --mark;
  return mark != before;
}

// Pages and the wheel move the list, and the mark stays in sight.
std::size_t mark_in_sight(std::size_t mark, float row, float height) {
  const auto first = static_cast<std::size_t>(std::ceil(ImGui::GetScrollY() / row));
  const auto end = static_cast<std::size_t>(std::floor((ImGui::GetScrollY() + height) / row));
  return std::clamp(mark, first, std::max(first + 1, end) - 1);
}

// The number among those found of what was pressed; else their count.
std::size_t draw_found(const PanelContext& context, const std::vector<PaletteEntry>& entries,
                       const std::vector<std::size_t>& found, float width, bool has_moved) {
  std::size_t& mark = context.memory.form.marked_action;
  const float row = ImGui::GetFrameHeight();
  const float room = ImGui::GetIO().DisplaySize.y - rest_of_palette * context.scale;
  const float height = std::max(row, std::floor(room));
  std::size_t pressed = found.size();
  ImGui::BeginChild("found", {width, height}, ImGuiChildFlags_None, ImGuiWindowFlags_NoNav);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.0F});
  if (has_moved) {
    const float top = row * static_cast<float>(mark);
    ImGui::SetScrollY(std::clamp(ImGui::GetScrollY(), std::max(0.0F, top + row - height), top));
  } else {
    mark = mark_in_sight(mark, row, height);
  }
  if (found.empty()) {
    wrapped_text(stage_language(context.session.language).palette.nothing);
  } else {
    mark = std::min(mark, found.size() - 1);
  }
  const ImVec2 size{ImGui::GetContentRegionAvail().x, row};
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (draw_entry(context, entries[found[i]], static_cast<int>(i), size, i == mark)) pressed = i;
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    if (ImGui::IsItemHovered() && (moved.x != 0.0F || moved.y != 0.0F)) mark = i;
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
  return pressed;
}

}  // namespace

void draw_palette(const PanelContext& context) {
  const Session& session = context.session;
  Form& form = context.memory.form;
  const StageLanguage::Palette& said = stage_language(session.language).palette;
  const std::vector<PaletteEntry> entries = palette_catalog(session, context.loop);
  const float width = dialog_field_width(palette_width, context);
  const std::string sought_before = form.sought;
  const bool is_new = form.belongs_to != Dialog::palette;
  ImGui::SetNextItemWidth(width);
  // After a click into the list, too.
  if (is_new || !ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
  const bool entered = search_field("##sought", said.hint.data(), form.sought);
  const bool is_active = ImGui::IsItemActive();
  const std::vector<std::size_t> found = find_in_palette(entries, form.sought);
  const bool is_other = is_new || form.sought != sought_before;
  if (is_other) form.marked_action = 0;
  const bool has_moved = (is_active && move_palette_mark(form.marked_action, found.size())) || is_other;
  std::size_t chosen = draw_found(context, entries, found, width, has_moved);
  const std::string refusal = found.empty() ? "" : entries[found[form.marked_action]].refusal;
  const float top = ImGui::GetCursorPosY();
  wrapped_text(refusal.empty() ? said.keys : std::string_view(refusal), ImGui::GetCursorPosX() + width);
  const float bottom = top + lines_of_refusal * ImGui::GetTextLineHeightWithSpacing();
  ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), bottom));
  ImGui::Dummy({width, 0.0F});
  if (entered) chosen = form.marked_action;
  if (chosen < found.size()) choose(entries[found[chosen]], context);
}

}  // namespace ghostforce
