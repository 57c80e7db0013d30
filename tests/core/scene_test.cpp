#include "core/scene.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

namespace ghostforce::scene_test {
namespace {

std::string full_name(const SceneKey& key) {
  return key.table.empty() ? std::string(key.name) : std::string(key.table) + '.' + std::string(key.name);
}

const SceneKey& key_named(std::string_view name) {
  for (const SceneKey& key : scene_keys()) {
    if (full_name(key) == name) return key;
  }
  ADD_FAILURE() << "no key " << name;
  return scene_keys()[0];
}

// The place in a scene that a key stands for; choices have none of their own.
const void* place_of(const SceneKey& key, Scene& scene) {
  return std::visit(
      [&scene](const auto& value) -> const void* {
        if constexpr (requires { value.in(scene); }) {
          return &value.in(scene);
        } else {
          return nullptr;
        }
      },
      key.value);
}

TEST(SceneTest, KeysAreThoseOfTheFileFormatInItsOrder) {
  const std::vector<std::pair<std::string, bool>> expected{
      {"title", true},
      {"about", true},
      {"wall.kind", false},
      {"wall.point_mm", true},
      {"wall.normal_deg", true},
      {"wall.normals_deg", true},
      {"wall.center_mm", true},
      {"wall.radius_mm", true},
      {"wall.free", true},
      {"device.kind", false},
      {"device.actuated_deg", true},
      {"device.base_mm", true},
      {"device.links_mm", true},
      {"device.elbow", true},
      {"device.bases_mm", true},
      {"device.proximal_mm", true},
      {"device.distal_mm", true},
      {"device.motor", true},
      {"device.anchors_mm", true},
      {"device.most_N", false},
      {"device.mass_kg", true},
      {"device.damping_N_s_per_m", true},
      {"device.rate_hz", true},
      {"device.encoder_mm", false},
      {"user.k_u_N_per_m", true},
      {"user.k_u_second_N_per_m", false},
      {"user.k_u_first_deg", false},
      {"user.believed_k_u_N_per_m", false},
      {"user.k_u_path_N_per_m", false},
      {"user.k_u_times_s", false},
      {"user.tremor_mm_rms", false},
      {"user.tremor_hz", false},
      {"user.drift_mm_per_s", false},
      {"user.seed", false},
      {"rendering.strategy", true},
      {"rendering.k_r_N_per_m", true},
      {"rendering.k_t_N_per_m", true},
      {"rendering.k_c_N_per_m", true},
      {"rendering.tracking_ratio", false},
      {"rendering.compliance_share", false},
      {"goal.path_mm", true},
      {"goal.times_s", true},
      {"goal.duration_s", true},
      {"goal.motion", false},
      {"view.center_mm", false},
      {"view.width_mm", false},
  };
  std::vector<std::pair<std::string, bool>> actual;
  for (const SceneKey& key : scene_keys()) actual.emplace_back(full_name(key), key.required);
  EXPECT_EQ(actual, expected);
}

TEST(SceneTest, KeysHaveUniqueNamesAndPlaces) {
  Scene scene;
  std::set<std::string> names;
  std::set<const void*> places;
  std::size_t with_place = 0;
  for (const SceneKey& key : scene_keys()) {
    EXPECT_FALSE(key.name.empty());
    names.insert(full_name(key));
    if (const void* place = place_of(key, scene)) {
      places.insert(place);
      ++with_place;
    }
  }
  EXPECT_EQ(names.size(), scene_keys().size());
  EXPECT_EQ(places.size(), with_place);
}

TEST(SceneTest, KeysOfATableStandTogether) {
  std::set<std::string_view> closed;
  std::string_view open;
  for (const SceneKey& key : scene_keys()) {
    if (key.table == open) continue;
    EXPECT_TRUE(closed.insert(open).second) << open;
    EXPECT_EQ(closed.count(key.table), 0U) << key.table;
    open = key.table;
  }
}

TEST(SceneTest, EachKeyIsAtItsPlace) {
  Scene scene;
  const std::vector<std::pair<std::string_view, const void*>> places{
      {"title", &scene.title},
      {"about", &scene.about},
      {"wall.point_mm", &scene.settings.wall_point},
      {"wall.normal_deg", &scene.settings.wall_normal_angle},
      {"device.actuated_deg", &scene.settings.actuated_angle},
      {"device.mass_kg", &scene.settings.mass},
      {"device.damping_N_s_per_m", &scene.settings.damping},
      {"device.rate_hz", &scene.settings.rate},
      {"device.encoder_mm", &scene.settings.encoder_step},
      {"user.k_u_N_per_m", &scene.settings.stiffnesses.k_u},
      {"user.believed_k_u_N_per_m", &scene.settings.stiffnesses.believed_k_u},
      {"user.k_u_path_N_per_m", &scene.stiffness_path.values},
      {"user.k_u_times_s", &scene.stiffness_path.times},
      {"user.tremor_mm_rms", &scene.tremor_and_drift.tremor_rms},
      {"user.tremor_hz", &scene.tremor_and_drift.tremor_hz},
      {"user.drift_mm_per_s", &scene.tremor_and_drift.drift_speed},
      {"user.seed", &scene.tremor_and_drift.seed},
      {"rendering.k_r_N_per_m", &scene.settings.stiffnesses.k_r},
      {"rendering.k_t_N_per_m", &scene.settings.stiffnesses.k_t},
      {"rendering.k_c_N_per_m", &scene.settings.stiffnesses.k_c},
      {"rendering.tracking_ratio", &scene.settings.stiffnesses.chosen_tracking_ratio},
      {"goal.path_mm", &scene.goal.points},
      {"goal.times_s", &scene.goal.times},
      {"goal.duration_s", &scene.duration},
      {"view.center_mm", &scene.view.center},
      {"view.width_mm", &scene.view.width},
  };
  for (const auto& [name, place] : places) EXPECT_EQ(place_of(key_named(name), scene), place) << name;
}

// Ranges in the units of the file, both ends included.
TEST(SceneTest, RangesAreThoseOfTheFileFormat) {
  const auto expect_range = [](std::string_view name, double least, double greatest) {
    SCOPED_TRACE(name);
    const SceneKey& key = key_named(name);
    if (const auto* number = std::get_if<NumberKey>(&key.value)) {
      EXPECT_EQ(number->least, least);
      EXPECT_EQ(number->greatest, greatest);
    } else {
      const auto* optional = std::get_if<OptionalNumberKey>(&key.value);
      ASSERT_NE(optional, nullptr);
      EXPECT_EQ(optional->least, least);
      EXPECT_EQ(optional->greatest, greatest);
    }
  };
  expect_range("device.mass_kg", 0.001, 100.0);
  expect_range("device.damping_N_s_per_m", 0.0, 1e4);
  expect_range("device.rate_hz", 10.0, 20000.0);
  expect_range("device.encoder_mm", 0.0, 10.0);
  expect_range("user.tremor_mm_rms", 0.0, 10.0);
  expect_range("user.drift_mm_per_s", 0.0, 100.0);
  expect_range("user.seed", 0.0, 1e9);
  EXPECT_EQ(std::get<NumbersKey>(key_named("user.k_u_path_N_per_m").value).range, user_stiffness_range);
  EXPECT_EQ(std::get<RangeKey>(key_named("user.tremor_hz").value).range, (NumberRange{0.1, 100.0}));
  expect_range("user.k_u_N_per_m", 0.1, 1e6);
  expect_range("user.believed_k_u_N_per_m", 0.1, 1e6);
  expect_range("rendering.k_r_N_per_m", 0.0, 1e6);
  expect_range("rendering.k_t_N_per_m", 0.1, 1e6);
  expect_range("rendering.k_c_N_per_m", 1.0, 1e9);
  expect_range("rendering.tracking_ratio", 1e-3, 1e3);
  EXPECT_EQ(farthest_mm, 1000.0);
  EXPECT_EQ(most_ticks, 1e7);

  for (const SceneKey& key : scene_keys()) {
    SCOPED_TRACE(full_name(key));
    if (const auto* number = std::get_if<NumberKey>(&key.value)) {
      EXPECT_LT(number->least, number->greatest);
      EXPECT_TRUE(std::isfinite(number->least) && std::isfinite(number->greatest));
      EXPECT_GT(number->per_si, 0.0);
      EXPECT_EQ(number->may_be_infinite, key.name == "k_c_N_per_m" || key.name == "most_N");
      EXPECT_EQ(number->whole, key.name == "rate_hz" || key.name == "seed");
    }
    if (const auto* optional = std::get_if<OptionalNumberKey>(&key.value)) {
      EXPECT_LT(optional->least, optional->greatest);
      EXPECT_FALSE(key.required);
    }
  }
}

// The name tells the unit of the file; the scene is in SI.
TEST(SceneTest, UnitsFollowTheNames) {
  for (const SceneKey& key : scene_keys()) {
    SCOPED_TRACE(full_name(key));
    const auto* number = std::get_if<NumberKey>(&key.value);
    if (number == nullptr) continue;
    if (key.name.ends_with("_deg")) {
      EXPECT_DOUBLE_EQ(number->per_si * std::numbers::pi, 180.0);
    } else if (key.name.ends_with("_mm") || key.name.ends_with("_mm_rms") || key.name.ends_with("_mm_per_s")) {
      EXPECT_EQ(number->per_si, 1000.0);
    } else {
      EXPECT_EQ(number->per_si, 1.0);
    }
  }
}

TEST(SceneTest, ChoicesGoBackAndForth) {
  const auto words_of = [](std::string_view name) {
    const auto& choice = std::get<ChoiceKey>(key_named(name).value);
    Scene scene;
    for (std::size_t word = 0; word < choice.words.size(); ++word) {
      choice.set(scene, word);
      EXPECT_EQ(choice.get(scene), word) << choice.words[word];
    }
    return std::vector<std::string_view>(choice.words.begin(), choice.words.end());
  };
  std::vector<std::string_view> strategies;
  for (const Strategy& entry : strategy_catalog()) strategies.push_back(entry.name);
  EXPECT_EQ(words_of("rendering.strategy"), strategies);
  EXPECT_EQ(words_of("goal.motion"), (std::vector<std::string_view>{"linear", "minimum-jerk"}));

  Scene scene;
  std::get<ChoiceKey>(key_named("rendering.strategy").value).set(scene, 1);
  EXPECT_EQ(scene.settings.active, StrategyId::naive);
  std::get<ChoiceKey>(key_named("goal.motion").value).set(scene, 1);
  EXPECT_EQ(scene.goal.motion, Motion::minimum_jerk);
}

// What the program does about an empty place: a word for it in the file, or no line at all.
TEST(SceneTest, EmptyRatioHasAWord) {
  EXPECT_EQ(std::get<OptionalNumberKey>(key_named("rendering.tracking_ratio").value).word_for_empty, "optimal");
  EXPECT_EQ(std::get<OptionalNumberKey>(key_named("user.believed_k_u_N_per_m").value).word_for_empty, "");
}

Scene valid() {
  Scene scene;
  scene.settings.rate = 1000.0;
  scene.goal = {{{0.0, 0.0}, {0.01, 0.0}}, {0.0, 1.0}, Motion::linear};
  scene.duration = 3.0;
  return scene;
}

TEST(SceneTest, AValidSceneHasNoProblem) {
  EXPECT_FALSE(find_problem(valid()).has_value());
}

TEST(SceneTest, AsManyTimesAsWaypoints) {
  for (const std::vector<double>& times :
       {std::vector<double>{}, std::vector<double>{0.0}, std::vector<double>{0.0, 1.0, 2.0}}) {
    Scene scene = valid();
    scene.goal.times = times;
    const auto problem = find_problem(scene);
    ASSERT_TRUE(problem.has_value());
    EXPECT_EQ(problem->table, "goal");
    EXPECT_EQ(problem->name, "times_s");
    EXPECT_NE(problem->what.find(std::to_string(times.size())), std::string::npos);
    EXPECT_NE(problem->what.find('2'), std::string::npos);
  }
}

TEST(SceneTest, NotTooManyTicks) {
  Scene scene = valid();
  scene.duration = 1e4;  // exactly 1e7 ticks
  EXPECT_FALSE(find_problem(scene).has_value());
  scene.duration = 10001.0;
  const auto problem = find_problem(scene);
  ASSERT_TRUE(problem.has_value());
  EXPECT_EQ(problem->table, "goal");
  EXPECT_EQ(problem->name, "duration_s");
}

// A problem names a key that exists, so that a message can point at its line.
TEST(SceneTest, ProblemsNameKeysOfTheCatalog) {
  Scene scene = valid();
  scene.goal.times = {0.0};
  for (const auto& problem : {find_problem(scene)}) {
    ASSERT_TRUE(problem.has_value());
    EXPECT_EQ(key_named(std::string(problem->table) + '.' + std::string(problem->name)).name, problem->name);
  }
}

Settings settings_in_range() {
  Settings settings;
  settings.mass = 0.1;
  settings.damping = 5.0;
  settings.rate = 1000.0;
  settings.stiffnesses.k_u = 100.0;
  settings.stiffnesses.k_r = 1000.0;
  settings.stiffnesses.k_t = 1000.0;
  settings.stiffnesses.k_c = 1e5;
  return settings;
}

// What a servo takes: each number of each setting at both ends of its range, just past them, and not a number at all.
TEST(SceneTest, SettingsAreInRangeWhereEachKeyIs) {
  ASSERT_TRUE(is_in_range(settings_in_range()));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto with = [](const SceneKey& key, auto value) {
    Scene scene;
    scene.settings = settings_in_range();
    scene.settings.general.strings.count = 1;
    if (key.name == "k_u_first_deg") scene.settings.general.k_u_second = 100.0;
    for (std::size_t kind = 0; kind < kinds_of(key.table).size() && !belongs(key, scene); ++kind) {
      std::get<ChoiceKey>(key_named(std::string(key.table) + ".kind").value).set(scene, kind);
    }
    std::visit(
        [&](const auto& k) {
          if constexpr (requires { k.in(scene); }) {
            if constexpr (std::is_same_v<decltype(k.in(scene)), decltype(value)&>) k.in(scene) = value;
          }
        },
        key.value);
    return is_in_range(scene.settings);
  };
  for (const SceneKey& key : scene_keys()) {
    if (!is_setting(key)) continue;
    SCOPED_TRACE(full_name(key));
    if (const auto* number = std::get_if<NumberKey>(&key.value)) {
      EXPECT_FALSE(with(key, nan));
      EXPECT_FALSE(with(key, -infinity));
      EXPECT_EQ(with(key, infinity), number->may_be_infinite);
      if (number->greatest > 1e300) continue;  // any finite number
      EXPECT_TRUE(with(key, number->least / number->per_si));
      EXPECT_TRUE(with(key, number->greatest / number->per_si));
      // A number just below 0 is 0 in another unit.
      const double below = number->least == 0.0 ? -1e-300 : std::nextafter(number->least, -infinity);
      EXPECT_FALSE(with(key, below / number->per_si));
      EXPECT_FALSE(with(key, std::nextafter(number->greatest, infinity) / number->per_si));
      EXPECT_EQ(with(key, 100.5 / number->per_si), !number->whole && number->greatest > 100.0 && number->least < 100.5);
    } else if (const auto* optional = std::get_if<OptionalNumberKey>(&key.value)) {
      EXPECT_TRUE(with(key, std::optional<double>{}));
      EXPECT_TRUE(with(key, std::optional{optional->least}));
      EXPECT_TRUE(with(key, std::optional{optional->greatest}));
      EXPECT_FALSE(with(key, std::optional{std::nextafter(optional->least, -infinity)}));
      EXPECT_FALSE(with(key, std::optional{std::nextafter(optional->greatest, infinity)}));
      EXPECT_FALSE(with(key, std::optional{nan}));
      EXPECT_FALSE(with(key, std::optional{infinity}));
    } else if (std::holds_alternative<PointKey>(key.value)) {
      EXPECT_TRUE(with(key, Vector<2>(1.0, -1.0)));
      EXPECT_FALSE(with(key, Vector<2>(1.001, 0.0)));
      EXPECT_FALSE(with(key, Vector<2>(0.0, -1.001)));
      EXPECT_FALSE(with(key, Vector<2>(0.0, nan)));
    }
  }
  Settings settings = settings_in_range();
  settings.active = static_cast<StrategyId>(strategy_count);
  EXPECT_FALSE(is_in_range(settings));
}
static_assert(noexcept(is_in_range(std::declval<const Settings&>())));

// What may change while a scene runs; how its hand moves stands once and for all in the scene.
TEST(SceneTest, SettingsAreWhatAPersonMayChange) {
  std::vector<std::string> others;
  for (const SceneKey& key : scene_keys()) {
    if (!is_setting(key)) others.push_back(full_name(key));
  }
  EXPECT_EQ(others, (std::vector<std::string>{"title", "about", "user.k_u_path_N_per_m", "user.k_u_times_s",
                                              "user.tremor_mm_rms", "user.tremor_hz", "user.drift_mm_per_s",
                                              "user.seed", "goal.path_mm", "goal.times_s", "goal.duration_s",
                                              "goal.motion", "view.center_mm", "view.width_mm"}));
}

// Files that were written before these keys were there must still be written the same.
TEST(SceneTest, RareKeysAreTheNewOnes) {
  std::vector<std::string> rare;
  for (const SceneKey& key : scene_keys()) {
    EXPECT_FALSE(key.is_omitted_when_default && key.required) << full_name(key);
    if (key.is_omitted_when_default) rare.push_back(full_name(key));
  }
  EXPECT_EQ(rare, (std::vector<std::string>{"wall.kind", "device.kind", "device.most_N", "device.encoder_mm",
                                            "user.k_u_first_deg", "user.k_u_path_N_per_m", "user.k_u_times_s",
                                            "user.tremor_mm_rms", "user.tremor_hz", "user.drift_mm_per_s", "user.seed",
                                            "rendering.compliance_share"}));
  const Scene scene;
  EXPECT_EQ(scene.settings.encoder_step, 0.0);
  EXPECT_TRUE(scene.stiffness_path.is_empty());
  EXPECT_TRUE(scene.tremor_and_drift.is_still());
  EXPECT_EQ(scene.tremor_and_drift.tremor_hz, (NumberRange{8.0, 12.0}));
  EXPECT_EQ(scene.tremor_and_drift.seed, 1.0);
}

TEST(SceneTest, AStiffnessNeedsItsTimes) {
  Scene scene = valid();
  scene.stiffness_path = {{200.0, 400.0}, {0.0, 5.0}};
  EXPECT_FALSE(find_problem(scene).has_value());
  const auto problem_of = [&scene](StiffnessPath path) {
    scene.stiffness_path = std::move(path);
    const auto problem = find_problem(scene);
    return problem ? std::string(problem->name) + ": " + problem->what : "none";
  };
  EXPECT_EQ(problem_of({{200.0, 400.0}, {}}), "k_u_path_N_per_m: k_u_times_s is missing");
  EXPECT_EQ(problem_of({{}, {0.0}}), "k_u_times_s: k_u_path_N_per_m is missing");
  EXPECT_EQ(problem_of({{200.0, 400.0}, {0.0}}),
            "k_u_times_s: there are 1 times for 2 stiffnesses in k_u_path_N_per_m");
}

// At a moment the hand is as stiff as its path says, and the renderer, which cannot see that, believes what it believed.
TEST(SceneTest, SettingsOfAMomentHaveTheHandOfThatMoment) {
  Scene scene = valid();
  scene.settings = settings_in_range();
  EXPECT_EQ(settings_at(scene, scene.settings, 1.0), scene.settings);
  const double ratio = tracking_ratio(scene.settings.stiffnesses);
  scene.stiffness_path = {{200.0, 400.0}, {0.0, 5.0}};
  const Settings then = settings_at(scene, scene.settings, 2.5);
  EXPECT_EQ(then.stiffnesses.k_u, 300.0);
  EXPECT_EQ(then.stiffnesses.believed_k_u, 100.0);
  EXPECT_EQ(tracking_ratio(then.stiffnesses), ratio);
  scene.settings.stiffnesses.believed_k_u = 50.0;
  EXPECT_EQ(settings_at(scene, scene.settings, 9.0).stiffnesses.believed_k_u, 50.0);
}

TEST(SceneTest, NumbersOfKeysAreInTheFilesUnit) {
  Scene scene = valid();
  set_number(scene, key_named("view.width_mm"), 120.0);
  EXPECT_EQ(scene.view.width, 0.12);
  EXPECT_EQ(number_of(scene, key_named("view.width_mm")), 120.0);
  const SceneKey& belief = key_named("user.believed_k_u_N_per_m");
  scene.settings.stiffnesses.believed_k_u.reset();
  EXPECT_EQ(number_of(scene, belief), std::nullopt) << "left to the program";
  set_number(scene, belief, 50.0);
  EXPECT_EQ(scene.settings.stiffnesses.believed_k_u, 50.0);
  EXPECT_EQ(number_of(scene, belief), 50.0);
}

TEST(SceneTest, LastTickIsRoundedNotCut) {
  Scene scene = valid();
  EXPECT_EQ(last_tick(scene), 3000);
  scene.duration = 0.29;  // 0.29 · 1000 is 289.99999999999994
  EXPECT_EQ(last_tick(scene), 290);
  scene.duration = 0.0;
  EXPECT_EQ(last_tick(scene), 0);
}

}  // namespace
}  // namespace ghostforce::scene_test
