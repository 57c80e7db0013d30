#include "core/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include <glm/geometric.hpp>

#include "core/conventions.h"
#include "core/general_equilibrium.h"

namespace ghostforce {
namespace {

constexpr double any = std::numeric_limits<double>::max();

const auto strategy_words = [] {
  std::array<std::string_view, strategy_count> words;
  for (const Strategy& entry : strategy_catalog()) words[index_of(entry.id)] = entry.name;
  return words;
}();
constexpr std::array<std::string_view, 2> motion_words{"linear", "minimum-jerk"};
constexpr std::array<std::string_view, 3> constraint_words{"plane", "corner", "circle"};
constexpr std::array<std::string_view, 4> mechanism_words{"axes", "arm", "pantograph", "strings"};
constexpr std::array<std::string_view, 2> free_words{"inside", "outside"};
constexpr std::array<std::string_view, 2> side_words{"left", "right"};
constexpr std::array<std::string_view, 2> joint_words{"base", "elbow"};

// Which motor of a linkage exists.
std::span<const std::string_view> motor_words_in(const Scene& scene) {
  return scene.settings.general.mechanism == MechanismKind::pantograph ? side_words : joint_words;
}
std::size_t motor_of(const Scene& scene) {
  const GeneralSettings& general = scene.settings.general;
  return general.mechanism == MechanismKind::pantograph ? static_cast<std::size_t>(general.pantograph.motor)
                                                        : static_cast<std::size_t>(general.arm.motor);
}
void set_motor(Scene& scene, std::size_t word) {
  GeneralSettings& general = scene.settings.general;
  if (general.mechanism == MechanismKind::pantograph) {
    general.pantograph.motor = static_cast<FiveBar::Motor>(word);
  } else {
    general.arm.motor = static_cast<TwoLinkArm::Motor>(word);
  }
}

constexpr double least_length_mm = 1.0;
constexpr double greatest_length_mm = 1000.0;

// clang-format off
const std::array keys{
    SceneKey{"", "title", true, TextKey{[](Scene& s) -> auto& { return s.title; }}},
    SceneKey{"", "about", true, TextKey{[](Scene& s) -> auto& { return s.about; }, true}},

    SceneKey{"wall", "kind", false,
             ChoiceKey{constraint_words, [](const Scene& s) { return static_cast<std::size_t>(s.settings.general.constraint); },
                       [](Scene& s, std::size_t word) { s.settings.general.constraint = static_cast<ConstraintKind>(word); }},
             true, "", 2},
    SceneKey{"wall", "point_mm", true, PointKey{[](Scene& s) -> auto& { return s.settings.wall_point; }}, false,
             "plane corner"},
    SceneKey{"wall", "normal_deg", true,
             NumberKey{[](Scene& s) -> auto& { return s.settings.wall_normal_angle; }, degrees_per_radian, -any, any},
             false, "plane"},
    SceneKey{"wall", "normals_deg", true,
             PairKey{[](Scene& s) -> auto& { return s.settings.general.corner_normal_angles; }, degrees_per_radian, -any, any},
             false, "corner", 2},
    SceneKey{"wall", "center_mm", true, PointKey{[](Scene& s) -> auto& { return s.settings.general.circle_center; }}, false,
             "circle", 2},
    SceneKey{"wall", "radius_mm", true,
             NumberKey{[](Scene& s) -> auto& { return s.settings.general.circle_radius; }, mm_per_m, least_length_mm,
                       greatest_length_mm},
             false, "circle", 2},
    SceneKey{"wall", "free", true,
             ChoiceKey{free_words, [](const Scene& s) -> std::size_t { return s.settings.general.circle_is_free_inside ? 0 : 1; },
                       [](Scene& s, std::size_t word) { s.settings.general.circle_is_free_inside = word == 0; }},
             false, "circle", 2},

    SceneKey{"device", "kind", false,
             ChoiceKey{mechanism_words, [](const Scene& s) { return static_cast<std::size_t>(s.settings.general.mechanism); },
                       [](Scene& s, std::size_t word) { s.settings.general.mechanism = static_cast<MechanismKind>(word); }},
             true, "", 2},
    SceneKey{"device", "actuated_deg", true,
             NumberKey{[](Scene& s) -> auto& { return s.settings.actuated_angle; }, degrees_per_radian, -any, any}, false,
             "axes"},
    SceneKey{"device", "base_mm", true, PointKey{[](Scene& s) -> auto& { return s.settings.general.arm.base; }}, false, "arm",
             2},
    SceneKey{"device", "links_mm", true,
             PairKey{[](Scene& s) -> auto& { return s.settings.general.arm.links; }, mm_per_m, least_length_mm,
                     greatest_length_mm},
             false, "arm", 2},
    SceneKey{"device", "elbow", true,
             ChoiceKey{side_words, [](const Scene& s) { return static_cast<std::size_t>(s.settings.general.arm.elbow); },
                       [](Scene& s, std::size_t word) { s.settings.general.arm.elbow = static_cast<TwoLinkArm::Elbow>(word); }},
             false, "arm", 2},
    SceneKey{"device", "bases_mm", true, PointPairKey{[](Scene& s) -> auto& { return s.settings.general.pantograph.bases; }},
             false, "pantograph", 2},
    SceneKey{"device", "proximal_mm", true,
             NumberKey{[](Scene& s) -> auto& { return s.settings.general.pantograph.proximal; }, mm_per_m, least_length_mm,
                       greatest_length_mm},
             false, "pantograph", 2},
    SceneKey{"device", "distal_mm", true,
             NumberKey{[](Scene& s) -> auto& { return s.settings.general.pantograph.distal; }, mm_per_m, least_length_mm,
                       greatest_length_mm},
             false, "pantograph", 2},
    SceneKey{"device", "motor", true, ChoiceKey{joint_words, motor_of, set_motor, motor_words_in}, false, "arm pantograph", 2},
    SceneKey{"device", "anchors_mm", true, AnchorsKey{[](Scene& s) -> auto& { return s.settings.general.strings; }}, false,
             "strings", 2},
    SceneKey{"device", "most_N", false,
             NumberKey{[](Scene& s) -> auto& { return s.settings.general.strings.most; }, 1.0, 0.001, 1000.0, true}, true,
             "strings", 2},
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
    SceneKey{"user", "k_u_second_N_per_m", false,
             OptionalNumberKey{[](Scene& s) -> auto& { return s.settings.general.k_u_second; }, user_stiffness_range.least,
                               user_stiffness_range.greatest, ""},
             false, "", 2},
    SceneKey{"user", "k_u_first_deg", false,
             NumberKey{[](Scene& s) -> auto& { return s.settings.general.k_u_first_angle; }, degrees_per_radian, -any, any},
             true, "", 2},
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
    SceneKey{"rendering", "compliance_share", false,
             NumberKey{[](Scene& s) -> auto& { return s.settings.general.compliance_share; }, 1.0, compliance_share_range.least,
                       compliance_share_range.greatest},
             true, "", 2},

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
  bool operator()(const ChoiceKey& key) const noexcept { return key.get(scene) < words_of(key, scene).size(); }
  bool operator()(const PointKey& key) const noexcept {
    return nearest_in_scene(key.in(scene)) == key.in(scene);  // false for NaN
  }
  bool operator()(const TextKey&) const noexcept { return true; }
  bool operator()(const PointsKey&) const noexcept { return true; }
  bool operator()(const TimesKey&) const noexcept { return true; }
  bool operator()(const NumbersKey&) const noexcept { return true; }
  bool operator()(const RangeKey&) const noexcept { return true; }
  bool operator()(const PairKey& key) const noexcept {
    return std::ranges::all_of(
        key.in(scene), [&key](double value) { return is_between(value * key.per_si, key.least, key.greatest); });
  }
  bool operator()(const PointPairKey& key) const noexcept { return are_in_scene(key.in(scene)); }
  bool operator()(const AnchorsKey& key) const noexcept {
    const Strings& strings = key.in(scene);
    return strings.count >= 1 && strings.count <= most_motors &&
           are_in_scene(std::span(strings.anchors).first(strings.count));
  }

  static bool are_in_scene(std::span<const Vector<2>> points) noexcept {
    return std::ranges::all_of(points, [](const Vector<2>& point) { return nearest_in_scene(point) == point; });
  }
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

std::string_view kind_of(std::string_view table, const Scene& scene) noexcept {
  if (table == "wall") return constraint_words[static_cast<std::size_t>(scene.settings.general.constraint)];
  if (table == "device") return mechanism_words[static_cast<std::size_t>(scene.settings.general.mechanism)];
  return {};
}

std::span<const std::string_view> kinds_of(std::string_view table) noexcept {
  if (table == "wall") return constraint_words;
  if (table == "device") return mechanism_words;
  return {};
}

bool belongs_to_kind(const SceneKey& key, std::string_view kind) noexcept {
  for (std::string_view rest = key.kinds; !rest.empty();) {
    const std::string_view word = rest.substr(0, rest.find(' '));
    if (word == kind) return true;
    rest.remove_prefix(std::min(word.size() + 1, rest.size()));
  }
  return key.kinds.empty();
}

bool belongs(const SceneKey& key, const Scene& scene) noexcept {
  // Of which a general scene has the compliance share, and a hand that is as stiff all round no direction.
  if (key.name == "tracking_ratio" && is_general(scene.settings)) return false;
  if (key.name == "k_u_first_deg" && !scene.settings.general.k_u_second) return false;
  return belongs_to_kind(key, kind_of(key.table, scene));
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
  if (key.table == "user") return !key.is_omitted_when_default || key.format > 1;  // how it moves is the scene's
  return key.table == "wall" || key.table == "device" || key.table == "rendering";
}

namespace {

// To whole millimetres, as people read it.
std::string mm(double metres) {
  return std::to_string(std::llround(metres * mm_per_m));
}

std::string mm(const Vector<2>& position) {
  return std::string("(").append(mm(position.x)).append(", ").append(mm(position.y)).append(") mm");
}

// Two walls that enclose less are one wall, and two that enclose more leave nothing free.
constexpr double least_corner_deg = 5.0;
constexpr double greatest_corner_deg = 175.0;

// A hand next to an anchor turns the string by much with little way.
constexpr double nearest_anchor_m = 0.02;

}  // namespace

std::optional<SceneProblem> find_corner_problem(const GeneralSettings& general) {
  const double turn = general.corner_normal_angles[1] - general.corner_normal_angles[0];
  const double between = std::abs(std::remainder(turn * degrees_per_radian, 360.0));
  constexpr double rounding = 1e-9;  // [degrees]
  if (between >= least_corner_deg - rounding && between <= greatest_corner_deg + rounding) return std::nullopt;
  return SceneProblem{"wall", "normals_deg",
                      "the two normals are " + std::to_string(std::llround(between)) + " degrees apart",
                      "give two that are 5 to 175 degrees apart"};
}

namespace {

std::optional<SceneProblem> find_strings_problem(const Strings& strings) {
  for (std::size_t i = 0; i < strings.count; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (strings.anchors[i] != strings.anchors[k]) continue;
      return SceneProblem{"device", "anchors_mm", "two strings have the same anchor, " + mm(strings.anchors[i]),
                          "give each string its own"};
    }
  }
  return std::nullopt;
}

std::string at(std::string_view what, const Vector<2>& q) {
  return std::string(what) + " at " + mm(q);
}

// Of two links in a row, from `base`.
std::optional<std::string> why_out_of_reach(const Vector<2>& base, double first, double second, std::string_view arm,
                                            const Vector<2>& q, std::string_view what) {
  const double distance = glm::length(q - base);
  if (distance > first + second) {
    return std::string(arm) + " reaches " + mm(first + second) + " mm from its base; " + at(what, q) + " is " +
           mm(distance) + " mm away";
  }
  if (distance < std::abs(first - second)) {
    return std::string(arm) + " comes no nearer to its base than " + mm(std::abs(first - second)) + " mm; " +
           at(what, q) + " is " + mm(distance) + " mm away";
  }
  return std::nullopt;
}

// Called where the handle cannot be.
struct WhyOutside {
  const Vector<2>& q;
  std::string_view what;

  std::string operator()(const FixedAxis&) const { return {}; }
  std::string operator()(const TwoLinkArm& arm) const {
    if (const auto far = why_out_of_reach(arm.base, arm.links[0], arm.links[1], "the arm", q, what)) return *far;
    return "the arm is all but stretched or folded with " + at(what, q) + ", and its motor has no hold there";
  }
  std::string operator()(const FiveBar& linkage) const {
    constexpr std::array<std::string_view, 2> arms{"the left arm", "the right arm"};
    for (std::size_t i = 0; i < arms.size(); ++i) {
      const auto far = why_out_of_reach(linkage.bases[i], linkage.proximal, linkage.distal, arms[i], q, what);
      if (far) return *far;
    }
    return "two links of the pantograph lie all but in line with " + at(what, q) +
           ", and its motors have no hold there";
  }
  std::string operator()(const Strings&) const {
    return at(what, q) + " is at an anchor, where a string has no direction";
  }
};

std::optional<std::string> why_too_near_to_anchor(const Mechanism& mechanism, const Vector<2>& q) {
  const auto* const strings = std::get_if<Strings>(&mechanism);
  if (strings == nullptr) return std::nullopt;
  for (std::size_t i = 0; i < strings->count; ++i) {
    const double distance = glm::length(strings->anchors[i] - q);
    if (distance >= nearest_anchor_m) continue;
    return at("the goal", q) + " is " + mm(distance) + " mm from the anchor " + mm(strings->anchors[i]) +
           "; a string needs " + mm(nearest_anchor_m) + " mm";
  }
  return std::nullopt;
}

std::optional<SceneProblem> find_general_problem(const Scene& scene) {
  const GeneralSettings& general = scene.settings.general;
  if (!scene.stiffness_path.is_empty() && general.k_u_second) {
    return SceneProblem{"user", "k_u_path_N_per_m",
                        "a hand that is stiffer in one direction cannot change its stiffness",
                        "leave out k_u_second_N_per_m or the path"};
  }
  if (general.constraint == ConstraintKind::corner) {
    if (auto problem = find_corner_problem(general)) return problem;
  }
  return general.mechanism == MechanismKind::strings ? find_strings_problem(general.strings) : std::nullopt;
}

}  // namespace

std::optional<std::string> why_outside_workspace(const Mechanism& mechanism, const Vector<2>& q,
                                                 std::string_view what) {
  if (actuation_at(mechanism, q)) return std::nullopt;
  return std::visit(WhyOutside{q, what}, mechanism);
}

std::optional<SceneProblem> find_workspace_problem(const Scene& scene) {
  if (!is_general(scene.settings)) return std::nullopt;
  const GeneralScene general = general_scene_of(scene.settings);
  const auto problem = [has_links = makes_torques(general.mechanism)](std::string what) {
    return SceneProblem{
        "goal", "path_mm", std::move(what),
        has_links ? "move the goal or the base, or make the links longer" : "move the goal, or what it is too near to"};
  };
  for (const Vector<2>& goal : scene.goal.points) {
    const auto* const linkage = std::get_if<FiveBar>(&general.mechanism);
    if (linkage != nullptr && !has_elbows_outward(*linkage, goal)) {
      return SceneProblem{"device", "bases_mm",
                          "of the two bases, seen towards " + at("the goal", goal) +
                              ", the first is the right one, and the elbows would be inward",
                          "give the left base first"};
    }
    if (auto why = why_outside_workspace(general.mechanism, goal, "the goal")) return problem(std::move(*why));
    if (auto why = why_too_near_to_anchor(general.mechanism, goal)) return problem(std::move(*why));
    if (general_equilibrium_of(StrategyId::full, general, goal)) continue;
    return problem("with the goal at " + mm(goal) +
                   " the handle would rest where the device cannot be, with all its motors on");
  }
  return std::nullopt;
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
  return find_general_problem(scene);
}

bool is_in_range(const Settings& settings) noexcept {
  Scene scene;  // its strings and vectors stay empty
  scene.settings = settings;
  const auto in_range = [&scene](const SceneKey& key) {
    return !belongs(key, scene) || std::visit(InRange{scene}, key.value);
  };
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
