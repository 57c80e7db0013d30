// ghostforce replay-session: what a person did in the window, once more, before their eyes or without a display.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/progress.h"
#include "app/base/quoted.h"
#include "app/base/words.h"
#include "app/cli/command.h"
#include "app/cli/desktop_inputs.h"
#include "app/cli/option.h"
#include "app/paint/vector/vector_file_painter.h"
#include "app/shell/desktop/glfw_window.h"
#include "app/shell/session_replay.h"

namespace ghostforce {
namespace {

struct ReplaySessionOptions {
  std::string session;
  bool is_headless = false;
};

// As fast as it can.
std::string play_unseen(SessionReplay& replay, double end_s) {
  Progress progress("replaying", static_cast<std::int64_t>(end_s / SessionReplay::frame_s), true);
  std::int64_t frame = 0;
  do {
    stop_if_interrupted();
    replay.step();
    progress.at(++frame);
  } while (!replay.is_over());
  return replay.result();
}

// In its own time; then the picture stays until the window is closed. Returns the result at the end of the session, or
// where somebody has closed it.
std::string play_in_window(SessionReplay& replay, const Application& application, Window& window) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point began = Clock::now();
  std::string result;
  say("A replay: you only watch. Close the window to end it.\n");
  while (!window.should_close()) {
    stop_if_interrupted();
    replay.step();
    if (result.empty() && replay.is_over()) {
      result = replay.result();
      say("This is the end of the session. Everything is yours now, until you close the window.\n");
    }
    const double passed_s = std::chrono::duration<double>(Clock::now() - began).count();
    window.poll(std::max(0.0, application.clock_s() - passed_s));
  }
  return result.empty() ? replay.result() : result;
}

int replay_session(const ReplaySessionOptions& options) {
  const std::string shown = quoted_text(options.session, longest_path);
  const RecordedSession session = load_session(options.session);
  const SessionStart& start = session.start;
  const Scene scene = SessionReplay::scene_of(start, shown);
  ApplicationOptions application_options = SessionReplay::options_for(start, simulated_inputs());
  application_options.painter = cairo_file_painter();
  if (application_options.input != start.input) {
    say("{}: the hand was at '{}', which is not in the file; it is replayed with the mouse\n", shown,
        quoted_text(start.input));
  }
  GlfwWindow window({.title = fmt::format("{} · replayed", window_title(scene)),
                     .width = start.width,
                     .height = start.height,
                     .offscreen = options.is_headless,
                     .fits_monitor = true});
  if (options.is_headless) window.set_visible_drawing(false);
  Application application(window, scene, application_options);
  SessionReplay replay(application, session);
  const std::string result =
      options.is_headless ? play_unseen(replay, session.end_s) : play_in_window(replay, application, window);
  application.stop();
  print(result);
  if (const std::size_t left_out = replay.counts().left_out; left_out > 0) {
    say("{}: {} of {} actions left out: a replay writes and copies nothing, records nothing, leaves the window as it "
        "is, and has no device\n",
        shown, left_out, session.actions.size());
  }
  return static_cast<int>(ExitCode::done);
}

}  // namespace

std::function<int()> attach_replay_session(CLI::App& command, FileOptions& files) {
  const auto options = std::make_shared<ReplaySessionOptions>();
  files.reads(
      add_option(command, "SESSION", options->session, "A file from 'ghostforce run --record-session'")->required());
  command.add_flag("--headless", options->is_headless,
                   "Without a display and as fast as it goes; the result is the line that is printed");
  return [options] { return replay_session(*options); };
}

}  // namespace ghostforce
