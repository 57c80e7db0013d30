#include "app/tools/figures/figures.h"

#include <fmt/format.h>

#include <utility>

#include "app/files/scene_file.h"
#include "app/tools/figures/scene_pane.h"

namespace ghostforce {

std::vector<SimulatedMotion> stiffness_ratios() {
  std::vector<SimulatedMotion> motions;
  for (const int ratio : {1, 5, 10, 20}) {
    motions.push_back(
        simulate_motion(fmt::format("k_r/k_u = {}", ratio), load_scene(fmt::format("fig4-ratio{}", ratio))));
  }
  return motions;
}

Figure stiffness_ratios_figure(const FigureRequest&) {
  const std::vector<SimulatedMotion> motions = stiffness_ratios();
  Sheet sheet("Stiffer rendering, larger ghost force", 700.0);
  std::vector<ScenePicture> pictures;
  for (const SimulatedMotion& motion : motions) {
    ScenePicture picture = picture_of(motion, "", "");
    const Stiffnesses& k = motion.scene.settings.stiffnesses;
    picture.title = fmt::format("kᵣ/kᵤ = {:g}", k.k_r / k.k_u);
    constexpr std::size_t naive = index_of(StrategyId::naive);
    const StrategySnapshot<2>& now = motion.moments.back().strategies[naive];
    picture.arrows.push_back({.tail = now.device,
                              .force = now.ghost_force,
                              .colour = paper().strategy[naive],
                              .letters = paper().strategy_text[naive],
                              .name = fmt::format("{:.2f} N", glm::length(now.ghost_force)),
                              .is_hollow = true});
    pictures.push_back(std::move(picture));
  }
  add_scenes(sheet, 280.0, std::move(pictures), 2);
  sheet.add_legend(motion_legend());
  return sheet.finish(
      "The same motion into the wall at four ratios of rendering stiffness to hand stiffness. Hollow arrow: the ghost "
      "force at rest under naïve rendering. With anisotropic rendering there is none at any ratio.",
      provenance_of_scene("fig4-ratio1, fig4-ratio5, fig4-ratio10, fig4-ratio20"), table_of(motions));
}

}  // namespace ghostforce
