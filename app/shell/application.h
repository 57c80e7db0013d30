// Application: a session at the window, live. Carries values between the screen and the servo once per frame: commands
// and the goal one way, samples and the newest report the other; and does what the person asked for: other scenes
// and inputs, undo, files. UI thread; whoever makes it decides who drives the servo, or steps it by hand.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/files/clipboard_tool.h"
#include "app/paint/file_painter.h"
#include "app/picture/trail_history.h"
#include "app/runs/recording.h"
#include "app/shell/clip_saving.h"
#include "app/shell/frame_pacer.h"
#include "app/shell/hand_following.h"
#include "app/shell/input_link.h"
#include "app/shell/looking_back.h"
#include "app/shell/receipt.h"
#include "app/shell/screen.h"
#include "app/shell/shader_watch.h"
#include "app/shell/visible_state.h"
#include "app/state/apply.h"
#include "app/state/set_up.h"
#include "app/state/undo.h"
#include "device/report/input_choice.h"
#include "device/servo/servo.h"
#include "device/servo/servo_driver.h"

namespace ghostforce {

struct ApplicationOptions {
  Part part = Part::window;
  Appearance appearance{};
  Face face = Face::workbench;
  StageMode mode = StageMode::none;                          // of the stage
  std::shared_ptr<const Lesson> lesson{};                    // that begins at once; null: none
  std::size_t lesson_step = 0;                               // of it, to begin with
  std::string language{"en"};                                // of the stage and of lessons
  std::vector<std::shared_ptr<const Lesson>> kiosk_visit{};  // of the visitor's mode; empty: an ordinary run
  LessonProgress lesson_progress{};
  std::vector<InputEntry> inputs{};     // all that there are
  std::string input{mouse_hand.name};   // the name of one of them
  std::string_view why_no_falcon{};     // is among them, in words that outlive the application; empty: there is one
  FilePainter painter{};                // for what is saved as lines and letters
  std::optional<std::string> record{};  // from the first tick, to a file of this name
  std::optional<ReceiptOrigin> receipt_origin{};  // empty: recordings get no receipts
  InputOptions input_options{};
  std::function<std::unique_ptr<ServoDriver>()> make_servo_driver{};  // empty: nobody drives the servo
  std::function<void()> show_controls{};                              // beside the picture; empty: there are none
  std::function<void(const std::string& line)> show_link{};           // to a set-up; empty: there is no page to link to
  bool offers_hints = false;
  std::set<std::string, std::less<>> folded_panels{};
  std::string shader_folder{};  // empty: the embedded shaders, not watched
  // Hears what the person does, before it is done, and when; may be empty. `time_s`: as clock_s().
  std::function<void(double time_s, const Action& action)> watch_actions{};
  bool is_replay = false;  // who sits at the window only watches, and may close it, until the replay is over
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

  // Has the servo driven; also after a change of the input.
  void start();
  // Nobody drives it any longer.
  void stop() noexcept;
  // After stop(), where no destructor will run: the input ends, and a device that is owed a stop gets it if it is
  // plugged in. Nothing else may be called any more.
  void let_go_of_input() noexcept;

  // Since it began: the sum of the intervals [s].
  double clock_s() const noexcept { return clock_s_; }
  bool has_input(std::string_view name) const noexcept { return find_input(inputs_, name) != nullptr; }
  Servo& servo() noexcept { return *servo_; }
  Session& session() noexcept { return session_; }
  const Screen& screen() const noexcept { return screen_; }
  const History& history() const noexcept { return history_; }
  const ServoReport& report() const noexcept { return report_; }

  // Takes what servo and input have made since the last time, or has it made now where there is no thread for it, and
  // tells the servo that the window is alive. Often, whether a frame is drawn or not. `interval_s`: real time since the
  // last call.
  void update(double interval_s);

  // The computer is about to sleep, or has slept: until it has, motors go off and stay off. Returns whether it has to
  // wait for them. Before update().
  bool delays_sleep(bool is_coming);

  // Something that can be seen is other than in the last frame, or moves by itself. What the person does to the window
  // is not known here.
  bool needs_drawing() const;

  // Does it with the session; what is then left to do, the next draw() does.
  void act(const Action& action);
  // As a key does: nothing is left to do.
  void act_at_once(const Action& action);

  // Shows what the last update() has found, and does what the person asked for.
  void draw();

  // update() and draw().
  void frame(double interval_s);

  // What the line of a set-up describes (set_up.h), as if it had been pasted. Throws ReadError.
  void show_set_up(const std::string& line);

  // After the window has lost its OpenGL context and has another one.
  void restart_drawing();

  // Tells the person something at the next frame; in the visitor's mode, who stands at the terminal.
  void show_notice(std::string words, bool is_problem, std::string language = "en");
  // How many there have been; the same words once more count again.
  std::uint64_t notice_count() const noexcept { return notice_count_ + (has_new_notice() ? 1 : 0); }

  // The person sees a replay, which is as far as that. When it is over, they have the window to themselves.
  void show_replay_place(const ReplayPlace& place) noexcept {
    replay_place_ = place;
    is_replay_ = !place.is_over;
  }

  // Time stands still: there will be something to draw when the person does something, and else hardly ever.
  bool is_idle() const { return session_.paused && link_->is_idle() && !needs_drawing(); }

  // Returns what to tell the person; empty where nothing was being recorded.
  std::string end_recording();
  // Why the last recording is not complete; empty: it is.
  const std::string& recording_problem() const noexcept { return recording_problem_; }

  // What the screen shows: the present, or a moment that somebody looks back at.
  ShownMoment shown() const { return shown_moment(session_, report_.snapshot, history_.moments()); }

  // What the screen shows of servo and input.
  LoopReading reading() const;

  // What the stage says of that, or would say if it were there instead of the workbench.
  StageReading stage_reading() const;

  const InputLink& input_link() const noexcept { return *link_; }

 private:
  void take_samples();
  // What the newest tick says against the target that is drawn, if one is.
  void see_target();
  void follow_lesson_in_session(double interval_s);
  void follow_kiosk_visit_in_session(double interval_s);
  VisibleState visible() const;
  // Since the last frame.
  bool has_changed() const;
  void send();
  void heartbeat();
  void follow_own_wish(double interval_s);
  void copy_motor_requests();
  // What a person at the window does.
  void hear(const Action& action);
  void apply_now(const Action& action);
  // What one key press, or one frame, has left in the session.
  void do_what_is_asked();
  struct EffectDoer;
  // All that was asked for, each by itself: what fails keeps nothing else from being done.
  void do_effects();
  void attempt(const std::function<void()>& work);
  // As the picker of scenes asks for it: the dialog stays until there is something to show.
  void open_for_dialog(const std::string& name_or_path);
  void open_lesson(const std::string& name_or_path);
  struct FileKind;
  // A scene by name, or a file of any of these kinds.
  void open(const std::string& name_or_path);
  void open_dropped(const std::vector<std::string>& paths);
  void open_scene(const std::string& name_or_path);
  void show_picture(const std::string& path);
  void replay_run(const std::string& path);
  std::string picture_bytes(const SavePicture& request);
  void save(const std::string& path, const std::function<std::string()>& make_bytes);
  void copy_picture(const CopyPicture& request);
  void save_clip(const SaveClip& request);
  void start_recording(const std::string& path);
  void read_recording();
  void keep_receipt_of(const std::string& recording) const;
  void take_back(bool undo);
  void offer_undo();
  const InputEntry& input_of(std::string_view name) const;
  void refuse_to_leave_for(const InputEntry& entry) const;
  // Another scene puts the hand at `goal`, or at the end of its path.
  void use(const InputEntry& entry, std::shared_ptr<const Scene> scene, const Settings& settings,
           const std::optional<Vector<2>>& goal = {});
  void use_at_request(const InputEntry& entry);
  UndoState undo_state() const;
  // Another scene as it stood, or shall stand, on the screen. The input stays.
  void show(const UndoState& wanted);
  void show(const SetUp& set_up);
  void copy_set_up();
  void paste_set_up(const PasteSetUp& wanted);
  void add_to_notice(const std::string& words);
  void dismiss_notice();
  void toggle_audience();
  void take_answer_of_chooser(std::vector<std::string>& dropped);
  const StageLanguage::Notices& notice_words() const { return stage_language(session_.language).notices; }
  bool has_new_notice() const noexcept { return session_.notice && session_.notice->age_s == 0.0; }
  TickState<2> start_state();

  Window& window_;
  Session session_;
  UndoHistory undo_;
  Effects effects_;                 // that are still to be done
  std::uint64_t notice_count_ = 0;  // before the last update
  bool has_failed_ = false;         // of what is being done at the moment, something
  std::vector<InputEntry> inputs_;
  std::vector<InputChoice> input_choices_;
  const InputEntry* input_ = nullptr;  // in use
  std::string_view why_no_falcon_;
  InputOptions input_options_;
  FilePainter painter_;
  std::function<void()> show_controls_;
  std::function<void(const std::string& line)> show_link_;
  std::function<void(double time_s, const Action& action)> watch_actions_;
  bool is_replay_;
  std::optional<ReplayPlace> replay_place_;
  History history_;
  LateTicks late_ticks_{LoopReading::lately_s};
  ClipboardTool clipboard_tool_;
  ClipSaving clip_saving_;
  LookingBack looking_back_;
  HandFollowing hand_following_;
  ServoCommand command_;
  Settings sent_settings_;  // chosen ones, of which those in the command are the nearest that a file can hold
  std::unique_ptr<Servo> servo_;
  std::unique_ptr<ServoDriver> servo_driver_;  // of the servo; null: nobody drives it
  std::unique_ptr<InputLink> link_;            // to the servo's input
  std::unique_ptr<Recording> recording_;
  RecordingReading recording_reading_;
  std::string recording_problem_;
  std::optional<ReceiptOrigin> receipt_origin_;
  SessionLog log_;                // of the input in use
  std::uint32_t recordings_ = 0;  // begun so far
  bool is_started_ = false;
  ServoReport report_;
  Screen screen_;
  std::optional<ShaderWatch> shader_watch_;
  double clock_s_ = 0.0;          // sum of the intervals
  double interval_s_ = 0.0;       // the newest
  double since_drawn_s_ = 0.0;    // all that has passed since a frame was drawn
  double off_by_person_s_ = 0.0;  // for so long the motors have been off because the person wanted it
  std::optional<VisibleState> drawn_;
  double drawn_at_s_ = 0.0;   // by that clock
  int frames_to_settle_ = 0;  // that follow a change
};

}  // namespace ghostforce
