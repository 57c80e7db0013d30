// The hand: how stiff it is, and how stiff the renderer believes it to be.
#include "app/panels/controls.h"
#include "app/panels/panel_catalog.h"

namespace ghostforce {

void draw_user(const PanelContext& context) {
  constexpr SliderLimits limits{10.0, 10000.0};
  Impedances& impedances = context.session.settings.impedances;
  if (!begin_rows("user", context)) return;
  row("Hand k_u", "Stiffness of the user's hand, f_u = k_u (q_u − q_h), in N/m.");
  stiffness_slider("##k_u", impedances.k_u, limits);
  row("Believed k_u",
      "The hand's stiffness that the renderer assumes when it computes ρ*. It cannot measure it; a wrong belief shows "
      "as "
      "drift, in N/m.");
  bool right = !impedances.believed_k_u.has_value();
  const float switch_width = ImGui::CalcTextSize("right").x + ImGui::GetFrameHeight() + 14.0F * context.scale;
  double believed = believed_user_stiffness(impedances);
  ImGui::SetNextItemWidth(-switch_width);
  if (stiffness_slider("##believed", believed, limits)) impedances.believed_k_u = believed;
  ImGui::SameLine();
  if (ImGui::Checkbox("right", &right)) {
    impedances.believed_k_u = right ? std::nullopt : std::optional(impedances.k_u);
  }
  explain("The renderer happens to know the hand's true stiffness.");
  end_rows();
}

}  // namespace ghostforce
