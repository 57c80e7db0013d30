#include "core/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>

#include "core/conventions.h"

namespace ghostforce {
namespace {

constexpr double any = std::numeric_limits<double>::max();

const auto strategy_words = [] {
  std::array<std::string_view, strategy_count> words;
  for (const Strategy& entry : strategy_catalog()) words[index_of(entry.id)] = entry.name;
  return words;
}();
constexpr std::array<std::string_view, 2> motion_words{"linear", "minimum-jerk"};

// clang-format off
const std::array keys{
    SceneKey{"", "title", true, TextKey{[](Scene& s) -> auto& { return s.title; }}},
    SceneKey{"", "about", true, TextKey{[](Scene& s) -> auto& { return s.about; }, true}},

    SceneKey{"wall", "point_mm", true, PointKey{[](Scene& s) -> auto& { return s.settings.wall_point; }}},
    SceneKey{"wall", "normal_deg", true,
             NumberKey{[](Scene& s) -> auto& { return s.settings.wall_normal_angle; }, degrees_per_radian, -any, any}},

    SceneKey{"device", "actuated_deg", true,
             NumberKey{[](Scene& s) -> auto& { return s.settings.actuated_angle; }, degrees_per_radian, -any, any}},
    SceneKey{"device", "mass_kg", true,
             NumberKey{[](Scene& s) -> auto& { return s.settings.mass; }, 1.0, 0.001, 100.0}},
    SceneKey{"device", "damping_N_s_per_m", true,
             NumberKey{[](Scene& s) -> auto& { return s.settings.damping; }, 1.0, 0.0, 1e4}},
    SceneKey{"device", "rate_hz", true,
             NumberKey{[](Scene& s) -> auto& { return s.settings.rate; }, 1.0, rate_range.least, rate_range.greatest,
                       false, true}},
    SceneKey{"device", "encoder_mm", false,
             NumberKey{[](Scene& s) -> auto& { return s.settings.encoder_step; }, mm_per_m, 0.0, 10.0}, true},

    SceneKey{"user", "k_u_N_per_m", true,
             NumberKey{[](Scene& s) -> auto& { return s.settings.stiffnesses.k_u; }, 1.0, user_stiffness_range.least,
                       user_stiffness_range.greatest}},
    SceneKey{"user", "believed_k_u_N_per_m", false,
             OptionalNumberKey{[](Scene& s) -> auto& { return s.settings.stiffnesses.believed_k_u; },
                               user_stiffness_range.least, user_stiffness_range.greatest, ""}},
    SceneKey{"user", "k_u_path_N_per_m", false,
             NumbersKey{[](Scene& s) -> auto& { return s.stiffness_path.values; }, user_stiffness_range}, true},
    SceneKey{"user", "k_u_times_s", false, TimesKey{[](Scene& s) -> auto& { return s.stiffness_path.times; }}, true},
    SceneKey{"user", "tremor_mm_rms", false,
             NumberKey{[](Scene& s) -> auto& { return s.tremor_and_drift.tremor_rms; }, mm_per_m, 0.0, 10.0}, true},
    SceneKey{"user", "tremor_hz", false, RangeKey{[](Scene& s) -> auto& { return s.tremor_and_drift.tremor_hz; }, {0.1, 100.0}},
             true},
    SceneKey{"user", "drift_mm_per_s", false,
             NumberKey{[](Scene& s) -> auto& { return s.tremor_and_drift.drift_speed; }, mm_per_m, 0.0, 100.0}, true},
    SceneKey{"user", "seed", false,
             NumberKey{[](Scene& s) -> auto& { return s.tremor_and_drift.seed; }, 1.0, 0.0, 1e9, false, true}, true},

    SceneKey{"rendering", "strategy", true,
             ChoiceKey{strategy_words, [](const Scene& s) { return index_of(s.settings.active); },
                       [](Scene& s, std::size_t word) { s.settings.active = strategy_catalog()[word].id; }}},
    SceneKey{"rendering", "k_r_N_per_m", true,
             NumberKey{[](Scene& s) -> auto& { return s.settings.stiffnesses.k_r; }, 1.0, rendering_stiffness_range.least,
                       rendering_stiffness_range.greatest}},
    SceneKey{"rendering", "k_t_N_per_m", true,
             NumberKey{[](Scene& s) -> auto& { return s.settings.stiffnesses.k_t; }, 1.0, tracking_stiffness_range.least,
                       tracking_stiffness_range.greatest}},
    SceneKey{"rendering", "k_c_N_per_m", true,
             NumberKey{[](Scene& s) -> auto& { return s.settings.stiffnesses.k_c; }, 1.0, 1.0, 1e9, true}},
    SceneKey{"rendering", "tracking_ratio", false,
             OptionalNumberKey{[](Scene& s) -> auto& { return s.settings.stiffnesses.chosen_tracking_ratio; },
                               tracking_ratio_range.least, tracking_ratio_range.greatest, "optimal"}},

    SceneKey{"goal", "path_mm", true, PointsKey{[](Scene& s) -> auto& { return s.goal.points; }}},
    SceneKey{"goal", "times_s", true, TimesKey{[](Scene& s) -> auto& { return s.goal.times; }}},
    SceneKey{"goal", "duration_s", true, NumberKey{[](Scene& s) -> auto& { return s.duration; }, 1.0, 0.0, longest_s}},
    SceneKey{"goal", "motion", false,
             ChoiceKey{motion_words, [](const Scene& s) { return static_cast<std::size_t>(s.goal.motion); },
                       [](Scene& s, std::size_t word) { s.goal.motion = static_cast<Motion>(word); }}},

    SceneKey{"view", "center_mm", false, PointKey{[](Scene& s) -> auto& { return s.view.center; }}},
    SceneKey{"view", "width_mm", false,
             NumberKey{[](Scene& s) -> auto& { return s.view.width; }, mm_per_m, 1.0, 10000.0}},
};
// clang-format on

bool is_between(double value, double least, double greatest) noexcept {
  return value >= least && value <= greatest;  // false for NaN
}

// Whether a scene's value lies in the range of its key, one function per kind of key; texts, paths and bands
// are no settings.
struct InRange {
  Scene& scene;

  bool operator()(const NumberKey& key) const noexcept {
    const double value = key.in(scene);
    if (key.may_be_infinite && value == std::numeric_limits<double>::infinity()) return true;
    return is_between(value * key.per_si, key.least, key.greatest) && (!key.whole || value == std::trunc(value));
  }
  bool operator()(const OptionalNumberKey& key) const noexcept {
    const std::optional<double>& value = key.in(scene);
    return !value || is_between(*value, key.least, key.greatest);
  }
  bool operator()(const ChoiceKey& key) const noexcept { return key.get(scene) < key.words.size(); }
  bool operator()(const PointKey& key) const noexcept {
    return nearest_in_scene(key.in(scene)) == key.in(scene);  // false for NaN
  }
  bool operator()(const TextKey&) const noexcept { return true; }
  bool operator()(const PointsKey&) const noexcept { return true; }
  bool operator()(const TimesKey&) const noexcept { return true; }
  bool operator()(const NumbersKey&) const noexcept { return true; }
  bool operator()(const RangeKey&) const noexcept { return true; }
};

// Of keys that may be missing: the one that is there is at fault.
std::optional<SceneProblem> find_problem(const StiffnessPath& path) {
  const std::size_t values = path.values.size();
  const std::size_t times = path.times.size();
  if (values == times) return std::nullopt;
  const std::string_view both = "give both, or neither for a hand that is always as stiff";
  if (times == 0) return SceneProblem{"user", "k_u_path_N_per_m", "k_u_times_s is missing", std::string(both)};
  if (values == 0) return SceneProblem{"user", "k_u_times_s", "k_u_path_N_per_m is missing", std::string(both)};
  return SceneProblem{"user", "k_u_times_s",
                      "there are " + std::to_string(times) + " times for " + std::to_string(values) +
                          " stiffnesses in k_u_path_N_per_m",
                      "give as many of each"};
}

}  // namespace

std::span<const SceneKey> scene_keys() noexcept {
  return keys;
}

std::optional<double> number_of(Scene& scene, const SceneKey& key) noexcept {
  if (const auto* const real = std::get_if<NumberKey>(&key.value)) return real->in(scene)*real->per_si;
  return std::get<OptionalNumberKey>(key.value).in(scene);
}

void set_number(Scene& scene, const SceneKey& key, double number) noexcept {
  if (const auto* const real = std::get_if<NumberKey>(&key.value)) {
    real->in(scene) = number / real->per_si;
  } else {
    std::get<OptionalNumberKey>(key.value).in(scene) = number;
  }
}

bool is_setting(const SceneKey& key) noexcept {
  if (key.table == "user") return !key.is_omitted_when_default;  // how the hand moves is the scene's
  return key.table == "wall" || key.table == "device" || key.table == "rendering";
}

std::optional<SceneProblem> find_problem(const Scene& scene) {
  if (auto problem = find_problem(scene.stiffness_path)) return problem;
  if (scene.goal.points.size() != scene.goal.times.size()) {
    return SceneProblem{"goal", "times_s",
                        "there are " + std::to_string(scene.goal.times.size()) + " times for " +
                            std::to_string(scene.goal.points.size()) + " waypoints in path_mm",
                        "give as many of each"};
  }
  if (scene.duration * scene.settings.rate > most_ticks) {
    return SceneProblem{"goal", "duration_s", "duration_s times rate_hz is over 1e7 ticks", "shorten one of them"};
  }
  return std::nullopt;
}

bool is_in_range(const Settings& settings) noexcept {
  Scene scene;  // its strings and vectors stay empty
  scene.settings = settings;
  const auto in_range = [&scene](const SceneKey& key) { return std::visit(InRange{scene}, key.value); };
  return std::ranges::all_of(keys, in_range);
}

SceneView within_scene_limits(SceneView shown) {
  for (const SceneKey& key : keys) {
    if (key.table != "view" || key.name != "width_mm") continue;
    const auto& width = std::get<NumberKey>(key.value);
    shown.width = std::clamp(shown.width, width.least / width.per_si, width.greatest / width.per_si);
  }
  shown.center = nearest_in_scene(shown.center);
  return shown;
}

}  // namespace ghostforce
