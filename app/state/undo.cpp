#include "app/state/undo.h"

#include <array>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace ghostforce {
namespace {

struct Part {
  std::string_view words;
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
    Part{"the strategy", is_same<&Settings::active>},
    Part{"the goal", is_same_goal},
    Part{"k_r", is_same_stiffness<&Stiffnesses::k_r>},
    Part{"k_t", is_same_stiffness<&Stiffnesses::k_t>},
    Part{"k_c", is_same_stiffness<&Stiffnesses::k_c>},
    Part{"the ratio ρ", is_same_stiffness<&Stiffnesses::chosen_tracking_ratio>},
    Part{"k_u", is_same_stiffness<&Stiffnesses::k_u>},
    Part{"the believed k_u", is_same_belief},
    Part{"where the belief comes from", is_same_belief_source},
    Part{"the wall's angle", is_same<&Settings::wall_normal_angle>},
    Part{"the wall's position", is_same<&Settings::wall_point>},
    Part{"the actuated direction", is_same<&Settings::actuated_angle>},
    Part{"the mass", is_same<&Settings::mass>},
    Part{"the damping", is_same<&Settings::damping>},
    Part{"the tick rate", is_same<&Settings::rate>},
};

}  // namespace

std::string words_of_change(const UndoState& before, const UndoState& after) {
  if (before.scene != after.scene) return fmt::format("opening “{}”", after.scene->title);
  std::vector<std::string_view> changed;
  for (const Part& part : parts) {
    if (!part.is_same(before, after)) changed.push_back(part.words);
  }
  if (changed.size() == 1) return std::string(changed.front());
  if (changed.size() == 2) return fmt::format("{} and {}", changed[0], changed[1]);
  return "several settings";
}

}  // namespace ghostforce
