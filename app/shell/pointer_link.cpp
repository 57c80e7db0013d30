#include "app/shell/pointer_link.h"

#include <utility>

namespace ghostforce {

void PointerLink::begin(Session& session) {
  session.pointer_moves_goal = true;
  sent_goal_ = session.goal;
  restarts_ = session.restarts_asked;
}

void PointerLink::send(Session& session, double interval_s) {
  target_.set_user_stiffness(session.settings.stiffnesses.k_u);
  // A restart takes the goal along.
  if (std::exchange(restarts_, session.restarts_asked) != session.restarts_asked) sent_goal_ = session.goal;
  if (!session.drags_goal && session.goal == sent_goal_) return;
  target_.move_to(session.goal, interval_s * session.speed);
  sent_goal_ = session.goal;
}

}  // namespace ghostforce
