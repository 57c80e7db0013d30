// How the wall is rendered: the three stiffnesses of the renderer and the ρ dial.
#include <cmath>
#include <limits>

#include "app/panels/controls.h"
#include "app/panels/panel_catalog.h"
#include "app/panels/ratio_dial.h"

namespace ghostforce {
namespace {

constexpr SliderLimits rendering_limits{1.0, 20000.0};
constexpr SliderLimits constraint_limits{100.0, 1e7};
constexpr double first_soft_constraint = 1e5;  // when "hard" is switched off [N/m]

void draw_constraint(Impedances& impedances, float scale) {
  bool hard = std::isinf(impedances.k_c);
  const float switch_width = ImGui::CalcTextSize("hard").x + ImGui::GetFrameHeight() + 14.0F * scale;
  ImGui::SetNextItemWidth(-switch_width);
  if (hard) {
    ImGui::BeginDisabled();
    double shown = constraint_limits.greatest;
    ImGui::SliderScalar("##k_c", ImGuiDataType_Double, &shown, &constraint_limits.least, &constraint_limits.greatest,
                        "∞ N/m", ImGuiSliderFlags_Logarithmic);
    ImGui::EndDisabled();
  } else {
    stiffness_slider("##k_c", impedances.k_c, constraint_limits);
  }
  ImGui::SameLine();
  if (ImGui::Checkbox("hard", &hard)) {
    impedances.k_c = hard ? std::numeric_limits<double>::infinity() : first_soft_constraint;
  }
  explain("The hard constraint, k_c = ∞: the proxy never enters the wall.");
}

}  // namespace

void draw_rendering(const PanelContext& context) {
  Impedances& impedances = context.session.settings.impedances;
  if (!begin_rows("rendering", context)) return;
  row("Rendering k_r",
      "Stiffness of the spring that pushes the device towards the proxy, f_r = K_r (q_p − q_h), in N/m.");
  stiffness_slider("##k_r", impedances.k_r, rendering_limits);
  row("Tracking k_t",
      "Stiffness with which the proxy follows the device where there is a motor, f_t = K_t (q_h − q_p), in N/m.");
  stiffness_slider("##k_t", impedances.k_t, rendering_limits);
  row("Constraint k_c", "Stiffness with which the wall holds the proxy back, f_c = k_c (q_c − q_p), in N/m.");
  draw_constraint(impedances, context.scale);
  row("Ratio ρ", "The dial of the anisotropic strategy: from naïve to the cure and beyond.");
  draw_ratio_dial(context);
  end_rows();
}

}  // namespace ghostforce
