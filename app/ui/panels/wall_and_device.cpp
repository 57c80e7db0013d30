// Which way the wall faces, and which way the device can push.
#include "app/ui/panels/panel_catalog.h"
#include "app/ui/widgets/controls.h"

namespace ghostforce {

void draw_wall_and_device(const PanelContext& context) {
  Settings& settings = context.session.settings;
  if (!begin_rows("wall", context)) return;
  row("Wall normal", Term::wall_normal);
  angle_slider("##normal", settings.wall_normal_angle);
  row("Actuated direction", Term::motor_axis);
  angle_slider("##actuated", settings.actuated_angle);
  end_rows();
}

}  // namespace ghostforce
