#include "app/shell/application.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/base/words.h"
#include "app/files/file_exchange.h"
#include "app/files/scene_file.h"
#include "app/state/kiosk_visit.h"
#include "app/state/lesson_guide.h"
#include "app/state/stiffness_probe_guide.h"
#include "app/state/target.h"
#include "app/state/user_measurement_guide.h"
#include "core/divergence.h"
#include "core/simulate.h"

namespace ghostforce {
namespace {

constexpr double news_last_s = 6.0;  // problems stay until they are dismissed
constexpr double dial_words_last_s = 4.0;
constexpr double own_wish_stands_s = 1.0;

// Model time in the status bar, ticks a second and ticks that came late change all the time: they can wait.
constexpr double counts_last_s = 2.0;
constexpr double paused_counts_last_s = 5.0;
// What appears on the screen is measured in one frame and put in its place in the next.
constexpr int settling_frames = 3;

Session session_with(const Scene& scene, const ApplicationOptions& options) {
  Session session = session_of(scene);
  session.appearance = options.appearance;
  session.input = options.input;
  session.has_handles = true;
  session.folded_panels = options.folded_panels;
  if (options.offers_hints) session.hint = 0;
  session.face = options.face;
  if (options.mode != StageMode::none) apply(session, ToggleMode{options.mode});
  session.language = options.language;
  session.lesson_progress = options.lesson_progress;
  if (!options.kiosk_visit.empty()) {
    begin_kiosk_visit(session, options.kiosk_visit);
  } else if (options.lesson) {
    begin_lesson(session, options.lesson);
    if (options.lesson_step > 0) show_lesson_step(session, options.lesson_step);
  }
  if (session.lesson) {
    session.stage_shown = stage_view_of(session);
    session.fits_view = false;  // it stands there at once
  }
  return session;
}

// What runs is what a file can hold, so that a recording tells it exactly.
Settings as_in_file(const Settings& settings) {
  Scene scene;
  scene.settings = settings;
  return rounded_to_file(std::move(scene)).settings;
}

}  // namespace

std::string window_title(const Scene& scene) {
  return fmt::format("{} · ghostforce", scene.title);
}

Application::Application(Window& window, const Scene& scene, const ApplicationOptions& options)
    : window_(window),
      session_(session_with(scene, options)),
      undo_(undo_state()),
      inputs_(options.inputs),
      input_choices_(choices_of(inputs_, options.input_options.recorded_hand != nullptr)),
      why_no_falcon_(options.why_no_falcon),
      input_options_(options.input_options),
      painter_(options.painter),
      show_controls_(options.show_controls),
      show_link_(options.show_link),
      watch_actions_(options.watch_actions),
      is_replay_(options.is_replay),
      servo_driver_(options.make_servo_driver ? options.make_servo_driver() : nullptr),
      receipt_origin_(options.receipt_origin),
      screen_(window, options.part) {
  if (session_.kiosk_visit) window_.stay_open();
  if (!options.shader_folder.empty()) shader_watch_.emplace(options.shader_folder);
  use(input_of(options.input), session_.scene, session_.settings);
  if (options.record) start_recording(*options.record);
}

Application::~Application() {
  stop();
}

void Application::start() {
  is_started_ = true;
  if (servo_driver_) servo_driver_->start(*servo_);
}

void Application::stop() noexcept {
  is_started_ = false;
  if (servo_driver_) servo_driver_->stop();
}

void Application::let_go_of_input() noexcept {
  link_.reset();
  servo_.reset();
}

const InputEntry& Application::input_of(std::string_view name) const {
  if (const InputEntry* const entry = find_input(inputs_, name)) return *entry;
  throw Failure(ExitCode::wrong_call, fmt::format("there is no input '{}' here; choose another", quoted_text(name)));
}

void Application::refuse_to_leave_for(const InputEntry& entry) const {
  if (!link_ || session_.input == entry.name) return;
  if (const std::string why = link_->why_not_leave(); !why.empty()) throw Failure(ExitCode::device_failed, why);
}

namespace {

// Forces of such a scene go to no motors.
void refuse_motors_in_general_scene(Input& input, const InputEntry& entry, const Scene& scene) {
  if (!is_general(scene.settings) || input.haptic_device() == nullptr) return;
  throw Failure(ExitCode::wrong_call,
                fmt::format("{}: {} has motors, and no motor follows a scene of format 2 yet; choose the mouse",
                            quoted_text(scene.title), entry.title));
}

}  // namespace

// A servo owns its input, so another input or another script is another servo; counts go on, so that what is asked for
// later still looks new to it. An input that cannot be had leaves everything as it was.
void Application::use(const InputEntry& entry, std::shared_ptr<const Scene> scene, const Settings& settings,
                      const std::optional<Vector<2>>& goal) {
  refuse_to_leave_for(entry);
  // A device has one driver: the one before lets go of it first.
  if (servo_driver_) servo_driver_->stop();
  LinkedInput made;
  try {
    refuse_to_leave_for(entry);  // it may not have answered just now
    made = make_in_hand_of(*scene, entry, input_options_);
    refuse_motors_in_general_scene(*made.input, entry, *scene);
  } catch (...) {
    if (is_started_) start();
    throw;
  }
  // Its header would not be true any longer.
  if (const std::string words = end_recording(); !words.empty()) {
    show_notice(fmt::format("The recording ended because the scene or the input changed. {}", words),
                !recording_problem_.empty());
  }
  const bool is_other_scene = scene != session_.scene;
  // Another hand may be at another input, or in another scene.
  if (is_other_scene || session_.input != entry.name) session_.stiffness_probe = {};
  input_ = &entry;
  session_.input = entry.name;
  session_.pointer_moves_goal = false;
  session_.hand_is_simulated = entry.hand_is_simulated;
  session_.circle_test.is_on = session_.circle_test.has_news = false;
  session_.injected_fault.clear();
  session_.scene = std::move(scene);
  session_.settings = settings;
  if (is_other_scene) {
    abandon_lesson(session_);
    session_.belief_source = BeliefSource::typed;  // a scene says what is believed
    session_.measured_k_u.reset();
    session_.goal = goal.value_or(session_.scene->goal.points.back());
    session_.shown = session_.scene->view;
    session_.stage_shown = stage_view_of(session_);
    session_.pane_views.reset();
    window_.set_title(window_title(*session_.scene));
  }
  sent_settings_ = chosen_settings(session_.settings, session_.belief_source);
  command_.settings = as_in_file(session_.settings);
  command_.restarts_asked = session_.restarts_asked;
  command_.steps_asked = session_.steps_asked;
  copy_motor_requests();
  command_hand(session_, command_);
  command_.restart_state = start_state();
  link_.reset();
  servo_ = std::make_unique<Servo>(std::move(made.input), command_);
  link_ = std::move(made.link);
  link_->begin(session_);
  report_ = {};
  log_ = {};
  report_.restarts = command_.restarts_asked;
  report_.snapshot = snapshot_of(loop_coefficients_of(session_.settings), command_.restart_state);
  if (is_started_) start();
}

// A person at the mouse starts at rest where the scripted hand ends, so that the first picture already shows what the
// scene is about; the scripted hand itself starts at the beginning. A recorded hand may begin in the wall: there it
// starts at rest, and so does a person whose goal is elsewhere already. A reset uses the settings of the moment.
TickState<2> Application::start_state() {
  history_.clear();
  session_.plots.follows = true;  // what was looked back at is gone
  session_.stage.looks_back_to_s.reset();
  Scene scene = *session_.scene;
  scene.settings = session_.settings;
  const bool is_replay = input_->needs_recording && input_options_.recorded_hand;
  if (is_replay) scene.goal = *input_options_.recorded_hand;
  const bool is_elsewhere = !input_->is_scripted && session_.goal != scene.goal.points.back();
  if (is_elsewhere) scene.goal = {.points = {session_.goal}, .times = {0.0}};
  const Vector<2> first = goal_at(scene.goal, 0.0);
  const TickState<2> state = simulate_from(
      is_replay || is_elsewhere ? equilibrium_at_start(scene, first) : state_at_start(scene.settings, first), scene,
      input_->is_scripted || is_elsewhere ? 0 : last_tick(scene),
      [&](const Snapshot& snapshot) { history_.add(snapshot, scene.settings); });
  if (!has_diverged(state)) return state;
  // Unstable settings have no rest to start from: start where the hand is, and let the servo say what it finds.
  history_.clear();
  return state_at_start(scene.settings, scene.goal.points.back());
}

void Application::frame(double interval_s) {
  update(interval_s);
  draw();
}

void Application::update(double interval_s) {
  clock_s_ += interval_s;
  interval_s_ = interval_s;
  since_drawn_s_ += interval_s;
  if (servo_driver_) servo_driver_->step(std::llround(clock_s_ * 1e9));
  take_samples();
  report_ = servo_->newest();
  hand_following_.take_report(report_, session_, command_);
  if (recording_) {
    recording_->poll();
    read_recording();
    if (recording_->progress().error != 0) show_notice(end_recording(), true);
  }
  see_target();
  link_->poll();
  log_.note(report_, link_->fault());
  follow_own_wish(interval_s);
  late_ticks_.note(report_.loop.late_ticks, link_->is_opening(), interval_s);
  if (const std::string problem = clipboard_tool_.poll(); !problem.empty()) show_notice(problem, true);
  if (const std::string problem = window_.take_clipboard_problem(); !problem.empty()) show_notice(problem, true);
  // Nobody stops the time of a real hand.
  if (report_.snapshot.measured) session_.paused = false;
  if (report_.restarts != command_.restarts_asked || report_.snapshot.tick == 0) {
    // The servo has not seen the restart yet: show the state that it will start from.
    report_.snapshot = snapshot_of(loop_coefficients_of(session_.settings), command_.restart_state);
    report_.hand = {};
  }
  session_.time_s = report_.snapshot.time_s;
  follow_measurement(session_, report_.snapshot, report_.motors);
  session_.has_motors = report_.motors.has_motors;
  // The device says where its motor's line is: that is neither sent back nor undone.
  session_.motor_line_turns = report_.motors.line_turns;
  if (session_.motor_line_turns)
    session_.settings.actuated_angle = sent_settings_.actuated_angle = report_.motors.line_angle;
  session_.motors_may_push = report_.motors.has_motors && report_.motors.state != SafetyState::off;
  follow_stiffness_probe(session_, report_.snapshot, report_.motors, report_.hand);
  follow_lesson_in_session(interval_s);
  follow_kiosk_visit_in_session(interval_s);
  if (shader_watch_ && shader_watch_->poll(screen_.painter(), clock_s_)) frames_to_settle_ = settling_frames;
  if (session_.notice) {
    notice_count_ = notice_count();
    session_.notice->age_s += interval_s;
    if (!session_.notice->is_problem && session_.notice->age_s > news_last_s) session_.notice.reset();
  }
  clip_saving_.poll(session_);
  if (std::optional<double>& age_s = session_.dial_turned_s; age_s && (*age_s += interval_s) > dial_words_last_s)
    age_s.reset();
  if (screen_.has_audience_left()) toggle_audience();
  screen_.advance(session_, interval_s);
  heartbeat();
}

bool Application::delays_sleep(bool is_coming) {
  command_.machine_sleeps = is_coming;
  return report_.motors.has_motors && !(is_coming && report_.motors.state == SafetyState::off);
}

VisibleState Application::visible() const {
  return visible_state(session_, shown(), history_, report_.snapshot.time_s, reading());
}

bool Application::has_changed() const {
  if (!drawn_ || link_->has_news()) return true;
  double points_per_metre = 1.0;
  for (const Pane& pane : screen_.panes()) points_per_metre = std::max(points_per_metre, pane.camera.points_per_metre);
  return differs_visibly(*drawn_, visible(), points_per_metre);
}

bool Application::needs_drawing() const {
  // A caret blinks while somebody writes, and a button that is held may go on counting.
  if (session_.is_editing && !session_.drags_goal) return true;
  if (has_chosen_files()) return true;
  const bool has_counts = session_.face == Face::workbench;
  const bool is_old = has_counts && clock_s_ - drawn_at_s_ >= (session_.paused ? paused_counts_last_s : counts_last_s);
  return is_old || frames_to_settle_ > 0 || screen_.is_moving(session_) || has_changed();
}

void Application::draw() {
  screen_.take_keys(session_, [this](const Action& action) {
    hear(action);
    do_what_is_asked();
  });
  // What is changed within the frame, some of it shows and some does not: it is a reason for another one.
  frames_to_settle_ = has_changed() ? settling_frames : std::max(0, frames_to_settle_ - 1);
  drawn_ = visible();
  drawn_at_s_ = clock_s_;
  // After a rest the first frame must not leap over what begins with it.
  constexpr double longest_step_s = 0.25;
  const double since_drawn_s = std::min(std::exchange(since_drawn_s_, 0.0), longest_step_s);
  screen_.draw(
      session_, [this](const Action& action) { hear(action); }, shown(), history_, reading(), since_drawn_s);
  do_what_is_asked();
  send();
}

void Application::hear(const Action& action) {
  if (is_replay_ && !std::holds_alternative<Quit>(action)) return;
  replay_place_.reset();  // whoever goes on has read that it is over
  act(action);
}

void Application::act(const Action& action) {
  Action whole = action;
  if (auto* const paste = std::get_if<PasteSetUp>(&whole); paste != nullptr && paste->line.empty() && !is_replay_) {
    std::optional<std::string> text = window_.clipboard_text();
    if (!text) return;
    paste->line = *std::move(text);
  }
  if (watch_actions_) watch_actions_(clock_s_, whole);
  apply_now(whole);
}

void Application::act_at_once(const Action& action) {
  act(action);
  do_what_is_asked();
}

void Application::apply_now(const Action& action) {
  std::ranges::move(apply(session_, action), std::back_inserter(effects_));
}

void Application::do_what_is_asked() {
  looking_back_.follow(session_, report_.snapshot, history_.moments());
  do_effects();
  hand_following_.decide_source(session_);
  undo_.note(undo_state(), session_.is_editing || session_.drags_goal || is_measuring(session_));
  offer_undo();
}

void Application::offer_undo() {
  const UndoState* const before = undo_.before();
  const UndoState* const after = undo_.after();
  session_.undo_offer = {.undo = before != nullptr ? words_of_change(*before, undo_.present()) : "",
                         .redo = after != nullptr ? words_of_change(undo_.present(), *after) : ""};
  if (is_measuring(session_))
    session_.undo_offer = {.undo = "what the measurement has changed, and end it", .redo = ""};
}

LoopReading Application::reading() const {
  LoopReading reading{.input_title = input_->title,
                      .rate_hz = report_.loop.rate_hz,
                      .late_ticks = late_ticks_.all(),
                      .late_ticks_lately = late_ticks_.lately(),
                      .periods = report_.loop.periods,
                      .dropped_samples = report_.loop.dropped_samples,
                      .refused = report_.refused_commands,
                      .diverged = report_.diverged,
                      .inputs = input_choices_,
                      .why_no_falcon = why_no_falcon_,
                      .shader_problem = shader_watch_ ? std::string_view(shader_watch_->problem()) : std::string_view(),
                      .motors = report_.motors,
                      .hand = report_.hand,
                      .hand_unknown_s = hand_following_.unknown_s(),
                      .recording = recording_reading_,
                      .refused_by_system = refused_words(report_.realtime),
                      .replay = replay_place_};
  link_->fill(reading);
  return reading;
}

StageReading Application::stage_reading() const {
  return screen_.stage_reading(session_, shown(), history_, reading());
}

void Application::take_samples() {
  Sample sample;
  while (servo_->take_sample(sample)) {
    // Samples of a run that has been reset meanwhile belong to no picture any more.
    if (sample.restarts != command_.restarts_asked) continue;
    if (const auto target = target_of(session_, report_.motors)) {
      measure_against_target(*target, sample.settings, !sample.is_saturated && report_.motors.gain == 1.0,
                             sample.snapshot);
    }
    history_.add(sample.snapshot, sample.settings);
    history_.add(hand_point(sample, *session_.scene, session_.hand_is_simulated));
    link_->add(sample.snapshot);
  }
}

void Application::see_target() {
  const MotorReport& motors = report_.motors;
  const std::optional<Vector<2>> target = target_of(session_, motors);
  if (!target) return;
  Settings settings = session_.settings;
  if (motors.held_k_r > 0.0) settings.stiffnesses.k_r = motors.held_k_r;
  measure_against_target(*target, settings, motors.gives_all(), report_.snapshot);
}

void Application::send() {
  link_->send(session_, interval_s_);
  // What the servo has changed by itself is not sent back.
  const Settings chosen = chosen_settings(session_.settings, session_.belief_source);
  if (command_hand(session_, command_) || chosen != sent_settings_) {
    ++command_.settings_generation;
    sent_settings_ = chosen;
    command_.settings = as_in_file(session_.settings);
  }
  if (session_.restarts_asked != command_.restarts_asked) {
    command_.restart_state = start_state();
  }
  command_.paused = session_.paused;
  command_.speed = session_.speed;
  command_.steps_asked = session_.steps_asked;
  command_.restarts_asked = session_.restarts_asked;
  heartbeat();
}

void Application::copy_motor_requests() {
  command_.arms_asked = session_.arms_asked;
  command_.offs_asked = session_.offs_asked;
  command_.acknowledgements = session_.acknowledgements;
  command_.departures = session_.kiosk_visit ? session_.kiosk_visit->departures : 0;
  command_.safety = session_.safety;
  // The words on screen need not wait until the servo has heard of it.
  command_.has_focus = report_.motors.has_focus = window_.has_focus();
}

void Application::heartbeat() {
  copy_motor_requests();
  ++command_.heartbeats;
  servo_->send(command_);
}

void Application::show_notice(std::string words, bool is_problem, std::string language) {
  if (session_.kiosk_visit) return say("{}\n", words);
  // What has failed just now stays to be read.
  if (has_failed_ && session_.notice) words = fmt::format("{}\n{}", session_.notice->words, words);
  has_failed_ = has_failed_ || is_problem;
  session_.notice = Notice{std::move(words), has_failed_, 0.0, std::move(language)};
}

// Whoever has turned the motors off by themselves has nothing to read, and may arm them again. Not at once, though: a
// second press on their button, in haste, must not.
void Application::follow_own_wish(double interval_s) {
  const MotorReport& motors = report_.motors;
  const bool is_off = motors.state == SafetyState::off && !motors.may_still_push;
  off_by_person_s_ = is_off && motors.reason == OffReason::key ? off_by_person_s_ + interval_s : 0.0;
  if (off_by_person_s_ <= own_wish_stands_s) return;
  apply_now(AcknowledgeOff{});
  off_by_person_s_ = 0.0;
}

// --- What guides the person through a lesson, or waits for a visitor, once a frame ---

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
