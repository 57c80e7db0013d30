#include "app/shell/desktop/offscreen.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <exception>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/quoted.h"
#include "app/files/descriptor.h"
#include "app/files/run.h"
#include "app/paint/file_painter.h"
#include "app/shell/desktop/glfw_window.h"
#include "app/shell/desktop/opengl_window.h"
#include "app/shell/preferences.h"
#include "app/stage/stage_face.h"
#include "app/state/apply.h"
#include "app/state/lesson_guide.h"
#include "app/state/mode_changes.h"
#include "app/state/set_up_of.h"
#include "app/state/stiffness_probe_guide.h"
#include "core/conventions.h"
#include "core/divergence.h"
#include "core/hand_measurement.h"
#include "core/scene_shape.h"
#include "core/simulate.h"
#include "ghostforce_version.h"

namespace ghostforce {
namespace {

std::int64_t tick_at(const Scene& scene, const std::optional<double>& at_s) {
  if (!at_s) return last_tick(scene);
  const double tick = *at_s * scene.settings.rate;
  if (tick >= 0.0 && tick <= most_ticks) return std::llround(tick);
  throw Failure(ExitCode::wrong_call, fmt::format("the moment {} s cannot be shown; give a time from 0 to {} s", *at_s,
                                                  most_ticks / scene.settings.rate));
}

nlohmann::ordered_json describe_pane(const Pane& pane, const Vector<2>& corner) {
  const Camera& camera = pane.camera;
  const Vector<2> at = corner + pane.corner;
  nlohmann::ordered_json description;
  description["camera"] = {{"center_mm", {camera.center.x * mm_per_m, camera.center.y * mm_per_m}},
                           {"points_per_mm", camera.points_per_metre / mm_per_m},
                           {"size", {camera.size.x, camera.size.y}},
                           {"corner", {at.x, at.y}}};
  description["marks"] = marks_as_json(pane.marks);
  return description;
}

// The hand of the scene goes round the circle, twice once it is on it.
void go_round(Scene& scene, const Circle& circle) {
  constexpr int corners_per_turn = 400;
  constexpr int turns = 2;
  const double turn_s = 1.0 / std::abs(circle.turns_per_second);
  GoalPath path{.points = {circle.center}, .times = {0.0}};
  for (int i = 0; i <= corners_per_turn * turns; ++i) {
    const double on_circle_s = turn_s * i / corners_per_turn;
    path.points.push_back(position_on(circle, on_circle_s));
    path.times.push_back(circle_begins_s + on_circle_s);
  }
  scene.duration = path.times.back();
  scene.goal = std::move(path);
}

Session session_of(const PictureRequest& request, const Moment& moment) {
  Session session = session_of(request.scene);
  session.options = request.options;
  session.appearance = request.appearance;
  session.pointer_moves_goal = false;
  session.input = scripted_hand.name;
  session.goal = request.scene.goal.points.back();
  session.stage_shown = stage_view_of(session.settings, std::array{moment.snapshot.goal}, reference_force_of(session));
  session.time_s = moment.snapshot.time_s;
  session.face = request.face;
  session.language = request.language;
  if (request.mode != StageMode::none) apply(session, ToggleMode{request.mode});
  if (request.mode == StageMode::why) session.stage.why_step = last_why_step;
  if (request.lesson) show_lesson(session, *request.lesson);
  if (moment.hand) show_stiffness_probe(session, *moment.hand);
  if (request.is_bare) session.stage.guess.reset();
  if (request.hides_handle) {
    session.stage.mode = StageMode::predict;
    session.stage.guess_is_open = true;
  }
  return session;
}

ShownMoment shown_moment(const Scene& scene, const Settings& settings, const Moment& moment) {
  return {settings_at(scene, settings, moment.snapshot.time_s), moment.snapshot};
}

LoopReading loop_of(const PictureRequest& request, const Moment& moment) {
  return {.input_title = scripted_hand.title,
          .rate_hz = request.scene.settings.rate,
          .inputs = std::span(&scripted_hand, 1),
          .circle = moment.circle};
}

// Up to that tick; on_tick(const Moment&) is called after each.
template <typename OnTick>
Moment simulate_moments(const PictureRequest& request, const std::optional<double>& until_s, OnTick&& on_tick) {
  Moment moment;
  Scene scene = request.scene;
  std::optional<CircleEnergyMeter> meter;
  if (request.mode == StageMode::round) {
    const Circle circle = circle_inside(
        wall_near(scene.settings, scene.goal.points.back()), scene.goal.points.back(),
        {.radius = {}, .is_clockwise = makes_energy_clockwise(flattened(scene.settings, scene.goal.points.back()))});
    go_round(scene, circle);
    meter.emplace();
    meter->start(scene.settings, circle);
  }
  const bool is_looked_back_at = request.mode == StageMode::ribbon || meter;
  std::optional<Failure> other_ran_away;  // told where the active one does not
  simulate(scene, tick_at(scene, until_s), [&](const Snapshot& snapshot) {
    if (snapshot.tick % ticks_between_looks == 0) stop_if_interrupted();
    const StrategyId active = scene.settings.active;
    if (has_diverged(snapshot.strategies[index_of(active)])) throw unstable_loop(active, snapshot.time_s);
    if (other_ran_away) return;
    if (const auto id = diverged_strategy(snapshot)) {
      other_ran_away = unstable_loop(*id, snapshot.time_s);
      return;
    }
    if (is_looked_back_at) {
      moment.history.add(snapshot, scene.settings);
    } else {
      moment.history.add(snapshot);
    }
    if (meter) {
      meter->add(snapshot);
      moment.circle = meter->reading();
    }
    moment.snapshot = snapshot;
    on_tick(moment);
  });
  if (other_ran_away) throw *other_ran_away;
  // A lesson's step waits for whoever does it.
  if (request.mode == StageMode::measure && !request.lesson) {
    moment.hand = measure_simulated_hand(scene, moment.snapshot.time_s, StiffnessProbe::gives_up_after_s);
  }
  return moment;
}

// One that shows every place of the hand in these times.
SceneView stage_view_of(const Scene& scene, const ClipTimes& times) {
  std::vector<Vector<2>> goals;
  for (std::int64_t i = 0; i < frame_count(times); ++i) goals.push_back(goal_at(scene.goal, time_of_frame(times, i)));
  return stage_view_of(scene.settings, goals, reference_force_of(scene.settings, scene.goal.points.back()));
}

}  // namespace

bool apply_strategy_word(std::string_view word, PictureRequest& request) {
  if (word.empty()) return true;
  if (word == every_strategy) {
    request.options.compare = Compare::overlay;
    return true;
  }
  const auto id = find_strategy(word);
  if (!id) return false;
  request.scene.settings.active = *id;
  request.options.compare = Compare::active_only;
  return true;
}

void show_lesson_in(PictureRequest& request, LessonPicture lesson) {
  Session session = session_of(request.scene);
  show_lesson(session, lesson);
  request.scene.settings = session.settings;
  request.scene.goal.points.back() = session.goal;
  request.face = Face::stage;
  request.mode = session.stage.mode;
  request.lesson = std::move(lesson);
}

Moment simulate_to_moment(const PictureRequest& request) {
  return simulate_moments(request, request.at_s, [](const Moment&) {});
}

SetUp set_up_of(const PictureRequest& request, const Moment& moment) {
  return set_up_of(session_of(request, moment), {request.scene.settings, moment.snapshot});
}

std::vector<Pane> compose_moment(const PictureRequest& request, const Moment& moment, const Vector<2>& size,
                                 const MeasureText& measure) {
  if (request.face == Face::stage) {
    const Session session = session_of(request, moment);
    const ShownMoment shown = shown_moment(request.scene, request.scene.settings, moment);
    return {StageFace()
                .still(session, {.shown = shown,
                                 .history = moment.history,
                                 .loop = loop_of(request, moment),
                                 .theme = *request.appearance.theme,
                                 .measure = measure,
                                 .size = size,
                                 .scale = request.appearance.scale,
                                 .is_bare = request.is_bare,
                                 .has_controls = request.part == Part::window})
                .pane};
  }
  return compose_panes({.settings = shown_moment(request.scene, request.scene.settings, moment).settings,
                        .snapshot = moment.snapshot,
                        .history = moment.history,
                        .theme = *request.appearance.theme,
                        .options = request.options,
                        .shown = request.scene.view,
                        .size = size,
                        .scale = request.appearance.scale,
                        .arrow_scale = request.appearance.arrow_scale,
                        .measure = measure});
}

namespace {

WindowOptions offscreen_window(const PictureRequest& request) {
  return {.title = "ghostforce",
          .width = request.width,
          .height = request.height,
          .offscreen = true,
          .renderer = request.renderer,
          .takes_mouse = false};
}

// A panel of ImGui knows its size one frame after its content. Nobody sees the frames before the last.
void draw_settled(Window& window, Screen& screen, Session& session, const PictureRequest& request,
                  const Moment& moment) {
  constexpr int frames_to_settle = 3;
  for (int i = 0; i < frames_to_settle; ++i) {
    window.set_visible_drawing(i + 1 == frames_to_settle);
    screen.draw(
        session, [](const Action&) {}, shown_moment(request.scene, session.settings, moment), moment.history,
        loop_of(request, moment), 0.0);
  }
}

}  // namespace

Drawing draw_moment(const PictureRequest& request, const Moment& moment) {
  Session session = session_of(request, moment);
  session.folded_panels = panels_folded_at_first(request.height / request.appearance.scale);
  GlfwWindow window(offscreen_window(request));
  Screen screen(window, request.part);
  draw_settled(window, screen, session, request, moment);
  stop_if_interrupted();
  const ImVec2 corner = screen.scene_corner();
  return {window.picture(),
          screen.panes(),
          {static_cast<double>(corner.x), static_cast<double>(corner.y)},
          window.graphics_description()};
}

std::int64_t frame_count(const ClipTimes& times) noexcept {
  constexpr double rounding = 1e-6;  // of an interval
  return static_cast<std::int64_t>(std::ceil((times.to_s - times.from_s) * times.frames_per_second - rounding));
}

double time_of_frame(const ClipTimes& times, std::int64_t i) noexcept {
  return times.from_s + static_cast<double>(i) / times.frames_per_second;
}

void draw_clip(const PictureRequest& request, const ClipTimes& times, const std::function<void(const Image&)>& take) {
  std::optional<Session> session;
  GlfwWindow window(offscreen_window(request));
  Screen screen(window, request.part);
  const std::int64_t count = frame_count(times);
  std::int64_t drawn = 0;
  const auto draw_next = [&](const Moment& moment) {
    if (drawn == 0) {
      session = session_of(request, moment);
      session->folded_panels = panels_folded_at_first(request.height / request.appearance.scale);
      session->stage_shown = stage_view_of(request.scene, times);
      draw_settled(window, screen, *session, request, moment);
    } else {
      session->time_s = moment.snapshot.time_s;
      screen.draw(
          *session, [](const Action&) {}, shown_moment(request.scene, session->settings, moment), moment.history,
          loop_of(request, moment), 1.0 / times.frames_per_second);
    }
    ++drawn;
    stop_if_interrupted();
    take(window.picture());
  };
  simulate_moments(request, time_of_frame(times, count - 1), [&](const Moment& moment) {
    while (drawn < count && moment.snapshot.tick == tick_at(request.scene, time_of_frame(times, drawn))) {
      draw_next(moment);
    }
  });
}

nlohmann::ordered_json describe_picture(const PictureRequest& request, const Moment& moment,
                                        const std::vector<Pane>& panes, const Vector<2>& corner) {
  nlohmann::ordered_json picture;
  picture["version"] = version;
  picture["scene"] = request.scene.title;
  picture["t_s"] = moment.snapshot.time_s;
  picture["strategy"] = strategy(request.scene.settings.active).name;
  if (request.face == Face::stage) {
    picture["view"] = face_name(request.face);
    if (request.mode != StageMode::none) picture["mode"] = stage_mode_name(request.mode);
    if (request.lesson) {
      picture["lesson"] = request.lesson->lesson->name;
      picture["step"] = request.lesson->step + 1;
    }
    if (request.lesson || request.language != english_stage.code) picture["language"] = request.language;
    if (request.lesson && request.lesson->answer) picture["answer"] = *request.lesson->answer;
  } else {
    picture["compare"] = compare_name(request.options.compare);
  }
  if (panes.size() == 1) {
    picture.update(describe_pane(panes.front(), corner));
    return picture;
  }
  for (const Pane& pane : panes) {
    nlohmann::ordered_json description;
    description["strategy"] = strategy(pane.active).name;
    description.update(describe_pane(pane, corner));
    picture["panes"].push_back(std::move(description));
  }
  return picture;
}

std::size_t answers_of(const LessonPicture& picture) {
  switch (picture.lesson->steps[picture.step].question) {
    case LessonQuestion::none:
      return 0;
    case LessonQuestion::choose:
      return picture.lesson->words.begin()->second.steps[picture.step].answers.size();
    case LessonQuestion::guess:
    case LessonQuestion::task:
      return 2;
  }
  return 0;
}

std::string find_problem(const LessonPicture& picture) {
  const std::string name = quoted_text(picture.lesson->name, longest_path);
  const std::size_t steps = picture.lesson->steps.size();
  if (picture.step >= steps) return fmt::format("the lesson {} has {} steps; give 1 to {}", name, steps, steps);
  const std::size_t answers = answers_of(picture);
  if (!picture.answer || (*picture.answer >= 1 && *picture.answer <= answers)) return {};
  if (answers == 0) return fmt::format("step {} of {} asks nothing; leave out the answer", picture.step + 1, name);
  return fmt::format("step {} of {} has {} answers; give 1 to {}", picture.step + 1, name, answers, answers);
}

void show_lesson(Session& session, const LessonPicture& picture) {
  begin_lesson(session, picture.lesson);
  show_lesson_step(session, picture.step);
  if (picture.answer) settle_in_lesson(session, *picture.answer - 1);
  session.stage_shown = stage_view_of(session);
  session.fits_view = false;  // it stands there at once
}

namespace {

constexpr unsigned int longest_trial_s = 20;

constexpr char is_there_mark = '+';
constexpr char is_absent_mark = '-';

// A mark, then words.
std::string tried(Renderer renderer) {
  try {
    const OpenGlWindow window({.title = "", .width = 64, .height = 64, .offscreen = true}, renderer);
    return is_there_mark + Window::graphics_description();
  } catch (const std::exception& failure) {
    return std::string(1, is_absent_mark) + failure.what();
  }
}

// What drivers print is nobody's concern here.
[[noreturn]] void try_as_child(Renderer renderer, int out) {
  alarm(longest_trial_s);
  if (const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0) {
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
  }
  const std::string words = tried(renderer);
  const ssize_t written = write(out, words.data(), words.size());  // a pipe takes that much at once
  _exit(written == static_cast<ssize_t>(words.size()) ? 0 : 1);
}

std::string read_to_end(int in) {
  std::string text;
  std::array<char, 4096> piece{};
  for (;;) {
    wait_to_read(in);
    const ssize_t count = read(in, piece.data(), piece.size());
    if (count > 0) text.append(piece.data(), static_cast<std::size_t>(count));
    if (count == 0 || (count < 0 && errno != EINTR)) return text;
  }
}

// It has said everything, or nobody waits for it any more.
struct EndOfChild {
  pid_t child;
  ~EndOfChild() {
    kill(child, SIGKILL);
    while (waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
};

RendererFinding examine(Renderer renderer) {
  RendererFinding finding{.renderer = renderer, .words = "this system lets the program start no other process"};
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return finding;
  const Descriptor read_end(ends[0]);
  const pid_t child = fork();
  if (child == 0) try_as_child(renderer, ends[1]);
  close(ends[1]);
  if (child < 0) return finding;
  const EndOfChild end{child};
  const std::string answer = read_to_end(read_end.number());
  finding.is_there = answer.starts_with(is_there_mark);
  finding.words = answer.empty() ? "its driver crashes or hangs" : answer.substr(1);
  return finding;
}

}  // namespace

std::vector<RendererFinding> examine_renderers() {
  std::vector<RendererFinding> findings;
  for (const RendererEntry& entry : renderer_catalog()) findings.push_back(examine(entry.renderer));
  const auto chosen = std::ranges::find_if(findings, [](const RendererFinding& finding) {
    return finding.is_there && entry_of(finding.renderer).is_tried_unasked;
  });
  if (chosen != findings.end()) chosen->is_default = true;
  return findings;
}

std::string default_renderer_words() {
  std::vector<std::string> problems;
  for (const RendererEntry& entry : renderer_catalog()) {
    if (!entry.is_tried_unasked) continue;
    const RendererFinding finding = examine(entry.renderer);
    if (finding.is_there) return fmt::format("{}, by {}", finding.words, entry.name);
    problems.push_back(fmt::format("{}: {}", entry.name, finding.words));
  }
  return fmt::format("none; {}", fmt::join(problems, "; "));
}

}  // namespace ghostforce
