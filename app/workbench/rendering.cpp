// How the wall is rendered: the three stiffnesses of the renderer and the ρ dial; and which way the wall faces and the
// device can push.
#include <cmath>
#include <limits>

#include "app/widgets/controls.h"
#include "app/workbench/panel_catalog.h"
#include "app/workbench/ratio_dial.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

constexpr SliderLimits rendering_limits{1.0, 20000.0};
constexpr SliderLimits constraint_limits{100.0, 1e7};
constexpr double first_soft_constraint = 1e5;  // when "hard" is switched off [N/m]

void draw_constraint(Stiffnesses& stiffnesses, float scale) {
  bool hard = std::isinf(stiffnesses.k_c);
  const float switch_width = ImGui::CalcTextSize("hard").x + ImGui::GetFrameHeight() + 14.0F * scale;
  ImGui::SetNextItemWidth(-switch_width);
  if (hard) {
    ImGui::BeginDisabled();
    double shown = constraint_limits.greatest;
    slider("##k_c", shown, constraint_limits, "∞ N/m", ImGuiSliderFlags_Logarithmic);
    ImGui::EndDisabled();
  } else {
    stiffness_slider("##k_c", "k_c_N_per_m", stiffnesses.k_c, constraint_limits);
  }
  ImGui::SameLine();
  if (ImGui::Checkbox("hard", &hard)) {
    stiffnesses.k_c = hard ? std::numeric_limits<double>::infinity() : first_soft_constraint;
  }
  tooltip(Term::hard_constraint);
}

}  // namespace

void draw_rendering(const PanelContext& context) {
  Stiffnesses stiffnesses = context.session.settings.stiffnesses;
  if (!begin_rows("rendering", context)) return;
  row("Rendering k_r", Term::rendering_stiffness);
  stiffness_slider("##k_r", "k_r_N_per_m", stiffnesses.k_r, rendering_limits);
  row("Tracking k_t", Term::tracking_stiffness);
  stiffness_slider("##k_t", "k_t_N_per_m", stiffnesses.k_t, rendering_limits);
  row("Constraint k_c", Term::constraint_stiffness);
  draw_constraint(stiffnesses, context.scale);
  if (stiffnesses != context.session.settings.stiffnesses) context.apply(ChangeStiffnesses{stiffnesses});
  if (!is_general(context.session.settings)) {
    row("Ratio ρ", Term::tracking_ratio);
    draw_ratio_dial(context);
  }
  end_rows();
}

void draw_wall_and_device(const PanelContext& context) {
  const Settings& settings = context.session.settings;
  const bool has_plane = settings.general.constraint == ConstraintKind::plane;
  const bool has_axis = settings.general.mechanism == MechanismKind::axes;
  if (begin_rows("wall", context)) {
    if (has_plane) {
      row("Wall normal", Term::wall_normal);
      double normal = settings.wall_normal_angle;
      if (angle_slider("##normal", normal)) context.apply(TurnWallTo{normal});
    }
    if (has_axis) {
      row("Actuated direction", Term::motor_axis);
      double actuated = settings.actuated_angle;
      if (angle_slider("##actuated", actuated)) context.apply(TurnMotorTo{actuated});
    }
    end_rows();
  }
  if (has_joints(settings) && ImGui::Button("Motor to the other joint")) context.apply(SwitchMotor{});
  if (!has_plane || !has_axis) wrapped_text("On the stage (F4), drag the walls, the base and the joints.");
}

}  // namespace ghostforce
