#include "app/cli/command.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <sstream>

#include <fmt/core.h>
#include <fmt/format.h>

#include "app/base/interruption.h"
#include "app/base/progress.h"
#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/base/words.h"
#include "app/cli/option.h"
#include "app/files/run.h"
#include "app/state/set_up.h"
#include "core/divergence.h"
#include "core/simulate.h"

namespace ghostforce {
namespace {

// CLI11 keeps a name with each check and shows it nowhere. Checks other than these two have none.
std::string name_with(const std::vector<std::string_view>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

}  // namespace

CLI::Validator one_of(std::vector<std::string_view> words) {
  std::string name = name_with(words);
  return {[words = std::move(words)](std::string& word) { return not_one_of(word, words); }, "", std::move(name)};
}

CLI::Validator suggests(const std::vector<std::string_view>& words) {
  return {[](std::string&) { return std::string(); }, "", name_with(words)};
}

std::vector<std::string> offered_words(CLI::Option& option) {
  std::string names;
  try {
    for (int i = 0;; ++i) names += option.get_validator(i)->get_name() + " ";
  } catch (const CLI::OptionNotFound&) {
    // CLI11 does not say how many checks there are.
  }
  std::istringstream words(names);
  return {std::istream_iterator<std::string>(words), {}};
}

void SceneOptions::attach(CLI::App& command, FileOptions& files, bool scene_required) {
  option = files.reads(add_option(command, "SCENE", scene,
                                  "Path of a scene file, or name of a shipped scene; 'ghostforce --help' lists them")
                           ->check(suggests(shipped_scene_names())),
                       path_unless_one_of(shipped_scene_names()));
  if (scene_required) {
    option->required();
  } else {
    option->default_str(scene);
  }
  repeatable(add_option(command, "--set KEY=VALUE", overrides,
                        "Set a key of the scene, as in rendering.k_r_N_per_m=800; may be repeated")
                 ->check(suggests_keys(KeyKind::any)));
}

bool SceneOptions::is_named() const {
  return option != nullptr && option->count() > 0;
}

Scene SceneOptions::load() const {
  return load_scene(scene, overrides);
}

void tell_of_doubtful_times(const Scene& scene) {
  const GoalPath& path = scene.goal;
  if (path.times.back() > scene.duration) {
    say("note: the hand would be at its last waypoint after {} s, and the run ends after {} s; goal.times_s and "
        "goal.duration_s are in seconds\n",
        path.times.back(), scene.duration);
  }
}

void tell_of_doubtful_path(const Scene& scene) {
  const GoalPath& path = scene.goal;
  const auto is_within_a_millimetre = [](const Vector<2>& point) {
    return std::hypot(point.x, point.y) < 1.0 / mm_per_m;
  };
  if (path.points.size() > 1 && std::ranges::all_of(path.points, is_within_a_millimetre)) {
    say("note: the hand stays within a millimetre of the origin; goal.path_mm is in millimetres\n");
  }
}

CLI::Validator suggests_keys(KeyKind kind) {
  std::vector<std::string> keys = dotted_names(kind);
  for (std::string& key : keys) key += "=";
  return suggests({keys.begin(), keys.end()});
}

WordCheck number_between(double least, double greatest, std::string unit) {
  return [least, greatest, unit = std::move(unit)](const std::string& text) -> std::string {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (!text.empty() && *end == '\0' && value >= least && value <= greatest) return {};
    return fmt::format("'{}' is not a number from {:g} to {:g}{}{}", quoted_text(text), least, greatest,
                       unit.empty() ? "" : " ", unit);
  };
}

WordCheck whole_number_from(int least) {
  return [least](const std::string& text) -> std::string {
    if (const auto number = number_in<int>(text); number && *number >= least) return {};
    return fmt::format("'{}' is not a whole number, {} or more", quoted_text(text), least);
  };
}

WordCheck whole_number_between(int least, int greatest) {
  return [least, greatest](const std::string& text) -> std::string {
    if (const auto number = number_in<int>(text); number && *number >= least && *number <= greatest) return {};
    return fmt::format("'{}' is not a whole number from {} to {}", quoted_text(text), least, greatest);
  };
}

CLI::Option* repeatable(CLI::Option* option) {
  return option->expected(1)->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void print(std::string_view text) {
  OutputFile output("-");
  output.write(text);
  output.commit();
}

void end_unstable(OutputFile& file, StrategyId strategy, double time_s, std::string_view run) {
  if (file.part_path().empty()) file.commit();
  throw unstable_loop(strategy, time_s, run);
}

void write_played(OutputFile& file, std::string_view doing, const Scene& scene, const TickState<2>& start,
                  std::int64_t last, std::span<const StrategyId> ids) {
  Progress progress(std::string(doing), last, !file.is_terminal());
  fmt::memory_buffer rows;
  simulate_from(start, scene, last, [&](const Snapshot& snapshot, const TickState<2>& state) {
    for (const StrategyId id : ids) {
      if (has_diverged(snapshot.strategies[index_of(id)])) end_unstable(file, id, snapshot.time_s);
      append_run_row(rows, snapshot, id);
      append_efforts(rows, scene.settings, state.strategies[index_of(id)].contact.efforts);
      rows.push_back('\n');
    }
    file.write({rows.data(), rows.size()});
    rows.clear();
    if (snapshot.tick % ticks_between_looks == 0) {
      stop_if_interrupted();
      progress.at(snapshot.tick);
    }
  });
}

Vector<2> position_from_mm(std::string_view option, std::string_view text) {
  if (const auto position = read_position_mm(text)) return *position;
  throw Failure(ExitCode::wrong_call, fmt::format("{} {}", option, no_position_words(option, text)));
}

void refuse_contradictions(const CLI::App& command, std::string_view given,
                           std::span<const Contradiction> contradictions) {
  for (const Contradiction& each : contradictions) {
    const CLI::Option* const option = command.get_option_no_throw(std::string(each.option));
    if (option == nullptr || option->count() == 0) continue;
    if (!each.value.empty() && !option->as<std::string>().starts_with(each.value)) continue;
    throw Failure(ExitCode::wrong_call,
                  fmt::format("{} and {}{}{} contradict each other: {}; leave out one of them", given, each.option,
                              each.value.empty() ? "" : " ", each.value, each.reason));
  }
}

}  // namespace ghostforce
