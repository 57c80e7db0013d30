// ghostforce run: the window, live.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "app/application.h"
#include "app/commands/command.h"
#include "app/commands/command_catalog.h"
#include "app/commands/picture_options.h"
#include "app/failure.h"
#include "app/interruption.h"

namespace ghostforce {
namespace {

using Clock = std::chrono::steady_clock;

struct Options {
  SceneOptions scene;
  PictureOptions picture;
  std::string input = "mouse";
  std::optional<double> exit_after_s;
};

double seconds(Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

// Decides how long to wait for the person before the next frame. Displays without vertical sync would otherwise draw as
// fast as they can; a paused window has nothing to show and looks up only now and then.
class FramePacer {
 public:
  void wait(Window& window, bool idle, Clock::time_point frame_began) {
    const double interval_s = idle && frames_to_settle_ == 0 ? idle_s : frame_s;
    const double wait_s = std::max(0.0, interval_s - seconds(Clock::now() - frame_began));
    const Clock::time_point before = Clock::now();
    window.poll(wait_s);
    const bool something_happened = seconds(Clock::now() - before) < 0.9 * wait_s;
    frames_to_settle_ = something_happened ? settling_frames : std::max(0, frames_to_settle_ - 1);
  }

 private:
  static constexpr double frame_s = 1.0 / 60.0;
  static constexpr double idle_s = 0.25;
  // ImGui takes what comes in at once apart, one event a frame.
  static constexpr int settling_frames = 6;
  int frames_to_settle_ = settling_frames;
};

int run(const Options& options) {
  Scene scene = options.scene.load();
  options.picture.apply_strategy(scene);
  const auto scaled = [&](int points) { return static_cast<int>(std::lround(points * options.picture.scale)); };
  Window window({.title = fmt::format("{} · ghostforce", scene.title), .width = scaled(1280), .height = scaled(800)});
  Application application(
      window, {.theme = &options.picture.chosen_theme(), .scale = static_cast<float>(options.picture.scale)}, scene,
      *find_input(options.input));
  application.servo().start();

  FramePacer pacer;
  const Clock::time_point began = Clock::now();
  Clock::time_point last = began;
  while (!window.should_close()) {
    stop_if_interrupted();
    const Clock::time_point now = Clock::now();
    if (options.exit_after_s && seconds(now - began) >= *options.exit_after_s) break;
    application.frame(seconds(now - last));
    last = now;
    pacer.wait(window, application.is_idle(), now);
  }
  return static_cast<int>(ExitCode::done);
}

}  // namespace

std::function<int()> attach_run(CLI::App& subcommand) {
  const auto options = std::make_shared<Options>();
  options->scene.attach(subcommand, false);
  std::vector<std::string_view> inputs;
  for (const InputKind& kind : input_catalog()) inputs.push_back(kind.name);
  subcommand.add_option("--input", options->input, "Who moves the goal: mouse, or the scene's script; default: mouse")
      ->type_name("NAME")
      ->check(one_of(inputs));
  options->picture.attach(subcommand, false);
  subcommand.add_option("--exit-after", options->exit_after_s, "Close the window by itself after so many seconds")
      ->type_name("S")
      ->check(number_between(0.0, 1e6, "s"));
  subcommand.footer(
      "Drag anywhere in the scene: the goal of your hand follows.\n"
      "Keys: 1 2 3 strategy, 0 compare, Space pause, . step, R reset, Alt+R reset all.\n"
      "\n"
      "Examples:\n"
      "  ghostforce run\n"
      "  ghostforce run fig1 --strategy anisotropic --theme projector --scale 1.5\n"
      "  ghostforce run my_scene.toml --input script");
  return [options] { return run(*options); };
}

}  // namespace ghostforce
