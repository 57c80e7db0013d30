#include "app/live/circle_input_link.h"

#include "app/ui/panels/panel_catalog.h"

namespace ghostforce {

void CircleInputLink::begin(Session& session) {
  session.folded_panels.erase(std::string(passivity_panel));
  session.circle_test.is_on = true;
  session.circle_test.has_news = true;
  settings_ = session.settings;
  restarts_ = session.restarts_asked;
  meter_.start(settings_, sent_circle_);
}

void CircleInputLink::send(Session& session, double /*interval_s*/) {
  // The circle lies in the wall as it is now. While the wall is being turned it waits.
  const Circle circle =
      circle_inside(wall_of(session.settings), session.scene->goal.points.back(), session.circle_test.choice);
  if (circle != sent_circle_ && !session.is_editing) {
    input_.go_round(circle);
    sent_circle_ = circle;
    ++session.restarts_asked;
  }
  // All strategies are measured, whichever is the active one.
  settings_.active = session.settings.active;
  if (session.settings == settings_ && session.restarts_asked == restarts_) return;
  settings_ = session.settings;
  restarts_ = session.restarts_asked;
  meter_.start(settings_, sent_circle_);
}

}  // namespace ghostforce
