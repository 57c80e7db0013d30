// The hand: how stiff it is, how stiff the renderer believes it to be, and what a wrong belief does.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "app/picture/text.h"
#include "app/state/user_measurement_guide.h"
#include "app/widgets/controls.h"
#include "app/workbench/panel_catalog.h"
#include "core/belief.h"
#include "core/conventions.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

// Seven characters at least.
std::string millimetres(const Vector<2>& drift) {
  return fmt::format("{:>4} mm", decimal_text(mm_per_m * glm::length(drift), 1));
}

// The error of the belief, where it can be seen: the drift that the anisotropic strategy is left with.
void draw_drift_of_belief(const PanelContext& context) {
  row("Anisotropic drift", Term::drift_of_belief);
  ImGui::AlignTextToFramePadding();
  const Settings& settings = context.settings;
  if (context.snapshot.measured) {
    ImGui::TextUnformatted("—");
    tooltip(
        "Cannot be known: the goal of a real hand is only estimated, from the force and this very belief. Measure the "
        "hand "
        "instead.");
    return;
  }
  if (settings.stiffnesses.chosen_tracking_ratio) {
    wrapped_text("—  ρ chosen by you");
    tooltip(
        "The belief has no effect on a ρ that you chose. At the optimal ratio, a drift here means that the belief is "
        "wrong.");
    return;
  }
  const Vector<2> seen = context.snapshot.strategies[index_of(StrategyId::anisotropic)].proxy_drift;
  const auto rest = rest_of(StrategyId::anisotropic, settings, context.snapshot.goal);
  text_in(context.fonts.number, millimetres(seen));
  tooltip("The simulated drift of the anisotropic strategy along the wall.");
  if (hides_answer(context.session) || !rest) return;
  same_line_if_room(ImGui::CalcTextSize("theory").x + ImGui::GetItemRectSize().x + ImGui::GetStyle().ItemSpacing.x);
  ImGui::PushStyleColor(ImGuiCol_Text, unpacked(context.theme.faint_text));
  ImGui::TextUnformatted("theory");
  ImGui::SameLine();
  text_in(context.fonts.number, millimetres(rest->proxy_drift));
  ImGui::PopStyleColor();
  tooltip("The drift at rest, from the closed form.");
}

// While the hand is measured, or has been and is not revealed yet, its given stiffness stands nowhere.
void draw_hidden_hand(const PanelContext& context) {
  const Session& session = context.session;
  row("Hand k_u", Term::user_stiffness);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("hidden");
  if (session.measurement.given_k_u) {
    tooltip("Hidden for a blind measurement: the given stiffness is the answer.");
    ImGui::SameLine();
    if (ImGui::Button("Reveal")) context.apply(RevealHand{});
    tooltip(is_measuring(session) ? "Shows the given k_u. The measurement is not blind then, and its result says so."
                                  : "Shows the stiffness that the simulated hand was given.");
  } else {
    tooltip("Hidden while this hand is measured: nobody knows its stiffness yet.");
  }
  row("Believed k_u", Term::believed_user_stiffness);
  ImGui::AlignTextToFramePadding();
  const std::optional<double>& believed = session.settings.stiffnesses.believed_k_u;
  if (session.belief_source == BeliefSource::live) {
    ImGui::TextUnformatted("live");
    tooltip("Hidden for a blind measurement: a belief that follows the hand is the answer.");
    return;
  }
  ImGui::TextUnformatted(believed ? fmt::format("{} N/m", decimal_text(*believed, 1)).c_str() : "same as the hand's");
}

// A choice in the list of where the belief comes from; true when it is made.
template <typename Explanation>
bool belief_choice(const char* name, bool is_chosen, const Explanation& explanation) {
  const bool is_made = ImGui::Selectable(name, is_chosen) && !is_chosen;
  if (is_chosen) ImGui::SetItemDefaultFocus();
  tooltip(explanation);
  return is_made;
}

const char* name_of_source(const Session& session) {
  switch (session.belief_source) {
    case BeliefSource::live:
      return "live";
    case BeliefSource::measured:
      return "measured";
    case BeliefSource::typed:
      break;
  }
  return session.settings.stiffnesses.believed_k_u ? "typed" : "same";
}

void draw_belief_source(const PanelContext& context) {
  const Session& session = context.session;
  const Stiffnesses& stiffnesses = session.settings.stiffnesses;
  const std::string_view chosen = name_of_source(session);
  ImGui::SetNextItemWidth(-1.0F);
  if (ImGui::BeginCombo("##source", chosen.data())) {
    close_popup_on_escape();
    const auto type = [&](std::optional<double> believed) { context.apply(Believe{BeliefSource::typed, believed}); };
    if (belief_choice("same", chosen == "same", Term::right_belief)) type(std::nullopt);
    if (belief_choice("typed", chosen == "typed", "The renderer believes what you set here.")) {
      type(believed_user_stiffness(stiffnesses));
    }
    ImGui::BeginDisabled(!session.measured_k_u);
    if (belief_choice("measured", chosen == "measured",
                      "What was measured last: by “Measure the hand”, or on the stage.")) {
      context.apply(Believe{BeliefSource::measured});
    }
    ImGui::EndDisabled();
    if (belief_choice("live", chosen == "live",
                      "Two small tones in the motor's force measure the hand all the time, and the belief follows it. "
                      "You can feel them: about 0.7 mm.")) {
      context.apply(Believe{BeliefSource::live});
    }
    ImGui::EndCombo();
  }
  tooltip("Where the belief comes from: the same as the hand's own, typed, measured, or live, following the hand.");
}

void draw_belief(const PanelContext& context, const SliderLimits& limits) {
  const Session& session = context.session;
  Stiffnesses stiffnesses = session.settings.stiffnesses;
  const ImGuiStyle& style = ImGui::GetStyle();
  const float source_width = ImGui::CalcTextSize("measured").x + ImGui::GetFrameHeight() + 2.0F * style.FramePadding.x;
  const float left = ImGui::GetCursorPosX();
  const float room = ImGui::GetContentRegionAvail().x;
  const float beside = room - source_width - style.ItemSpacing.x;
  const bool follows = session.belief_source == BeliefSource::live;
  const float line = ImGui::GetTextLineHeight();
  const float needed = ImGui::CalcTextSize("1000 N/m").x + (follows ? line : 0.0F);
  const bool has_one_line = needed <= beside;
  double believed = believed_user_stiffness(stiffnesses);
  if (follows) {
    // No field: nobody sets it. The dial's needle stands before it.
    ImGui::AlignTextToFramePadding();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float top = corner.y + style.FramePadding.y;
    ImGui::GetWindowDrawList()->AddTriangleFilled(
        {corner.x, top + 0.25F * line}, {corner.x + 0.7F * line, top + 0.25F * line},
        {corner.x + 0.35F * line, top + 0.85F * line}, packed(context.theme.accent));
    ImGui::SetCursorPosX(left + line);
    ImGui::TextUnformatted(fmt::format("{} N/m", decimal_text(believed, believed < 100.0 ? 1 : 0)).c_str());
    tooltip("What the renderer believes now. It follows the hand; to set it yourself, choose “typed”, or turn ρ.");
  } else {
    ImGui::SetNextItemWidth(has_one_line ? beside : room);
    if (stiffness_slider("##believed", "believed_k_u_N_per_m", believed, limits)) {
      stiffnesses.believed_k_u = believed;
      context.apply(ChangeStiffnesses{stiffnesses});
    }
    if (session.belief_source == BeliefSource::measured) {
      // A frame of its own, as of something that was found out.
      ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                          packed(context.theme.accent), style.FrameRounding, ImDrawFlags_None,
                                          2.0F * context.scale);
    }
  }
  if (has_one_line) {
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + beside + style.ItemSpacing.x);
  }
  draw_belief_source(context);
}

// What a belief that follows does while nobody knows the hand.
std::string words_of_waiting(const PanelContext& context) {
  Settings settings = context.session.settings;
  if (const double held = context.loop.motors.held_k_r; held > 0.0) settings.stiffnesses.k_r = held;
  const double believed = believed_user_stiffness(settings.stiffnesses);
  if (context.loop.hand_unknown_s <= BeliefFollower::holds_s) {
    return fmt::format("The belief holds {} N/m.", decimal_text(believed, 0));
  }
  const double least_regret = least_regret_belief(settings);
  return fmt::format("{} {} N/m, the value of least regret.",
                     believed == least_regret ? "The belief is" : "The belief is going to",
                     decimal_text(least_regret, 0));
}

// What it does while the hand is known.
std::string words_of_following(const PanelContext& context) {
  const double believed = believed_user_stiffness(context.session.settings.stiffnesses);
  const bool is_near = std::abs(std::log(context.loop.hand.estimate.k_u / believed)) <= BeliefFollower::hysteresis;
  return is_near ? "The belief stays: it is within 10 % of that." : "The belief is moving there.";
}

// Always as high, so that nothing below moves when the hand becomes known or unknown.
void draw_live_hand(const PanelContext& context) {
  constexpr float lines = 4.0F;
  row("Measured live", Term::live_user_stiffness);
  const HandEstimate& hand = context.loop.hand.estimate;
  const float top = ImGui::GetCursorPosY();
  const bool follows = context.session.belief_source == BeliefSource::live;
  ImGui::BeginGroup();
  if (hand.is_known()) {
    text_in(context.fonts.number, fmt::format("{:>4} ± {} N/m", decimal_text(hand.k_u, 0), deviation_text(hand.sigma)));
    ImGui::SameLine();
    if (ImGui::SmallButton("Plot")) {
      PlotView plots = context.session.plots;
      plots.is_open = true;
      plots.tab = PlotTab::hand;
      context.apply(ChangePlots{plots});
    }
    tooltip("Over the last minute, in the plots below.");
  } else {
    wrapped_text(fmt::format("Unknown. {}", sentence_of(hand.why)));
  }
  if (follows) {
    ImGui::PushStyleColor(ImGuiCol_Text, unpacked(context.theme.faint_text));
    wrapped_text(hand.is_known() ? words_of_following(context) : words_of_waiting(context));
    ImGui::PopStyleColor();
  }
  ImGui::EndGroup();
  tooltip(
      "While the hand is unknown, a live belief holds for 3 s, then goes to the one of least regret for a hand of 50 "
      "to 1000 N/m. For a very stiff hand that can be worse than naïve rendering: for example 2.1 times its ghost "
      "force at 1000 N/m with k_r 600 N/m and a wall at 45°.");
  ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), top + lines * ImGui::GetTextLineHeightWithSpacing()));
  ImGui::Dummy({0.0F, 0.0F});
}

}  // namespace

void draw_user(const PanelContext& context) {
  constexpr SliderLimits limits{10.0, 10000.0};
  Stiffnesses stiffnesses = context.session.settings.stiffnesses;
  if (!begin_rows("user", context)) return;
  if (hides_answer(context.session)) {
    draw_hidden_hand(context);
    draw_drift_of_belief(context);
    end_rows();
    return;
  }
  row("Hand k_u", Term::user_stiffness);
  if (stiffness_slider("##k_u", "k_u_N_per_m", stiffnesses.k_u, limits)) {
    context.apply(ChangeStiffnesses{stiffnesses});
  }
  row("Believed k_u", Term::believed_user_stiffness);
  draw_belief(context, limits);
  if (context.session.belief_source == BeliefSource::live || context.loop.hand.is_measuring) draw_live_hand(context);
  draw_drift_of_belief(context);
  end_rows();
}

}  // namespace ghostforce
