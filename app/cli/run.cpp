// ghostforce run: the window, live.
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/base/words.h"
#include "app/cli/command.h"
#include "app/cli/desktop_inputs.h"
#include "app/cli/lesson_options.h"
#include "app/cli/option.h"
#include "app/cli/picture_options.h"
#include "app/cli/reading_aloud.h"
#include "app/cli/version.h"
#include "app/files/output_file.h"
#include "app/files/program_build.h"
#include "app/files/run_reader.h"
#include "app/files/scene_file.h"
#include "app/paint/vector/vector_file_painter.h"
#include "app/runs/replay.h"
#include "app/shell/application.h"
#include "app/shell/desktop/display_watch.h"
#include "app/shell/desktop/glfw_window.h"
#include "app/shell/desktop/motion_watch.h"
#include "app/shell/desktop/portal_file_chooser.h"
#include "app/shell/desktop/sleep_watch.h"
#include "app/shell/frame_pacer.h"
#include "app/shell/preferences.h"
#include "app/shell/session_file.h"
#include "app/state/lesson_progress.h"
#include "app/tools/doctor/diagnosis.h"
#include "core/safety.h"
#include "device/motors/emergency_stop.h"
#include "device/report/input_choice.h"
#include "device/servo/realtime.h"
#include "device/servo/servo_thread.h"

namespace ghostforce {
namespace {

using Clock = std::chrono::steady_clock;

struct RunOptions {
  SetUpOptions set_up;
  LessonOptions lesson;
  KioskOptions kiosk;
  std::string input{mouse_hand.name};
  std::optional<std::string> record;
  std::optional<std::string> record_session;
  DeviceSetUp devices;
  std::string shader_folder;
  bool no_hints = false;
  bool has_audience = false;
  std::optional<double> printed_hz;
  bool speaks = false;
  std::optional<double> exit_after_s;
};

// What stands before the recording that is to be replayed.
std::string replay_begins() {
  return fmt::format("{}:", replayed_hand.name);
}

// Of all inputs; `replay` stands for the one that replays a recording.
std::vector<std::string_view> input_names(std::string_view replay) {
  std::vector<std::string_view> names;
  for (const InputKind& kind : desktop_inputs()) {
    if (!kind.needs_recording) names.push_back(kind.name);
  }
  names.push_back(replay);
  return names;
}

// Either the name of an input, or replay and the recording.
std::string refuse_other_than_input(const std::string& word) {
  if (word == replayed_hand.name || word == replay_begins()) return "give the recording too: --input replay:FILE";
  return word.starts_with(replay_begins()) ? std::string() : not_one_of(word, input_names("replay:FILE"));
}

// A recording grows while the program runs, and words go to the terminal beside it.
std::string refuse_standard_output(const std::string& path) {
  return path.empty() || path == "-" ? "name a file; it must not exist yet" : "";
}

// The recording whose hand is to be replayed.
std::optional<Run> load_recording(const RunOptions& options) {
  if (!options.input.starts_with(replay_begins())) return std::nullopt;
  Run run = load_run(options.input.substr(replay_begins().size()));
  for (const std::string& warning : run.warnings) say("{}\n", warning);
  return run;
}

Scene scene_for(const RunOptions& options, const std::optional<Run>& recording) {
  if (!recording || !recording->scene || options.set_up.scene.is_named()) {
    return options.set_up.scene.load();
  }
  const Scene scene = recording->ticks.empty() ? *recording->scene : scene_since(*recording, recording->ticks.front());
  return read_scene(scene_text(scene), options.input, options.set_up.scene.overrides);
}

void refuse_goal_of_other_hand(const RunOptions& options) {
  if (!options.set_up.goal_mm) return;
  if (options.input != scripted_hand.name && !options.input.starts_with(replay_begins())) return;
  throw Failure(
      ExitCode::wrong_call,
      fmt::format("--goal-mm places your own hand, but --input {} brings a hand of its own; leave out one of them",
                  quoted_text(options.input, longest_path)));
}

// The hand of another file is not in the list of what the person did.
void refuse_session_of_other_hand(const RunOptions& options) {
  if (!options.record_session || !options.input.starts_with(replay_begins())) return;
  throw Failure(ExitCode::wrong_call,
                fmt::format("--record-session writes down what you do yourself, but --input {} brings the hand of a "
                            "recording; leave out one of them",
                            quoted_text(options.input, longest_path)));
}

SessionStart session_start(const RunOptions& options, const SetUp& set_up, const std::string& language,
                           const Window& window) {
  const auto points = [&](int pixels) {
    return std::max(1, static_cast<int>(std::lround(pixels / static_cast<double>(window.display_scale()))));
  };
  return {.program = program_build(),
          .input = options.input,
          .face = set_up.face,
          .mode = set_up.mode,
          .lesson = options.lesson.name,
          .language = language,
          .width = points(window.pixel_width()),
          .height = points(window.pixel_height()),
          .scene = scene_text(set_up.scene)};
}

int run(const RunOptions& options) {
  options.kiosk.refuse_contradictions();
  refuse_session_of_other_hand(options);
  const std::optional<Run> recording = load_recording(options);
  Scene loaded = scene_for(options, recording);
  refuse_goal_of_other_hand(options);
  options.devices.refuse_misbehaviour_of_others(options.input);
  const std::shared_ptr<const Lesson> lesson = options.lesson.load();
  const bool is_kiosk = options.kiosk.is_on;
  StoredPreferences stored = is_kiosk ? for_visitors(load_preferences()) : load_preferences();
  const LessonProgress progress = is_kiosk ? LessonProgress{} : load_lesson_progress(stored.remarks);
  const SetUp set_up = options.set_up.set_up(std::move(loaded), stored.preferences.face);
  const std::optional<FirmwareImage> firmware = options.devices.read_firmware_file();
  if (firmware) say("{}\n", firmware_words(firmware));
  InputOptions input_options = options.devices.input_options(firmware);
  if (recording) {
    input_options.recorded_hand =
        std::make_shared<const GoalPath>(goal_path_of(*recording, set_up.scene.settings.rate));
  }
  Preferences preferences = stored.preferences;
  preferences.face = set_up.face;
  options.set_up.picture.apply_appearance(preferences.appearance);
  preferences.offers_hints = preferences.offers_hints && !options.no_hints;
  preferences.speaks = preferences.speaks || options.speaks;
  preferences.language = options.lesson.wanted(preferences.language, lesson);
  const Appearance& appearance = preferences.appearance;
  const auto scaled = [&](int points) { return static_cast<int>(std::lround(points * appearance.scale)); };
  const WindowLayout layout = stored.layout.value_or(
      WindowLayout{.width = scaled(WindowLayout::first_width), .height = scaled(WindowLayout::first_height)});
  if (is_kiosk) say("{}\n", end_of_kiosk);
  leave_processor_to_servo();
  GlfwWindow window({.title = window_title(set_up.scene),
                     .width = layout.width,
                     .height = layout.height,
                     .fits_monitor = true,
                     .when_lost = emergency_stop::stop_motors});
  if (layout.is_maximized) window.maximize();
  if (layout.is_full_screen) window.toggle_full_screen();
  std::optional<SessionRecorder> session_recorder;
  std::function<void(double, const Action&)> watch_actions;
  if (options.record_session) {
    session_recorder.emplace(*options.record_session, session_start(options, set_up, preferences.language, window));
    watch_actions = [&](double time_s, const Action& action) { session_recorder->write(time_s, action); };
  }
  Application application(
      window, set_up.scene,
      {.appearance = appearance,
       .face = set_up.face,
       .mode = set_up.mode,
       .lesson = lesson,
       .language = preferences.language,
       .kiosk_visit = options.kiosk.lessons(lesson),
       .lesson_progress = progress,
       .inputs = desktop_inputs(options.devices.cables()),
       .input = std::string(recording ? replayed_hand.name : std::string_view(options.input)),
       .painter = cairo_file_painter(),
       .record = options.record,
       .receipt_origin = receipt_origin(
           firmware ? fmt::format("{}, SHA-256 {}", quoted_text(firmware->path.filename().string(), longest_path),
                                  firmware->sha256)
                    : std::string()),
       .input_options = input_options,
       .make_servo_driver = [] { return std::make_unique<ServoThread>(); },
       .offers_hints = preferences.offers_hints,
       .folded_panels = stored.layout ? layout.folded_panels
                                      : panels_folded_at_first(window.restored_size().height / appearance.scale),
       .shader_folder = options.shader_folder,
       .watch_actions = watch_actions});
  if (!stored.remarks.empty()) application.show_notice(fmt::format("{}", fmt::join(stored.remarks, "\n\n")), true);
  emergency_stop::refuse_to_be_stopped();
  apply(preferences, application.session());
  if (session_recorder) session_recorder->write_choices(application.session());
  PreferenceKeeper keeper(stored.preferences, application.session());
  ProgressKeeper progress_keeper(progress);
  const auto keep = [&] {
    if (is_kiosk) return;
    keeper.keep(application.session());
    progress_keeper.keep(application.session().lesson_progress);
  };
  if (options.has_audience) application.act(ToggleAudience{});
  application.start();
  SleepWatch sleep_watch;
  const MotionWatch motion_watch;
  std::optional<PortalFileChooser> file_chooser;
  if (!is_kiosk) file_chooser.emplace(window.portal_name());
  ReadingAloud reading_aloud(options.printed_hz, STDOUT_FILENO);
  const BeforeDisplayLoss before_display_loss([&application] {
    application.stop();
    interrupt();
    if (const std::string words = application.end_recording(); !words.empty()) say("{}\n", words);
    application.let_go_of_input();
  });

  const Clock::time_point began = Clock::now();
  const auto clock_s = [began] { return std::chrono::duration<double>(Clock::now() - began).count(); };
  FramePacer pacer(0.0);
  double last_s = 0.0;
  double drawn_s = 0.0;
  while (!window.should_close()) {
    stop_if_interrupted();
    const double now_s = clock_s();
    if (options.exit_after_s && now_s >= *options.exit_after_s) break;
    const double interval_s = now_s - std::exchange(last_s, now_s);
    sleep_watch.delay(application.delays_sleep(sleep_watch.is_coming()));
    if (motion_watch.is_reduced() != application.session().system_reduces_motion) {
      application.act(FollowSystemMotion{motion_watch.is_reduced()});
    }
    application.update(interval_s);
    reading_aloud.follow(application, interval_s);
    if (reading_aloud.output_problem() == EPIPE) break;  // who wanted the values has gone
    if (pacer.is_due(drawn_s, now_s) || application.needs_drawing()) {
      application.draw();
      drawn_s = now_s;
      try {
        // A slow disk keeps this thread, and motors that are on go off without its heartbeat.
        if (application.report().motors.state == SafetyState::off) keep();
      } catch (const Failure& failure) {
        application.show_notice(failure.what(), true);
      }
    }
    const bool is_stirred = window.poll(pacer.wait_s(application.is_idle(), now_s, clock_s()));
    pacer.waited(is_stirred, clock_s());
  }
  // Before files are written and pipes are waited for: no motor pushes meanwhile.
  application.stop();
  try {
    keep();
    const WindowSize size = window.restored_size();
    const WindowLayout left{size.width, size.height, window.is_maximized(), window.is_full_screen(),
                            application.session().folded_panels};
    if (!is_kiosk) save(left);
  } catch (const Failure& failure) {
    // The visit is over and went well; the window only opens in its usual size the next time.
    say("{}\n", failure.what());
  }
  const std::string end_of_recording = application.end_recording();
  const std::string& problem = application.recording_problem();
  // One that ended on the way was told in the window only.
  if (const std::string& words = problem.empty() ? end_of_recording : problem; !words.empty()) {
    say("{}\n", words);
  }
  if (session_recorder) session_recorder->end(application.clock_s());
  const std::string session_problem = session_recorder ? session_recorder->problem() : std::string();
  if (!session_problem.empty()) say("{}\n", session_problem);
  reading_aloud.finish_printing();
  const bool lost_values = reading_aloud.output_problem() != 0 && reading_aloud.output_problem() != EPIPE;
  if (lost_values) say("not all values were printed: {}\n", reason_of(reading_aloud.output_problem()));
  if (lost_values || (options.record && !problem.empty()) || !session_problem.empty())
    return static_cast<int>(ExitCode::file_trouble);
  if (!options.exit_after_s) return static_cast<int>(ExitCode::done);
  // Scripts want to know; a person has seen it on the screen.
  const EndOfRun end =
      end_of_run(application.report().motors, application.reading().readiness, application.input_link().end());
  if (!end.words.empty()) say("{}\n", end.words);
  return static_cast<int>(end.code);
}

}  // namespace

std::function<int()> attach_run(CLI::App& command, FileOptions& files) {
  const auto options = std::make_shared<RunOptions>();
  options->set_up.attach(command, files);
  files.reads(add_option(command, "--input NAME", options->input,
                         "What moves the goal: mouse, script (the scene's scripted hand), circle (round a circle "
                         "inside the wall), spacemouse, falcon, virtual-falcon (a rehearsal), haply, virtual-haply "
                         "(likewise) or replay:FILE (a "
                         "recording, with its own scene unless you name one); default: mouse")
                  ->check(refuse_other_than_input)
                  ->check(suggests(input_names(replay_begins()))),
              [](const std::string& word) {
                return word.starts_with(replay_begins()) ? std::vector{word.substr(replay_begins().size())}
                                                         : std::vector<std::string>{};
              });
  files.writes(
      add_option(command, "--record FILE", options->record,
                 "Record every tick, starting with the first, to this CSV file, which must not exist yet; when "
                 "it ends, a receipt is written beside it (docs/recording.md)")
          ->check(refuse_standard_output));
  files.writes(add_option(command, "--record-session FILE", options->record_session,
                          "Write what you do to this file, which must not exist yet: a line for each action, for "
                          "'ghostforce replay-session' (docs/sessions.md)")
                   ->check(refuse_standard_output));
  options->lesson.attach(command, files, "the one that was chosen in the window, else the environment's");
  options->kiosk.attach(command);
  options->devices.attach(command, files);
  command.add_flag("--audience", options->has_audience,
                   "Open a second window for the audience, with the stage alone; the first one has your notes "
                   "(docs/stage.md)");
  command.add_flag("--no-hints", options->no_hints, "Do not show the hints for newcomers");
  add_option(command, "--print-values HZ", options->printed_hz,
             "Print what the stage says to the standard output, for screen readers and loggers: a line when it "
             "changes, at most this many times a second (docs/reading-aloud.md)")
      ->check(number_between(PrintedValues::least_hz, PrintedValues::greatest_hz, "Hz"));
  command.add_flag("--speak", options->speaks, "Read the stage's sentence aloud, through speech-dispatcher");
  add_option(command, "--shader-dir DIR", options->shader_folder,
             "Load the shaders from this folder, and reload them whenever one changes");
  add_option(command, "--exit-after S", options->exit_after_s, "Close the window after this many seconds")
      ->check(number_between(0.0, longest_s, "s"));
  return [options, &command] {
    options->lesson.refuse_contradictions(command);
    return run(*options);
  };
}

}  // namespace ghostforce
