// The stage with the scenes that are not the paper's: what is drawn stands where core says, and what is said is so.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <glm/geometric.hpp>

#include "app/files/scene_file.h"
#include "app/picture/share_colour.h"
#include "app/picture/workspace_layer.h"
#include "app/stage/stage_sentence.h"
#include "app/stage/stage_transition.h"
#include "app/state/stage_view.h"
#include "core/scene_shape.h"
#include "tests/app/stage/stage_dice.h"
#include "tests/core/general_scenes.h"

namespace ghostforce::any_device_test {
namespace {

constexpr std::array<const char*, 5> scenes{"arm", "pantograph", "string", "corner", "curve"};

StageCase case_of(const Scene& scene, const Vector<2>& goal, StrategyId active) {
  Settings settings = scene.settings;
  settings.active = active;
  return stage_case_at(settings, goal);
}

StageCase case_of(const std::string& name, StrategyId active) {
  const Scene scene = load_scene(name);
  return case_of(scene, scene.goal.points.back(), active);
}

template <typename Form>
std::vector<Form> forms(const StagePicture& picture, Role role) {
  std::vector<Form> found;
  for (const Mark& mark : picture.pane.marks) {
    if (mark.role != role) continue;
    if (const auto* const form = std::get_if<Form>(&mark.form)) found.push_back(*form);
  }
  return found;
}

double off_line(const Vector<2>& direction, const Vector<2>& along) {
  return std::abs(direction.x * along.y - direction.y * along.x) / (glm::length(direction) * glm::length(along));
}

// any-device.md, section 6: naïve, at the first goal.
TEST(AnyDeviceStage, ShowsGhostForceAndSlideOfEachScene) {
  constexpr std::array<double, 5> ghosts{1.41, 3.40, 1.49, 0.42, 0.74};
  constexpr std::array<double, 5> slides{11.5, 20.8, 13.0, 3.0, 6.4};
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    SCOPED_TRACE(scenes[i]);
    const StageReading naive = case_of(scenes[i], StrategyId::naive).read();
    EXPECT_NEAR(std::abs(naive.numbers.ghost_force.value()), ghosts[i], 0.005);
    EXPECT_NEAR(naive.numbers.slide.value() * mm_per_m, slides[i], 0.05);
    const StageReading cured = case_of(scenes[i], StrategyId::anisotropic).read();
    EXPECT_EQ(force_number(cured.numbers.ghost_force.value()), "0.00");
    EXPECT_EQ(slide_number(cured.numbers.slide.value()), "0.0");
  }
}

TEST(AnyDeviceStage, DrawsTheEdgeWhereTheConstraintHasIt) {
  for (const char* const name : {"corner", "curve"}) {
    const Scene scene = load_scene(name);
    const Constraint constraint = constraint_of(scene.settings);
    const auto lines = forms<Line>(case_of(name, StrategyId::naive).compose(), Role::wall);
    ASSERT_GE(lines.size(), 2U) << name;
    double longest = 0.0;
    for (const Line& line : lines) {
      longest = std::max(longest, glm::distance(line.from, line.to));
      for (const Vector<2>& end : {line.from, line.to})
        EXPECT_NEAR(signed_distance(constraint, end), 0.0, 1e-9) << name;
    }
    EXPECT_GT(longest, 0.0005);
  }
}

TEST(AnyDeviceStage, LightsTheWallsThatAct) {
  const auto widths = [](StrategyId active) {
    std::multiset<double> all;
    for (const Line& line : forms<Line>(case_of("corner", active).compose(), Role::wall)) all.insert(line.width);
    return all;
  };
  const auto one = widths(StrategyId::full);
  EXPECT_LT(*one.begin(), *one.rbegin()) << "one wall holds the handle";
  const auto both = widths(StrategyId::naive);
  EXPECT_EQ(*both.begin(), *both.rbegin()) << "both do";
}

TEST(AnyDeviceStage, LaysTheRailAlongTheColumnOfA) {
  for (const char* const name : {"arm", "pantograph"}) {
    const Scene scene = load_scene(name);
    std::vector<Vector<2>> rails;
    for (const Vector<2>& offset : {Vector<2>(0.0), Vector<2>(0.02, 0.01), Vector<2>(-0.03, -0.02)}) {
      const StageCase shown = case_of(scene, scene.goal.points.back() + offset, StrategyId::naive);
      const Vector<2> column = actuation_at(mechanism_of(shown.settings), shown.moment.handle).value().columns[0];
      const auto lines = forms<Line>(shown.compose(), Role::motor_axis);
      ASSERT_FALSE(lines.empty());
      const auto widest = std::ranges::max_element(lines, {}, &Line::width);
      rails.push_back(glm::normalize(widest->to - widest->from));
      EXPECT_LT(off_line(rails.back(), column), 1e-9) << name;
    }
    EXPECT_GT(off_line(rails[0], rails[2]), 1e-3) << name << ": it turns with the handle";
  }
}

TEST(AnyDeviceStage, DrawsLinksFromJointToJointAndTheMotorFilled) {
  for (const char* const name : {"arm", "pantograph"}) {
    const StageCase shown = case_of(name, StrategyId::naive);
    const LinkagePose pose = pose_at(mechanism_of(shown.settings), shown.moment.handle).value();
    const StagePicture picture = shown.compose();
    const auto links = forms<Line>(picture, Role::linkage);
    ASSERT_GE(links.size(), pose.link_count) << "and again in the small picture";
    for (std::size_t i = 0; i < pose.link_count; ++i) {
      EXPECT_LT(glm::distance(links[i].from, pose.joints[pose.links[i].from]), 1e-9);
      EXPECT_LT(glm::distance(links[i].to, pose.joints[pose.links[i].to]), 1e-9);
    }
    const auto filled_at = [&](const Vector<2>& joint) {
      return std::ranges::any_of(forms<Marker>(picture, Role::joint), [&](const Marker& marker) {
        return glm::distance(marker.center, joint) < 1e-9 && marker.rim_width == 0.0;
      });
    };
    EXPECT_TRUE(filled_at(pose.joints[0]));
    EXPECT_FALSE(filled_at(pose.joints[1])) << "no motor there";
  }
}

TEST(AnyDeviceStage, DashesASlackStringAndLetsItHang) {
  const StageCase shown = case_of("string", StrategyId::naive);
  const Strings& strings = shown.settings.general.strings;
  const Efforts efforts =
      efforts_of(shown.settings, shown.moment.handle, shown.moment.wall_share + shown.moment.ghost_force);
  ASSERT_EQ(std::min(efforts[0], efforts[1]), 0.0);
  const std::size_t slack = efforts[0] == 0.0 ? 0 : 1;
  std::array<int, 2> straight{};
  int beside = 0;
  for (const Line& line : forms<Line>(shown.compose(), Role::linkage)) {
    for (std::size_t i = 0; i < 2; ++i) {
      straight[i] += line.from == strings.anchors[i] && line.to == shown.moment.handle ? 1 : 0;
    }
    const Vector<2> middle = 0.5 * (line.from + line.to);
    const Vector<2> way = shown.moment.handle - strings.anchors[slack];
    beside += off_line(middle - strings.anchors[slack], way) > 0.05 ? 1 : 0;
  }
  EXPECT_LE(straight[slack], 0);
  EXPECT_GE(beside, 3) << "pieces that hang through";
}

// κ = 10, and a wall at which the motor's push and its lever enclose enough.
Settings without_rest() {
  Settings settings = load_scene("arm").settings;
  settings.stiffnesses.k_u = 60.0;
  settings.active = StrategyId::naive;
  for (int deg = 0; deg < 360; deg += 5) {
    settings.wall_normal_angle = deg * radians_per_degree;
    const Vector<2> goal = -0.01 * direction_at(settings.wall_normal_angle);
    if (!rest_of(StrategyId::naive, settings, goal)) return settings;
  }
  ADD_FAILURE() << "each wall has a rest";
  return settings;
}

TEST(AnyDeviceStage, SaysThatThereIsNoRest) {
  Settings settings = without_rest();
  const Vector<2> goal = -0.01 * direction_at(settings.wall_normal_angle);
  StageCase shown = stage_case_at(settings, goal);
  EXPECT_FALSE(shown.moment.has_rest);
  for (const StageLanguage* const language : stage_languages) {
    shown.language = language;
    EXPECT_EQ(shown.read().sentence, language->sentences.no_rest);
    shown.mode = StageMode::why;
    EXPECT_EQ(shown.read().sentence, language->sentences.no_rest);
    EXPECT_TRUE(shown.read().steps.empty());
    shown.mode = StageMode::none;
  }
  settings.active = StrategyId::anisotropic;
  const StageCase cured = stage_case_at(settings, goal);
  EXPECT_TRUE(cured.moment.has_rest);
  EXPECT_EQ(cured.read().sentence, english_stage.sentences.cured);
}

// Near the edge of an arm's reach the cure may have none either, and waiting would be in vain.
TEST(AnyDeviceStage, SaysThatTheCureHasNoRest) {
  Settings settings = with_arm_near_edge(load_scene("arm").settings);
  settings.active = StrategyId::anisotropic;
  StageCase shown = stage_case_at(settings, goal_near_edge);
  EXPECT_FALSE(shown.moment.has_rest);
  for (const StageLanguage* const language : stage_languages) {
    shown.language = language;
    for (const StageMode mode : {StageMode::none, StageMode::why}) {
      shown.mode = mode;
      EXPECT_EQ(shown.read().sentence, language->sentences.no_rest_for_cure);
    }
  }
}

TEST(AnyDeviceStage, SaysThatTheDeviceDoesNotReachThere) {
  const Scene scene = load_scene("arm");
  StageCase shown = case_of("arm", StrategyId::naive);
  Snapshot snapshot;
  snapshot.goal = Vector<2>(0.4, 0.0);
  for (auto& each : snapshot.strategies) each.device = each.proxy = snapshot.goal;
  shown.moment = stage_moment(shown.settings, snapshot, snapshot.goal);
  for (const StageLanguage* const language : stage_languages) {
    shown.language = language;
    EXPECT_EQ(shown.read().sentence, language->sentences.out_of_reach);
  }
  EXPECT_TRUE(forms<Line>(shown.compose(), Role::motor_axis).empty()) << "no rail";
  const auto links = forms<Line>(shown.compose(), Role::linkage);
  ASSERT_GE(links.size(), 2U) << "it is stretched towards the handle, and can be taken hold of";
  const TwoLinkArm& arm = scene.settings.general.arm;
  EXPECT_LT(glm::distance(links[0].from, arm.base), 1e-9);
  EXPECT_NEAR(glm::distance(links[1].to, arm.base), arm.links[0] + arm.links[1], 1e-6);
  EXPECT_LT(off_line(links[1].to - arm.base, snapshot.goal - arm.base), 1e-6);
}

// However far the loop lets it run.
TEST(AnyDeviceStage, TheHandleStaysAtTheEndOfItsLinks) {
  for (const char* const name : {"arm", "pantograph"}) {
    const Settings settings = load_scene(name).settings;
    Snapshot snapshot;
    for (auto& each : snapshot.strategies) each.device = {0.7, -0.4};
    const StageMoment live = stage_moment(settings, snapshot, {0.7, -0.4});
    EXPECT_TRUE(live.is_outside);
    EXPECT_TRUE(pose_at(mechanism_of(settings), live.handle)) << name;
    const StageMoment between = stage_moment_between(settings, snapshot, {0.7, -0.4}, {.fullness = 0.5, .cure = 0.5});
    EXPECT_TRUE(pose_at(mechanism_of(settings), between.handle)) << name;
    const StageMoment at_rest = stage_moment_at_rest(settings, {0.7, -0.4});
    EXPECT_TRUE(pose_at(mechanism_of(settings), at_rest.handle)) << name;
  }
}

// A place of its own: it does not look for another one while something is dragged.
TEST(AnyDeviceStage, TheSmallPictureOfTheDeviceStandsStill) {
  for (const char* const name : {"arm", "pantograph", "string"}) {
    const Scene scene = load_scene(name);
    std::optional<ScreenBox> place;
    for (const Vector<2>& offset : {Vector<2>(0.0), Vector<2>(0.004, -0.002), Vector<2>(-0.02, -0.02),
                                    Vector<2>(0.02, -0.01), Vector<2>(0.0, 0.01)}) {
      for (const StrategyId id : {StrategyId::full, StrategyId::naive, StrategyId::anisotropic}) {
        const StagePicture picture = case_of(scene, scene.goal.points.back() + offset, id).compose();
        if (!picture.inset) continue;
        if (!place) place = picture.inset;
        EXPECT_EQ(picture.inset->least, place->least) << name;
        EXPECT_EQ(picture.inset->most, place->most) << name;
      }
    }
    EXPECT_TRUE(place || std::string_view(name) == "string") << name;
  }
}

TEST(AnyDeviceStage, ACirclesEdgeHasAGripThatIsSeen) {
  StageCase shown = case_of("curve", StrategyId::naive);
  shown.may_move_parts = true;
  const StagePicture picture = shown.compose();
  const auto edge = std::ranges::find_if(
      picture.parts, [](const StagePart& part) { return part.placed.part == ScenePart::circle_edge; });
  ASSERT_NE(edge, picture.parts.end());
  EXPECT_TRUE(contains(picture.scene, edge->place));
  EXPECT_NEAR(signed_distance(constraint_of(shown.settings), edge->placed.at), 0.0, 1e-9);
  const auto knobs = forms<Marker>(picture, Role::handle);
  EXPECT_TRUE(std::ranges::any_of(
      knobs, [&](const Marker& knob) { return glm::distance(knob.center, edge->placed.at) < 1e-9; }));
}

// --- Which walls are bad ---

TEST(WorkspaceStage, ColoursEachPlaceByWhatTheWallDoesThere) {
  for (const char* const name : {"arm", "pantograph"}) {
    StageCase shown = case_of(name, StrategyId::naive);
    shown.mode = StageMode::landscape;
    shown.shown = workspace_view(shown.settings);
    const StagePicture picture = shown.compose();
    EXPECT_FALSE(picture.landscape) << "it is not the map of walls and hands";
    const auto maps = forms<Raster>(picture, Role::map);
    ASSERT_EQ(maps.size(), 2U) << name << ": with either motor";
    const Raster& map = maps[0];
    const WorkspaceMap expected = workspace_map(shown.settings, shown.moment.goal);
    const Theme& theme = *find_theme(shown.theme);
    int red = 0;
    int grey = 0;
    for (std::size_t i = 0; i < map.cells.size(); i += 7) {
      const auto columns = static_cast<std::size_t>(map.columns);
      const Vector<2> share((static_cast<double>(i % columns) + 0.5) / map.columns,
                            (static_cast<double>(i / columns) + 0.5) / map.rows);
      const Vector<2> corner = to_screen(picture.pane.camera, map.corner);
      const WallAtPose there = expected.at(to_world(picture.pane.camera, corner + share * map.size));
      if (there.rest == WallAtPose::Rest::unreachable) {
        EXPECT_EQ(map.cells[i], theme.wall);
        ++grey;
      } else if (there.rest == WallAtPose::Rest::stays) {
        EXPECT_EQ(map.cells[i], colour_of_share(theme, there.ghost_share));
        red += there.ghost_share > 0.1 ? 1 : 0;
      }
    }
    EXPECT_GT(red, 20) << name;
    EXPECT_GT(grey, 20) << name;
    EXPECT_EQ(shown.read().sentence, english_stage.sentences.bad_walls);
    shown.settings.active = StrategyId::anisotropic;
    EXPECT_EQ(shown.read().sentence, english_stage.sentences.no_bad_walls);
  }
}

TEST(AnyDeviceStage, SaysWhatEachDeviceDoes) {
  const StageLanguage::Sentences& all = english_stage.sentences;
  const auto naive = [](const char* name) { return case_of(name, StrategyId::naive).read().sentence; };
  EXPECT_EQ(naive("arm"), filled(all.arm_pushes_by_base, "11.5"));
  EXPECT_EQ(naive("pantograph"), filled(all.pantograph_throws, "20.8"));
  EXPECT_EQ(naive("string"), all.string_is_slack);
  EXPECT_EQ(naive("corner"), filled(all.dragged_into_corner, "3.0"));
  EXPECT_EQ(naive("curve"), all.naive_ghost);
  for (const char* const name : scenes) {
    EXPECT_EQ(case_of(name, StrategyId::anisotropic).read().sentence, all.cured) << name;
  }
}

TEST(AnyDeviceStage, TellsTheTorqueOfTheGhostForce) {
  const StagePicture picture = case_of("arm", StrategyId::naive).compose();
  const auto labels = forms<Label>(picture, Role::number);
  EXPECT_TRUE(std::ranges::any_of(labels, [](const Label& label) { return label.text == "ghost force (0.22 N·m)"; }));
}

// What the way between two strategies has at its ends, and nothing that is no number on it.
TEST(AnyDeviceStage, SwitchesFromOneRestToTheOther) {
  for (const char* const name : scenes) {
    const Scene scene = load_scene(name);
    const Vector<2> goal = scene.goal.points.back();
    Settings settings = scene.settings;
    const Snapshot rest = snapshot_of(loop_coefficients_of(settings), equilibrium_state(settings, goal));
    StageMoment before;
    for (int i = 0; i <= 50; ++i) {
      settings.active = StrategyId::anisotropic;
      const StageMoment now = stage_moment_between(settings, rest, goal, {.fullness = 0.0, .cure = i / 50.0});
      EXPECT_TRUE(std::isfinite(now.handle.x) && std::isfinite(now.ghost_force.x)) << name;
      if (i > 0) {
        EXPECT_LT(glm::distance(now.handle, before.handle), 0.002) << name << ": it does not jump";
      } else {
        EXPECT_LT(glm::distance(now.handle, rest.strategies[index_of(StrategyId::naive)].device), 1e-9) << name;
      }
      before = now;
    }
    EXPECT_LT(glm::distance(before.handle, rest.strategies[index_of(StrategyId::anisotropic)].device), 1e-9) << name;
  }
}

TEST(AnyDeviceStage, ShowsTheContactLargeAndTheWholeDevice) {
  for (const char* const name : {"arm", "pantograph", "string"}) {
    StageCase shown = case_of(name, StrategyId::naive);
    shown.may_move_parts = true;
    const StagePicture picture = shown.compose();
    const double points = glm::length(shown.moment.slide) * picture.pane.camera.points_per_metre;
    EXPECT_GT(points, 40.0) << name << ": the slide is seen";
    const auto has = [&](ScenePart part) {
      return std::ranges::any_of(picture.parts, [&](const StagePart& each) {
        const ScreenBox& numbers = picture.numbers.value();
        const bool is_beside_numbers = each.place.x > numbers.most.x || each.place.y > numbers.most.y;
        return each.placed.part == part && contains(picture.scene, each.place) && is_beside_numbers;
      });
    };
    for (const PlacedPart& part : scene_parts(shown.settings, shown.moment.handle, 0.05)) EXPECT_TRUE(has(part.part));
  }
}

TEST(SceneParts, MoveWhereTheyAreDraggedAndNothingElse) {
  for (const char* const name : scenes) {
    const Scene scene = load_scene(name);
    for (const PlacedPart& part : scene_parts(scene.settings, scene.goal.points.back(), 0.05)) {
      const Vector<2> to = part.at + Vector<2>(0.004, -0.003);
      const Settings moved = with_part_at(scene.settings, part.part, to, scene.goal.points.back());
      if (part.stays) {
        EXPECT_EQ(moved, scene.settings);
        continue;
      }
      EXPECT_NE(moved, scene.settings) << name;
      double nearest = 1.0;
      for (const PlacedPart& now : scene_parts(moved, scene.goal.points.back(), glm::distance(to, moved.wall_point))) {
        if (now.part == part.part) nearest = glm::distance(now.at, to);
      }
      // The circle is held at its top, wherever it was dragged by.
      EXPECT_LT(nearest, part.part == ScenePart::circle_edge ? 0.01 : 1e-9) << name;
      EXPECT_TRUE(is_in_range(moved));
      EXPECT_EQ(part.may_have_motor, part.part <= ScenePart::elbow);
    }
  }
}

TEST(SceneParts, KeepABaseWithinReachOfTheHand) {
  for (const auto& [name, reach] : {std::pair{"arm", 0.320}, {"pantograph", 0.250}}) {
    const Settings settings = load_scene(name).settings;
    const Vector<2> goal(0.01, -0.01);
    for (const Vector<2>& to : {Vector<2>(0.9, 0.3), Vector<2>(-2.0, 0.0), Vector<2>(0.0, -0.7)}) {
      const Settings moved = with_part_at(settings, ScenePart::left_base, to, goal);
      // Not past a pantograph's right one: its elbows stay outward.
      if (moved.general.mechanism == MechanismKind::pantograph) {
        EXPECT_TRUE(has_elbows_outward(moved.general.pantograph, goal));
        if (moved == settings && to.x > 0.0) continue;
      }
      const Vector<2> base = scene_parts(moved, goal, 0.05).front().at;
      EXPECT_LE(glm::distance(base, goal), reach) << name;
      EXPECT_GE(glm::dot(glm::normalize(base - goal), glm::normalize(nearest_in_scene(to) - goal)), 1.0 - 1e-12)
          << name;
    }
  }
}

TEST(SceneParts, KeepACornerOpen) {
  const Settings settings = load_scene("corner").settings;
  const std::array<double, 2>& angles = settings.general.corner_normal_angles;
  // Onto the other wall.
  const Vector<2> other = direction_at(angles[1] + 0.5 * std::numbers::pi);
  for (const double side : {-0.05, 0.05}) {
    EXPECT_EQ(with_part_at(settings, ScenePart::first_wall, settings.wall_point + side * other, Vector<2>(0.0)),
              settings);
  }
}

TEST(SceneParts, TheMotorGoesToTheOtherJointAndBack) {
  for (const char* const name : {"arm", "pantograph"}) {
    const Settings settings = load_scene(name).settings;
    EXPECT_NE(with_other_motor(settings), settings);
    EXPECT_EQ(with_other_motor(with_other_motor(settings)), settings);
  }
  const Settings corner = load_scene("corner").settings;
  EXPECT_EQ(with_other_motor(corner), corner);
}

}  // namespace
}  // namespace ghostforce::any_device_test
