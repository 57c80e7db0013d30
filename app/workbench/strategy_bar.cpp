// The bar on top: which strategy is on the device, what is compared, how time runs, and the ways back.
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "app/stage/hints.h"
#include "app/widgets/controls.h"
#include "app/workbench/bars.h"
#include "app/workbench/motor_control.h"
#include "app/workbench/panel_catalog.h"

namespace ghostforce {
namespace {

// Signs that everybody knows, drawn because the font has none of them. `unit` is half a sign's height.
using DrawSign = void (*)(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour);

void draw_play_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  draw_list.AddTriangleFilled({middle.x - 0.7F * unit, middle.y - unit}, {middle.x + unit, middle.y},
                              {middle.x - 0.7F * unit, middle.y + unit}, colour);
}

void draw_pause_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  for (const float side : {-1.0F, 1.0F}) {
    const float x = middle.x + 0.5F * side * unit;
    draw_list.AddRectFilled({x - 0.28F * unit, middle.y - unit}, {x + 0.28F * unit, middle.y + unit}, colour);
  }
}

// A step to the right, or mirrored.
void draw_step(ImDrawList& draw_list, ImVec2 middle, float unit, float side, ImU32 colour) {
  const float x = middle.x - side * unit;
  // The corners in the order that ImGui smooths the edges of.
  ImVec2 top{x, middle.y - unit};
  ImVec2 bottom{x, middle.y + unit};
  if (side < 0.0F) std::swap(top, bottom);
  draw_list.AddTriangleFilled(top, {middle.x + 0.4F * side * unit, middle.y}, bottom, colour);
  const float from = middle.x + 0.5F * side * unit;
  const float to = middle.x + 0.95F * side * unit;
  draw_list.AddRectFilled({std::min(from, to), middle.y - unit}, {std::max(from, to), middle.y + unit}, colour);
}

// Back to where it came from: a hook that ends in an arrow head to the left, or mirrored.
void draw_hook(ImDrawList& draw_list, ImVec2 middle, float unit, float side, ImU32 colour) {
  constexpr float quarter = 1.5708F;
  const auto at = [&](float x, float y) { return ImVec2{middle.x + side * x * unit, middle.y + y * unit}; };
  const float turn = side > 0.0F ? 0.0F : 2.0F * quarter;
  draw_list.PathLineTo(at(-0.5F, -0.4F));
  draw_list.PathArcTo(at(0.35F, 0.2F), 0.6F * unit, turn - side * quarter, turn + side * quarter, 16);
  draw_list.PathLineTo(at(-0.5F, 0.8F));
  draw_list.PathStroke(colour, 0, 0.3F * unit);
  ImVec2 top = at(-0.4F, -0.95F);
  ImVec2 bottom = at(-0.4F, 0.15F);
  if (side < 0.0F) std::swap(top, bottom);
  draw_list.AddTriangleFilled(at(-1.1F, -0.4F), top, bottom, colour);
}

void draw_step_back_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  draw_step(draw_list, middle, unit, -1.0F, colour);
}

void draw_step_on_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  draw_step(draw_list, middle, unit, 1.0F, colour);
}

// Three quarters of a circle and an arrow head: once more.
void draw_reset_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  constexpr float quarter = 1.5708F;
  draw_list.PathArcTo(middle, 0.85F * unit, -0.6F * quarter, 2.6F * quarter, 24);
  draw_list.PathStroke(colour, 0, 0.3F * unit);
  const ImVec2 end{middle.x + 0.5F * unit, middle.y - 0.69F * unit};
  draw_list.AddTriangleFilled({end.x - 0.75F * unit, end.y - 0.3F * unit}, {end.x + 0.5F * unit, end.y - 0.75F * unit},
                              {end.x + 0.35F * unit, end.y + 0.6F * unit}, colour);
}

void draw_record_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  draw_list.AddCircleFilled(middle, unit, colour, 24);
}

void draw_undo_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  draw_hook(draw_list, middle, unit, 1.0F, colour);
}

void draw_redo_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  draw_hook(draw_list, middle, unit, -1.0F, colour);
}

// How much room there is for the same things [letter heights].
struct BarSizes {
  bool has_titles;  // of strategies: else their letters must do
  float pad;        // in a strategy's button
  float compare;
  float speed;
  float sign;  // width of a button with a sign, in heights of it
  float gap;   // between groups [points]
};
constexpr std::array bar_sizes{
    BarSizes{.has_titles = true, .pad = 1.2F, .compare = 9.6F, .speed = 4.8F, .sign = 1.15F, .gap = 14.0F},
    BarSizes{.has_titles = true, .pad = 0.6F, .compare = 7.6F, .speed = 4.0F, .sign = 0.9F, .gap = 7.0F},
    BarSizes{.has_titles = false, .pad = 0.5F, .compare = 7.6F, .speed = 4.0F, .sign = 0.9F, .gap = 6.0F},
};

constexpr float row_height = 30.0F;  // of the buttons [points]
constexpr const char* stage_words = "Stage (F4)";

struct Bar {
  const PanelContext& context;
  const BarSizes& sizes;

  float height() const { return row_height * context.scale; }
  float letters() const { return 15.0F * context.scale; }  // their height
  float icon() const { return sizes.sign * height(); }
  float spacing() const { return ImGui::GetStyle().ItemSpacing.x; }
  float gap() const { return sizes.gap * context.scale; }
  std::string words_of(const Strategy& entry) const {
    return sizes.has_titles ? std::string(entry.title) : std::string(1, entry.letter);
  }
  // As wide as the bold words, so that choosing does not make the bar jump.
  float width_of(const Strategy& entry) const {
    const std::string words = words_of(entry);
    const float words_width = context.fonts.bold->CalcTextSizeA(letters(), 1e9F, 0.0F, words.c_str()).x;
    return words_width + (1.5F + 2.6F * 0.4F + sizes.pad) * letters();
  }
  float stage_width() const { return button_width(stage_words); }

  // Strategies and comparison; then time, what is taken back, and the way to the stage.
  float choices_width() const {
    float width = gap() + sizes.compare * letters();
    for (const Strategy& entry : strategy_catalog()) width += width_of(entry) + spacing();
    return width - spacing();
  }
  float actions_width() const {
    constexpr int icons = 7;
    constexpr int spaces = 5;  // between things that belong together
    return icons * icon() + sizes.speed * letters() + stage_width() + spaces * spacing() + 3.0F * gap();
  }
};

struct BarPlan {
  const BarSizes& sizes;
  bool has_two_rows;
};

// The largest with which everything has room in one row; else in two.
BarPlan plan_bar(const PanelContext& context) {
  const float room = ImGui::GetIO().DisplaySize.x - 2.0F * ImGui::GetStyle().WindowPadding.x;
  const float motors = motor_button_room(context);
  for (const BarSizes& sizes : bar_sizes) {
    const Bar bar{context, sizes};
    if (bar.choices_width() + bar.actions_width() + 2.0F * bar.gap() + motors <= room) return {sizes, false};
  }
  for (const BarSizes& sizes : bar_sizes) {
    const Bar bar{context, sizes};
    if (bar.actions_width() <= room && bar.choices_width() + bar.gap() + motors <= room) return {sizes, true};
  }
  return {bar_sizes.back(), true};
}

void draw_strategy_button(const Bar& bar, const Strategy& entry) {
  const PanelContext& context = bar.context;
  const std::size_t i = index_of(entry.id);
  const bool active = entry.id == context.session.settings.active;
  const std::string words = bar.words_of(entry);
  const float glyph = 0.4F * ImGui::GetFontSize();
  const float key_width = 1.5F * ImGui::GetFontSize();
  ImGui::PushFont(active ? context.fonts.bold : context.fonts.regular, 0.0F);
  const ImVec2 size{bar.width_of(entry), bar.height()};
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::PushID(static_cast<int>(i));
  if (ImGui::InvisibleButton("strategy", size, ImGuiButtonFlags_EnableNav)) context.apply(ChooseStrategy{entry.id});
  ImGui::PopID();
  const bool hovered = ImGui::IsItemHovered();
  const bool is_hinted = i == 2 && points_at(context.session, HintTarget::third_strategy);
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const ImVec2 end{corner.x + size.x, corner.y + size.y};
  const float rounding = ImGui::GetStyle().FrameRounding;
  const double tint = active ? active_tint : hovered ? 0.5 * active_tint : 0.0;
  draw_list.AddRectFilled(corner, end, packed(mix(context.theme.panel_field, context.theme.strategy[i], tint)),
                          rounding);
  const Colour rim = is_hinted ? context.theme.accent : active ? context.theme.strategy[i] : context.theme.panel_border;
  draw_list.AddRect(corner, end, packed(rim), rounding, 0, (is_hinted ? 3.0F : active ? 2.0F : 1.0F) * context.scale);
  const float text_y = corner.y + 0.5F * (size.y - ImGui::GetFontSize());
  const float pad = 0.5F * ImGui::GetFontSize();
  draw_list.AddText({corner.x + pad, text_y}, packed(context.theme.faint_text), fmt::format("{}", i + 1).c_str());
  draw_glyph(draw_list, {corner.x + key_width + glyph, corner.y + 0.5F * size.y}, glyph, strategy_style(entry.id).shape,
             context.theme.strategy[i]);
  draw_list.AddText({corner.x + key_width + 2.6F * glyph + 0.3F * pad, text_y},
                    packed(active ? context.theme.strategy_text[i] : context.theme.text), words.c_str());
  ImGui::PopFont();
  tooltip(entry.sentence);
  ImGui::SameLine();
}

// A combo box as high as the bar's buttons.
template <typename DrawChoices>
void bar_combo(const char* id, const std::string& shown, float width, float height, DrawChoices&& draw_choices) {
  ImGui::SetNextItemWidth(width);
  const float pad = 0.5F * (height - ImGui::GetFontSize());
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, pad});
  if (ImGui::BeginCombo(id, shown.c_str())) {
    close_popup_on_escape();
    draw_choices();
    ImGui::EndCombo();
  }
  ImGui::PopStyleVar();
}

void draw_compare(const PanelContext& context, float width, float height) {
  ViewOptions options = context.session.options;
  const CompareMode& mode = compare_catalog()[static_cast<std::size_t>(options.compare)];
  bar_combo("##compare", std::string(mode.title), width * ImGui::GetFontSize(), height, [&] {
    for (const CompareMode& each : compare_catalog()) {
      if (!ImGui::Selectable(each.title.data(), each.id == mode.id)) continue;
      options.compare = each.id;
      context.apply(ChangeViewOptions{options});
    }
  });
  tooltip("Compare: all strategies in one picture, a picture for each, or the active one only.");
}

void draw_speed(const PanelContext& context, float width, float height) {
  constexpr std::array speeds{1.0, 0.5, 0.2, 0.1, 0.02};
  bar_combo("##speed", fmt::format("{:g}×", context.session.speed), width * ImGui::GetFontSize(), height, [&] {
    for (const double speed : speeds) {
      const bool is_chosen = speed == context.session.speed;
      if (ImGui::Selectable(fmt::format("{:g}×", speed).c_str(), is_chosen)) context.apply(ChangeSpeed{speed});
    }
  });
  tooltip("Slow motion: fewer ticks per second, the same physics.");
}

bool icon_button(const Bar& bar, const char* id, DrawSign draw_sign, Colour colour, bool is_enabled = true) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::BeginDisabled(!is_enabled);
  const bool pressed = ImGui::Button(id, {bar.icon(), bar.height()});
  ImGui::EndDisabled();
  draw_sign(*ImGui::GetWindowDrawList(), {corner.x + 0.5F * bar.icon(), corner.y + 0.5F * bar.height()},
            0.22F * bar.height(), packed(is_enabled ? colour : bar.context.theme.panel_border));
  return pressed;
}

bool icon_button(const Bar& bar, const char* id, DrawSign draw_sign, bool is_enabled = true) {
  return icon_button(bar, id, draw_sign, bar.context.theme.text, is_enabled);
}

void draw_record_button(const Bar& bar) {
  const PanelContext& context = bar.context;
  const bool is_on = context.loop.recording.is_on;
  if (is_on) {
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 2.5F * context.scale);
    ImGui::PushStyleColor(ImGuiCol_Border, unpacked(context.theme.problem));
  }
  if (icon_button(bar, "##record", draw_record_sign, is_on ? context.theme.problem : context.theme.text)) {
    toggle_recording(context);
  }
  if (is_on) {
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
  }
  tooltip(is_on ? fmt::format("Recording: {}. Click to stop.", words_about(context.loop.recording))
                : "Records every tick to a new file, for spreadsheets and for replay.");
}

void draw_time(const Bar& bar) {
  const PanelContext& context = bar.context;
  const Session& session = context.session;
  const bool looks_back = session.stage.looks_back_to_s.has_value();
  // Nobody stops the time of a real hand; one can look back at what it did.
  const bool can_stop = !context.snapshot.measured;
  const bool is_still = session.paused || looks_back;
  if (icon_button(bar, "##pause", is_still ? draw_play_sign : draw_pause_sign, can_stop || looks_back)) {
    context.apply(TogglePause{});
  }
  tooltip(is_still ? "Resumes model time. Space." : "Pauses model time. Space.");
  ImGui::SameLine();
  if (icon_button(bar, "##back", draw_step_back_sign)) context.apply(StepBack{});
  tooltip("Pauses and steps back one tick, up to a minute. The key is the comma.");
  ImGui::SameLine();
  if (icon_button(bar, "##step", draw_step_on_sign, can_stop || looks_back)) context.apply(StepOn{});
  tooltip("Pauses and steps forward one tick. The key is the full stop.");
  ImGui::SameLine();
  if (icon_button(bar, "##reset", draw_reset_sign)) context.apply(Restart{});
  tooltip("Resets the motion. Key R; Alt+R also resets the settings.");
  ImGui::SameLine();
  ImGui::BeginDisabled(!can_stop);
  draw_speed(context, bar.sizes.speed, bar.height());
  ImGui::EndDisabled();
}

void draw_undo_and_redo(const Bar& bar) {
  const ActionSink& apply = bar.context.apply;
  const UndoOffer& offer = bar.context.session.undo_offer;
  if (icon_button(bar, "##undo", draw_undo_sign, !offer.undo.empty())) apply(Undo{});
  tooltip(offer.undo.empty() ? "There is nothing to undo." : fmt::format("Undo {}. Ctrl+Z.", offer.undo));
  ImGui::SameLine();
  if (icon_button(bar, "##redo", draw_redo_sign, !offer.redo.empty())) apply(Redo{});
  tooltip(offer.redo.empty() ? "There is nothing to redo." : fmt::format("Redo {}. Ctrl+Shift+Z.", offer.redo));
}

}  // namespace

float strategy_bar_height(const PanelContext& context) {
  const float rows = plan_bar(context).has_two_rows ? 2.0F : 1.0F;
  return (16.0F + rows * row_height) * context.scale + (rows - 1.0F) * ImGui::GetStyle().ItemSpacing.y;
}

void draw_strategy_bar(const PanelContext& context) {
  const BarPlan plan = plan_bar(context);
  const Bar bar{context, plan.sizes};
  for (const Strategy& entry : strategy_catalog()) draw_strategy_button(bar, entry);
  ImGui::SameLine(0.0F, bar.gap());
  draw_compare(context, bar.sizes.compare, bar.height());
  // The motors' button has its place at the right edge of the first row.
  if (plan.has_two_rows) {
    draw_motor_button(context, bar.height());
  } else {
    ImGui::SameLine(0.0F, bar.gap());
  }
  draw_time(bar);
  ImGui::SameLine();
  draw_record_button(bar);
  ImGui::SameLine(0.0F, bar.gap());
  draw_undo_and_redo(bar);
  ImGui::SameLine(0.0F, bar.gap());
  if (ImGui::Button(stage_words, {bar.stage_width(), bar.height()})) context.apply(ShowFace{Face::stage});
  tooltip("Back to the stage: one hand, one handle, one wall. F4.");
  if (!plan.has_two_rows) draw_motor_button(context, bar.height());
}

}  // namespace ghostforce
