#include "app/state/circle_test.h"

namespace ghostforce {

void begin_circle_test(Session& session) {
  if (session.circle_test.is_on) {
    session.wanted_input.reset();  // which would end it, where one lesson follows another
    return;
  }
  session.circle_test.input_before = session.input;
  session.wanted_input = circling_hand.name;
}

void end_circle_test(Session& session) {
  session.wanted_input = session.circle_test.input_before;
}

Circle circle_of(const Session& session) noexcept {
  return circle_inside(wall_of(session.settings), session.goal, session.circle_test.choice);
}

}  // namespace ghostforce
