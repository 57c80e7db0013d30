// The hand: how stiff it is, and how stiff the renderer believes it to be.
#include "app/panels/controls.h"
#include "app/panels/panel_catalog.h"

namespace ghostforce {

void draw_user(const PanelContext& context) {
  constexpr SliderLimits limits{10.0, 10000.0};
  Impedances& impedances = context.session.settings.impedances;
  if (!begin_rows("user", context)) return;
  row("Hand k_u", Term::user_stiffness);
  stiffness_slider("##k_u", "k_u_N_per_m", impedances.k_u, limits);
  row("Believed k_u", Term::believed_user_stiffness);
  bool right = !impedances.believed_k_u.has_value();
  const float switch_width = ImGui::CalcTextSize("same").x + ImGui::GetFrameHeight() + 14.0F * context.scale;
  double believed = believed_user_stiffness(impedances);
  ImGui::SetNextItemWidth(-switch_width);
  if (stiffness_slider("##believed", "believed_k_u_N_per_m", believed, limits)) impedances.believed_k_u = believed;
  ImGui::SameLine();
  if (ImGui::Checkbox("same", &right)) {
    impedances.believed_k_u = right ? std::nullopt : std::optional(impedances.k_u);
  }
  explain(Term::right_belief);
  end_rows();
}

}  // namespace ghostforce
