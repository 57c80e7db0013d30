// ghostforce simulate: the scripted hand of a scene, every tick as a row.
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/cli/command.h"
#include "app/cli/option.h"
#include "app/files/output_file.h"
#include "app/files/run.h"
#include "core/goal_path.h"

namespace ghostforce {
namespace {

struct SimulateOptions {
  SceneOptions scene;
  std::string strategy;  // empty: the scene's
  std::string output = "-";
};

int simulate(const SimulateOptions& options) {
  Scene scene = options.scene.load();
  tell_of_doubtful_times(scene);
  tell_of_doubtful_path(scene);
  std::vector<StrategyId> ids;
  if (options.strategy == every_strategy) {
    for (const Strategy& strategy : strategy_catalog()) ids.push_back(strategy.id);
  } else {
    // The scene in the header is the one that was simulated.
    if (!options.strategy.empty()) scene.settings.active = find_strategy(options.strategy).value();
    ids.push_back(scene.settings.active);
  }

  OutputFile file(options.output);
  file.write(run_header(scene));
  write_played(file, "simulating", scene, state_at_start(scene.settings, goal_at(scene.goal, 0.0)), last_tick(scene),
               ids);
  file.commit();
  return static_cast<int>(ExitCode::done);
}

}  // namespace

std::function<int()> attach_simulate(CLI::App& command, FileOptions& files) {
  const auto options = std::make_shared<SimulateOptions>();
  options->scene.attach(command, files, true);
  std::vector<std::string_view> strategies = names_of(strategy_catalog());
  strategies.push_back(every_strategy);
  add_option(command, "--strategy NAME", options->strategy, "full, naive, anisotropic or all; default: the scene's own")
      ->check(one_of(strategies));
  files.writes(add_option(command, "-o,--output FILE", options->output,
                          "The CSV file to write, whole or not at all; default: -, standard output"));
  return [options] { return simulate(*options); };
}

}  // namespace ghostforce
