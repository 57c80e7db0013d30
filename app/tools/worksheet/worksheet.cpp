#include "app/tools/worksheet/worksheet.h"

#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "app/base/quoted.h"
#include "app/base/shell_word.h"
#include "app/files/scene_file.h"
#include "app/paint/vector/vector_painter.h"
#include "app/shell/desktop/offscreen.h"
#include "app/state/lesson_file.h"
#include "app/tools/worksheet/worksheet_item.h"

namespace ghostforce {
namespace {

// What opens the lesson, each shorter than the one before.
std::vector<std::string> commands_for(const Lesson& lesson) {
  const auto command = [](const std::string& word) {
    return fmt::format("ghostforce run --lesson {}", shell_word(quoted_text(word, longest_path)));
  };
  if (lesson.file.empty()) return {command(lesson.name)};
  return {command(lesson.file), command(std::filesystem::path(lesson.file).filename().string()), "ghostforce"};
}

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

// The stage of a lesson's step, as one that nobody has answered or as the answer leaves it, without what surrounds the
// stage on a screen. Throws what simulate_to_moment() does.
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

}  // namespace

std::vector<std::vector<Pane>> worksheet_of(const std::shared_ptr<const Lesson>& lesson,
                                            const WorksheetChoice& choice) {
  const std::string language(language_in(*lesson, choice.language));
  const WorksheetPhrases& phrases = worksheet_phrases(language);
  const LessonWords& words = words_in(*lesson, language);
  const bool has_answers = choice.side == WorksheetSide::answers;
  const bool is_own = !lesson->file.empty();
  const WorksheetContent content{.title = fmt::format("{:g}  {}{}{}", lesson->number, words.title,
                                                      has_answers ? " – " : "", has_answers ? phrases.answers : ""),
                                 .how = fmt::format("{} {}", is_own ? phrases.open_own : phrases.open, phrases.how),
                                 .footers = commands_for(*lesson),
                                 .items = worksheet_items(*lesson, language, choice.side),
                                 .in_short = has_answers ? words.about : "",
                                 .phrases = phrases,
                                 .side = choice.side};
  std::vector<std::vector<Pane>> pages;
  for (WorksheetPage& page : worksheet_pages(content, choice.paper->size, measure_vector_text)) {
    std::vector<Pane>& panes = pages.emplace_back();
    panes.push_back({Vector<2>(0.0), page.camera, StrategyId::full, std::move(page.marks)});
    for (const WorksheetPicture& picture : page.pictures) {
      panes.push_back(worksheet_picture(lesson, language, choice.side, picture));
    }
  }
  return pages;
}

std::string worksheet_file(std::span<const std::vector<Pane>> pages, const WorksheetPaper& paper_format,
                           std::string_view title) {
  return paint_pdf(pages, paper(), paper_format.size, 1.0, title);
}

}  // namespace ghostforce
