#include "app/application.h"

#include "core/play.h"
#include "core/sound_state.h"

namespace ghostforce {

Application::Application(Window& window, const ScreenOptions& options, const Scene& scene, const InputKind& input)
    : session_(session_of(scene)), input_title_(input.title), screen_(window, options) {
  std::unique_ptr<Input> hand = input.make(scene);
  mouse_ = dynamic_cast<MouseInput*>(hand.get());
  session_.pointer_moves_goal = mouse_ != nullptr;
  starts_at_rest_ = mouse_ != nullptr;
  command_ = {.settings = session_.settings, .restart_state = start_state()};
  servo_ = std::make_unique<Servo>(std::move(hand), command_);
  report_.snapshot = snapshot_of(plan_of(session_.settings), command_.restart_state);
}

// Plays the scripted hand to the end, so that the first picture already shows what the scene is about. A reset uses the
// settings of the moment.
TickState<2> Application::start_state() {
  history_.clear();
  Scene scene = session_.scene;
  scene.settings = session_.settings;
  const TickState<2> state =
      play(scene, starts_at_rest_ ? last_tick(scene) : 0, [this](const Snapshot& snapshot) { history_.add(snapshot); });
  if (is_sound(state)) return state;
  // Unstable settings have no rest to start from: start where the hand is, and let the servo say what it finds.
  history_.clear();
  return state_at_start(scene.goal.points.back());
}

void Application::frame(double interval_s) {
  take_samples();
  report_ = servo_->newest();
  if (report_.restarts != command_.restarts_asked || report_.snapshot.tick == 0) {
    // The servo has not seen the restart yet: show the state that it will start from.
    report_.snapshot = snapshot_of(plan_of(session_.settings), command_.restart_state);
  }
  screen_.draw(session_, report_.snapshot, history_,
               {.input_title = input_title_,
                .rate_hz = report_.loop.rate_hz,
                .late_ticks = report_.loop.late_ticks,
                .dropped_samples = report_.loop.dropped_samples,
                .diverged = report_.diverged,
                .remark = describe(report_.realtime)});
  send(interval_s);
}

void Application::take_samples() {
  Sample sample;
  while (servo_->take_sample(sample)) {
    // Samples of a run that has been reset meanwhile belong to no picture any more.
    if (sample.restarts == command_.restarts_asked) history_.add(sample.snapshot);
  }
}

void Application::send(double interval_s) {
  if (session_.settings != command_.settings) ++command_.settings_generation;
  if (session_.restarts_asked != command_.restarts_asked) command_.restart_state = start_state();
  command_.settings = session_.settings;
  command_.paused = session_.paused;
  command_.speed = session_.speed;
  command_.steps_asked = session_.steps_asked;
  command_.restarts_asked = session_.restarts_asked;
  servo_->send(command_);
  if (mouse_ != nullptr && session_.drags_goal) mouse_->move_to(session_.goal, interval_s * session_.speed);
}

}  // namespace ghostforce
