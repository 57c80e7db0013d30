// The picture as marks: what is drawn, where the model says it is, and that words stay readable. No OpenGL here.

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/files/scene_file.h"
#include "app/picture/glossary.h"
#include "app/picture/layers.h"
#include "app/picture/panes.h"
#include "core/simulate.h"
#include "tests/support/paper_scenes.h"

namespace ghostforce::compose_test {
namespace {

// Letters of a fixed width: close to DejaVu Sans, and the same everywhere.
const MeasureText measure = [](std::string_view text, const TextStyle& style) {
  return Vector<2>(0.58 * style.height * static_cast<double>(text.size()), style.height);
};

struct Picture {
  Scene scene;
  Snapshot snapshot;
  History history;
  Camera camera;
  ViewOptions options;
  Marks marks;
};

void compose_again(Picture& picture) {
  PaneMemory memory;
  picture.marks = compose({.settings = picture.scene.settings,
                           .snapshot = picture.snapshot,
                           .history = picture.history,
                           .theme = *find_theme("light"),
                           .camera = picture.camera,
                           .options = picture.options,
                           .scale = 1.0,
                           .points_per_newton = 30.0,
                           .measure = measure},
                          memory);
}

Picture picture_of(const std::string& name, StrategyId active, Compare compare, Vector<2> size = {853.0, 724.0},
                   std::vector<std::string> overrides = {}) {
  Picture picture;
  picture.scene = load_scene(name, overrides);
  picture.scene.settings.active = active;
  simulate(picture.scene, last_tick(picture.scene), [&](const Snapshot& snapshot) {
    picture.history.add(snapshot);
    picture.snapshot = snapshot;
  });
  picture.camera = camera_on(picture.scene.view.center, picture.scene.view.width, size);
  picture.options = {.compare = compare};
  compose_again(picture);
  return picture;
}

template <typename Form>
std::vector<const Form*> find_forms(const Picture& picture, Role role, std::optional<StrategyId> strategy) {
  std::vector<const Form*> found;
  for (const Mark& mark : picture.marks) {
    if (mark.role == role && mark.strategy == strategy) {
      if (const auto* form = std::get_if<Form>(&mark.form)) found.push_back(form);
    }
  }
  return found;
}

// Its end on the screen, from where its device is.
Vector<2> end_of(const Picture& picture, const Arrow& arrow, StrategyId id) {
  return (arrow.tip - picture.snapshot.strategies[index_of(id)].device) * picture.camera.points_per_metre;
}

TEST(Compose, DrawsTheNaiveGhostForceAsTheHatchedEndOfItsForce) {
  const Picture picture = picture_of("wall45", StrategyId::naive, Compare::overlay);
  const auto forces = find_forms<Arrow>(picture, Role::force, StrategyId::naive);
  const auto ghosts = find_forms<Arrow>(picture, Role::ghost_force, StrategyId::naive);
  ASSERT_EQ(forces.size(), 1U);
  ASSERT_EQ(ghosts.size(), 1U);
  EXPECT_TRUE(ghosts[0]->is_hatched);
  EXPECT_TRUE(ghosts[0]->has_head);
  EXPECT_FALSE(forces[0]->is_hatched);
  EXPECT_FALSE(forces[0]->has_head) << "there is one head, and it is the ghost's";
  const StrategySnapshot<2>& naive = picture.snapshot.strategies[index_of(StrategyId::naive)];
  EXPECT_LT(glm::distance(forces[0]->tail, naive.device), 1e-12);
  // 1e-9 points: rounding of two conversions.
  const Vector<2> whole = end_of(picture, *ghosts[0], StrategyId::naive);
  EXPECT_LT(glm::distance(whole, naive.force * 30.0), 1e-9);
  EXPECT_LT(
      glm::distance((ghosts[0]->tip - ghosts[0]->tail) * picture.camera.points_per_metre, naive.ghost_force * 30.0),
      1e-9);
  EXPECT_LT(whole.x, -30.0) << "to the left, more than a newton";
}

TEST(Compose, FoldsTheGhostBackWhereItIsTooLittle) {
  const Picture picture = picture_of("fig3-normal", StrategyId::anisotropic, Compare::overlay, {853.0, 724.0},
                                     {"rendering.tracking_ratio=40"});
  const StrategySnapshot<2>& now = picture.snapshot.strategies[index_of(StrategyId::anisotropic)];
  ASSERT_LT(glm::dot(now.force, now.ghost_force), 0.0);
  const auto forces = find_forms<Arrow>(picture, Role::force, StrategyId::anisotropic);
  const auto ghosts = find_forms<Arrow>(picture, Role::ghost_force, StrategyId::anisotropic);
  ASSERT_EQ(forces.size(), 1U);
  ASSERT_EQ(ghosts.size(), 1U);
  EXPECT_LT(glm::distance(end_of(picture, *ghosts[0], StrategyId::anisotropic), now.force * 30.0), 1e-9);
  EXPECT_LT(glm::distance(end_of(picture, *forces[0], StrategyId::anisotropic), (now.force - now.ghost_force) * 30.0),
            1e-9);
}

TEST(Compose, DrawsNoGhostForceAndNoDriftWhereThereIsNone) {
  const Picture picture = picture_of("wall45", StrategyId::anisotropic, Compare::overlay);
  for (const Strategy& entry : strategy_catalog()) {
    EXPECT_TRUE(find_forms<Arrow>(picture, Role::ghost_force, entry.id).empty());
    EXPECT_TRUE(find_forms<Line>(picture, Role::proxy_drift, entry.id).empty());
  }
}

// Against a target it may be, and then all else is drawn as ever.
TEST(Compose, LeavesOutAGhostForceThatIsUnknown) {
  Picture picture = picture_of("wall45", StrategyId::naive, Compare::overlay);
  picture.snapshot.measured = StrategyId::naive;
  picture.snapshot.has_target = true;
  StrategySnapshot<2>& naive = picture.snapshot.strategies[index_of(StrategyId::naive)];
  naive.ghost_force = naive.proxy_drift = Vector<2>(std::numeric_limits<double>::quiet_NaN());
  compose_again(picture);
  const auto forces = find_forms<Arrow>(picture, Role::force, StrategyId::naive);
  ASSERT_EQ(forces.size(), 1U);
  EXPECT_LT(glm::distance(end_of(picture, *forces[0], StrategyId::naive), naive.force * 30.0), 1e-9);
  EXPECT_TRUE(find_forms<Arrow>(picture, Role::ghost_force, StrategyId::naive).empty());
  EXPECT_TRUE(find_forms<Line>(picture, Role::proxy_drift, StrategyId::naive).empty());
  EXPECT_FALSE(find_forms<Label>(picture, Role::device, StrategyId::naive).empty());
  EXPECT_FALSE(find_forms<Label>(picture, Role::force, StrategyId::naive).empty());
}

// Only the active strategy has words, numbers, arrows and rulers.
TEST(Compose, LeavesTheOtherStrategiesPaleAndSilent) {
  for (const Strategy& active : strategy_catalog()) {
    const Picture picture = picture_of("fig3-normal", active.id, Compare::overlay);
    for (const Mark& mark : picture.marks) {
      if (!mark.strategy || *mark.strategy == active.id || mark.role == Role::legend) continue;
      EXPECT_TRUE(mark.role == Role::device || mark.role == Role::proxy || mark.role == Role::trail)
          << role_name(mark.role);
      const auto* marker = std::get_if<Marker>(&mark.form);
      if (marker == nullptr) continue;
      const Colour full = find_theme("light")->strategy[index_of(*mark.strategy)];
      EXPECT_NE(marker->fill, full);
      EXPECT_NE(marker->rim, full);
    }
  }
}

// "N" is a newton there.
TEST(Compose, LabelsOfTheActiveStrategyHaveNoLetterBeforeThem) {
  const Picture picture = picture_of("fig3-normal", StrategyId::naive, Compare::overlay);
  int found = 0;
  for (const Mark& mark : picture.marks) {
    const auto* label = std::get_if<Label>(&mark.form);
    if (label == nullptr || mark.strategy != StrategyId::naive || mark.role == Role::legend) continue;
    ++found;
    EXPECT_FALSE(label->text.starts_with("N")) << label->text;
  }
  EXPECT_GE(found, 5) << "force, ghost force, proxy drift, device, proxy";
}

TEST(Compose, DrawsTheForceAboveProxiesAndRings) {
  const Picture picture = picture_of("fig3-normal", StrategyId::naive, Compare::overlay);
  const auto last = [&](Role role) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < picture.marks.size(); ++i) {
      const bool is_text = std::holds_alternative<Label>(picture.marks[i].form);
      if (picture.marks[i].role == role && !is_text) found = i;
    }
    return found;
  };
  for (const Role role : {Role::proxy, Role::prediction, Role::goal, Role::proxy_drift}) {
    EXPECT_LT(last(role), last(Role::force)) << role_name(role);
    EXPECT_LT(last(role), last(Role::ghost_force)) << role_name(role);
  }
  EXPECT_LT(last(Role::force), last(Role::device)) << "it begins below its device";
}

TEST(Compose, DrawsAForceThatIsShorterThanItsDeviceAboveIt) {
  const Picture picture = picture_of("fig3-normal", StrategyId::full, Compare::overlay, {853.0, 724.0},
                                     {"goal.path_mm=[[3,-3]]", "goal.times_s=[0]"});
  std::optional<Role> last;
  for (const Mark& mark : picture.marks) {
    const bool is_text = std::holds_alternative<Label>(mark.form);
    if (!is_text && (mark.role == Role::device || mark.role == Role::force)) last = mark.role;
  }
  EXPECT_EQ(last, Role::force);
}

TEST(Compose, DrawsTheRulerAsLongAsTheDriftAndLeadsItToWhatItMeasures) {
  const Picture picture = picture_of("fig3-normal", StrategyId::naive, Compare::active_only);
  const auto lines = find_forms<Line>(picture, Role::proxy_drift, StrategyId::naive);
  ASSERT_EQ(lines.size(), 5U) << "a ruler, its two ends, and a thin line to each";
  const StrategySnapshot<2>& naive = picture.snapshot.strategies[index_of(StrategyId::naive)];
  // The device lags a nanometre behind rest after two seconds; the ruler is drawn from the same numbers.
  EXPECT_NEAR(glm::distance(lines[0]->from, lines[0]->to), glm::length(naive.proxy_drift), 1e-12);
  EXPECT_EQ(lines[3]->from, picture.snapshot.goal);
  EXPECT_EQ(lines[3]->to, lines[0]->from);
  EXPECT_EQ(lines[4]->from, naive.contact);
  EXPECT_EQ(lines[4]->to, lines[0]->to);
  // Its ends are clear of every marker.
  for (const Mark& mark : picture.marks) {
    const auto* marker = std::get_if<Marker>(&mark.form);
    if (marker == nullptr || mark.role == Role::legend || mark.role == Role::motor_axis) continue;
    for (const Vector<2>& end : {lines[0]->from, lines[0]->to}) {
      EXPECT_GT(glm::distance(end, marker->center) * picture.camera.points_per_metre, marker->radius + 5.0)
          << role_name(mark.role);
    }
  }
}

TEST(Compose, ShowsTheDevicesWhereTheyAre) {
  const Picture picture = picture_of("fig1", StrategyId::full, Compare::overlay);
  for (const Strategy& entry : strategy_catalog()) {
    const auto devices = find_forms<Marker>(picture, Role::device, entry.id);
    ASSERT_EQ(devices.size(), 1U) << entry.name;
    EXPECT_EQ(devices[0]->center, picture.snapshot.strategies[index_of(entry.id)].device) << entry.name;
    EXPECT_EQ(devices[0]->shape, strategy_style(entry.id).shape) << entry.name;
  }
  const auto goals = find_forms<Marker>(picture, Role::goal, std::nullopt);
  ASSERT_EQ(goals.size(), 1U);
  EXPECT_EQ(goals[0]->center, picture.snapshot.goal);
}

TEST(Compose, ShowsTheActiveStrategyAloneWhenAsked) {
  const Picture picture = picture_of("fig1", StrategyId::naive, Compare::active_only);
  for (const Mark& mark : picture.marks) {
    if (mark.strategy) {
      EXPECT_EQ(*mark.strategy, StrategyId::naive) << role_name(mark.role);
    }
  }
}

TEST(Compose, DrawsNoProxyAndNoContactInFreeSpace) {
  const Picture picture = picture_of("wall45", StrategyId::naive, Compare::overlay, {853.0, 724.0},
                                     {"goal.path_mm=[[-30,30]]", "goal.times_s=[0]"});
  for (const Mark& mark : picture.marks) {
    EXPECT_NE(mark.role, Role::proxy);
    EXPECT_NE(mark.role, Role::contact);
    EXPECT_NE(mark.role, Role::force);
  }
}

TEST(Compose, HatchesTheInsideOfTheWall) {
  const Picture picture =
      picture_of("wall45", StrategyId::naive, Compare::overlay, {853.0, 724.0}, {"wall.normal_deg=20"});
  const Wall<2> wall = wall_of(picture.scene.settings);
  const auto strokes = find_forms<Line>(picture, Role::hatching, std::nullopt);
  EXPECT_GT(strokes.size(), 30U);
  for (const Line* stroke : strokes) EXPECT_GT(depth(wall, stroke->to), 0.0);
}

TEST(Compose, KeepsMarksCountBoundedHoweverFarOneZooms) {
  const Picture close =
      picture_of("wall45", StrategyId::naive, Compare::overlay, {4096.0, 4096.0}, {"view.width_mm=1"});
  const Picture far =
      picture_of("wall45", StrategyId::naive, Compare::overlay, {4096.0, 4096.0}, {"view.width_mm=10000"});
  EXPECT_LT(close.marks.size(), 6000U);
  EXPECT_LT(far.marks.size(), 6000U);
}

struct Box {
  std::string text;
  Vector<2> least, most;
};

std::vector<Box> text_boxes(const Picture& picture) {
  std::vector<Box> boxes;
  for (const Mark& mark : picture.marks) {
    if (const auto* label = std::get_if<Label>(&mark.form)) {
      const Vector<2> corner = to_screen(picture.camera, label->anchor) + label->offset;
      boxes.push_back({label->text, corner, corner + measure(label->text, label->style)});
    }
  }
  return boxes;
}

void expect_readable(const std::vector<Box>& boxes, const Vector<2>& size, const std::string& where) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Box& a = boxes[i];
    EXPECT_TRUE(a.least.x >= 0.0 && a.least.y >= 0.0 && a.most.x <= size.x && a.most.y <= size.y)
        << where << ' ' << size.x << ": '" << a.text << "' is cut off";
    for (std::size_t j = 0; j < i; ++j) {
      const Box& b = boxes[j];
      constexpr double rounding = 1e-9;  // of lines that stand one below the other
      const bool apart = a.most.x <= b.least.x || b.most.x <= a.least.x || a.most.y <= b.least.y + rounding ||
                         b.most.y <= a.least.y + rounding;
      EXPECT_TRUE(apart) << where << ' ' << size.x << ": '" << a.text << "' over '" << b.text << "'";
    }
  }
}

TEST(Compose, NoTwoLabelsOverlapAndNoneIsCutOff) {
  for (const auto& shipped : paper_scene_names()) {
    for (const Strategy& entry : strategy_catalog()) {
      for (const Compare compare : {Compare::overlay, Compare::active_only}) {
        for (const Vector<2>& size : {Vector<2>(674.0, 564.0), Vector<2>(853.0, 724.0), Vector<2>(1450.0, 1000.0)}) {
          const Picture picture = picture_of(std::string(shipped), entry.id, compare, size);
          expect_readable(text_boxes(picture), size, std::string(shipped) + ' ' + std::string(entry.name));
        }
      }
    }
  }
}

TEST(Panes, ShowEachStrategyAloneWithWordsThatCanBeRead) {
  for (const auto& shipped : paper_scene_names()) {
    const Picture picture = picture_of(std::string(shipped), StrategyId::naive, Compare::overlay);
    for (const Vector<2>& size : {Vector<2>(674.0, 564.0), Vector<2>(853.0, 724.0), Vector<2>(1450.0, 1000.0)}) {
      const std::vector<Pane> panes = compose_panes({.settings = picture.scene.settings,
                                                     .snapshot = picture.snapshot,
                                                     .history = picture.history,
                                                     .theme = *find_theme("light"),
                                                     .options = {.compare = Compare::side_by_side},
                                                     .shown = picture.scene.view,
                                                     .size = size,
                                                     .scale = 1.0,
                                                     .measure = measure});
      ASSERT_EQ(panes.size(), strategy_count);
      double right = 0.0;
      for (const Pane& pane : panes) {
        EXPECT_GE(pane.corner.x, right);
        right = pane.corner.x + pane.camera.size.x;
        Picture alone = picture;
        alone.camera = pane.camera;
        alone.marks = pane.marks;
        EXPECT_EQ(find_forms<Marker>(alone, Role::device, pane.active).size(), 1U);
        expect_readable(text_boxes(alone), pane.camera.size,
                        std::string(shipped) + ' ' + std::string(strategy(pane.active).name));
      }
      EXPECT_NEAR(right, size.x, 1e-9);
    }
  }
}

TEST(Panes, ThePointerBelongsToTheOneUnderIt) {
  std::vector<Pane> panes(2);
  panes[0].camera.size = {100.0, 50.0};
  panes[1].corner = {102.0, 0.0};
  panes[1].camera.size = {100.0, 50.0};
  EXPECT_EQ(&pane_at(panes, {50.0, 10.0}), &panes[0]);
  EXPECT_EQ(&pane_at(panes, {150.0, 10.0}), &panes[1]);
  EXPECT_EQ(&pane_at(panes, {900.0, -10.0}), &panes[1]) << "a drag may leave the scene";
}

TEST(Compose, PutsPredictionRingsWhereTheClosedFormsDo) {
  for (const Strategy& entry : strategy_catalog()) {
    const Picture active = picture_of("fig1", entry.id, Compare::overlay);
    const auto rings = find_forms<Marker>(active, Role::prediction, entry.id);
    ASSERT_EQ(rings.size(), 2U) << entry.name;
    const Equilibrium<2> rest = equilibrium_of(entry.id, active.scene.settings, active.snapshot.goal);
    EXPECT_EQ(rings[0]->center, rest.device);
    EXPECT_EQ(rings[1]->center, rest.proxy);
    // Two seconds after the motion the simulation is within a micrometre of rest.
    EXPECT_LT(glm::distance(rings[0]->center, active.snapshot.strategies[index_of(entry.id)].device), 1e-6);
  }
}

TEST(Glossary, ExplainsEveryMarkThatMeansSomething) {
  const Picture picture = picture_of("fig1", StrategyId::naive, Compare::overlay);
  for (const Mark& mark : picture.marks) {
    const bool is_decoration = mark.role == Role::grid || mark.role == Role::legend;
    EXPECT_TRUE(is_decoration || term_of(mark)) << role_name(mark.role);
    EXPECT_EQ(term_of(mark, false), term_of(mark));
    // Nobody can drag what is inferred.
    EXPECT_EQ(term_of(mark, true), term_of(mark) == Term::goal ? Term::estimated_goal : term_of(mark));
  }
  for (const GlossaryEntry& entry : glossary()) {
    EXPECT_FALSE(entry.title.empty());
    EXPECT_TRUE(entry.sentence.ends_with('.')) << entry.title;
  }
}

TEST(Compose, IsAFunctionOfItsInputs) {
  const Picture first = picture_of("fig1", StrategyId::naive, Compare::overlay);
  const Picture second = picture_of("fig1", StrategyId::naive, Compare::overlay);
  ASSERT_EQ(first.marks.size(), second.marks.size());
  const std::vector<Box> a = text_boxes(first);
  const std::vector<Box> b = text_boxes(second);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].least, b[i].least) << a[i].text;
}

}  // namespace
}  // namespace ghostforce::compose_test
