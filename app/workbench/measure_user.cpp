// The guided measurement of the hand: one step at a time, the drift as a number and on a ruler, and what came out.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "app/picture/text.h"
#include "app/state/user_measurement_guide.h"
#include "app/widgets/controls.h"
#include "app/widgets/symbol_text.h"
#include "app/workbench/panel_catalog.h"
#include "core/conventions.h"

namespace ghostforce {
namespace {

constexpr double ruler_reach = 0.010;  // to either side [m]

void draw_invitation(const PanelContext& context) {
  wrapped_text(
      "How stiff is the hand? Change the ratio ρ until the proxy no longer drifts along the wall: that ρ gives k_u. Do "
      "this five times; the median counts.");
  if (ImGui::Button("Start measuring")) context.apply(StartMeasuring{});
  tooltip(
      "Chooses the anisotropic strategy and a wrong ratio, and hides what would give the answer away. Afterwards, "
      "strategy and ratio are restored.");
  const char* const on_stage = "On the stage   S";
  same_line_if_room(button_width(on_stage));
  if (ImGui::Button(on_stage)) context.apply(MeasureHand{});
  tooltip(english_stage.modes.measure.about);
}

// Two lines, so that nothing below moves when the words change.
void draw_step(const PanelContext& context, const UserMeasurement& measurement) {
  const float top = ImGui::GetCursorPosY();
  ImGui::PushFont(context.fonts.bold, 0.0F);
  const std::string words(words_for(measurement.step, measurement.target.has_value()));
  wrapped_text(measurement.was_refused ? "Not taken. " + words : words);
  ImGui::PopFont();
  ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), top + 2.0F * ImGui::GetTextLineHeightWithSpacing()));
}

void draw_drift(const PanelContext& context, const UserMeasurement& measurement) {
  ImGui::BeginGroup();
  ImGui::PushFont(context.fonts.number, 2.0F * ImGui::GetStyle().FontSizeBase);
  const std::string number =
      fmt::format("{:>7}", measurement.drift ? signed_decimal_text(mm_per_m * *measurement.drift, 2) : "—");
  ImGui::TextUnformatted(fmt::format("{} mm", number).c_str());
  ImGui::PopFont();
  const float width = ImGui::GetContentRegionAvail().x;
  const float line = ImGui::GetTextLineHeight();
  const float scale = context.scale;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float radius = 0.5F * line;
  const float middle = corner.x + 0.5F * width;
  const float half = 0.5F * width - radius - 10.0F * scale;
  const float y = corner.y + radius + 4.0F * scale;
  const auto x_of = [&](double drift) {
    return middle + half * static_cast<float>(std::clamp(drift / ruler_reach, -1.05, 1.05));
  };
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const ImU32 ink = packed(context.theme.text);
  const double null = null_drift(measurement);
  draw_list.AddRectFilled({x_of(-null) - scale, y - radius}, {x_of(null) + scale, y + radius},
                          packed(mix(context.theme.panel, context.theme.accent, 0.35)));
  draw_list.AddLine({x_of(-ruler_reach), y}, {x_of(ruler_reach), y}, ink, 1.5F * scale);
  for (const int mm : {-10, -5, 0, 5, 10}) {
    const float x = x_of(0.001 * mm);
    draw_list.AddLine({x, y - 0.6F * radius}, {x, y + 0.6F * radius}, ink, (mm == 0 ? 2.5F : 1.5F) * scale);
    const std::string words = signed_decimal_text(mm, 0);
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    draw_list.AddText({x - 0.5F * size.x, y + radius + 2.0F * scale}, packed(context.theme.faint_text), words.c_str());
  }
  if (measurement.drift) {
    draw_glyph(draw_list, {x_of(*measurement.drift), y}, 0.8F * radius, strategy_style(StrategyId::anisotropic).shape,
               context.theme.strategy[index_of(StrategyId::anisotropic)]);
  }
  ImGui::Dummy({width, 2.0F * radius + line + 8.0F * scale});
  ImGui::EndGroup();
  tooltip(measurement.target ? Term::drift_from_target : Term::null_drift);
}

void draw_ratio(const PanelContext& context) {
  Stiffnesses stiffnesses = context.session.settings.stiffnesses;
  if (!begin_rows("measured ratio", context)) return;
  row("Ratio ρ", Term::tracking_ratio);
  // A decade to either side of where the reading began: what is believed must not show.
  const double first = context.session.measurement.first_ratio;
  const SliderLimits limits{0.1 * first, 10.0 * first};
  double ratio = tracking_ratio(stiffnesses);
  if (slider("##ratio", ratio, limits, "%.2f", ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp)) {
    stiffnesses.chosen_tracking_ratio = ratio;
    context.apply(ChangeStiffnesses{stiffnesses});
  }
  tooltip("Drag, or press − and + for 5 % (Alt: 1 %).");
  end_rows();
}

void draw_nulling(const PanelContext& context) {
  const UserMeasurement& measurement = context.session.measurement;
  std::string head = fmt::format("Reading {} of {}", measurement.readings.size() + 1, readings_wanted);
  if (measurement.has_begun_anew) head += ". Something changed, so the measurement started over.";
  wrapped_text(head);
  draw_step(context, measurement);
  draw_drift(context, measurement);
  draw_ratio(context);
  if (ImGui::Button("Take   Enter")) context.apply(TakeReading{});
  tooltip("Records this ρ as a reading: k_u = k_r / (ρ − 1).");
  ImGui::SameLine();
  if (ImGui::Button("Cancel")) context.apply(CancelMeasuring{});
  tooltip("Restores the ratio and the strategy, and discards the readings.");
}

void draw_readings(const PanelContext& context, const UserMeasurement& measurement) {
  if (!ImGui::BeginTable("readings", 3, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_BordersInnerH)) return;
  ImGui::TableSetupColumn("reading", ImGuiTableColumnFlags_WidthFixed, 70.0F * context.scale);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted("reading");
  ImGui::TableNextColumn();
  ImGui::TextUnformatted("     ρ°");
  tooltip(Term::null_ratio);
  ImGui::TableNextColumn();
  symbol_text("     k_u");
  tooltip("k_u = k_r / (ρ° − 1)");
  for (std::size_t i = 0; i < measurement.readings.size(); ++i) {
    ImGui::TableNextColumn();
    ImGui::Text("%zu", i + 1);
    number_cell(context, fmt::format("{:7.2f}", measurement.readings[i].tracking_ratio));
    number_cell(context, fmt::format("{:7.1f} N/m", measurement.readings[i].k_u));
  }
  ImGui::EndTable();
}

void draw_result(const PanelContext& context) {
  const UserMeasurement& measurement = context.session.measurement;
  draw_readings(context, measurement);
  const Spread spread = spread_of(measurement);
  ImGui::PushFont(context.fonts.bold, 0.0F);
  symbol_text(fmt::format("measured k_u  {:7.1f} N/m", spread.median));
  ImGui::PopFont();
  tooltip("The median of the readings.");
  ImGui::TextUnformatted(
      fmt::format("middle half  {:.1f} to {:.1f} N/m", spread.lower_quartile, spread.upper_quartile).c_str());
  tooltip("From the lower to the upper quartile: of five readings, the second to the fourth.");
  // Of a hand that is simulated there is a true value; it was given, not measured, and may be another by now.
  if (measurement.given_k_u && !measurement.is_revealed) {
    if (ImGui::Button("Reveal the given stiffness")) context.apply(RevealHand{});
    tooltip("Shows the stiffness that the simulated hand was given.");
  } else if (measurement.given_k_u) {
    text_in(context.theme.faint_text, fmt::format("(given: {:.1f} N/m)", *measurement.given_k_u));
    tooltip("The stiffness that the simulated hand was given.");
  }
  if (measurement.given_k_u && !measurement.was_blind)
    wrapped_text("Not a blind measurement: the given k_u was revealed early.");
  if (ImGui::Button("Use this stiffness")) {
    context.apply(BelieveMeasurement{});
    return;
  }
  tooltip("The renderer uses this k_u from now on.");
  const char* const again = "Measure again";
  same_line_if_room(button_width(again));
  if (ImGui::Button(again)) {
    context.apply(StartMeasuring{});
    return;
  }
  const char* const close = "Close";
  same_line_if_room(button_width(close));
  if (ImGui::Button(close)) context.apply(CancelMeasuring{});
}

}  // namespace

void draw_measure_user(const PanelContext& context) {
  if (is_general(context.session.settings)) {
    wrapped_text(english_stage.refusals.not_with_this_device);
    return;
  }
  const UserMeasurement& measurement = context.session.measurement;
  switch (measurement.stage) {
    case UserMeasurement::Stage::off:
      draw_invitation(context);
      break;
    case UserMeasurement::Stage::nulling:
      draw_nulling(context);
      break;
    case UserMeasurement::Stage::done:
      draw_result(context);
      break;
  }
}

}  // namespace ghostforce
