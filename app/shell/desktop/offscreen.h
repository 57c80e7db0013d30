// A picture of a scene at one moment, or of a step of a lesson, without a window on a display. What `render` writes,
// `check` compares and figures are made of. The same request gives the same picture. What draws is for the main thread
// only (OpenGL offscreen).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/files/image.h"
#include "app/picture/panes.h"
#include "app/picture/trail_history.h"
#include "app/shell/desktop/renderer.h"
#include "app/shell/screen.h"
#include "app/state/session.h"
#include "app/state/set_up.h"
#include "core/hand_estimator.h"
#include "core/loop_energy.h"
#include "core/scene.h"

namespace ghostforce {

// A step of a lesson as a picture, as it stands when nobody has answered it, or after an answer. A value; what is done
// with it is pure, any thread.
struct LessonPicture {
  std::shared_ptr<const Lesson> lesson;  // never null
  std::size_t step = 0;                  // from 0
  // From 1: of a choice the answer's number; of a guess 1 right and 2 wrong; of a task 1 done and 2 given up.
  std::optional<std::size_t> answer{};
};

// How many answers the picture's step can have; 0: it asks nothing.
std::size_t answers_of(const LessonPicture& picture);

// What is wrong with its step or answer, as a sentence; empty: nothing.
std::string find_problem(const LessonPicture& picture);

// Brings the session to that step, at once. Only without problems.
void show_lesson(Session& session, const LessonPicture& picture);

inline constexpr int smallest_picture = 64;  // [px] each way
inline constexpr int largest_picture = 4096;

struct PictureRequest {
  Scene scene;
  std::optional<double> at_s;  // empty: the scene's duration
  int width = 1280;            // [px]
  int height = 800;
  Part part = Part::window;
  Face face = Face::workbench;
  StageMode mode = StageMode::none;  // of the stage
  ViewOptions options{.compare = Compare::active_only};
  Appearance appearance{};
  std::string language{"en"};             // of the stage
  std::optional<LessonPicture> lesson{};  // of the stage
  // Of the stage: the scene alone, without words and buttons round it, and without the ring of a guess: to be printed.
  bool is_bare = false;
  bool hides_handle =
      false;  // with it: nor is there a handle, or what follows from where it is, as while it is guessed
  std::optional<Renderer> renderer{};  // of pixels; empty: the usual one
};

// The word that --strategy and a case file hold: a strategy's name shows that one alone, "all" shows the scene's own
// with the others beside it, in the same picture; empty changes nothing. False where the word is none of these.
bool apply_strategy_word(std::string_view word, PictureRequest& request);

// Makes it the picture of a step: scene, face and mode are as the step has them; what no step has stated yet stays as
// it is. Only for a picture without problems.
void show_lesson_in(PictureRequest& request, LessonPicture lesson);

// The moment: the scene simulated from its beginning. Throws Failure: wrong_call for a moment that cannot be, or where
// the loop is unstable; interrupted.
struct Moment {
  Snapshot snapshot;
  History history;
  std::optional<CircleReading> circle{};  // of Round and round, for which the hand goes round twice
  std::optional<HandEstimate> hand{};     // of measuring the hand, from that moment on
};
Moment simulate_to_moment(const PictureRequest& request);

// What the picture shows, as somebody would have it in the window.
SetUp set_up_of(const PictureRequest& request, const Moment& moment);

// The scene's marks, as a painter of vectors wants them.
std::vector<Pane> compose_moment(const PictureRequest& request, const Moment& moment, const Vector<2>& size,
                                 const MeasureText& measure);

// Drawn by the screen's own code with OpenGL. Throws Failure(no_display).
struct Drawing {
  Image image;
  std::vector<Pane> panes;
  Vector<2> corner;      // of the scene in the picture [points]
  std::string graphics;  // renderer and version of OpenGL
};
Drawing draw_moment(const PictureRequest& request, const Moment& moment);

// The moments of a clip, at even distances from the first time until before the other [s]. `from_s` < `to_s`.
struct ClipTimes {
  double from_s = 0.0;
  double to_s = 0.0;
  int frames_per_second = 30;
};
std::int64_t frame_count(const ClipTimes& times) noexcept;
double time_of_frame(const ClipTimes& times, std::int64_t i) noexcept;

// Draws the scene at each of these moments, from one simulation, and by one screen: like in the window, words and
// panels stay where they are from one picture to the next. The stage's view holds the whole way of the hand. `take`
// gets each picture in turn. `request.at_s` has no meaning here. Throws what simulate_to_moment() and draw_moment()
// throw.
void draw_clip(const PictureRequest& request, const ClipTimes& times, const std::function<void(const Image&)>& take);

// What was drawn, for scripts and tests.
nlohmann::ordered_json describe_picture(const PictureRequest& request, const Moment& moment,
                                        const std::vector<Pane>& panes, const Vector<2>& corner);

// Whether this machine has a renderer.
struct RendererFinding {
  Renderer renderer;
  bool is_there = false;
  bool is_default = false;  // draws where nobody asks for one
  std::string words;        // what draws and its version, or why it cannot and what to install
};

// In the order of the catalog. Each is tried in a process of its own, so that a driver that crashes or hangs does no
// harm, and nothing of it stays. Takes some 50 ms each. Throws nothing but Failure(interrupted). Call it while there is
// one thread.
std::vector<RendererFinding> examine_renderers();

// One line about the renderer that draws where nobody asks for one, "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 (Core
// Profile) Mesa 22.3.6, by egl", or why there is none.
std::string default_renderer_words();

}  // namespace ghostforce
