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
#include "core/general_equilibrium.h"
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

// --- General scenes --------------------------------------------------------------------------------------------------

using GeneralRests = PerStrategy<std::optional<PredictedGeneralEquilibrium>>;

// What is known where there is no rest.
nlohmann::ordered_json no_rest_json(const Vector<2>& goal) {
  return {{"goal_m", as_json(goal)}, {"no_rest", true}};
}

nlohmann::ordered_json rest_json(const PredictedGeneralEquilibrium& predicted, std::size_t motors, bool are_torques) {
  const auto& [at, contact_force, all_efforts, active] = predicted.rest;
  nlohmann::ordered_json efforts = nlohmann::ordered_json::array();
  nlohmann::ordered_json units = nlohmann::ordered_json::array();
  nlohmann::ordered_json walls = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < motors; ++i) {
    efforts.push_back(all_efforts[i] + 0.0);
    units.push_back(are_torques ? "N·m" : "N");
  }
  for (unsigned i = 0; i < most_planes; ++i) {
    if ((unsigned{active} >> i & 1U) != 0) walls.push_back(i + 1);
  }
  return {
      {"goal_m", as_json(at.goal)},
      {"proxy_m", as_json(at.proxy)},
      {"device_m", as_json(at.device)},
      {"contact_m", as_json(at.contact)},
      {"force_N", as_json(at.force)},
      {"ghost_force_N", as_json(predicted.ghost_force)},
      {"proxy_drift_m", as_json(predicted.slide)},
      {"efforts", efforts},
      {"effort_units", units},
      {"active", walls},
  };
}

std::string json_text(const GeneralScene& scene, const Vector<2>& goal, const GeneralRests& rests) {
  nlohmann::ordered_json strategies;
  for (const Strategy& strategy : strategy_catalog()) {
    const auto& rest = rests[index_of(strategy.id)];
    strategies[std::string(strategy.name)] =
        rest ? rest_json(*rest, motor_count(scene.mechanism), makes_torques(scene.mechanism)) : no_rest_json(goal);
  }
  const double goal_depth = -signed_distance(scene.constraint, goal);
  return nlohmann::ordered_json{{"depth_m", goal_depth + 0.0}, {"strategies", strategies}}.dump() + "\n";
}

std::string walls_text(std::uint8_t active) {
  std::string text;
  for (unsigned i = 0; i < most_planes; ++i) {
    if ((unsigned{active} >> i & 1U) != 0) text += fmt::format("{}{}", text.empty() ? "" : ", ", i + 1);
  }
  return text.empty() ? "none" : text;
}

std::string table_text(const Scene& scene, const GeneralScene& general, const Vector<2>& goal,
                       const GeneralRests& rests) {
  const double goal_depth = -signed_distance(general.constraint, goal);
  std::string text =
      fmt::format("{}\ngoal {} mm, {} mm {} the wall; compliance share {}\n\n{:16}", quoted_text(scene.title),
                  shown(mm_per_m * goal), shown(mm_per_m * std::abs(goal_depth)),
                  goal_depth > 0.0 ? "inside" : "outside", scene.settings.general.compliance_share, "");
  for (const Strategy& strategy : strategy_catalog()) {
    text += fmt::format("  {:>22}", fmt::format("{} {}", strategy.letter, strategy.name));
  }
  text += "\n";
  const auto add_row = [&](std::string_view title, std::string_view unit, const auto& value_of) {
    text += fmt::format("{:12}{:4}", title, unit);
    for (const auto& rest : rests) text += fmt::format("  {:>22}", rest ? value_of(*rest) : std::string("no rest"));
    text += "\n";
  };
  using Rest = PredictedGeneralEquilibrium;
  add_row("proxy", "mm", [](const Rest& rest) { return shown(mm_per_m * rest.rest.at.proxy); });
  add_row("device", "mm", [](const Rest& rest) { return shown(mm_per_m * rest.rest.at.device); });
  add_row("contact", "mm", [](const Rest& rest) { return shown(mm_per_m * rest.rest.at.contact); });
  add_row("force", "N", [](const Rest& rest) { return shown(rest.rest.at.force); });
  add_row("ghost force", "N", [](const Rest& rest) { return shown(rest.ghost_force); });
  add_row("slide", "mm", [](const Rest& rest) { return shown(mm_per_m * rest.slide); });
  const auto* const strings = std::get_if<Strings>(&general.mechanism);
  for (std::size_t i = 0; i < motor_count(general.mechanism); ++i) {
    add_row(fmt::format("effort {}", i + 1), makes_torques(general.mechanism) ? "N·m" : "N", [&, i](const Rest& rest) {
      const double effort = rest.rest.efforts[i];
      if (strings == nullptr) return shown(effort);
      // F has a motor for every direction, and what it gives a string may not be able to give.
      if (effort < 0.0 || effort > strings->most) return std::string("not by a string");
      return shown(effort) + (effort == strings->most ? " = most_N" : "");
    });
  }
  add_row("acting walls", "", [](const Rest& rest) { return walls_text(rest.rest.active); });
  return text;
}

int general_equilibrium(const EquilibriumOptions& options, const Scene& scene, const Vector<2>& goal) {
  const GeneralScene general = general_scene_of(scene.settings);
  if (const auto why = why_outside_workspace(general.mechanism, goal, "the goal")) {
    throw Failure(ExitCode::wrong_call, fmt::format("{}; choose a goal that the device reaches", *why));
  }
  const GeneralRests rests = predicted_general_equilibria(general, goal);
  print(options.json ? json_text(general, goal, rests) : table_text(scene, general, goal, rests));
  return static_cast<int>(ExitCode::done);
}

int equilibrium(const EquilibriumOptions& options) {
  Scene scene = options.scene.load();
  if (!options.goal_mm) tell_of_doubtful_path(scene);
  scene.settings = settings_at(scene, scene.settings, scene.duration);
  const Vector<2> goal = options.goal_mm ? position_from_mm("--goal-mm", *options.goal_mm) : scene.goal.points.back();
  if (is_general(scene.settings)) return general_equilibrium(options, scene, goal);
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
