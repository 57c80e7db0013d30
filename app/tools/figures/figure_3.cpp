#include "app/tools/figures/figures.h"

#include <utility>

#include "app/files/scene_file.h"
#include "app/tools/figures/scene_pane.h"

namespace ghostforce {

std::vector<SimulatedMotion> directions_of_intent() {
  return {simulate_motion("down (no motor there)", load_scene("fig3-nonactuated")),
          simulate_motion("straight into the wall", load_scene("fig3-normal")),
          simulate_motion("to the right (along the motor)", load_scene("fig3-actuated"))};
}

Figure directions_of_intent_figure(const FigureRequest&) {
  const std::vector<SimulatedMotion> motions = directions_of_intent();
  Sheet sheet("Three directions of intent", 900.0);
  std::vector<ScenePicture> pictures;
  for (const SimulatedMotion& motion : motions) pictures.push_back(picture_of(motion, "", ""));
  add_scenes(sheet, 290.0, std::move(pictures), 3);
  sheet.add_legend(motion_legend());
  return sheet.finish(
      "The hand goes down, where the device cannot push; straight into the wall; and to the right, where the motor can "
      "push. Along the actuated direction, A rests where F does each time. N is dragged to the left. When the hand "
      "goes straight in, N even ends on the other side of where it came in.",
      provenance_of_scene("fig3-nonactuated, fig3-normal, fig3-actuated"), table_of(motions));
}

}  // namespace ghostforce
