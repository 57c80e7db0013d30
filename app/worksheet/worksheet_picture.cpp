#include "app/worksheet/worksheet_picture.h"

#include <optional>
#include <utility>

#include "app/desktop/offscreen.h"
#include "app/files/scene_file.h"
#include "app/paint/vector/vector_painter.h"

namespace ghostforce {
namespace {

// Of the stage's design, which is 720 points high, so that the smallest words of the picture are 9.4 points large.
constexpr double design_height = 720.0;
constexpr double printed_unit = 0.39;  // a point of the design

constexpr double frame_width = 0.8;

std::optional<std::size_t> right_answer_of(const LessonStep& step) {
  switch (step.question) {
    case LessonQuestion::none:
      return std::nullopt;
    case LessonQuestion::choose:
      return step.right_answer + 1;
    case LessonQuestion::guess:
    case LessonQuestion::task:
      return 1;
  }
  return std::nullopt;
}

}  // namespace

Pane worksheet_picture(const std::shared_ptr<const Lesson>& lesson, const std::string& language, WorksheetSide side,
                       const WorksheetPicture& picture) {
  const Vector<2> size = picture.box.extent();
  PictureRequest request;
  request.scene = load_scene(std::string(default_scene_name), {});
  request.appearance = {.theme = &paper(), .scale = printed_unit * design_height / size.y};
  request.language = language;
  request.is_bare = true;
  request.hides_handle = picture.hides_handle;
  LessonPicture shown{.lesson = lesson, .step = picture.step};
  if (side == WorksheetSide::answers) shown.answer = right_answer_of(lesson->steps[picture.step]);
  show_lesson_in(request, std::move(shown));
  // Where there is no handle, nothing can be seen to go round.
  if (picture.hides_handle) request.mode = StageMode::none;
  Pane pane = compose_moment(request, simulate_to_moment(request), size, measure_vector_text).front();
  pane.corner = picture.box.least;
  pane.marks.push_back({Role::grid,
                        {},
                        Box{to_world(pane.camera, Vector<2>(0.5 * frame_width)), size - Vector<2>(frame_width), 0.0,
                            Colour{0, 0, 0, 0}, paper().text, frame_width}});
  return pane;
}

}  // namespace ghostforce
