#include "app/live/application.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/console/failure.h"
#include "app/console/quoted.h"
#include "app/files/output_file.h"
#include "app/files/png_file.h"
#include "app/files/run_reader.h"
#include "app/files/scene_file.h"
#include "app/paint/vector/vector_painter.h"
#include "app/runs/run_hand.h"
#include "app/session/input_choices.h"
#include "app/session/scene_as_seen.h"
#include "app/ui/panels/panel_catalog.h"
#include "app/ui/plots/plot_export.h"
#include "core/play.h"
#include "core/sound_state.h"

namespace ghostforce {
namespace {

constexpr double news_last_s = 6.0;  // problems stay until they are dismissed

Session session_with(const Scene& scene, const ApplicationOptions& options) {
  Session session = session_of(scene);
  session.look = options.look;
  session.input = options.input;
  session.has_handles = true;
  session.folded_panels = options.folded_panels;
  if (options.offers_hints) session.hint = 0;
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
      undo_({session_.scene, session_.settings}),
      inputs_(input_choices(options.input_options.recorded_hand != nullptr)),
      misbehaviours_(misbehaviour_choices()),
      input_options_(options.input_options),
      screen_(window, options.part) {
  if (!options.shader_folder.empty()) shader_watch_.emplace(options.shader_folder);
  use(*find_input(options.input), session_.scene, session_.settings);
  if (options.record) start_recording(*options.record);
}

Application::~Application() {
  servo_->stop();
}

void Application::start() {
  is_started_ = true;
  servo_->start();
}

// A servo owns its input, so another input or another script is another servo; counts go on, so that what is asked for
// later still looks new to it. An input that cannot be had leaves everything as it was.
void Application::use(const InputKind& kind, std::shared_ptr<const Scene> scene, const Settings& settings) {
  // A device has one driver: the one before lets go of it first.
  if (servo_) servo_->stop();
  std::unique_ptr<Input> hand;
  try {
    hand = kind.make(*scene, input_options_);
  } catch (...) {
    if (is_started_) servo_->start();
    throw;
  }
  // Its header would not be true any longer.
  if (const std::string words = end_recording(); !words.empty()) {
    tell(fmt::format("Another scene or input ends the recording. {}", words), !recording_problem_.empty());
  }
  const bool is_other_scene = scene != session_.scene;
  pointer_ = dynamic_cast<PointerTarget*>(hand.get());
  spacemouse_ = dynamic_cast<SpaceMouseInput*>(hand.get());
  circle_ = dynamic_cast<CircleInput*>(hand.get());
  falcon_ = dynamic_cast<FalconInput*>(hand.get());
  virtual_falcon_ = dynamic_cast<VirtualFalconInput*>(hand.get());
  falcon_report_ = {};
  input_title_ = kind.title;
  session_.input = kind.name;
  session_.misbehaviour.clear();
  if (circle_ != nullptr) session_.folded_panels.erase(std::string(energy_panel));
  session_.circle_test.has_news = circle_ != nullptr;
  session_.pointer_moves_goal = pointer_ != nullptr;
  session_.scene = std::move(scene);
  session_.settings = settings;
  session_.goal = session_.scene->goal.points.back();
  if (is_other_scene) {
    session_.shown = session_.scene->view;
    window_.set_title(window_title(*session_.scene));
  }
  sent_goal_ = session_.goal;
  sent_settings_ = session_.settings;
  command_.settings = as_in_file(session_.settings);
  sent_circle_ = {};
  circle_meter_.start(session_.settings, sent_circle_);
  command_.restarts_asked = session_.restarts_asked;
  command_.steps_asked = session_.steps_asked;
  note_motors();
  command_.restart_state = start_state();
  servo_ = std::make_unique<Servo>(std::move(hand), command_);
  if (virtual_falcon_ != nullptr) virtual_falcon_->move_to(session_.goal, 1.0);
  report_ = {};
  report_.restarts = command_.restarts_asked;
  report_.snapshot = snapshot_of(plan_of(session_.settings), command_.restart_state);
  if (is_started_) servo_->start();
}

// A person at the mouse starts at rest where the scripted hand ends, so that the first picture already shows what the
// scene is about; the scripted hand itself starts at the beginning. A recorded hand may begin in the wall: there it
// starts at rest. A reset uses the settings of the moment.
TickState<2> Application::start_state() {
  history_.clear();
  session_.plots.follows = true;  // what was looked back at is gone
  Scene scene = *session_.scene;
  scene.settings = session_.settings;
  const InputKind& kind = *find_input(session_.input);
  const bool is_replay = kind.needs_recording && input_options_.recorded_hand;
  if (is_replay) scene.goal = *input_options_.recorded_hand;
  const Vector<2> first = goal_at(scene.goal, 0.0);
  const TickState<2> state =
      play_from(is_replay ? state_at_rest(scene.settings, first) : state_at_start(first), scene,
                kind.is_scripted ? 0 : last_tick(scene), [this](const Snapshot& snapshot) { history_.add(snapshot); });
  if (is_sound(state)) return state;
  // Unstable settings have no rest to start from: start where the hand is, and let the servo say what it finds.
  history_.clear();
  return state_at_start(scene.goal.points.back());
}

void Application::frame(double interval_s) {
  clock_s_ += interval_s;
  take_samples();
  report_ = servo_->newest();
  if (recording_) {
    read_recording();
    if (recording_->progress().error != 0) tell(end_recording(), true);
  }
  if (falcon_ != nullptr) falcon_report_ = falcon_->report();
  if (spacemouse_ != nullptr) spacemouse_reading_ = spacemouse_->reading();
  // Nobody stops the time of a real hand.
  if (report_.snapshot.measured) session_.paused = false;
  if (report_.restarts != command_.restarts_asked || report_.snapshot.tick == 0) {
    // The servo has not seen the restart yet: show the state that it will start from.
    report_.snapshot = snapshot_of(plan_of(session_.settings), command_.restart_state);
  }
  follow_measurement(session_, report_.snapshot, report_.motors);
  if (shader_watch_) shader_watch_->look(screen_.painter(), clock_s_);
  screen_.draw(session_, report_.snapshot, history_, loop_reading(), interval_s);
  grant_wishes();
  undo_.note({session_.scene, session_.settings}, session_.is_editing || is_measuring(session_));
  if (session_.notice && !session_.notice->is_problem) {
    session_.notice->age_s += interval_s;
    if (session_.notice->age_s > news_last_s) session_.notice.reset();
  }
  send(interval_s);
}

LoopReading Application::loop_reading() const {
  return {.input_title = input_title_,
          .rate_hz = report_.loop.rate_hz,
          .late_ticks = report_.loop.late_ticks,
          .dropped_samples = report_.loop.dropped_samples,
          .refused = report_.refused_commands + (pointer_ != nullptr ? pointer_->ignored_moves() : 0),
          .diverged = report_.diverged,
          .inputs = inputs_,
          .shader_problem = shader_watch_ ? std::string_view(shader_watch_->problem()) : std::string_view(),
          .motors = report_.motors,
          .ladder = falcon_ != nullptr ? ladder_of(falcon_report_, &report_.motors) : std::vector<RungState>(),
          .device = falcon_ != nullptr ? fmt::format("{} {}", input_title_, falcon_report_.serial.text()) : "",
          .device_remark = device_remark(),
          .spacemouse = spacemouse_ != nullptr ? std::optional(spacemouse_reading_) : std::nullopt,
          .misbehaviours = virtual_falcon_ != nullptr ? misbehaviours_ : std::span<const InputChoice>(),
          .recording = recording_reading_,
          .circle = circle_ != nullptr ? std::optional(circle_meter_.reading()) : std::nullopt,
          .remark = mode_of(report_.realtime)};
}

std::string Application::device_remark() const {
  if (falcon_ == nullptr) return {};
  const auto known =
      std::ranges::find(input_options_.falcon.calibrations, falcon_report_.serial, &FalconCalibration::serial);
  const FalconCalibration calibration =
      known == input_options_.falcon.calibrations.end() ? FalconCalibration{} : *known;
  const FalconPlane plane(calibration, session_.scene->view.center);
  double needed = 0.0;
  for (const Vector<2>& point : session_.scene->goal.points) needed = std::max(needed, plane.scale_to_reach(point));
  if (needed <= calibration.scale) return {};
  return fmt::format(
      "This scene reaches {:.0f} mm from the middle of the view, and the handle {:.0f} mm: set scale = {:.1f} or more "
      "in "
      "the device's calibration file.",
      1000.0 * workspace_radius * needed, 1000.0 * workspace_radius * calibration.scale,
      std::ceil(10.0 * needed) / 10.0);
}

void Application::take_samples() {
  Sample sample;
  while (servo_->take_sample(sample)) {
    // Samples of a run that has been reset meanwhile belong to no picture any more.
    if (sample.restarts != command_.restarts_asked) continue;
    history_.add(sample.snapshot);
    if (circle_ != nullptr) circle_meter_.add(sample.snapshot);
  }
}

// The circle lies in the wall as it is now. While the wall is being turned it waits.
void Application::lead_round() {
  const Circle circle =
      circle_inside(wall_of(session_.settings), session_.scene->goal.points.back(), session_.circle_test.choice);
  if (circle == sent_circle_ || session_.is_editing) return;
  circle_->go_round(circle);
  sent_circle_ = circle;
  ++session_.restarts_asked;
}

void Application::send(double interval_s) {
  if (circle_ != nullptr) lead_round();
  Settings measured = session_.settings;
  measured.active = sent_settings_.active;  // all strategies are measured, whichever is the active one
  const bool is_other_run = measured != sent_settings_ || session_.restarts_asked != command_.restarts_asked;
  if (circle_ != nullptr && is_other_run) circle_meter_.start(session_.settings, sent_circle_);
  if (session_.settings != sent_settings_) {
    ++command_.settings_generation;
    sent_settings_ = session_.settings;
    command_.settings = as_in_file(session_.settings);
  }
  if (session_.restarts_asked != command_.restarts_asked) {
    command_.restart_state = start_state();
    sent_goal_ = session_.goal;
  }
  command_.paused = session_.paused;
  command_.speed = session_.speed;
  command_.steps_asked = session_.steps_asked;
  command_.restarts_asked = session_.restarts_asked;
  note_motors();
  ++command_.heart_beats;
  servo_->send(command_);
  if (spacemouse_ != nullptr) spacemouse_->set(session_.spacemouse);
  if (pointer_ == nullptr) return;
  pointer_->hold_with(session_.settings.impedances.k_u);
  if (virtual_falcon_ != nullptr) rehearse();
  if (session_.drags_goal || session_.goal != sent_goal_) {
    pointer_->move_to(session_.goal, interval_s * session_.speed);
    sent_goal_ = session_.goal;
  }
}

void Application::rehearse() {
  // Whoever drags a virtual handle holds its grip.
  virtual_falcon_->press(session_.drags_goal ? ReplyFrame::button_centre : 0);
  if (session_.misbehaviour.empty()) return;
  Misbehaviour wrong;
  if (const MisbehaviourKind* const kind = find_misbehaviour(session_.misbehaviour)) kind->add(wrong);
  virtual_falcon_->misbehave(wrong);
}

void Application::note_motors() {
  command_.arms_asked = session_.arms_asked;
  command_.offs_asked = session_.offs_asked;
  command_.acknowledgements = session_.acknowledgements;
  command_.safety = session_.safety;
  command_.has_focus = window_.has_focus();
}

void Application::beat() {
  note_motors();
  ++command_.heart_beats;
  servo_->send(command_);
}

bool Application::has_news() {
  if (recording_ && recording_->progress().error != 0) return true;
  if (spacemouse_ != nullptr) {
    const SpaceMouseReading& now = spacemouse_->reading();
    const SpaceMouseReading& shown = spacemouse_reading_;
    if (now.trouble != shown.trouble || now.connection != shown.connection || now.reports != shown.reports) return true;
  }
  const ServoReport& now = servo_->newest();
  return now.snapshot.tick != report_.snapshot.tick || now.restarts != report_.restarts ||
         now.refused_commands != report_.refused_commands || now.diverged != report_.diverged ||
         mode_of(now.realtime) != mode_of(report_.realtime);
}

void Application::tell(std::string words, bool is_problem) {
  session_.notice = Notice{std::move(words), is_problem, 0.0};
}

void Application::grant_wishes() {
  const Wishes wishes = std::exchange(session_.wishes, {});
  const std::vector<std::string> dropped = window_.take_dropped_files();
  try {
    if (wishes.quit) window_.close();
    if (wishes.toggle_full_screen) window_.toggle_full_screen();
    if (wishes.undo || wishes.redo) take_back(wishes.undo);
    if (wishes.input && *wishes.input != session_.input) {
      use(*find_input(*wishes.input), session_.scene, session_.settings);
    }
    if (wishes.open_scene) open(*wishes.open_scene);
    if (!dropped.empty()) open(dropped.front());
    if (dropped.size() > 1) tell("One scene at a time: the first of the files is open.", false);
    if (wishes.save_scene) {
      save_scene(session_, *wishes.save_scene);
      tell(fmt::format("Saved {}", printable(*wishes.save_scene, longest_path)), false);
    }
    if (wishes.save_picture) save_picture(*wishes.save_picture);
    if (wishes.save_plots) save_plots(*wishes.save_plots);
    if (wishes.record) start_recording(*wishes.record);
    if (wishes.stop_recording) {
      if (const std::string words = end_recording(); !words.empty()) tell(words, !recording_problem_.empty());
    }
  } catch (const Failure& failure) {
    if (failure.code() == ExitCode::interrupted) throw;
    tell(failure.what(), true);
  } catch (const ReadError& error) {
    tell(error.what(), true);
  }
}

void Application::take_back(bool undo) {
  // What a measurement has set is its own: to take it back is to cancel it.
  if (is_measuring(session_)) {
    cancel_measurement(session_);
    return;
  }
  // What is being changed right now is one more step to take back.
  undo_.note({session_.scene, session_.settings}, false);
  go_to(undo ? undo_.undo() : undo_.redo());
}

void Application::open(const std::string& name_or_path) {
  if (may_be_run(name_or_path)) return replay_run(name_or_path);
  const auto scene = std::make_shared<const Scene>(load_scene(name_or_path));
  use(*find_input(session_.input), scene, scene->settings);
}

void Application::replay_run(const std::string& path) {
  const Run run = load_run(path);
  if (!run.scene) {
    throw Failure(ExitCode::wrong_call,
                  fmt::format("{}: the run does not tell its scene; on the command line one can be named, as in\n"
                              "ghostforce run wall45 --input replay:RUN.csv",
                              printable(path, longest_path)));
  }
  input_options_.recorded_hand = std::make_shared<const GoalPath>(goal_path_of(run));
  inputs_ = input_choices(true);
  use(*find_input("replay"), std::make_shared<const Scene>(*run.scene), run.scene->settings);
  tell(fmt::format("Replaying {}{}{}", printable(path, longest_path), run.remarks.empty() ? "" : "\n",
                   fmt::join(run.remarks, "\n")),
       false);
}

void Application::start_recording(const std::string& path) {
  end_recording();
  Scene scene = *session_.scene;
  scene.settings = command_.settings;
  recording_ = std::make_unique<Recording>(path, rounded_to_file(std::move(scene)), *servo_, ++recordings_);
  recording_problem_.clear();
  command_.recording = recordings_;
  servo_->send(command_);
  read_recording();
}

std::string Application::end_recording() {
  if (!recording_) return {};
  command_.recording = 0;
  servo_->send(command_);
  recording_->end();
  read_recording();
  const int error = recording_->progress().error;
  const std::string found_at = recording_->found_at();
  recording_.reset();
  recording_reading_.is_on = false;
  const std::string shown = printable(found_at.empty() ? recording_reading_.path : found_at, longest_path);
  if (found_at.empty()) {
    recording_problem_ = fmt::format(
        "The recording is lost, {:.1f} s of it: {} was removed while it was written. Record again, to a folder that "
        "stays.",
        recording_reading_.seconds, shown);
    return recording_problem_;
  }
  if (error == EOVERFLOW) {
    recording_problem_ = fmt::format(
        "The recording has ended after {:.1f} s: {} is as long as a run may be, {:.0f} ticks. It is whole; record "
        "again, "
        "to another file, for what comes.",
        recording_reading_.seconds, shown, most_ticks);
    return recording_problem_;
  }
  if (error != 0) {
    recording_problem_ = fmt::format(
        "The recording has ended after {:.1f} s: {} takes no more: {}. What is in it can "
        "be read.",
        recording_reading_.seconds, shown, reason_of(error));
    return recording_problem_;
  }
  const std::uint64_t dropped = recording_reading_.dropped;
  const std::string words = fmt::format("Recorded {:.1f} s to {}{}", recording_reading_.seconds, shown,
                                        dropped > 0 ? fmt::format("; {} samples were lost", dropped) : "");
  if (found_at == recording_reading_.path) return words;
  recording_problem_ = fmt::format("{}. It was moved there while it was written: {} is not it any more.", words,
                                   printable(recording_reading_.path, longest_path));
  return recording_problem_;
}

void Application::read_recording() {
  const RecordingProgress progress = recording_->progress();
  recording_reading_ = {.is_on = true,
                        .path = recording_->path(),
                        .seconds = progress.seconds,
                        .bytes = progress.bytes,
                        .dropped = progress.dropped};
}

void Application::go_to(const std::optional<Edited>& edited) {
  if (!edited) return;
  if (edited->scene == session_.scene) {
    session_.settings = edited->settings;
  } else {
    use(*find_input(session_.input), edited->scene, edited->settings);
  }
}

void Application::save_picture(const PictureWish& wish) {
  OutputFile file(wish.path);
  file.write(picture_bytes(wish));
  file.commit();
  tell(fmt::format("Saved {}", printable(wish.path, longest_path)), false);
}

void Application::save_plots(const PlotWish& wish) {
  OutputFile file(wish.path);
  file.write(plot_file(session_, report_.snapshot, history_.plots(), wish));
  file.commit();
  tell(fmt::format("Saved {}", printable(wish.path, longest_path)), false);
}

std::string Application::picture_bytes(const PictureWish& wish) {
  const auto format = vector_format_of(wish.path);
  if (!format) {
    return png_bytes(screen_.picture(session_, report_.snapshot, history_, loop_reading(),
                                     wish.scene_alone ? Part::scene : Part::window, wish.density));
  }
  // As large as on this display, without the handles, which are for a pointer.
  const double scale = session_.look.scale * static_cast<double>(window_.display_scale());
  const Theme& theme = *session_.look.theme;
  const MeasureText measure = measure_vector_text;
  const std::vector<Pane> panes = compose_panes({.settings = session_.settings,
                                                 .snapshot = report_.snapshot,
                                                 .history = history_,
                                                 .theme = theme,
                                                 .options = session_.options,
                                                 .shown = session_.shown,
                                                 .size = screen_.scene_size(),
                                                 .scale = scale,
                                                 .measure = measure});
  return paint_vector(panes, theme, screen_.scene_size(), scale * theme.thickness, *format, session_.scene->title);
}

}  // namespace ghostforce
