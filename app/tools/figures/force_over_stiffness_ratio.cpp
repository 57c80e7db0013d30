#include "app/tools/figures/figures.h"

#include <string_view>

#include "app/files/scene_file.h"
#include "app/tools/figures/curves.h"

namespace ghostforce {
namespace {

constexpr std::string_view stiffness_ratio_scene = "fig3-normal";
constexpr double least_ratio = 0.5;
constexpr double greatest_stiffness_ratio = 50.0;

// The tracking stiffness goes with the rendering stiffness, as in figure 4.
Settings settings_at_stiffness_ratio(Settings settings, double ratio) {
  settings.stiffnesses.k_r = ratio * settings.stiffnesses.k_u;
  settings.stiffnesses.k_t = settings.stiffnesses.k_r;
  return settings;
}

}  // namespace

Curves force_over_stiffness_ratio() {
  const Settings settings = load_scene(std::string(stiffness_ratio_scene)).settings;
  Curves curves;
  for (const double ratio : evenly_in_ratio(least_ratio, greatest_stiffness_ratio, 129)) {
    add_closed_forms(settings_at_stiffness_ratio(settings, ratio), ratio, curves);
  }
  // F and A lie on one curve: they are simulated at ratios of their own, so that both are seen.
  int number = 0;
  for (const double ratio : evenly_in_ratio(least_ratio, greatest_stiffness_ratio, 17)) {
    add_simulated(settings_at_stiffness_ratio(settings, ratio),
                  number % 2 == 0 ? StrategyId::full : StrategyId::anisotropic, ratio, curves);
    if (number % 2 == 0) add_simulated(settings_at_stiffness_ratio(settings, ratio), StrategyId::naive, ratio, curves);
    ++number;
  }
  return curves;
}

Figure force_over_stiffness_ratio_figure(const FigureRequest&) {
  const Curves curves = force_over_stiffness_ratio();
  Sheet sheet("Force along the actuated direction, over the stiffness ratio", 520.0);
  add_force_chart(curves,
                  {.title = "rendering stiffness over hand stiffness, kᵣ/kᵤ",
                   .is_logarithmic = true,
                   .range = Vector<2>(least_ratio, greatest_stiffness_ratio)},
                  sheet);
  return sheet.finish(
      "Wall at 45° to the motor, goal 20 mm inside. Lines: equations (11), (15) and (20). Points: the simulated loop. "
      "A lies on F. The excess of N over them is the ghost force, which grows with the ratio.",
      provenance_of_scene(std::string(stiffness_ratio_scene) + ", k_r = k_t varied"),
      force_table(curves, "stiffness_ratio"));
}

}  // namespace ghostforce
