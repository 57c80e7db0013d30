// What a frame costs: the workbench against an empty ImGui frame and against what ImGui and ImPlot show of themselves, and
// the stage against the workbench, drawn in software into memory.
#include <glad/gl.h>

#include <fmt/format.h>
#include <imgui_internal.h>
#include <implot.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/desktop_inputs.h"
#include "app/files/scene_file.h"
#include "app/shell/desktop/glfw_window.h"
#include "app/shell/preferences.h"
#include "app/shell/screen.h"
#include "bench/support/contest.h"
#include "bench/support/report.h"
#include "core/simulate.h"

namespace ghostforce::bench {
namespace {

constexpr double frame_s = 1.0 / 60.0;
constexpr int width = 1280;
constexpr int height = 720;
constexpr std::string_view empty_frame = "an empty ImGui frame";
constexpr std::string_view demo_frame = "a window as ImGui's and ImPlot's demos";
constexpr std::string_view screen_frame = "the whole workbench";
constexpr std::string_view closed_frame = "the workbench as it opens, without plots";
constexpr std::string_view stage_frame = "the stage";

// ---- What a demo shows ----------------------------------------------------------------------------------------------

struct DemoCurves {
  static constexpr int count = 1001;
  std::vector<double> x, slow, quick, noise;

  DemoCurves() {
    for (int i = 0; i < count; ++i) {
      x.push_back(0.001 * i);
      slow.push_back(0.5 + 0.5 * std::sin(50.0 * (x.back() + 0.1)));
      quick.push_back(x.back() * x.back());
      noise.push_back(0.5 + 0.25 * std::sin(35.0 * x.back()) + 0.05 * std::sin(1234.5 * i * i));
    }
  }
};

void draw_demo_plots(const DemoCurves& curves) {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 size{0.5F * (room.x - ImGui::GetStyle().ItemSpacing.x),
                    0.5F * (room.y - ImGui::GetStyle().ItemSpacing.y)};
  constexpr int count = DemoCurves::count;
  if (ImPlot::BeginPlot("Line plots", size)) {
    ImPlot::SetupAxes("x", "y");
    ImPlot::PlotLine("f(x)", curves.x.data(), curves.slow.data(), count);
    ImPlot::PlotLine("g(x)", curves.x.data(), curves.quick.data(), count);
    ImPlot::EndPlot();
  }
  ImGui::SameLine();
  if (ImPlot::BeginPlot("Shaded plots", size)) {
    ImPlot::SetupAxes("days", "price");
    ImPlot::PlotShaded("stock", curves.x.data(), curves.noise.data(), count);
    ImPlot::PlotLine("stock", curves.x.data(), curves.noise.data(), count);
    ImPlot::EndPlot();
  }
  if (ImPlot::BeginPlot("Scatter plots", size)) {
    ImPlot::PlotScatter("data 1", curves.x.data(), curves.noise.data(), count / 10);
    ImPlot::PlotScatter("data 2", curves.x.data(), curves.slow.data(), count / 20);
    ImPlot::EndPlot();
  }
  ImGui::SameLine();
  if (ImPlot::BeginPlot("Bar plots", size)) {
    constexpr std::array heights{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0};
    ImPlot::PlotBars("vertical", heights.data(), static_cast<int>(heights.size()), 0.7, 1.0);
    ImPlot::EndPlot();
  }
}

void draw_demo_widgets() {
  static std::array<float, 4> colour{0.4F, 0.7F, 0.0F, 0.5F};
  static std::array<char, 32> words{"Hello, world!"};
  static bool is_checked = true;
  static int choice = 0;
  static int whole = 123;
  static float number = 0.001F;
  static float angle = 0.0F;
  if (ImGui::CollapsingHeader("Basic", ImGuiTreeNodeFlags_DefaultOpen)) {
    for (const char* const name : {"Button", "Another", "A third"}) {
      ImGui::Button(name);
      ImGui::SameLine();
    }
    ImGui::Checkbox("checkbox", &is_checked);
    for (int i = 0; i < 3; ++i) {
      if (i > 0) ImGui::SameLine();
      ImGui::RadioButton(fmt::format("radio {}", i).c_str(), &choice, i);
    }
    ImGui::InputText("input text", words.data(), words.size());
    ImGui::InputInt("input int", &whole);
    ImGui::DragFloat("drag float", &number, 0.005F);
    ImGui::SliderInt("slider int", &whole, -1, 300);
    ImGui::SliderFloat("slider float", &number, 0.0F, 1.0F, "ratio = %.3f");
    ImGui::SliderAngle("slider angle", &angle);
    ImGui::ColorEdit4("colour", colour.data());
    ImGui::Combo("combo", &choice, "AAAA\0BBBB\0CCCC\0");
    ImGui::ProgressBar(0.4F);
  }
  if (ImGui::CollapsingHeader("Tables", ImGuiTreeNodeFlags_DefaultOpen) &&
      ImGui::BeginTable("table", 4, ImGuiTableFlags_Borders | ImGuiTableFlags_RowBg)) {
    for (int row = 0; row < 8; ++row) {
      ImGui::TableNextRow();
      for (int column = 0; column < 4; ++column) {
        ImGui::TableSetColumnIndex(column);
        ImGui::Text("Hello %d,%d", column, row);
      }
    }
    ImGui::EndTable();
  }
  if (ImGui::CollapsingHeader("Text", ImGuiTreeNodeFlags_DefaultOpen)) {
    ImGui::TextWrapped(
        "This text should automatically wrap on the edge of the window. The current implementation for text wrapping "
        "follows simple rules suitable for English and possibly other languages.");
    for (int i = 0; i < 6; ++i) ImGui::BulletText("Bullet point %d", i);
  }
}

void draw_demo(const DemoCurves& curves) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float middle = 0.665F * size.x;  // where the screen's own column of panels begins
  ImGui::SetNextWindowPos({0.0F, 0.0F});
  ImGui::SetNextWindowSize({middle, size.y});
  ImGui::Begin("ImPlot demo", nullptr, ImGuiWindowFlags_NoSavedSettings);
  draw_demo_plots(curves);
  ImGui::End();
  ImGui::SetNextWindowPos({middle, 0.0F});
  ImGui::SetNextWindowSize({size.x - middle, size.y});
  ImGui::Begin("ImGui demo", nullptr, ImGuiWindowFlags_NoSavedSettings);
  draw_demo_widgets();
  ImGui::End();
}

// ---- What the program shows -----------------------------------------------------------------------------------------

// A hand that has gone round in and out of the wall for so long, once in every `period_s`, and what is to be seen of
// it.
struct Shown {
  Session session;
  Snapshot snapshot;
  History history;

  Shown(double seconds, double period_s) {
    Scene scene = load_scene("wall45");
    const std::vector<Vector<2>> ends = scene.goal.points;
    scene.goal = {{}, {}};
    // However long it has been: it ends in the same place, so that the moments that are shown differ in their history
    // only.
    const int turns = static_cast<int>(std::lround(seconds / period_s * 16.0));
    for (int turn = 0; turn <= turns; ++turn) {
      const double phase = (turn - turns) * std::numbers::pi / 8.0;
      const Vector<2> reach = 0.5 * (ends.back() - ends.front());
      scene.goal.points.push_back(0.5 * (ends.front() + ends.back()) + reach * std::cos(phase) +
                                  Vector<2>(-reach.y, reach.x) * std::sin(phase));
      scene.goal.times.push_back(turn * period_s / 16.0);
    }
    scene.duration = seconds;
    simulate(scene, last_tick(scene), [this](const Snapshot& tick) {
      history.add(tick);
      snapshot = tick;
    });
    session = session_of(scene);
    session.plots.is_open = true;
    session.plots.to_s = seconds;
    session.has_handles = true;
    session.folded_panels = panels_folded_at_first(height);
  }
};

double clock_s(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Counts the time of this thread's processor between ImGui's NewFrame and its EndFrame: what the program itself does
// for a frame.
class BuildClock {
 public:
  BuildClock() {
    add(ImGuiContextHookType_NewFramePost, [](ImGuiContext*, ImGuiContextHook* hook) {
      static_cast<BuildClock*>(hook->UserData)->began_s_ = processor_s();
    });
    add(ImGuiContextHookType_EndFramePre, [](ImGuiContext*, ImGuiContextHook* hook) {
      auto& clock = *static_cast<BuildClock*>(hook->UserData);
      clock.frames_s_.push_back(processor_s() - clock.began_s_);
    });
  }
  BuildClock(const BuildClock&) = delete;
  BuildClock& operator=(const BuildClock&) = delete;
  ~BuildClock() {
    for (const ImGuiID id : hooks_) ImGui::RemoveContextHook(ImGui::GetCurrentContext(), id);
  }

  // Of the frames since the last call.
  std::vector<double> take_frames() { return std::exchange(frames_s_, {}); }

 private:
  static double processor_s() { return clock_s(CLOCK_THREAD_CPUTIME_ID); }
  void add(ImGuiContextHookType type, ImGuiContextHookCallback callback) {
    ImGuiContextHook hook;
    hook.Type = type;
    hook.Callback = callback;
    hook.UserData = this;
    hooks_.push_back(ImGui::AddContextHook(ImGui::GetCurrentContext(), &hook));
  }

  std::vector<ImGuiID> hooks_;
  double began_s_ = 0.0;
  std::vector<double> frames_s_;
};

// The scene's marks go to OpenGL between NewFrame and EndFrame, where a software renderer begins with them at once.
// While this lives it is told of them and draws none.
class NothingDrawn {
 public:
  NothingDrawn() {
    glad_glDrawArraysInstanced = [](GLenum, GLint, GLsizei, GLsizei) {};
    glad_glClear = [](GLbitfield) {};
  }
  NothingDrawn(const NothingDrawn&) = delete;
  NothingDrawn& operator=(const NothingDrawn&) = delete;
  ~NothingDrawn() {
    glad_glDrawArraysInstanced = draw_;
    glad_glClear = clear_;
  }

 private:
  PFNGLDRAWARRAYSINSTANCEDPROC draw_ = glad_glDrawArraysInstanced;
  PFNGLCLEARPROC clear_ = glad_glClear;
};

class Frames {
 public:
  explicit Frames(int window_height)
      : window_({.title = "bench", .width = width, .height = window_height, .offscreen = true, .takes_mouse = false}),
        screen_(window_, Part::window),
        inputs_(choices_of(desktop_inputs(), false)) {}

  // All draw the same number of pixels, to the last of them.
  Contestant empty() {
    return frames(empty_frame, [this] {
      window_.frame(frame_s, [] {
        glClearColor(1.0F, 1.0F, 1.0F, 1.0F);
        glClear(GL_COLOR_BUFFER_BIT);
      });
    });
  }
  Contestant demo() {
    return frames(demo_frame, [this] {
      window_.frame(frame_s, [this] {
        glClearColor(1.0F, 1.0F, 1.0F, 1.0F);
        glClear(GL_COLOR_BUFFER_BIT);
        draw_demo(curves_);
      });
    });
  }
  Contestant screen(std::string_view name, Shown& shown) {
    return frames(name, [this, &shown] { draw(shown); });
  }
  void draw(Shown& shown) {
    screen_.draw(
        shown.session, [](const Action&) {}, {shown.session.settings, shown.snapshot}, shown.history,
        {.input_title = "mouse", .rate_hz = 1000.0, .inputs = inputs_}, frame_s);
  }

  static void finish() { glFinish(); }

  // The program's own share of a frame, each frame [s].
  std::vector<double> build_times(Shown& shown, int count) {
    const NothingDrawn nothing_drawn;
    BuildClock clock;
    for (int i = 0; i < count; ++i) draw(shown);
    glFinish();
    return clock.take_frames();
  }

 private:
  static Contestant frames(std::string_view name, const std::function<void()>& draw_one) {
    return {std::string(name), [draw_one](std::int64_t calls) {
              for (std::int64_t i = 0; i < calls; ++i) {
                draw_one();
                glFinish();
              }
            }};
  }

  GlfwWindow window_;
  Screen screen_;
  std::vector<InputChoice> inputs_;
  DemoCurves curves_;
};

// The program's own share of a frame, each in turn [s].
struct OwnCode {
  double screen_s = 0.0;
  double closed_s = 0.0;
  double stage_s = 0.0;
};

OwnCode own_code(Frames& frames, Shown& screen, Shown& closed, Shown& stage) {
  constexpr int rounds = 15;
  std::vector<double> screen_s, closed_s, stage_s;
  const auto take = [&](Shown& shown, std::vector<double>& seconds) {
    std::vector<double> times = frames.build_times(shown, 21);
    times.erase(times.begin());  // the face before left its windows
    seconds.push_back(median(std::move(times)));
  };
  for (int round = 0; round < rounds; ++round) {
    take(screen, screen_s);
    take(closed, closed_s);
    take(stage, stage_s);
  }
  return {median(std::move(screen_s)), median(std::move(closed_s)), median(std::move(stage_s))};
}

void add_frames(Report& report) {
  Frames frames(height);
  constexpr double quick_s = 1.0;
  constexpr double slow_s = 4.0;
  Shown shown(8.0, quick_s), quick_short(2.0, quick_s), quick_long(60.0, quick_s), slow_short(2.0, slow_s),
      slow_long(60.0, slow_s), closed(8.0, quick_s), stage(8.0, quick_s);
  closed.session.plots.is_open = false;
  stage.session.face = Face::stage;
  const Contest contest({frames.empty(), frames.demo(), frames.screen(screen_frame, shown),
                         frames.screen(closed_frame, closed), frames.screen(stage_frame, stage),
                         frames.screen("quick, 2 s", quick_short), frames.screen("quick, 60 s", quick_long),
                         frames.screen("slow, 2 s", slow_short), frames.screen("slow, 60 s", slow_long)},
                        {.rounds = 41, .seconds_per_turn = 0.02});
  for (const std::string_view name : {empty_frame, demo_frame, screen_frame, closed_frame, stage_frame}) {
    report.row(fmt::format("{}", name), fmt::format("{:.2f} ms", 1e3 * contest.median_seconds(name)));
  }
  const double to_demo = contest.ratio(screen_frame, demo_frame);
  report.row("the whole workbench, plots open, against the demos' window", fmt::format("{:.2f}", to_demo),
             at_most(to_demo, 2.0));
  report.row("… against an empty frame", fmt::format("{:.2f}", contest.ratio(screen_frame, empty_frame)));
  for (const std::string_view than : {screen_frame, closed_frame}) {
    const double ratio = contest.ratio(stage_frame, than);
    report.row(fmt::format("the stage against {}", than), fmt::format("{:.2f}", ratio), at_most(ratio, 1.0));
  }
  const OwnCode own = own_code(frames, shown, closed, stage);
  report.row("the program's own code, one processor's time, without drawing: the whole workbench",
             fmt::format("{:.3f} ms", 1e3 * own.screen_s), at_most(1e3 * own.screen_s, 0.5, "ms"));
  report.row("… the workbench as it opens", fmt::format("{:.3f} ms", 1e3 * own.closed_s));
  report.row("… the stage", fmt::format("{:.3f} ms", 1e3 * own.stage_s));
  const double own_ratio = own.stage_s / own.closed_s;
  report.row("… the stage against the workbench as it opens", fmt::format("{:.2f}", own_ratio),
             at_most(own_ratio, 1.0));
  for (const std::string_view hand : {"quick", "slow"}) {
    const double ratio = contest.ratio(fmt::format("{}, 60 s", hand), fmt::format("{}, 2 s", hand));
    report.row(fmt::format("a history of 60 s against one of 2 s, both in sight, {} hand", hand),
               fmt::format("{:.2f}", ratio), at_most(ratio, 1.1));
  }
  report.note(
      "Alone, 60 s against 2 s were seen at 1.11 and 1.05 (plots; quick and slow hand: sixty swings are a longer line "
      "than two) and at 1.00 and 1.08 (trails: of the quick hand equally long, of the slow one 375 pieces of line a "
      "strategy against 183). Before the older part of a trail had its straight pieces joined and plots' lines went "
      "from stroke to stroke by the shorter way, both together were 1.14 and 1.19, the latter with 0.05 for another "
      "moment of the slow hand's motion.");
  report.note(
      "Of the program's own code three quarters were axes that put into words ticks for which they had no room: "
      "without that, with shorter trails and with labels that look only at what is near them it fell from 1.75 to 0.43 "
      "ms.");
}

// As while somebody drags its ring: another set-up in each frame.
void add_landscape(Report& report) {
  constexpr int landscape_height = 800;
  Frames frames(landscape_height);
  Shown shown(8.0, 1.0);
  shown.session.face = Face::stage;
  shown.session.stage.mode = StageMode::landscape;
  frames.draw(shown);
  int drawn = 0;
  std::vector<double> processor_s;
  const auto drag = [&](std::int64_t calls) {
    const double before_s = clock_s(CLOCK_PROCESS_CPUTIME_ID);
    for (std::int64_t i = 0; i < calls; ++i) {
      const double phase = 0.05 * ++drawn;
      const LandscapePoint point{0.25 * std::numbers::pi * (1.0 + 0.9 * std::sin(phase)), 10.0 + 9.0 * std::cos(phase)};
      shown.session.settings = with_landscape_point(shown.session.settings, point);
      frames.draw(shown);
      Frames::finish();
    }
    processor_s.push_back((clock_s(CLOCK_PROCESS_CPUTIME_ID) - before_s) / static_cast<double>(calls));
  };
  const Contest contest({{"drag", drag}}, {.rounds = 41, .seconds_per_turn = 0.1});
  const double per_second = 1.0 / contest.median_seconds("drag");
  report.row("the landscape at 1280×800 while its ring is dragged", fmt::format("{:.0f} maps/s", per_second),
             at_least(per_second, 30.0, "maps/s"));
  report.row("… processor time of a map, all threads", fmt::format("{:.1f} ms", 1e3 * median(processor_s)));
}

}  // namespace

int run(int argc, char** argv) {
  Report report("4. Frames");
  report.paragraph(
      "1280×720 into memory, drawn by llvmpipe to the last pixel, in one process and one OpenGL context, in turn. The "
      "demos' window is as large and shows four plots (lines of 1001 points, an area, points, bars) and a column of "
      "widgets; the workbench shows the scene with all trails, the plots over time and the panels; the stage the same "
      "moment. The "
      "program's own code is what runs between ImGui's NewFrame and EndFrame, in processor time of its thread.");
  add_frames(report);
  add_landscape(report);
  return report.finish(argc, argv);
}

}  // namespace ghostforce::bench
