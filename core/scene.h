// A scene: a wall, a device, a user, a rendering and a scripted hand, as one value in SI units. And the catalog of its
// keys: name, unit, range and place of each, the one list that the file reader, `--set`, the writer and the window's
// sliders walk. Not for the servo thread (it holds strings and vectors).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/common.hpp>

#include "core/conventions.h"
#include "core/goal_path.h"
#include "core/settings.h"
#include "core/tremor_and_drift.h"

namespace ghostforce {

struct SceneView {
  Vector<2> center{0.0};  // what is in the middle of the picture [m]
  double width = 0.2;     // how much of the world the picture's width shows, at least [m]

  friend bool operator==(const SceneView&, const SceneView&) = default;
};

struct Scene {
  std::string title;
  std::string about;
  Settings settings;
  StiffnessPath stiffness_path;     // of the hand that moves the simulated devices, whoever guides it
  TremorAndDrift tremor_and_drift;  // of a hand that is simulated itself; what is recorded of a hand has its own
  GoalPath goal;
  double duration = 0.0;  // [s]
  SceneView view;

  friend bool operator==(const Scene&, const Scene&) = default;
};

// round(duration · rate): the last tick of a run.
inline std::int64_t last_tick(const Scene& scene) noexcept {
  return std::llround(scene.duration * scene.settings.rate);
}

// How stiff the hand is at that moment of a run [N/m].
inline double user_stiffness_at(const Scene& scene, const Settings& settings, double time_s) noexcept {
  return scene.stiffness_path.is_empty() ? settings.stiffnesses.k_u : stiffness_at(scene.stiffness_path, time_s);
}

// The settings as they hold at that moment of a run [s], for whoever asks what happens then: the hand is as stiff as the
// scene says, and the renderer, which sees no hand, believes what it believed.
inline Settings settings_at(const Scene& scene, const Settings& settings, double time_s) noexcept {
  if (scene.stiffness_path.is_empty()) return settings;
  return with_user_stiffness(settings, stiffness_at(scene.stiffness_path, time_s));
}

// A run's duration, and any moment that is asked for on the command line: eleven days.
inline constexpr double longest_s = 1e6;

// Ticks that a run may have at most, so that a slip of the keyboard does not fill a disk.
inline constexpr double most_ticks = 1e7;

// --- The catalog of keys ---------------------------------------------------------------------------------------------

// A real number. The file holds it in `unit`s: SI value = file value / per_si.
struct NumberKey {
  double& (*in)(Scene&);
  double per_si;  // file units per SI unit, e.g. 1000 for mm
  double least;   // in file units, both ends included
  double greatest;
  bool may_be_infinite = false;
  bool whole = false;  // an integer in the file
};

// A number that may be left to the program; `word_for_empty` says so in the file (empty: leave the key out).
struct OptionalNumberKey {
  std::optional<double>& (*in)(Scene&);
  double least;
  double greatest;
  std::string_view word_for_empty;
};

// A text that people read.
struct TextKey {
  std::string& (*in)(Scene&);
  bool may_have_lines = false;
};

// One word of a short list.
struct ChoiceKey {
  std::span<const std::string_view> words;
  std::size_t (*get)(const Scene&);
  void (*set)(Scene&, std::size_t word);
  // Where the scene's other words decide which words there are; null: those above.
  std::span<const std::string_view> (*words_in)(const Scene&) = nullptr;
};

inline std::span<const std::string_view> words_of(const ChoiceKey& key, const Scene& scene) {
  return key.words_in == nullptr ? key.words : key.words_in(scene);
}

// A position [x, y], in mm in the file.
struct PointKey {
  Vector<2>& (*in)(Scene&);
};

// A list of positions, in mm in the file; one or more.
struct PointsKey {
  std::vector<Vector<2>>& (*in)(Scene&);
};

// A list of times [s], strictly increasing from 0.
struct TimesKey {
  std::vector<double>& (*in)(Scene&);
};

// A list of numbers; both ends included.
struct NumbersKey {
  std::vector<double>& (*in)(Scene&);
  NumberRange range;
};

// [least, greatest], in this order or the same.
struct RangeKey {
  NumberRange& (*in)(Scene&);
  NumberRange range;  // within which both lie
};

// Two numbers; SI value = file value / per_si.
struct PairKey {
  std::array<double, 2>& (*in)(Scene&);
  double per_si;
  double least;  // in file units, both ends included
  double greatest;
};

// Two positions, in mm in the file.
struct PointPairKey {
  std::array<Vector<2>, 2>& (*in)(Scene&);
};

// The anchors of strings, one to most_motors positions, in mm in the file.
struct AnchorsKey {
  Strings& (*in)(Scene&);
};

struct SceneKey {
  std::string_view table;  // "" at the top of the file
  std::string_view name;   // with its unit, as in the file
  bool required;
  std::variant<NumberKey, OptionalNumberKey, TextKey, ChoiceKey, PointKey, PointsKey, TimesKey, NumbersKey, RangeKey,
               PairKey, PointPairKey, AnchorsKey>
      value;
  // What few scenes have: where it is as in a new Scene, a file says nothing of it.
  bool is_omitted_when_default = false;
  // The kinds of its table that have it, with blanks between them; empty: all.
  std::string_view kinds{};
  int format = 1;  // of the file that may have it, at least
};

// What kind the scene's table is of, as its key `kind` says; empty: it has no kinds.
std::string_view kind_of(std::string_view table, const Scene& scene) noexcept;

// Whether a table of this kind has the key.
bool belongs_to_kind(const SceneKey& key, std::string_view kind) noexcept;

// Whether the scene has it. Others keep their value, which means nothing there.
bool belongs(const SceneKey& key, const Scene& scene) noexcept;

// The words of a table's key `kind`; empty: it has none.
std::span<const std::string_view> kinds_of(std::string_view table) noexcept;

// In the order in which a scene is written.
std::span<const SceneKey> scene_keys() noexcept;

// The number that the key has, in the file's unit; empty: it is left to the program. The key must hold a single number.
std::optional<double> number_of(Scene& scene, const SceneKey& key) noexcept;

// Gives the key this number, in the file's unit: the same bits as --set KEY=NUMBER with its shortest decimal. The key
// must hold a single number.
void set_number(Scene& scene, const SceneKey& key, double number) noexcept;

// Whether it is one of Scene::settings, which may change while the scene runs.
bool is_setting(const SceneKey& key) noexcept;

// Positions in a scene lie within ± this [mm].
inline constexpr double farthest_mm = 1000.0;

// The nearest position that a scene may hold [m].
inline Vector<2> nearest_in_scene(const Vector<2>& position) noexcept {
  constexpr double farthest = farthest_mm / mm_per_m;
  return glm::clamp(position, Vector<2>(-farthest), Vector<2>(farthest));
}

// The nearest view that a scene may hold.
SceneView within_scene_limits(SceneView shown);

// What no single key shows: as many times as waypoints, and not too many ticks. Names the key at fault.
struct SceneProblem {
  std::string_view table;
  std::string_view name;
  std::string what;
  std::string remedy;
};
std::optional<SceneProblem> find_problem(const Scene& scene);

// That a corner's walls enclose too little or too much.
std::optional<SceneProblem> find_corner_problem(const GeneralSettings& general);

// What keeps a general scene's mechanism from where its hand goes: a waypoint, or a place at which the fully actuated
// handle would rest, lies outside the workspace.
std::optional<SceneProblem> find_workspace_problem(const Scene& scene);

// Why a handle cannot be there, as "the arm reaches 320 mm from its base; WHAT at (400, 0) mm is 427 mm away"; empty: it
// can. Allocates.
std::optional<std::string> why_outside_workspace(const Mechanism& mechanism, const Vector<2>& q, std::string_view what);

// Whether each setting lies in the range that its key gives it: what a servo takes. Any thread, the servo's too:
// allocates nothing.
bool is_in_range(const Settings& settings) noexcept;

}  // namespace ghostforce
