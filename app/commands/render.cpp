// ghostforce render: the picture of a scene at one moment, drawn offscreen by the same screen as the window's.
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/commands/command_catalog.h"
#include "app/commands/picture_options.h"
#include "app/failure.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "app/paint/json_painter.h"
#include "app/png_file.h"
#include "app/printable.h"
#include "app/screen.h"
#include "core/play.h"
#include "core/sound_state.h"
#include "ghostforce_version.h"

namespace ghostforce {
namespace {

constexpr int smallest_size = 64;
constexpr int largest_size = 4096;

struct Options {
  SceneOptions scene;
  PictureOptions picture;
  std::string output;
  std::string json;
  std::optional<double> at_s;
  std::string size = "1280x800";
  std::string part = "window";
};

struct Size {
  int width;
  int height;
};

Size parse_size(const std::string& text) {
  Size size{0, 0};
  char rest = '\0';
  const bool good = std::sscanf(text.c_str(), "%5dx%5d%c", &size.width, &size.height, &rest) == 2;
  const auto fits = [](int length) { return length >= smallest_size && length <= largest_size; };
  if (good && fits(size.width) && fits(size.height)) return size;
  throw Failure(ExitCode::wrong_call, fmt::format("--size {}: want WIDTHxHEIGHT in pixels, each {} to {}, for example "
                                                  "1280x800",
                                                  printable(text), smallest_size, largest_size));
}

std::int64_t tick_at(const Scene& scene, const std::optional<double>& at_s) {
  if (!at_s) return last_tick(scene);
  const double tick = *at_s * scene.settings.rate;
  if (tick >= 0.0 && tick <= most_ticks) return std::llround(tick);
  throw Failure(ExitCode::wrong_call,
                fmt::format("--at {}: want a time from 0 to {} s", *at_s, most_ticks / scene.settings.rate));
}

nlohmann::ordered_json describe_picture(const Session& session, const Snapshot& snapshot, const Screen& screen) {
  const Camera& camera = screen.camera();
  nlohmann::ordered_json picture;
  picture["version"] = version;
  picture["scene"] = session.scene.title;
  picture["t_s"] = snapshot.time_s;
  picture["strategy"] = strategy(session.settings.active).name;
  picture["compare"] = session.compare == Compare::overlay ? "overlay" : "active_only";
  picture["camera"] = {{"center_mm", {camera.center.x * 1000.0, camera.center.y * 1000.0}},
                       {"points_per_mm", camera.points_per_metre / 1000.0},
                       {"size", {camera.size.x, camera.size.y}},
                       {"corner", {screen.scene_corner().x, screen.scene_corner().y}}};
  picture["marks"] = marks_as_json(screen.marks());
  return picture;
}

// Two files of one name would be one file, and the picture lost.
void refuse_equal_outputs(const Options& options) {
  if (options.json.empty() ||
      std::filesystem::weakly_canonical(options.json) != std::filesystem::weakly_canonical(options.output)) {
    return;
  }
  throw Failure(ExitCode::wrong_call,
                fmt::format("--json {}: the picture goes there already; name another file", printable(options.json)));
}

int render(const Options& options) {
  refuse_equal_outputs(options);
  const Size size = parse_size(options.size);
  Scene scene = options.scene.load();
  options.picture.apply_strategy(scene);
  Session session = session_of(scene);
  session.compare = options.picture.compare();
  session.pointer_moves_goal = false;

  OutputFile picture_file(options.output);
  std::optional<OutputFile> json_file;
  if (!options.json.empty()) json_file.emplace(options.json);

  History history;
  Snapshot now;
  const TickState<2> state = play(session.scene, tick_at(session.scene, options.at_s), [&](const Snapshot& snapshot) {
    history.add(snapshot);
    now = snapshot;
    if (snapshot.tick % 1024 == 0) stop_if_interrupted();
  });

  if (!is_sound(state)) {
    throw Failure(
        ExitCode::wrong_call,
        "there is nothing to draw: with these settings the sampled loop is unstable and the device runs away; "
        "lower k_r_N_per_m, or raise rate_hz, mass_kg or damping_N_s_per_m");
  }

  Window window(
      {.title = "ghostforce", .width = size.width, .height = size.height, .offscreen = true, .takes_mouse = false});
  Screen screen(window, {.part = options.part == "scene" ? Part::scene : Part::window,
                         .theme = &options.picture.chosen_theme(),
                         .scale = static_cast<float>(options.picture.scale)});
  // A panel of ImGui knows its size one frame after its content.
  constexpr int frames_to_settle = 3;
  for (int i = 0; i < frames_to_settle; ++i) {
    screen.draw(session, now, history, {.input_title = "Scripted hand", .rate_hz = session.settings.rate});
  }
  stop_if_interrupted();
  picture_file.write(png_bytes(window.picture()));
  if (json_file) json_file->write(describe_picture(session, now, screen).dump(1) + "\n");
  picture_file.commit();
  if (json_file) json_file->commit();
  return static_cast<int>(ExitCode::done);
}

}  // namespace

std::function<int()> attach_render(CLI::App& subcommand) {
  const auto options = std::make_shared<Options>();
  options->scene.attach(subcommand, true);
  subcommand
      .add_option("-o,--output", options->output, "The PNG file to write, all or nothing; - is the standard output")
      ->type_name("FILE")
      ->required();
  subcommand.add_option("--at", options->at_s, "The moment to show [s]; default: the scene's duration")
      ->type_name("T")
      ->check(number_between(0.0, 1e6, "s"));
  subcommand.add_option("--size", options->size, "Pixels, 64 to 4096 each way; default: 1280x800")->type_name("WxH");
  subcommand
      .add_option("--part", options->part, "window: scene, panels and bars; scene: the scene alone; default: window")
      ->type_name("PART")
      ->check(one_of({"window", "scene"}));
  options->picture.attach(subcommand, true);
  subcommand.add_option("--json", options->json, "Also write what was drawn, as JSON")->type_name("FILE");
  subcommand.footer(
      "Drawn offscreen: no display is needed, and the same call gives the same bytes.\n"
      "\n"
      "Examples:\n"
      "  ghostforce render wall45 -o wall45.png\n"
      "  ghostforce render fig3-normal --strategy all --part scene --size 1600x1200 --scale 2 -o figure.png");
  return [options] { return render(*options); };
}

}  // namespace ghostforce
