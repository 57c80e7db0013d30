#include "app/shell/web/page_state.h"

#include <array>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/files/run.h"
#include "app/files/run_reader.h"
#include "app/files/scene_file.h"
#include "app/picture/camera.h"
#include "app/runs/replay.h"
#include "app/shell/web/browser.h"
#include "app/shell/web/page.h"
#include "app/shell/web/page_lesson.h"
#include "app/state/faces_and_modes.h"
#include "app/state/set_up.h"
#include "app/state/set_up_of.h"
#include "core/simulate.h"

namespace ghostforce {
namespace {

using Json = nlohmann::ordered_json;

// In the order of their ids.
constexpr std::array dialog_names{"none",       "help",       "device",           "lessons",
                                  "open",       "save_scene", "save_picture",     "save_clip",
                                  "save_plots", "palette",    "reset_preferences"};
static_assert(dialog_names.size() == static_cast<std::size_t>(Dialog::reset_preferences) + 1);

Json point(const Vector<2>& value) {
  return Json::array({value.x, value.y});
}

Json milliseconds(const FrameTimes& times) {
  return {
      {"median", 1e3 * times.quantile(0.5)}, {"p95", 1e3 * times.quantile(0.95)}, {"worst", 1e3 * times.quantile(1.0)}};
}

}  // namespace

std::string page_state(Page& page) {
  Application& application = page.application();
  const Session& session = application.session();
  const ShownMoment shown = application.shown();
  const auto& active = shown.snapshot.strategies[index_of(session.settings.active)];
  const LoopReading loop = application.reading();
  const HtmlWindow& window = page.window();
  const WindowSize size = window.restored_size();
  const Json json{
      {"ready", page.frames() > 0},
      {"frames", page.frames()},
      {"face", face_name(session.face)},
      {"mode", stage_mode_name(session.stage.mode)},
      {"strategy", strategy_catalog()[index_of(session.settings.active)].name},
      {"theme", shown_theme(session).name},
      {"scale", session.appearance.scale},
      {"reduces_motion", reduces_motion(session)},
      {"language", session.language},
      {"paused", session.paused},
      {"tick", shown.snapshot.tick},
      {"time_s", shown.snapshot.time_s},
      {"rate_hz", loop.rate_hz},
      {"goal_m", point(shown.snapshot.goal)},
      {"device_m", point(active.device)},
      {"proxy_m", point(active.proxy)},
      {"force_N", point(active.force)},
      {"ghost_force_N", point(active.ghost_force)},
      {"input", session.input},
      {"motors", loop.motors.has_motors},
      {"recording", loop.recording.is_on},
      {"dialog", dialog_names[static_cast<std::size_t>(session.dialog)]},
      {"notice", session.notice ? session.notice->words : ""},
      {"lesson", lesson_json(session)},
      {"kiosk", session.kiosk_visit.has_value()},
      {"set_up", set_up_line(set_up_of(session, shown))},
      {"size_px", Json::array({window.pixel_width(), window.pixel_height()})},
      {"density", size.width > 0 ? static_cast<double>(window.pixel_width()) / size.width : 1.0},
      {"renderer", window.can_draw() ? window.graphics_description() : ""},
      {"context_losses", window.context_losses()},
      {"is_visible", browser::is_visible()},
      {"script_ms", milliseconds(page.times().script)},
      {"servo_ms", milliseconds(page.times().servo)},
      {"ready_ms", 1e3 * page.times().ready_s},
  };
  return json.dump();
}

std::string simulated_rows(const std::string& scene_name, const std::string& strategy_name) {
  Scene scene = load_scene(scene_name);
  const std::optional<StrategyId> strategy = find_strategy(strategy_name);
  if (!strategy)
    throw Failure(ExitCode::wrong_call, fmt::format("there is no strategy '{}'", quoted_text(strategy_name)));
  scene.settings.active = *strategy;
  fmt::memory_buffer rows;
  rows.append(run_header(scene));
  simulate(scene, last_tick(scene), [&](const Snapshot& snapshot, const TickState<2>& state) {
    append_run_row(rows, snapshot, *strategy);
    append_efforts(rows, scene.settings, state.strategies[index_of(*strategy)].contact.efforts);
    rows.push_back('\n');
  });
  return fmt::to_string(rows);
}

std::string replayed(const std::string& recording) {
  const Run run = read_run(recording, "recording");
  if (!run.scene) throw Failure(ExitCode::wrong_call, "the recording does not say which scene it belongs to");
  const ReplayReport report = replay(run);
  const Agreement is = agreement(run, report);
  const Json json{{"agrees", is == Agreement::identical || is == Agreement::close},
                  {"is_identical", is == Agreement::identical},
                  {"ticks", report.compared},
                  {"greatest_relative_difference", report.compared > 0 ? report.worst().relative() : 0.0},
                  {"words", report.first ? fmt::format("differs first at t = {} s in {} of {}", report.first->time_s,
                                                       report.first->column, strategy(report.first->strategy).name)
                                         : "identical bit for bit"}};
  return json.dump();
}

Vector<2> on_page(Page& page, const Vector<2>& world) {
  const Screen& screen = page.application().screen();
  const Pane& pane = screen.panes().front();
  const ImVec2 corner = screen.scene_corner();
  return to_screen(pane.camera, world) + pane.corner +
         Vector<2>(static_cast<double>(corner.x), static_cast<double>(corner.y));
}

}  // namespace ghostforce
