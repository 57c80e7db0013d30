#include "app/state/set_up_of.h"

#include <cmath>

#include "app/files/scene_file.h"

namespace ghostforce {
namespace {

// A circle goes round the goal that was there before it.
bool hand_is_at_session_goal(const Session& session, const ShownMoment& shown) {
  const bool goes_round = session.circle_test.is_on || session.stage.mode == StageMode::round;
  return !shown.is_past && (session.pointer_moves_goal || goes_round);
}

Vector<2> goal_of(const Session& session, const ShownMoment& shown) {
  const Vector<2>& seen = shown.snapshot.goal;
  const bool is_known = std::isfinite(seen.x) && std::isfinite(seen.y);
  return nearest_in_scene(hand_is_at_session_goal(session, shown) || !is_known ? session.goal : seen);
}

// How stiff the hand was at that moment is told by its path.
void leave_hand_to_path(const Settings& chosen, Settings& settings) {
  std::optional<double>& believed = settings.stiffnesses.believed_k_u;
  settings.stiffnesses.k_u = chosen.stiffnesses.k_u;
  if (!chosen.stiffnesses.believed_k_u && believed == chosen.stiffnesses.k_u) believed.reset();
}

}  // namespace

SetUp set_up_of(const Session& session, const ShownMoment& shown) {
  SetUp set_up{*session.scene, {}, session.face, StageMode::none};
  set_up.scene.settings = shown.settings;
  if (!set_up.scene.stiffness_path.is_empty()) leave_hand_to_path(session.settings, set_up.scene.settings);
  set_up.scene.view = session.shown;
  set_up.scene.goal.points.back() = goal_of(session, shown);
  set_up.scene = rounded_to_file(std::move(set_up.scene));
  set_up.goal = set_up.scene.goal.points.back();
  if (session.face == Face::stage) set_up.mode = session.stage.mode;
  return set_up;
}

}  // namespace ghostforce
