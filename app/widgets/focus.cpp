#include "app/widgets/focus.h"

#include <imgui_internal.h>

#include <utility>

namespace ghostforce {
namespace {

// Dear ImGui's context is one for the whole program; this belongs to it.
struct ArrowTaker {
  ImGuiID id = 0;
  std::vector<Nudge> nudges;
} arrow_taker;

ImU32 ink_of(Colour colour) {
  return IM_COL32(colour.red, colour.green, colour.blue, colour.alpha);
}

}  // namespace

bool has_focus() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return context.NavCursorVisible && context.NavId != 0;
}

bool focus_takes_arrows() {
  return has_focus() && ImGui::GetCurrentContext()->NavId == arrow_taker.id;
}

void nudge_focused(const Nudge& nudge) {
  arrow_taker.nudges.push_back(nudge);
}

void leave_focus() {
  ImGui::SetNavCursorVisible(false);
  arrow_taker = {};
}

std::vector<Nudge> take_nudges() {
  if (!is_focused()) return {};
  arrow_taker.id = ImGui::GetItemID();
  return std::exchange(arrow_taker.nudges, {});
}

bool is_focused() {
  return has_focus() && ImGui::IsItemFocused();
}

void draw_focus_ring(const Theme& theme, float scale) {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (!has_focus() || context.NavWindow == nullptr || !context.NavIdIsAlive) return;
  ImGuiWindow& window = *context.NavWindow;
  const float gap = 2.0F * scale;
  ImRect ring = ImGui::WindowRectRelToAbs(&window, window.NavRectRel[context.NavLayer]);
  ring.Expand(gap);
  // All of it stays in sight where a control reaches to the edge of its window.
  ImRect sight = window.OuterRectClipped;
  sight.Expand(-gap);
  ring.ClipWithFull(sight);
  const float rounding = ImGui::GetStyle().FrameRounding + gap;
  ImDrawList& draw_list = *window.DrawList;
  draw_list.PushClipRect(window.OuterRectClipped.Min, window.OuterRectClipped.Max);
  // Light and dark, so that it stands out from whatever it lies on.
  draw_list.AddRect(ring.Min, ring.Max, ink_of(theme.panel), rounding, 0, 6.0F * scale);
  draw_list.AddRect(ring.Min, ring.Max, ink_of(theme.accent), rounding, 0, 3.0F * scale);
  draw_list.PopClipRect();
}

}  // namespace ghostforce
