// The driven window with ticks that its frames make, so that what is done in it can be recorded, and replayed exactly.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/shell/session_file.h"
#include "app/shell/session_replay.h"
#include "tests/app/shell/driven_window.h"

namespace ghostforce {

class RecordedWindow : public DrivenWindow {
 protected:
  RecordedWindow() { steps_by_hand_ = false; }
  ~RecordedWindow() override {
    replay_.reset();
    application_.reset();
  }

  // Opens anew; what is done goes to a new file of that name.
  void open_recorded(const std::string& path, ApplicationOptions options = {}, const std::string& scene_name = "wall45",
                     int width = 1280, int height = 800) {
    const Scene scene = load_scene(scene_name);
    close_all();
    const SessionStart start{.program = "test",
                             .input = options.input,
                             .face = options.face,
                             .mode = options.mode,
                             .language = options.language,
                             .width = width,
                             .height = height,
                             .scene = scene_text(scene)};
    ApplicationOptions as_replayed =
        SessionReplay::options_for(start, options.inputs.empty() ? simulated_inputs() : options.inputs);
    as_replayed.is_replay = false;
    recorder_ = std::make_unique<SessionRecorder>(path, start);
    as_replayed.watch_actions = [this](double time_s, const Action& action) { recorder_->write(time_s, action); };
    open_window(width, height);
    application_ = std::make_unique<Application>(*window_, scene, as_replayed);
    recorder_->write_choices(session());
    application_->start();
    point_at(width - 400.0, height - 5.0);  // nothing there
  }
  void end_recorded() { recorder_->end(application_->clock_s()); }

  // In a window as it was.
  void open_replayed(RecordedSession recorded) {
    close_all();
    recorded_ = std::move(recorded);
    const SessionStart& start = recorded_.start;
    open_window(start.width, start.height);
    ApplicationOptions options = SessionReplay::options_for(start, simulated_inputs());
    application_ = std::make_unique<Application>(*window_, SessionReplay::scene_of(start, "session"), options);
    replay_.emplace(*application_, recorded_);
  }
  void replay_whole() {
    do {
      replay_->step();
    } while (!replay_->is_over());
  }

  // Within a frame, as what a key does.
  void act(const Action& action) {
    application_->update(frame_s);
    application_->act_at_once(action);
    application_->draw();
  }

  std::unique_ptr<SessionRecorder> recorder_;
  RecordedSession recorded_;
  std::optional<SessionReplay> replay_;

 private:
  void close_all() {
    replay_.reset();
    application_.reset();
    recorder_.reset();
    window_.reset();
  }
};

}  // namespace ghostforce
