#include "app/ui/widgets/tooltips.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "app/paint/label_painter.h"

namespace ghostforce {
namespace {

constexpr double slack = 4.0;  // round a mark [points]

void write(std::string_view text) {
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

// Somebody who has just used a control knows what it is: no explanation until the pointer has left it.
bool has_been_used() {
  const ImGuiID id = ImGui::GetItemID();
  if (id == 0) return false;
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  if (ImGui::IsItemActive()) storage.SetBool(id, true);
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) storage.SetBool(id, false);
  return storage.GetBool(id);
}

bool begin_explanation() {
  if (has_been_used()) return false;
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip | ImGuiHoveredFlags_AllowWhenDisabled)) return false;
  // Beside the panels, not over the neighbours of what is explained.
  const ImVec2 window = ImGui::GetWindowPos();
  if (window.x > 0.4F * ImGui::GetIO().DisplaySize.x) {
    ImGui::SetNextWindowPos({window.x - ImGui::GetStyle().ItemSpacing.x, ImGui::GetItemRectMin().y}, ImGuiCond_Always,
                            {1.0F, 0.0F});
  }
  if (!ImGui::BeginTooltip()) return false;
  ImGui::PushTextWrapPos(26.0F * ImGui::GetFontSize());
  return true;
}

void end_explanation() {
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void write_entry(const GlossaryEntry& entry, std::string_view whose) {
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
  write(whose.empty() ? std::string(entry.title) : fmt::format("{} · {}", entry.title, whose));
  ImGui::PopStyleColor();
  write(entry.sentence);
  const std::string formula = entry.unit.empty()      ? std::string(entry.formula)
                              : entry.formula.empty() ? fmt::format("in {}", entry.unit)
                                                      : fmt::format("{}   [{}]", entry.formula, entry.unit);
  if (!formula.empty()) write(formula);
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
  if (!begin_explanation()) return;
  write(sentence);
  end_explanation();
}

void tooltip(Term term) {
  if (!begin_explanation()) return;
  write_entry(glossary(term), "");
  end_explanation();
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
  if (mark == nullptr || !begin_explanation()) return;
  write_entry(glossary(term_of(*mark, is_goal_estimated).value()),
              mark->strategy ? strategy(*mark->strategy).title : "");
  end_explanation();
}

}  // namespace ghostforce
