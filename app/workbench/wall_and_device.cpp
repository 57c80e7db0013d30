// Which way the wall faces, and which way the device can push.
#include "app/widgets/controls.h"
#include "app/workbench/panel_catalog.h"

namespace ghostforce {

void draw_wall_and_device(const PanelContext& context) {
  const Settings& settings = context.session.settings;
  if (!begin_rows("wall", context)) return;
  row("Wall normal", Term::wall_normal);
  double normal = settings.wall_normal_angle;
  if (angle_slider("##normal", normal)) context.apply(TurnWallTo{normal});
  row("Actuated direction", Term::motor_axis);
  double actuated = settings.actuated_angle;
  if (angle_slider("##actuated", actuated)) context.apply(TurnMotorTo{actuated});
  end_rows();
}

}  // namespace ghostforce
