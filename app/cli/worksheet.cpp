// ghostforce worksheet: lessons on paper, to be answered with a pen; and their answers, for the teacher.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/progress.h"
#include "app/base/quoted.h"
#include "app/cli/command.h"
#include "app/cli/lesson_options.h"
#include "app/cli/option.h"
#include "app/files/output_file.h"
#include "app/paint/vector/vector_painter.h"
#include "app/state/lesson_file.h"
#include "app/tools/worksheet/worksheet.h"

namespace ghostforce {
namespace {

constexpr const char* worksheet_language = "en";

struct WorksheetOptions {
  std::vector<std::string> lessons;  // empty: all that come with the program
  std::string output;
  bool has_answers = false;
  std::string language;  // empty: the usual one, so that the same call gives the same bytes everywhere
  std::string paper{worksheet_paper_catalog.front().name};
};

void refuse_what_is_no_pdf(const std::string& output) {
  if (output == "-" || vector_format_of(output) == VectorFormat::pdf) return;
  throw Failure(ExitCode::wrong_call, fmt::format("-o {}: a worksheet is a PDF; give a name that ends in .pdf",
                                                  quoted_text(output, longest_path)));
}

std::vector<std::shared_ptr<const Lesson>> lessons_of(const WorksheetOptions& options) {
  std::vector<std::string> names = options.lessons;
  if (names.empty()) {
    for (const std::string_view name : shipped_lesson_names()) names.emplace_back(name);
  }
  std::vector<std::shared_ptr<const Lesson>> lessons;
  for (const std::string& name : names) lessons.push_back(std::make_shared<const Lesson>(load_lesson(name)));
  return lessons;
}

// One lesson's title, or the program's name for several.
std::string title_of(const std::vector<std::shared_ptr<const Lesson>>& lessons, const WorksheetChoice& choice) {
  if (lessons.size() > 1) return "ghostforce";
  return words_in(*lessons.front(), choice.language).title;
}

int worksheet(const WorksheetOptions& options) {
  refuse_what_is_no_pdf(options.output);
  const std::vector<std::shared_ptr<const Lesson>> lessons = lessons_of(options);
  const WorksheetChoice choice{
      .language = language_wanted(options.language, worksheet_language, lessons),
      .paper = &*std::ranges::find(worksheet_paper_catalog, options.paper, &WorksheetPaper::name),
      .side = options.has_answers ? WorksheetSide::answers : WorksheetSide::questions};
  OutputFile file(options.output);
  std::vector<std::vector<Pane>> pages;
  {
    Progress progress("drawing", static_cast<std::int64_t>(lessons.size()), !file.is_terminal());
    std::int64_t done = 0;
    for (const auto& lesson : lessons) {
      stop_if_interrupted();
      for (std::vector<Pane>& page : worksheet_of(lesson, choice)) pages.push_back(std::move(page));
      progress.at(++done);
    }
  }
  file.write(worksheet_file(pages, *choice.paper, title_of(lessons, choice)));
  file.commit();
  return static_cast<int>(ExitCode::done);
}

}  // namespace

std::function<int()> attach_worksheet(CLI::App& command, FileOptions& files) {
  const auto options = std::make_shared<WorksheetOptions>();
  files.reads(add_option(command, "LESSON", options->lessons,
                         "Lessons that come with the program, or paths of others; default: all that come with it")
                  ->check(suggests(shipped_lesson_names())),
              path_unless_one_of(shipped_lesson_names()));
  files.writes(add_option(command, "-o,--output FILE.pdf", options->output,
                          "The PDF to write, whole or not at all; - is standard output")
                   ->required());
  command.add_flag("--answers", options->has_answers, "Make the pages with the answers instead, for the teacher");
  attach_language(command, options->language, worksheet_language);
  add_option(command, "--paper SIZE", options->paper, "a4 or letter; default: a4")
      ->check(one_of(names_of(worksheet_paper_catalog)));
  return [options] { return worksheet(*options); };
}

}  // namespace ghostforce
