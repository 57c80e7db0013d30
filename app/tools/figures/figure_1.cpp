#include "app/tools/figures/figures.h"

#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/files/scene_file.h"
#include "app/tools/figures/scene_pane.h"

namespace ghostforce {

SimulatedMotion one_motion() {
  return simulate_motion("", load_scene("fig1"));
}

Figure one_motion_figure(const FigureRequest&) {
  const SimulatedMotion motion = one_motion();
  Sheet sheet("One motion into a slanted wall", 520.0);
  ScenePicture picture = picture_of(motion, "A", "B");
  std::vector<LegendEntry> legend = motion_legend();
  // A is a place here; the paper's letter for the cure is O.
  constexpr std::size_t cure = index_of(StrategyId::anisotropic);
  const Vector<2> end = motion.moments.back().strategies[cure].device;
  for (FigurePoint& point : picture.points) {
    if (point.at == end && !point.name.empty()) point.name = "O";
  }
  legend[cure].name = fmt::format("O  {}", strategy(StrategyId::anisotropic).title);
  add_scenes(sheet, 370.0, {std::move(picture)}, 1);
  sheet.add_legend(legend);
  return sheet.finish(
      "The hand goes from A to B. The fully actuated device ends at F. With naïve rendering, the underactuated one "
      "ends at N, to the left of where it came in. With anisotropic rendering, it ends at O (A in the other figures), "
      "below F: along the actuated direction, the wall feels the same.",
      provenance_of_scene("fig1"), table_of(std::span(&motion, 1)));
}

}  // namespace ghostforce
