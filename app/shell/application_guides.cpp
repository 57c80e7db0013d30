// Application: what guides the person through a lesson, or waits for a visitor, once a frame.
#include "app/shell/application.h"
#include "app/state/lesson_guide.h"
#include "app/state/kiosk_visit.h"

namespace ghostforce {

void Application::follow_lesson_in_session(double interval_s) {
  if (!session_.lesson) return;
  const LoopReading reading = this->reading();
  const Settings now = settings_now(session_);
  const StageMoment moment = stage_moment(now, report_.snapshot, report_.snapshot.goal);
  const StiffnessProbe& probe = session_.stiffness_probe;
  follow_lesson(session_,
                {.moment = moment,
                 .settings = now,
                 .circle = reading.circle ? &*reading.circle : nullptr,
                 .hand_k_u = probe.is_known() ? std::optional(probe.estimate.k_u) : std::nullopt},
                interval_s);
}

void Application::follow_kiosk_visit_in_session(double interval_s) {
  const MotorReport& motors = report_.motors;
  const bool moves_by_itself = session_.pointer_moves_goal || input_->is_scripted || session_.circle_test.is_on;
  const Window::Touch touch = window_.take_touch();
  SignsOfLife signs{.has_acted = touch.has_acted, .has_pointed = touch.has_moved};
  if (motors.has_motors) {
    // Homing moves it too.
    if (motors.is_handle_known && motors.is_ready) signs.handle = motors.handle;
  } else if (!moves_by_itself) {
    signs.handle = report_.snapshot.goal;
  }
  follow_kiosk_visit(session_, signs, interval_s);
}

}  // namespace ghostforce
