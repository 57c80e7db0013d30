// What can be wrong with a picture of the stage: words over marks, over each other, or cut off.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/app/picture/picture_extents.h"
#include "tests/app/stage/stage_dice.h"

namespace ghostforce {

inline const MeasureText measure = measure_vector_text;
inline constexpr double rounding = 0.02;  // [points]

// What may pass below the two numbers, with their halo.
inline bool is_soft(const Extent& extent) {
  return extent.role == Role::motor_axis || extent.role == Role::wall ||
         (extent.role == Role::expected_contact && extent.corners.size() == 2);
}

// Large letters without a tail below their line: what is below the line is free for the words there.
inline ScreenBox ink_of(const LabelExtent& label) {
  ScreenBox box = label.box;
  if (label.role == Role::number && label.words.find_first_of("gy") == std::string::npos) {
    box.most.y = box.least.y + 0.8 * label.style.height;
  }
  return box;
}

inline bool lies_in(const ScreenBox& box, const ScreenBox& other) {
  return box.least.x >= other.least.x - rounding && box.least.y >= other.least.y - rounding &&
         box.most.x <= other.most.x + rounding && box.most.y <= other.most.y + rounding;
}

struct Drawn {
  StagePicture picture;
  PictureExtents extents;

  explicit Drawn(StagePicture made) : picture(std::move(made)), extents(picture.pane, measure) {}

  bool is_in_ribbon(const ScreenBox& box) const { return picture.ribbon && lies_in(box, picture.ribbon->box); }
  bool is_in_ribbon(const Extent& extent) const {
    return picture.ribbon && std::ranges::all_of(extent.corners, [&](const Vector<2>& corner) {
             return contains(picture.ribbon->box.grown(2.0), corner);
           });
  }
  // That hides what is below it.
  bool has_panel(const ScreenBox& box) const {
    return std::ranges::any_of(picture.pane.marks, [&](const Mark& mark) {
      const auto* const panel = std::get_if<Box>(&mark.form);
      if (panel == nullptr || (mark.role != Role::hint && mark.role != Role::number)) return false;
      const Vector<2> corner = to_screen(picture.pane.camera, panel->corner) + panel->offset;
      return lies_in(box, {corner, corner + panel->size});
    });
  }
  const LabelExtent* label(Role role, std::string_view words = "") const {
    for (const LabelExtent& each : extents.labels) {
      if (each.role == role && each.words.starts_with(words) && each.alpha > 0.0) return &each;
    }
    return nullptr;
  }
  ScreenBox numbers() const {
    ScreenBox box{Vector<2>(1e9), Vector<2>(-1e9)};
    for (const LabelExtent& each : extents.labels) {
      if (each.role != Role::number) continue;
      box.include(each.box.least);
      box.include(each.box.most);
    }
    return box;
  }
  bool covers_soft_marks(const ScreenBox& box, double margin = 0.0) const {
    return std::ranges::any_of(extents.marks, [&](const Extent& extent) {
      return is_soft(extent) && !is_in_ribbon(extent) && reach_into(box, extent) > margin;
    });
  }
};

// What is wrong with it; nothing should be.
inline std::vector<std::string> faults_of(const StageCase& shown, const Drawn& drawn) {
  std::vector<std::string> faults;
  const ScreenBox window{Vector<2>(-rounding), shown.size + Vector<2>(rounding)};
  const std::vector<LabelExtent>& labels = drawn.extents.labels;
  if (!drawn.extents.is_finite) faults.push_back("a number is not finite");
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const LabelExtent& label = labels[i];
    if (label.alpha == 0.0) continue;
    if (!lies_in(label.box, window)) faults.push_back(fmt::format("'{}' is cut off", label.words));
    for (std::size_t j = 0; j < i; ++j) {
      if (labels[j].alpha == 0.0 || overlap(ink_of(label), ink_of(labels[j])) <= rounding) continue;
      faults.push_back(fmt::format("'{}' and '{}' overlap", labels[j].words, label.words));
    }
    if (label.role == Role::button) {
      const bool has_button = std::ranges::any_of(
          drawn.picture.buttons, [&](const StageButton& button) { return lies_in(label.box, button.box); });
      if (!has_button) faults.push_back(fmt::format("'{}' sticks out of its button", label.words));
      continue;
    }
    if (label.role == Role::sentence || drawn.is_in_ribbon(label.box) || drawn.has_panel(label.box)) continue;
    for (const Extent& extent : drawn.extents.marks) {
      // A step of Why? that were left out would break its story.
      const bool may_cover = label.role == Role::number || label.role == Role::hint || shown.mode == StageMode::why;
      if (may_cover && is_soft(extent)) continue;
      const double reach = reach_into(ink_of(label), extent);
      if (reach > rounding) {
        faults.push_back(
            fmt::format("'{}' lies {:.1f} on a mark: {}", label.words, std::min(reach, 1e3), role_name(extent.role)));
        break;
      }
    }
  }
  for (const auto& leader : drawn.extents.leaders) {
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (i == leader.label || labels[i].alpha == 0.0) continue;
      ScreenPiece piece{leader.from, leader.to, 0.0};
      if (!clip(labels[i].box.grown(-rounding), piece)) continue;
      faults.push_back(fmt::format("the line to '{}' crosses '{}'", labels[leader.label].words, labels[i].words));
    }
    const std::set<Role> hard{Role::device, Role::proxy,      Role::goal,        Role::hand,  Role::guess,
                              Role::force,  Role::wall_share, Role::ghost_force, Role::button};
    for (const Extent& extent : drawn.extents.marks) {
      const bool is_own = extent.role == labels[leader.label].role;
      if (is_own || !hard.contains(extent.role) || reach_into(leader.from, leader.to, extent) <= rounding) continue;
      faults.push_back(fmt::format("the line to '{}' crosses a mark by {:.2f}: {}", labels[leader.label].words,
                                   reach_into(leader.from, leader.to, extent), role_name(extent.role)));
      break;
    }
  }
  return faults;
}

// What of the scene lies under the numbers, a button or the sentence, or outside. Empty: nothing.
inline std::string covered_by_frame(const Drawn& drawn) {
  const std::set<Role> scene{Role::device,      Role::proxy,         Role::goal,          Role::hand,
                             Role::hand_spring, Role::tracking_link, Role::wall_share,    Role::ghost_force,
                             Role::proxy_drift, Role::motor_axis,    Role::expected_rest, Role::expected_contact,
                             Role::handle};
  std::vector<ScreenBox> over{*drawn.picture.numbers};
  for (const StageButton& button : drawn.picture.buttons) over.push_back(button.box);
  for (const LabelExtent& label : drawn.extents.labels) {
    if (label.role == Role::sentence) over.push_back(label.box);
  }
  const ScreenBox window{Vector<2>(0.0), drawn.picture.pane.camera.size};
  for (const Extent& mark : drawn.extents.marks) {
    if (!scene.contains(mark.role)) continue;
    const bool is_inside = std::ranges::all_of(mark.corners, [&](const Vector<2>& at) { return contains(window, at); });
    if (!is_inside) return fmt::format("{} is outside", role_name(mark.role));
    for (const ScreenBox& box : over) {
      if (reach_into(box, mark) > rounding) {
        return fmt::format("{} is covered at ({:.0f}, {:.0f})", role_name(mark.role), box.least.x, box.least.y);
      }
    }
  }
  return {};
}

inline std::string words_for(const StageCase& shown) {
  return fmt::format("{}x{} scale {} {} mode {} strategy {}", shown.size.x, shown.size.y, shown.scale, shown.theme,
                     stage_mode_name(shown.mode), strategy(shown.settings.active).name);
}

// What is asked of the stage in each of its languages.
class StageInEachLanguage : public testing::TestWithParam<const StageLanguage*> {
 protected:
  // At rest under one goal.
  StageCase case_at(const Settings& settings, const Vector<2>& goal) const {
    StageCase made = stage_case_at(settings, goal);
    made.language = GetParam();
    return made;
  }
};

}  // namespace ghostforce
