#include "app/workbench/ratio_dial.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "app/state/user_measurement_guide.h"
#include "app/widgets/controls.h"
#include "app/widgets/focus.h"

namespace ghostforce {
namespace {

// The dial is logarithmic and has naïve at a quarter and optimal at three quarters of it, wherever ρ* is.
class Scale {
 public:
  explicit Scale(double optimal) : decade_(2.0 * std::log(std::max(optimal, 1.2))) {}
  double ratio(double place) const { return tracking_ratio_range.nearest_to(std::exp((place - 0.25) * decade_)); }
  // Of the ratio's logarithm, over the whole dial.
  double decade() const { return decade_; }
  double place(double ratio) const { return std::clamp(0.25 + std::log(ratio) / decade_, 0.0, 1.0); }
  bool holds(double ratio) const { return place(ratio) > 0.0 && place(ratio) < 1.0; }

 private:
  double decade_;
};

// Enter on the focused dial, as on a slider, makes it a field for a number; true while it is one.
bool type_ratio(const PanelContext& context, ImVec2 size) {
  const ImGuiContext& imgui = *ImGui::GetCurrentContext();
  const ImGuiID id = ImGui::GetID("ratio");
  const bool begins = imgui.NavActivateId == id && (imgui.NavActivateFlags & ImGuiActivateFlags_PreferInput) != 0;
  if (!begins && !ImGui::TempInputIsActive(id)) return false;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImRect field{corner, {corner.x + size.x, corner.y + ImGui::GetFrameHeight()}};
  ImGui::ItemSize(size);
  ImGui::ItemAdd(field, id, nullptr, ImGuiItemFlags_Inputable);
  Stiffnesses stiffnesses = context.session.settings.stiffnesses;
  double ratio = tracking_ratio(stiffnesses);
  if (ImGui::TempInputScalar(field, id, "ratio", ImGuiDataType_Double, &ratio, "%.2f")) {
    stiffnesses.chosen_tracking_ratio = tracking_ratio_range.nearest_to(ratio);
    context.apply(ChangeStiffnesses{stiffnesses});
  }
  return true;
}

// Somebody turns ρ, or has just done so: time to say whom it acts on.
bool is_turning(const PanelContext& context, bool is_held) {
  const auto ratio = static_cast<float>(context.session.settings.stiffnesses.chosen_tracking_ratio.value_or(0.0));
  float& last = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("last ratio"), ratio);
  const bool is_other = std::exchange(last, ratio) != ratio;
  if (is_held || is_other) context.memory.dial_turned_s = 0.0;
  return context.memory.dial_turned_s.has_value();
}

// Where the hand is, as it is measured live: where ρ would be optimal for it, and for one deviation to either side.
struct HandNeedle {
  double ratio;
  double least;
  double greatest;
};

std::optional<HandNeedle> hand_needle(const HandEstimate& hand, double k_r) {
  if (!hand.is_known()) return std::nullopt;
  return HandNeedle{optimal_tracking_ratio(k_r, hand.k_u), optimal_tracking_ratio(k_r, hand.k_u + hand.sigma),
                    optimal_tracking_ratio(k_r, hand.k_u - hand.sigma)};
}

const char* words_of_optimal(const Session& session) {
  switch (session.belief_source) {
    case BeliefSource::live:
      return "live optimal";
    case BeliefSource::measured:
      return "measured optimal";
    case BeliefSource::typed:
      break;
  }
  return session.settings.stiffnesses.believed_k_u ? "believed optimal" : "optimal";
}

}  // namespace

RatioRange ratio_range(const Stiffnesses& stiffnesses) {
  const double optimal = std::max(optimal_tracking_ratio(stiffnesses.k_r, believed_user_stiffness(stiffnesses)), 1.2);
  const double now = tracking_ratio(stiffnesses);
  return {std::min(1.0 / std::sqrt(optimal), now / 1.2), std::max(optimal * std::sqrt(optimal), now * 1.2)};
}

Stiffnesses with_ratio(Stiffnesses stiffnesses, double ratio, double snap) {
  const double optimal = optimal_tracking_ratio(stiffnesses.k_r, believed_user_stiffness(stiffnesses));
  if (std::abs(std::log(ratio / optimal)) < snap) {
    stiffnesses.chosen_tracking_ratio.reset();
  } else {
    const bool is_naive = std::abs(std::log(ratio)) < snap;
    stiffnesses.chosen_tracking_ratio = is_naive ? 1.0 : tracking_ratio_range.nearest_to(ratio);
  }
  return stiffnesses;
}

void draw_ratio_dial(const PanelContext& context) {
  if (hides_answer(context.session) || is_measuring(context.session)) {
    ImGui::AlignTextToFramePadding();
    wrapped_text(is_measuring(context.session) ? "set in “Measure the hand”" : "hidden until you reveal k_u");
    tooltip("The dial would show the optimal ratio, and so how stiff the hand is.");
    return;
  }
  const Stiffnesses& stiffnesses = context.session.settings.stiffnesses;
  const double optimal = optimal_tracking_ratio(stiffnesses.k_r, believed_user_stiffness(stiffnesses));
  const Scale scale(optimal);
  const Theme& theme = context.theme;
  const Colour naive = theme.strategy[index_of(StrategyId::naive)];
  const Colour cure = theme.strategy[index_of(StrategyId::anisotropic)];

  const float width = ImGui::GetContentRegionAvail().x;
  const float line = ImGui::GetTextLineHeight();
  const float radius = 8.0F * context.scale;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float left = corner.x + radius;
  const float length = width - 2.0F * radius;
  const float track_y = corner.y + line + radius + 3.0F * context.scale;
  const auto x_of = [&](double place) { return left + static_cast<float>(place) * length; };

  const ImVec2 size{width, 2.0F * line + 2.0F * radius + 8.0F * context.scale};
  if (type_ratio(context, size)) return;
  ImGui::InvisibleButton("ratio", size, ImGuiButtonFlags_EnableNav);
  if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    const float pointer = ImGui::GetIO().MousePos.x;
    const double place = std::clamp(static_cast<double>((pointer - left) / length), 0.0, 1.0);
    const double snap = scale.decade() * static_cast<double>(ratio_snap_points * context.scale / length);
    context.apply(ChangeStiffnesses{with_ratio(stiffnesses, scale.ratio(place), snap)});
  }
  for (const Nudge& nudge : take_nudges()) {
    const double step = 0.01 * nudge.steps;
    const double place = nudge.way == Nudge::Way::to_least      ? 0.0
                         : nudge.way == Nudge::Way::to_greatest ? 1.0
                                                                : scale.place(tracking_ratio(stiffnesses)) + step;
    // Half a step: whoever leaves naïve or optimal does not fall back on it.
    const double snap = 0.5 * std::abs(step) * scale.decade();
    context.apply(ChangeStiffnesses{with_ratio(stiffnesses, scale.ratio(std::clamp(place, 0.0, 1.0)), snap)});
  }
  const bool is_used = ImGui::IsItemActive() || is_focused();
  const std::optional<HandNeedle> needle = hand_needle(context.loop.hand.estimate, stiffnesses.k_r);
  const bool is_at_needle = needle && std::abs(ImGui::GetIO().MousePos.x - x_of(scale.place(needle->ratio))) < radius;
  tooltip(is_at_needle ? Term::live_ratio : Term::tracking_ratio);

  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const float thickness = 5.0F * context.scale;
  draw_list.AddLine({left, track_y}, {left + length, track_y}, packed(theme.panel_border), thickness);
  draw_list.AddRectFilledMultiColor({x_of(0.25), track_y - 0.5F * thickness}, {x_of(0.75), track_y + 0.5F * thickness},
                                    packed(naive), packed(cure), packed(cure), packed(naive));
  const auto stop = [&](double place, Colour colour) {
    const float x = x_of(place);
    draw_list.AddLine({x, track_y - radius}, {x, track_y + radius}, packed(colour), 2.0F * context.scale);
  };
  stop(scale.place(1.0), naive);
  stop(scale.place(optimal), cure);
  // The words over their stops, as far as both have room beside each other.
  const char* const optimal_words = words_of_optimal(context.session);
  const float naive_width = ImGui::CalcTextSize("naïve").x;
  const float optimal_width = ImGui::CalcTextSize(optimal_words).x;
  const float optimal_x = std::clamp(x_of(scale.place(optimal)) - 0.5F * optimal_width, corner.x,
                                     std::max(corner.x, corner.x + width - optimal_width));
  const float naive_end = optimal_x - 0.5F * ImGui::GetFontSize();
  const float naive_x = std::min(x_of(scale.place(1.0)) - 0.5F * naive_width, naive_end - naive_width);
  // In their place, so that nothing below moves.
  const bool acts_on_another = context.settings.active != StrategyId::anisotropic;
  if (is_turning(context, is_used) && acts_on_another) {
    draw_list.AddText(corner, packed(theme.text), "Only Anisotropic uses it.");
  } else {
    draw_list.AddText({optimal_x, corner.y}, packed(theme.strategy_text[index_of(StrategyId::anisotropic)]),
                      optimal_words);
    if (naive_x >= corner.x) {
      draw_list.AddText({naive_x, corner.y}, packed(theme.strategy_text[index_of(StrategyId::naive)]), "naïve");
    }
  }

  const double ratio = tracking_ratio(stiffnesses);
  const ImVec2 knob{x_of(scale.place(ratio)), track_y};
  draw_list.AddCircleFilled(knob, radius, packed(theme.panel_field), 24);
  draw_list.AddCircle(knob, radius, packed(theme.text), 24, 2.0F * context.scale);

  // Beyond the dial's ends the number below tells it alone.
  if (needle && scale.holds(needle->ratio)) {
    const ImU32 ink = packed(theme.accent);
    const float x = x_of(scale.place(needle->ratio));
    const float half = 0.6F * radius;
    draw_list.AddLine({x, track_y - radius}, {x, track_y + radius}, ink, 2.0F * context.scale);
    draw_list.AddTriangleFilled({x - half, track_y - radius - 2.0F * context.scale},
                                {x + half, track_y - radius - 2.0F * context.scale}, {x, track_y - 0.2F * radius}, ink);
    // As the bar of an error: along the track's lower side, with an upright end on either side.
    const float bar_y = track_y + 0.75F * radius;
    const float least_x = x_of(scale.place(needle->least));
    const float greatest_x = x_of(scale.place(needle->greatest));
    draw_list.AddLine({least_x, bar_y}, {greatest_x, bar_y}, ink, 1.5F * context.scale);
    for (const float end : {least_x, greatest_x}) {
      draw_list.AddLine({end, bar_y - 0.4F * radius}, {end, bar_y + 0.4F * radius}, ink, 1.5F * context.scale);
    }
  }

  const float text_y = track_y + radius + 3.0F * context.scale;
  const std::string own = fmt::format("{} = {:.2f}", stiffnesses.chosen_tracking_ratio ? "ρ" : "ρ = ρ*", ratio);
  draw_list.AddText({left, text_y}, packed(theme.text), own.c_str());
  const std::string other = needle                              ? fmt::format("hand: {:.2f}", needle->ratio)
                            : stiffnesses.chosen_tracking_ratio ? fmt::format("ρ* = {:.2f}", optimal)
                                                                : std::string();
  const float other_x = left + length - ImGui::CalcTextSize(other.c_str()).x;
  const float end = left + ImGui::CalcTextSize(own.c_str()).x + 0.5F * ImGui::GetFontSize();
  const ImU32 other_ink = packed(needle ? theme.accent : theme.faint_text);
  if (other_x >= end) draw_list.AddText({other_x, text_y}, other_ink, other.c_str());
}

}  // namespace ghostforce
