// The hand: how stiff it is, how stiff the renderer believes it to be, and what a wrong belief does.
#include <fmt/format.h>

#include <string>

#include "app/session/measurement_guide.h"
#include "app/ui/panels/panel_catalog.h"
#include "app/ui/widgets/controls.h"
#include "app/view/number_text.h"
#include "core/prediction.h"
#include "core/units.h"

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
        "Cannot be known: the goal of a real hand is only inferred, from this very belief. Measure the hand instead.");
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
  const Vector<2> predicted =
      predicted_equilibria(settings, context.snapshot.goal)[index_of(StrategyId::anisotropic)].proxy_drift;
  text_in(context.fonts.number, millimetres(seen));
  tooltip("The simulated drift of the anisotropic strategy along the wall.");
  if (hides_answer(context.session)) return;
  same_line_if_room(ImGui::CalcTextSize("theory").x + ImGui::GetItemRectSize().x + ImGui::GetStyle().ItemSpacing.x);
  ImGui::PushStyleColor(ImGuiCol_Text, unpacked(context.theme.faint_text));
  ImGui::TextUnformatted("theory");
  ImGui::SameLine();
  text_in(context.fonts.number, millimetres(predicted));
  ImGui::PopStyleColor();
  tooltip("The drift at rest, from the closed form.");
}

// While the hand is measured, or has been and is not revealed yet, its given stiffness stands nowhere.
void draw_hidden_hand(const PanelContext& context) {
  Session& session = context.session;
  row("Hand k_u", Term::user_stiffness);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("hidden");
  if (session.measurement.given_k_u) {
    tooltip("Hidden for a blind measurement: the given stiffness is the answer.");
    ImGui::SameLine();
    if (ImGui::Button("Reveal")) reveal_hand(session);
    tooltip(is_measuring(session) ? "Shows the given k_u. The measurement is not blind then, and its result says so."
                                  : "Shows the stiffness that the simulated hand was given.");
  } else {
    tooltip("Hidden while this hand is measured: nobody knows its stiffness yet.");
  }
  row("Believed k_u", Term::believed_user_stiffness);
  ImGui::AlignTextToFramePadding();
  const std::optional<double>& believed = session.settings.stiffnesses.believed_k_u;
  ImGui::TextUnformatted(believed ? fmt::format("{} N/m", decimal_text(*believed, 1)).c_str() : "same as the hand's");
}

}  // namespace

void draw_user(const PanelContext& context) {
  constexpr SliderLimits limits{10.0, 10000.0};
  Stiffnesses& stiffnesses = context.session.settings.stiffnesses;
  if (!begin_rows("user", context)) return;
  if (hides_answer(context.session)) {
    draw_hidden_hand(context);
    draw_drift_of_belief(context);
    end_rows();
    return;
  }
  row("Hand k_u", Term::user_stiffness);
  stiffness_slider("##k_u", "k_u_N_per_m", stiffnesses.k_u, limits);
  row("Believed k_u", Term::believed_user_stiffness);
  bool right = !stiffnesses.believed_k_u.has_value();
  const float switch_width = ImGui::CalcTextSize("same").x + ImGui::GetFrameHeight() + 14.0F * context.scale;
  double believed = believed_user_stiffness(stiffnesses);
  ImGui::SetNextItemWidth(-switch_width);
  if (stiffness_slider("##believed", "believed_k_u_N_per_m", believed, limits)) stiffnesses.believed_k_u = believed;
  ImGui::SameLine();
  if (ImGui::Checkbox("same", &right)) {
    stiffnesses.believed_k_u = right ? std::nullopt : std::optional(stiffnesses.k_u);
  }
  tooltip(Term::right_belief);
  draw_drift_of_belief(context);
  end_rows();
}

}  // namespace ghostforce
