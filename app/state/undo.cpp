#include "app/state/undo.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace ghostforce {
namespace {

using Changes = StageLanguage::Changes;

struct Part {
  std::string_view words;
  std::string_view Changes::*on_stage;
  bool (*is_same)(const UndoState&, const UndoState&);
};

template <auto Settings::*member>
bool is_same(const UndoState& a, const UndoState& b) {
  return a.settings.*member == b.settings.*member;
}

template <auto Stiffnesses::*member>
bool is_same_stiffness(const UndoState& a, const UndoState& b) {
  return a.settings.stiffnesses.*member == b.settings.stiffnesses.*member;
}

bool is_same_belief_source(const UndoState& a, const UndoState& b) {
  return a.belief_source == b.belief_source;
}

// What follows the hand changes by itself, and is another value wherever it comes from elsewhere.
bool is_same_belief(const UndoState& a, const UndoState& b) {
  const bool follows = a.belief_source == BeliefSource::live || b.belief_source == BeliefSource::live;
  return follows || is_same_stiffness<&Stiffnesses::believed_k_u>(a, b);
}

bool is_same_goal(const UndoState& a, const UndoState& b) {
  return a.has_same_goal_as(b);
}

constexpr std::array parts{
    Part{"the strategy", &Changes::strategy, is_same<&Settings::active>},
    Part{"the goal", &Changes::hand, is_same_goal},
    Part{"k_r", &Changes::wall_stiffness, is_same_stiffness<&Stiffnesses::k_r>},
    Part{"k_t", &Changes::wall_stiffness, is_same_stiffness<&Stiffnesses::k_t>},
    Part{"k_c", &Changes::wall_stiffness, is_same_stiffness<&Stiffnesses::k_c>},
    Part{"the ratio ρ", &Changes::ratio, is_same_stiffness<&Stiffnesses::chosen_tracking_ratio>},
    Part{"k_u", &Changes::hand_stiffness, is_same_stiffness<&Stiffnesses::k_u>},
    Part{"the believed k_u", &Changes::belief, is_same_belief},
    Part{"where the belief comes from", &Changes::belief_source, is_same_belief_source},
    Part{"the wall's angle", &Changes::wall_angle, is_same<&Settings::wall_normal_angle>},
    Part{"the wall's position", &Changes::wall_place, is_same<&Settings::wall_point>},
    Part{"the actuated direction", &Changes::motor, is_same<&Settings::actuated_angle>},
    Part{"the walls or the device", &Changes::device, is_same<&Settings::general>},
    Part{"the mass", &Changes::mass, is_same<&Settings::mass>},
    Part{"the damping", &Changes::damping, is_same<&Settings::damping>},
    Part{"the tick rate", &Changes::rate, is_same<&Settings::rate>},
};

// Each once: the stage has one word for what the workbench has three of.
std::vector<std::string_view> changed_parts(const UndoState& before, const UndoState& after, const Changes* on_stage) {
  std::vector<std::string_view> changed;
  for (const Part& part : parts) {
    const std::string_view words = on_stage == nullptr ? part.words : on_stage->*part.on_stage;
    if (!part.is_same(before, after) && std::ranges::find(changed, words) == changed.end()) changed.push_back(words);
  }
  return changed;
}

std::string change_in_words(const UndoState& before, const UndoState& after, const Changes& all,
                            const Changes* on_stage) {
  if (before.scene != after.scene) return filled(all.opening, after.scene->title);
  const std::vector<std::string_view> changed = changed_parts(before, after, on_stage);
  if (changed.size() == 1) return std::string(changed.front());
  if (changed.size() == 2) return filled(all.two, changed[0], changed[1]);
  return std::string(all.several);
}

}  // namespace

std::string words_of_change(const UndoState& before, const UndoState& after) {
  return change_in_words(before, after, english_stage.changes, nullptr);
}

std::string words_of_change(const UndoState& before, const UndoState& after, const StageLanguage& language) {
  return change_in_words(before, after, language.changes, &language.changes);
}

}  // namespace ghostforce
