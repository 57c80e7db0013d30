#include "app/widgets/tooltips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <imgui_internal.h>

#include "app/widgets/symbol_text.h"

namespace ghostforce {
namespace {

constexpr double slack = 4.0;  // round a mark [points]

// Somebody who has just used a control knows what it is: no explanation until the pointer has left it.
bool has_been_used() {
  const ImGuiID id = ImGui::GetItemID();
  if (id == 0) return false;
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  if (ImGui::IsItemActive()) storage.SetBool(id, true);
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) storage.SetBool(id, false);
  return storage.GetBool(id);
}

// Whoever has just dragged something looks at what it does [s of frames].
constexpr double quiet_after_drag_s = 2.0;
constexpr double never_s = -1e9;
constexpr float still_there = 12.0F;  // from where the drag ended [points]
double last_drag_s = never_s;
ImVec2 last_drag_at{0.0F, 0.0F};

// Also until the pointer has left what it dragged: an explanation would cover it.
bool has_just_dragged() {
  if (last_drag_s == never_s) return false;
  const double since_s = ImGui::GetTime() - last_drag_s;
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  const bool is_still_there = std::hypot(pointer.x - last_drag_at.x, pointer.y - last_drag_at.y) < still_there;
  if (!is_still_there && since_s >= quiet_after_drag_s) last_drag_s = never_s;
  return is_still_there || since_s < quiet_after_drag_s;
}

struct Sentence {
  std::string words;
  ImGuiCol colour = ImGuiCol_Text;
};
using Explanation = std::vector<Sentence>;

bool is_wanted() {
  return !has_been_used() && !has_just_dragged() &&
         ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip | ImGuiHoveredFlags_AllowWhenDisabled);
}

struct Neighbour {
  ImRect item;      // what is explained,
  ImRect surround;  // and what should stay in sight round it
};

// All of it in the window, beside what is explained: left of its panel, or else below or above it.
ImVec2 place_beside(const Neighbour& neighbour, ImVec2 size) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const ImVec2 whole = ImGui::GetIO().DisplaySize;
  const auto& [item, surround] = neighbour;
  const ImVec2 beside{surround.Min.x - style.ItemSpacing.x - size.x, item.Min.y};
  const ImVec2 below{item.Min.x, item.Max.y + style.ItemSpacing.y};
  const ImVec2 above{item.Min.x, item.Min.y - style.ItemSpacing.y - size.y};
  // Nothing is beside a bar across the window.
  const bool is_bar = surround.GetWidth() > 0.5F * whole.x;
  const std::array places{is_bar ? below : beside, is_bar ? above : below, is_bar ? beside : above,
                          ImVec2(surround.Max.x + style.ItemSpacing.x, item.Min.y)};
  const auto moved_in = [&](ImVec2 place) {
    return ImVec2(std::clamp(place.x, 0.0F, std::max(0.0F, whole.x - size.x)),
                  std::clamp(place.y, 0.0F, std::max(0.0F, whole.y - size.y)));
  };
  for (const ImVec2 place : places) {
    const ImVec2 inside = moved_in(place);
    if (!ImRect(inside, {inside.x + size.x, inside.y + size.y}).Overlaps(item)) return inside;
  }
  return moved_in(places[1]);
}

void show(const Explanation& explanation, const Neighbour& neighbour) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float width =
      std::min(26.0F * ImGui::GetFontSize(), ImGui::GetIO().DisplaySize.x - 2.0F * style.WindowPadding.x);
  ImVec2 size{0.0F, -style.ItemSpacing.y};
  for (const Sentence& sentence : explanation) {
    const ImVec2 extent = symbol_text_size(sentence.words, width);
    size = {std::max(size.x, extent.x), size.y + extent.y + style.ItemSpacing.y};
  }
  size = {size.x + 2.0F * style.WindowPadding.x, size.y + 2.0F * style.WindowPadding.y};
  ImGui::SetNextWindowPos(place_beside(neighbour, size));
  if (!ImGui::BeginTooltip()) return;
  for (const Sentence& sentence : explanation) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(sentence.colour));
    symbol_text(sentence.words, width);
    ImGui::PopStyleColor();
  }
  ImGui::EndTooltip();
}

Neighbour item_and_window() {
  const ImVec2 corner = ImGui::GetWindowPos();
  const ImVec2 size = ImGui::GetWindowSize();
  return {{ImGui::GetItemRectMin(), ImGui::GetItemRectMax()}, {corner, {corner.x + size.x, corner.y + size.y}}};
}

Explanation entry_about(const GlossaryEntry& entry, std::string_view whose) {
  Explanation explanation{
      {whose.empty() ? std::string(entry.title) : fmt::format("{} · {}", entry.title, whose), ImGuiCol_CheckMark},
      {std::string(entry.sentence)}};
  if (!entry.formula.empty()) explanation.push_back({std::string(entry.formula)});
  if (!entry.unit.empty()) explanation.push_back({fmt::format("Unit: {}", entry.unit)});
  return explanation;
}

struct DistanceTo {
  const Camera& camera;
  const LabelFonts& fonts;
  Vector<2> pointer;
  double unit;

  double to_segment(const Vector<2>& from, const Vector<2>& to) const {
    const Vector<2> along = to - from;
    const double squared = glm::dot(along, along);
    const double share = squared > 0.0 ? std::clamp(glm::dot(pointer - from, along) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(pointer, from + along * share);
  }
  double to_rectangle(const Vector<2>& corner, const Vector<2>& extent) const {
    return glm::distance(pointer, glm::clamp(pointer, corner, corner + extent));
  }
  double operator()(const HalfPlane&) const { return 1e9; }  // everywhere: of no help to anybody
  double operator()(const Label& form) const {
    const Vector<2> corner = to_screen(camera, form.anchor) + form.offset;
    const Vector<2> extent = measure_text(fonts, form.text, {form.style.height * unit, form.style.is_bold});
    return to_rectangle(corner, extent);
  }
  double operator()(const Line& form) const {
    return to_segment(to_screen(camera, form.from), to_screen(camera, form.to)) - 0.5 * form.width;
  }
  double operator()(const Marker& form) const {
    const double distance = glm::distance(pointer, to_screen(camera, form.center) + form.offset);
    // A ring is there only where it is drawn.
    const bool is_ring = form.fill.alpha == 0;
    return is_ring ? std::abs(distance - form.radius) : distance - form.radius;
  }
  double operator()(const Arrow& form) const {
    return to_segment(to_screen(camera, form.tail) + form.offset, to_screen(camera, form.tip) + form.offset) -
           form.width;
  }
  double operator()(const Box& form) const {
    return to_rectangle(to_screen(camera, form.corner) + form.offset, form.size);
  }
  double operator()(const Raster& form) const { return to_rectangle(to_screen(camera, form.corner), form.size); }
  double operator()(const Area& form) const {
    double nearest = 1e9;
    bool is_inside = false;
    for (std::size_t i = 0; i < form.corners.size(); ++i) {
      const Vector<2> from = to_screen(camera, form.corners[i]);
      const Vector<2> to = to_screen(camera, form.corners[(i + 1) % form.corners.size()]);
      nearest = std::min(nearest, to_segment(from, to));
      if ((from.y > pointer.y) != (to.y > pointer.y) &&
          pointer.x < from.x + (to.x - from.x) * (pointer.y - from.y) / (to.y - from.y)) {
        is_inside = !is_inside;
      }
    }
    return is_inside ? 0.0 : nearest;
  }
};

}  // namespace

void tooltip(std::string_view sentence) {
  if (is_wanted()) show({{std::string(sentence)}}, item_and_window());
}

void tooltip(Term term) {
  if (is_wanted()) show(entry_about(glossary(term), ""), item_and_window());
}

void keep_tooltips_from_drags() {
  if (ImGui::GetFrameCount() <= 1) last_drag_s = never_s;  // another window than before
  for (const ImGuiMouseButton button : {ImGuiMouseButton_Left, ImGuiMouseButton_Right}) {
    if (!ImGui::IsMouseDragging(button)) continue;
    last_drag_s = ImGui::GetTime();
    last_drag_at = ImGui::GetIO().MousePos;
  }
}

const Mark* mark_at(const Pane& pane, const LabelFonts& fonts, const Vector<2>& pointer, double unit) {
  // Springs and trails are thin and everywhere: whoever points at an arrow that one crosses means the arrow.
  for (const bool is_line : {false, true}) {
    for (auto mark = pane.marks.rbegin(); mark != pane.marks.rend(); ++mark) {
      if (!term_of(*mark) || std::holds_alternative<Line>(mark->form) != is_line) continue;
      if (std::visit(DistanceTo{pane.camera, fonts, pointer, unit}, mark->form) <= slack * unit) return &*mark;
    }
  }
  return nullptr;
}

void mark_tooltip(const Pane& pane, const LabelFonts& fonts, const Vector<2>& pointer, double unit,
                  bool is_goal_estimated) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip)) return;
  const Mark* const mark = mark_at(pane, fonts, pointer, unit);
  if (mark == nullptr || !is_wanted()) return;
  const ImVec2 at = ImGui::GetMousePos();
  const float reach = ImGui::GetFontSize();
  const ImRect under_pointer{{at.x, at.y - 0.5F * reach}, {at.x + reach, at.y + reach}};
  show(entry_about(glossary(term_of(*mark, is_goal_estimated).value()),
                   mark->strategy ? strategy(*mark->strategy).title : ""),
       {under_pointer, under_pointer});
}

}  // namespace ghostforce
