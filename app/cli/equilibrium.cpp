// ghostforce equilibrium: where everything comes to rest, by closed form.
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/cli/command.h"
#include "app/cli/option.h"
#include "core/conventions.h"
#include "core/prediction.h"

namespace ghostforce {
namespace {

struct EquilibriumOptions {
  SceneOptions scene;
  std::optional<std::string> goal_mm;  // empty: the scene's last waypoint
  bool json = false;
};

// −0 is a zero too.
nlohmann::ordered_json as_json(const Vector<2>& vector) {
  return {vector.x + 0.0, vector.y + 0.0};
}

std::string json_text(double goal_depth, const PerStrategy<PredictedEquilibrium>& equilibria) {
  nlohmann::ordered_json strategies;
  for (const Strategy& strategy : strategy_catalog()) {
    const PredictedEquilibrium& rest = equilibria[index_of(strategy.id)];
    strategies[std::string(strategy.name)] = {
        {"goal_m", as_json(rest.at.goal)},
        {"proxy_m", as_json(rest.at.proxy)},
        {"device_m", as_json(rest.at.device)},
        {"contact_m", as_json(rest.at.contact)},
        {"force_N", as_json(rest.at.force)},
        {"ghost_force_N", as_json(rest.ghost_force)},
        {"proxy_drift_m", as_json(rest.proxy_drift)},
    };
  }
  return nlohmann::ordered_json{{"depth_m", goal_depth + 0.0}, {"strategies", strategies}}.dump() + "\n";
}

// A number as people read it; what rounds to zero has no sign.
std::string shown(double value) {
  constexpr double least_shown = 0.0005;
  return fmt::format("{:.3f}", std::abs(value) < least_shown ? 0.0 : value);
}

std::string shown(const Vector<2>& vector) {
  return fmt::format("({}, {})", shown(vector.x), shown(vector.y));
}

std::string table_text(const Scene& scene, double goal_depth, const PerStrategy<PredictedEquilibrium>& equilibria) {
  struct Row {
    std::string_view title;
    std::string_view unit;
    double per_si;
    Vector<2> (*of)(const PredictedEquilibrium&);
  };
  constexpr std::array rows{
      Row{"proxy", "mm", mm_per_m, [](const PredictedEquilibrium& rest) { return rest.at.proxy; }},
      Row{"device", "mm", mm_per_m, [](const PredictedEquilibrium& rest) { return rest.at.device; }},
      Row{"contact", "mm", mm_per_m, [](const PredictedEquilibrium& rest) { return rest.at.contact; }},
      Row{"force", "N", 1.0, [](const PredictedEquilibrium& rest) { return rest.at.force; }},
      Row{"ghost force", "N", 1.0, [](const PredictedEquilibrium& rest) { return rest.ghost_force; }},
      Row{"proxy drift", "mm", mm_per_m, [](const PredictedEquilibrium& rest) { return rest.proxy_drift; }},
  };
  const bool inside = goal_depth > 0.0;
  std::string text =
      fmt::format("{}\ngoal {} mm, {} mm {} the wall; tracking ratio {}\n\n{:16}", quoted_text(scene.title),
                  shown(mm_per_m * equilibria[0].at.goal), shown(mm_per_m * std::abs(goal_depth)),
                  inside ? "inside" : "outside", tracking_ratio(scene.settings.stiffnesses), "");
  for (const Strategy& strategy : strategy_catalog()) {
    text += fmt::format("  {:>22}", fmt::format("{} {}", strategy.letter, strategy.name));
  }
  text += "\n";
  for (const Row& row : rows) {
    text += fmt::format("{:12}{:4}", row.title, row.unit);
    for (const PredictedEquilibrium& rest : equilibria)
      text += fmt::format("  {:>22}", shown(row.per_si * row.of(rest)));
    text += "\n";
  }
  return text;
}

int equilibrium(const EquilibriumOptions& options) {
  Scene scene = options.scene.load();
  scene.settings = settings_at(scene, scene.settings, scene.duration);
  const Vector<2> goal = options.goal_mm ? position_from_mm("--goal-mm", *options.goal_mm) : scene.goal.points.back();
  const double goal_depth = depth(wall_of(scene.settings), goal);
  const PerStrategy<PredictedEquilibrium> equilibria = predicted_equilibria(scene.settings, goal);
  print(options.json ? json_text(goal_depth, equilibria) : table_text(scene, goal_depth, equilibria));
  return static_cast<int>(ExitCode::done);
}

}  // namespace

std::function<int()> attach_equilibrium(CLI::App& command, FileOptions& files) {
  const auto options = std::make_shared<EquilibriumOptions>();
  options->scene.attach(command, files, true);
  add_option(command, "--goal-mm X,Y", options->goal_mm,
             "Where the hand wants to be, in mm; default: the scene's last waypoint");
  command.add_flag("--json", options->json, "Print JSON for programs, in SI units with all digits");
  return [options] { return equilibrium(*options); };
}

}  // namespace ghostforce
