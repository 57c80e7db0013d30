// The workbench's scene over many moments by dice: no words over a mark, over each other or beyond the picture, and legend
// and scale bars over none of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "tests/app/picture/picture_extents.h"
#include "tests/app/picture/workbench_case.h"

namespace ghostforce::workbench_words_test {
namespace {

const MeasureText measure = measure_vector_text;
constexpr double rounding = 0.02;  // [points]

// What may pass below legend and scale bars, which have a ground of their own, and below the dial's caption.
const std::set<Role> soft{Role::wall, Role::hand_spring};
// What may pass below all words, as their halo keeps them readable.
const std::set<Role> ground{Role::grid, Role::hatching, Role::trail};

bool stands_beside_the_scene(Role role) {
  return role == Role::legend || role == Role::scale || role == Role::motor_axis;
}

bool lies_in(const ScreenBox& box, const ScreenBox& other) {
  return contains(other.grown(rounding), box.least) && contains(other.grown(rounding), box.most);
}

// The ground of legend or scale bars.
bool is_backdrop(const Pane& pane, const Extent& extent) {
  return std::holds_alternative<Box>(pane.marks[extent.mark].form);
}

std::vector<std::string> faults_of(const Pane& pane, double text_scale) {
  const PictureExtents extents(pane, measure, text_scale);
  std::vector<std::string> faults;
  if (!extents.is_finite) faults.emplace_back("a number is not finite");
  const std::vector<LabelExtent>& labels = extents.labels;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const LabelExtent& label = labels[i];
    if (label.alpha == 0.0) continue;
    if (!lies_in(label.box, {Vector<2>(0.0), pane.camera.size})) {
      faults.push_back(fmt::format("'{}' is cut off", label.words));
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (labels[j].alpha == 0.0 || overlap(label.box, labels[j].box) <= rounding) continue;
      faults.push_back(fmt::format("'{}' and '{}' overlap", labels[j].words, label.words));
    }
    for (const Extent& extent : extents.marks) {
      if (ground.contains(extent.role)) continue;
      if (stands_beside_the_scene(label.role) && soft.contains(extent.role)) continue;
      if (is_backdrop(pane, extent) && extent.role == label.role) continue;
      const double reach = reach_into(label.box, extent);
      if (reach <= rounding) continue;
      faults.push_back(
          fmt::format("'{}' lies {:.1f} on a mark: {}", label.words, std::min(reach, 1e3), role_name(extent.role)));
      break;
    }
  }
  for (const Extent& ground_of : extents.marks) {
    if (!is_backdrop(pane, ground_of)) continue;
    const ScreenBox box{ground_of.corners[0], ground_of.corners[2]};
    for (const Extent& extent : extents.marks) {
      const bool is_own = extent.role == ground_of.role;
      if (is_own || ground.contains(extent.role) || soft.contains(extent.role)) continue;
      if (reach_into(box, extent) <= rounding) continue;
      faults.push_back(fmt::format("{} covers {}", role_name(ground_of.role), role_name(extent.role)));
      break;
    }
  }
  for (const auto& leader : extents.leaders) {
    if (stands_beside_the_scene(labels[leader.label].role)) continue;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      ScreenPiece piece{leader.from, leader.to, 0.0};
      if (i == leader.label || labels[i].alpha == 0.0 || !clip(labels[i].box.grown(-rounding), piece)) continue;
      faults.push_back(fmt::format("the line to '{}' crosses '{}'", labels[leader.label].words, labels[i].words));
    }
  }
  return faults;
}

// Says what is wrong; true if anything is.
bool report(const std::vector<Pane>& panes, const WorkbenchCase& shown, const std::string& where, bool in_words) {
  bool is_faulty = false;
  for (const Pane& pane : panes) {
    for (const std::string& fault : faults_of(pane, shown.text_scale())) {
      is_faulty = true;
      if (in_words) ADD_FAILURE() << where << " " << shown.words() << ": " << fault;
    }
  }
  return is_faulty;
}

TEST(WorkbenchWords, CoverNoMarksAndNoOtherWordsAndAreNotCutOff) {
  PictureDice dice(20261201);
  int faulty = 0;
  for (int i = 0; i < 700; ++i) {
    const WorkbenchCase shown = workbench_case_by(dice);
    if (report(shown.compose(), shown, fmt::format("case {}", i), faulty < 20)) ++faulty;
  }
  EXPECT_EQ(faulty, 0);
}

// Also where words have just lost their place: in pictures that follow one another.
TEST(WorkbenchWords, CoverNothingFromMomentToMoment) {
  PictureDice dice(11);
  int faulty = 0;
  for (int round = 0; round < 40; ++round) {
    PictureMemory memory;
    WorkbenchCase shown = workbench_case_by(dice);
    const WorkbenchCase other = workbench_case_by(dice);
    const Camera camera = camera_on(shown.shown.center, shown.shown.width, shown.size);
    const auto anywhere = [&] {
      return to_world(camera, shown.size * Vector<2>(dice.between(0.0, 1.0), dice.between(0.0, 1.0)));
    };
    const Vector<2> from = shown.snapshot.goal;
    const Vector<2> to = anywhere();
    shown.pane_views = fitted_pane_views(shown.content());
    for (int i = 0; i < 40; ++i) {
      const auto measured = shown.snapshot.measured;
      shown.snapshot = snapshot_at_rest_of_all(shown.settings, from + (to - from) * (i / 40.0));
      shown.snapshot.measured = measured;
      if (i == 20) shown.size = other.size;
      if (i == 25) shown.scale = other.scale;
      if (i == 30) shown.options = other.options;
      if (i == 35) shown.settings.active = StrategyId::naive;
      const auto panes = shown.compose(memory, 1.0 / 60.0);
      if (report(panes, shown, fmt::format("round {}.{}", round, i), faulty < 20)) ++faulty;
    }
  }
  EXPECT_EQ(faulty, 0);
}

// What a stranger must find: the shipped picture has all words, legend and scale bars in every window.
TEST(WorkbenchWords, AreAllThereInTheUsualPicture) {
  PictureDice dice(5);
  WorkbenchCase shown;
  shown.settings.wall_normal_angle = 0.75 * std::numbers::pi;
  shown.settings.stiffnesses = {
      .k_u = 100.0, .believed_k_u = {}, .k_r = 1000.0, .k_t = 1000.0, .k_c = 1e5, .chosen_tracking_ratio = {}};
  shown.settings.active = StrategyId::naive;
  shown.snapshot = snapshot_at_rest_of_all(shown.settings, {0.04, -0.04});
  for (const Vector<2>& window : {Vector<2>(1024.0, 640.0), Vector<2>(1280.0, 800.0), Vector<2>(1920.0, 1080.0)}) {
    for (const bool has_plots : {false, true}) {
      shown.size = scene_size_in(window, 1.0, has_plots);
      for (const Compare compare : {Compare::overlay, Compare::side_by_side, Compare::active_only}) {
        shown.options.compare = compare;
        const std::vector<Pane> panes = shown.compose();
        const Pane& pane = compare == Compare::side_by_side ? panes[index_of(StrategyId::naive)] : panes[0];
        std::set<Role> found;
        for (const Pane& each : panes) {
          for (const Mark& mark : each.marks) {
            const bool is_there = &each == &pane || mark.role == Role::scale;
            if (is_there && std::holds_alternative<Label>(mark.form)) found.insert(mark.role);
          }
        }
        for (const Role role :
             {Role::force, Role::ghost_force, Role::proxy_drift, Role::device, Role::goal, Role::legend, Role::scale}) {
          EXPECT_TRUE(found.contains(role)) << shown.words() << ": " << role_name(role);
        }
      }
    }
  }
}

}  // namespace
}  // namespace ghostforce::workbench_words_test
