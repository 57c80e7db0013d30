// The live table: what each strategy does right now, in numbers of fixed width.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/picture/glossary.h"
#include "app/picture/text.h"
#include "app/state/front_keys.h"
#include "app/widgets/controls.h"
#include "app/workbench/panel_catalog.h"
#include "core/conventions.h"
#include "core/scene_shape.h"
#include "core/settings.h"

namespace ghostforce {
namespace {

// Eight characters at most, whatever the number.
std::string in_fixed_width(double value, int decimals) {
  const double too_long = std::pow(10.0, 6 - decimals) - 1.0;
  return std::abs(value) < too_long ? decimal_text(value, decimals) : fmt::format("{:.1e}", value);
}

void right_aligned(std::string_view text) {
  const float free = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
  if (free > 0.0F) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + free);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

void draw_head() {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  for (const Quantity& quantity : quantity_catalog()) {
    ImGui::TableNextColumn();
    ImGui::BeginGroup();
    right_aligned(quantity.title);
    right_aligned(quantity.unit);
    ImGui::EndGroup();
    tooltip(quantity.term);
  }
}

// Why nobody knows a number against the goal.
std::string_view words_of_unknown(const PanelContext& context, StrategyId id) {
  if (!context.snapshot.has_target) {
    return "Cannot be known: the goal of a real hand is only estimated from the force itself. Tick “Aim at a target” "
           "in "
           "the panel “Input”.";
  }
  if (context.snapshot.measured != id) return "Cannot be known: this strategy is only simulated beside the device.";
  return "Cannot be known now: the hand does not pull towards the target, or the motors give less than they were asked "
         "for.";
}

void draw_row(const PanelContext& context, const Strategy& entry) {
  const std::size_t i = index_of(entry.id);
  const bool active = entry.id == context.settings.active;
  ImGui::TableNextRow();
  if (active)
    ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0,
                           packed(mix(context.theme.panel, context.theme.strategy[i], active_tint)));
  ImGui::TableNextColumn();
  draw_strategy_name(context, entry, active ? context.fonts.bold : context.fonts.regular);
  for (const Quantity& quantity : quantity_catalog()) {
    ImGui::TableNextColumn();
    ImGui::PushFont(context.fonts.number, 0.0F);
    const bool has_value = is_known(quantity, context.snapshot, entry.id);
    const bool is_against_target = quantity.is_against_goal && context.snapshot.has_target;
    const double value = quantity.value(context.snapshot.strategies[i]);
    std::string text = has_value ? in_fixed_width(value, quantity.decimals) : "—";
    if (has_value && is_against_target) text = fmt::format("{} {}", target_sign, text);
    right_aligned(text);
    ImGui::PopFont();
    if (!has_value) {
      tooltip(words_of_unknown(context, entry.id));
    } else if (is_against_target) {
      tooltip("Relative to the target: assumes a hand at rest that aims straight into the wall at it.");
    }
  }
}

// How far the simulation is from rest as theory has it: the largest of the three [m]. Infinite where one has no rest.
double model_error(const PanelContext& context) {
  double largest = 0.0;
  for (const Strategy& entry : strategy_catalog()) {
    const auto rest = rest_of(entry.id, context.settings, context.snapshot.goal);
    if (!rest) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, glm::distance(rest->at.device, context.snapshot.strategies[index_of(entry.id)].device));
  }
  return largest;
}

void draw_model_error(const PanelContext& context) {
  if (context.snapshot.measured) {
    ImGui::TextUnformatted(
        fmt::format("{} measured, others simulated{}", strategy(*context.snapshot.measured).title,
                    context.snapshot.has_target ? fmt::format("; {} relative to the target", target_sign) : "")
            .c_str());
    tooltip(
        "Forces are what each strategy asks for, before any limit. The others are simulated with the estimated goal, "
        "so "
        "their ghost force and drift cannot be known.");
    return;
  }
  ImGui::BeginGroup();
  ImGui::TextUnformatted("model − simulation ≤");
  const double error_mm = model_error(context) * mm_per_m;
  const std::string error = std::isinf(error_mm) ? "no rest" : fmt::format("{:>8} mm", in_fixed_width(error_mm, 3));
  same_line_if_room(context.fonts.number->CalcTextSizeA(ImGui::GetFontSize(), 1e9F, 0.0F, error.c_str()).x);
  text_in(context.fonts.number, error);
  ImGui::EndGroup();
  tooltip(Term::model_error);
}

// For up to eight digits, and for the title.
float column_room(const PanelContext& context, const Quantity& quantity) {
  const float digits = context.fonts.number->CalcTextSizeA(ImGui::GetFontSize(), 1e9F, 0.0F, "−1000.0").x;
  return std::max(digits, ImGui::CalcTextSize(quantity.title.data()).x);
}

void draw_table(const PanelContext& context) {
  if (!ImGui::BeginTable("live", 1 + static_cast<int>(quantity_count),
                         ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_PadOuterX)) {
    return;
  }
  ImGui::TableSetupColumn("strategy", ImGuiTableColumnFlags_WidthFixed, 2.6F * ImGui::GetFontSize());
  for (const Quantity& quantity : quantity_catalog())
    ImGui::TableSetupColumn(quantity.title.data(), ImGuiTableColumnFlags_WidthStretch, column_room(context, quantity));
  draw_head();
  for (const Strategy& entry : strategy_catalog()) draw_row(context, entry);
  ImGui::EndTable();
}

// Of the letters, so that all columns and a strategy's name have room in a narrow panel.
float size_that_fits(const PanelContext& context) {
  const float padding = 2.0F * ImGui::GetStyle().CellPadding.x;
  const float room = ImGui::GetContentRegionAvail().x - (static_cast<float>(quantity_count) + 1.0F) * padding;
  float needed = 2.6F * ImGui::GetFontSize();
  for (const Quantity& quantity : quantity_catalog()) needed += column_room(context, quantity);
  return ImGui::GetStyle().FontSizeBase * std::clamp(room / needed, 0.6F, 1.0F);
}

void draw_copy_button(const PanelContext& context, float top) {
  const char* const copy = "Copy";
  const float copy_x = ImGui::GetContentRegionMax().x - button_width(copy);
  if (ImGui::GetItemRectMax().x < ImGui::GetWindowPos().x + copy_x) {
    ImGui::SameLine();
    ImGui::SetCursorPosY(top);
  }
  ImGui::SetCursorPosX(copy_x);
  if (ImGui::SmallButton(copy)) context.apply(CopyValues{});
  tooltip(fmt::format("Copies the values of all three strategies to the clipboard, for a spreadsheet. {}.",
                      front_keys().copy_values.shown));
}

}  // namespace

void draw_live_values(const PanelContext& context) {
  ImGui::PushFont(nullptr, size_that_fits(context));
  draw_table(context);
  ImGui::PopFont();
  const float top = ImGui::GetCursorPosY();
  draw_model_error(context);
  draw_copy_button(context, top);
}

}  // namespace ghostforce
