#include "app/worksheet/worksheet.h"

#include <filesystem>

#include <fmt/format.h>

#include "app/console/quoted.h"
#include "app/console/shell_word.h"
#include "app/lessons/lesson_file.h"
#include "app/paint/vector/vector_painter.h"
#include "app/worksheet/worksheet_picture.h"

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
