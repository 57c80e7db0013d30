// Application: a session at the window, live. Carries values between the screen and the servo once per frame: commands
// and the goal one way, samples and the newest report the other; and grants what the person wished for: other scenes
// and inputs, undo, files. UI thread; whoever drives it decides whether the servo runs on its own thread or is stepped
// by hand.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/runs/recording.h"
#include "app/session/session.h"
#include "app/session/undo.h"
#include "app/ui/screen.h"
#include "app/ui/shader_watch.h"
#include "app/view/trail_history.h"
#include "core/loop_energy.h"
#include "device/falcon/falcon_input.h"
#include "device/input/circle_input.h"
#include "device/input/pointer_target.h"
#include "device/input_catalog.h"
#include "device/servo/servo.h"
#include "device/spacemouse/spacemouse_input.h"
#include "device/virtual_falcon/virtual_falcon_input.h"

namespace ghostforce {

struct ApplicationOptions {
  Part part = Part::window;
  Look look{};
  std::string input = "mouse";          // a name of the input catalog
  std::optional<std::string> record{};  // from the first tick, to a file of this name
  InputOptions input_options{};
  bool offers_hints = false;
  std::set<std::string, std::less<>> folded_panels{};
  std::string shader_folder{};  // empty: the embedded shaders, not watched
};

// Of the window in which the scene is.
std::string window_title(const Scene& scene);

class Application {
 public:
  // The window must outlive the application. Throws Failure.
  Application(Window& window, const Scene& scene, const ApplicationOptions& options);
  Application(const Application&) = delete;
  Application& operator=(const Application&) = delete;
  // All that has been ticked is in the recording, if one is being made.
  ~Application();

  // Starts the servo's thread; also after a change of the input.
  void start();

  Servo& servo() noexcept { return *servo_; }
  Session& session() noexcept { return session_; }
  const Screen& screen() const noexcept { return screen_; }
  const History& history() const noexcept { return history_; }
  const ServoReport& report() const noexcept { return report_; }

  // One frame. `interval_s`: real time since the frame before.
  void frame(double interval_s);

  // Instead of a frame, where nothing is to be drawn: the servo learns that the window is alive.
  void beat();

  // Tells the person something at the next frame.
  void tell(std::string words, bool is_problem);

  // Nothing would change on screen until the person does something.
  // (What a haptic device reports changes all the time.)
  bool is_idle() const noexcept { return session_.paused && !session_.notice && !shader_watch_ && falcon_ == nullptr; }

  // The servo or its input reports something else than what the last frame showed, or a recording ended. The servo's
  // counts of ticks that came late and of ticks per second are no news: they can wait.
  bool has_news();

  // Returns what to tell the person; empty where nothing was being recorded.
  std::string end_recording();
  // Why the last recording is not complete; empty: it is.
  const std::string& recording_problem() const noexcept { return recording_problem_; }

  // Whether the handle reaches what the scene is about; empty: it does, or there is none.
  std::string device_remark() const;

  // What the circle test has measured; null when another input is in use.
  const CircleReading* circle_reading() const noexcept {
    return circle_ != nullptr ? &circle_meter_.reading() : nullptr;
  }

  // What the Falcon's driver knows of its device; null when another input is in use.
  const FalconReport* falcon_report() const noexcept { return falcon_ != nullptr ? &falcon_report_ : nullptr; }

  // What is known of the SpaceMouse; null when another input is in use.
  const SpaceMouseReading* spacemouse_reading() const noexcept {
    return spacemouse_ != nullptr ? &spacemouse_reading_ : nullptr;
  }

 private:
  void take_samples();
  void send(double interval_s);
  void note_motors();
  void rehearse();
  void lead_round();
  void grant_wishes();
  // A scene, or a recording to be replayed.
  void open(const std::string& name_or_path);
  void replay_run(const std::string& path);
  void save_picture(const PictureWish& wish);
  std::string picture_bytes(const PictureWish& wish);
  void save_plots(const PlotWish& wish);
  void start_recording(const std::string& path);
  void read_recording();
  void take_back(bool undo);
  void go_to(const std::optional<Edited>& edited);
  void use(const InputKind& kind, std::shared_ptr<const Scene> scene, const Settings& settings);
  LoopReading loop_reading() const;
  TickState<2> start_state();

  Window& window_;
  Session session_;
  UndoHistory undo_;
  std::vector<InputChoice> inputs_;
  std::vector<InputChoice> misbehaviours_;
  std::string input_title_;
  History history_;
  ServoCommand command_;
  Settings sent_settings_;  // the session's, of which those in the command are the nearest that a file can hold
  std::unique_ptr<Servo> servo_;
  std::unique_ptr<Recording> recording_;
  RecordingReading recording_reading_;
  std::string recording_problem_;
  std::uint32_t recordings_ = 0;  // begun so far
  bool is_started_ = false;
  InputOptions input_options_;
  // What the input in use is besides; each may be null.
  PointerTarget* pointer_ = nullptr;  // led by the pointer
  SpaceMouseInput* spacemouse_ = nullptr;
  CircleInput* circle_ = nullptr;
  FalconInput* falcon_ = nullptr;
  VirtualFalconInput* virtual_falcon_ = nullptr;
  FalconReport falcon_report_;
  SpaceMouseReading spacemouse_reading_;
  Vector<2> sent_goal_{0.0};
  Circle sent_circle_;
  CircleMeter circle_meter_;
  ServoReport report_;
  Screen screen_;
  std::optional<ShaderWatch> shader_watch_;
  double clock_s_ = 0.0;  // sum of the frames' intervals
};

}  // namespace ghostforce
