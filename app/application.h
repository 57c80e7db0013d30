// Application: a session at the window, live. Carries values between the screen and the servo once per frame: commands
// and the goal one way, samples and the newest report the other. UI thread; whoever drives it decides whether the servo
// runs on its own thread or is stepped by hand.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "app/screen.h"
#include "app/session.h"
#include "app/view/history.h"
#include "device/input_catalog.h"
#include "device/mouse_input.h"
#include "device/servo.h"

namespace ghostforce {

class Application {
 public:
  // The window must outlive the application.
  Application(Window& window, const ScreenOptions& options, const Scene& scene, const InputKind& input);

  Servo& servo() noexcept { return *servo_; }
  Session& session() noexcept { return session_; }
  const Screen& screen() const noexcept { return screen_; }
  const History& history() const noexcept { return history_; }
  const ServoReport& report() const noexcept { return report_; }

  // One frame. `interval_s`: real time since the frame before.
  void frame(double interval_s);

  // Nothing would change on screen until the person does something.
  bool is_idle() const noexcept { return session_.paused; }

 private:
  void take_samples();
  void send(double interval_s);
  TickState<2> start_state();

  Session session_;

  bool starts_at_rest_;  // pre-rolled to the end of the path; else the scripted hand plays from the path's beginning
  std::string input_title_;
  History history_;
  ServoCommand command_;
  std::unique_ptr<Servo> servo_;
  MouseInput* mouse_;  // null when another input holds the goal
  ServoReport report_;
  Screen screen_;
};

}  // namespace ghostforce
