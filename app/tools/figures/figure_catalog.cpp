#include "app/tools/figures/figure.h"

#include "app/base/interruption.h"
#include "app/files/csv_table.h"
#include "app/paint/vector/vector_file_painter.h"
#include "app/tools/figures/figures.h"

namespace ghostforce {
namespace {

constexpr std::array catalog{
    FigureEntry{"figure-1", "One motion into a slanted wall, and where the devices go", one_motion_figure},
    FigureEntry{"figure-2", "The three equilibria: goal, device, proxy and contact", three_equilibria_figure},
    FigureEntry{"figure-3", "Three directions of intent", directions_of_intent_figure},
    FigureEntry{"figure-4", "Stiffness ratios k_r/k_u = 1, 5, 10, 20", stiffness_ratios_figure},
    FigureEntry{"figure-6", "One hand under the three strategies; see --hand", one_hand_figure, true},
    FigureEntry{"force-over-wall-angle", "Force along the actuated direction over the wall's angle",
                force_over_wall_angle_figure},
    FigureEntry{"force-over-stiffness-ratio", "Force along the actuated direction over k_r/k_u",
                force_over_stiffness_ratio_figure},
    FigureEntry{"proxy-drift", "Proxy drift over the tracking ratio and over a wrong belief", proxy_drift_figure},
    FigureEntry{"energy-per-loop", "Energy per closed loop over the tracking ratio", energy_per_loop_figure},
    FigureEntry{"hand-estimate", "The hand measured live while its stiffness jumps", hand_estimate_figure},
    FigureEntry{"wrong-belief", "What a wrong belief about the hand costs", wrong_belief_figure},
    FigureEntry{"which-walls", "Which walls are bad for an arm, with its motor at the base and at the elbow",
                which_walls_figure},
};

}  // namespace

std::span<const FigureEntry> figure_catalog() noexcept {
  return catalog;
}

namespace {

constexpr double density = 2.0;  // of the smaller PNG [pixels per point]

std::string content_of(const Figure& figure, std::string_view ending, const std::string& file_name) {
  if (ending == ".csv") return csv_text(figure.data);
  const Theme& theme = paper();
  return paint_file({.panes = figure.panes,
                     .theme = theme,
                     .size = figure.size,
                     .text_scale = theme.thickness,
                     .title = figure.title,
                     .density = ending == "@2x.png" ? 2.0 * density : density},
                    file_name);
}

}  // namespace

std::vector<NamedFile> figure_files(std::string_view name, const Figure& figure) {
  std::vector<NamedFile> files;
  for (const std::string_view ending : figure_file_endings) {
    stop_if_interrupted();
    const std::string file_name = std::string(name) + std::string(ending);
    files.push_back({file_name, content_of(figure, ending, file_name)});
  }
  return files;
}

}  // namespace ghostforce
