#include "app/cli/lesson_options.h"

#include <algorithm>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/base/did_you_mean.h"
#include "app/base/failure.h"
#include "app/base/language.h"
#include "app/base/quoted.h"
#include "app/state/lesson_file.h"

namespace ghostforce {

std::vector<std::string> files_of_lesson(const std::string& word) {
  const std::vector<std::string_view> shipped = shipped_lesson_names();
  const bool is_shipped = std::ranges::find(shipped, word) != shipped.end();
  return is_shipped ? std::vector<std::string>{} : std::vector{word};
}

void attach_language(CLI::App& command, std::string& language, std::string_view usual_language) {
  command
      .add_option("--language", language,
                  fmt::format("The language of the stage and of lessons, as two letters: {}, or another that the "
                              "lesson has; default: {}",
                              listed(languages_with({})), usual_language))
      ->type_name("CODE")
      ->check(suggests(languages_with({})));
}

std::string language_wanted(const std::string& asked_for, const std::string& kept,
                            std::span<const std::shared_ptr<const Lesson>> lessons) {
  if (!asked_for.empty()) {
    const std::string problem = not_one_of(asked_for, languages_with(lessons));
    if (!problem.empty()) throw Failure(ExitCode::wrong_call, fmt::format("--language: {}", problem));
  }
  return wanted_language(asked_for.empty() ? kept : asked_for, locale_variables());
}

void LessonOptions::attach(CLI::App& command, FileOptions& files, std::string_view usual_language) {
  files.reads(command.add_option("--lesson", name, "A lesson that comes with the program, or the path of one")
                  ->type_name("NAME|FILE")
                  ->check(suggests(shipped_lesson_names())),
              files_of_lesson);
  attach_language(command, language, usual_language);
}

std::string LessonOptions::wanted(const std::string& kept, const std::shared_ptr<const Lesson>& lesson) const {
  return language_wanted(language, kept, std::span(&lesson, lesson ? 1 : 0));
}

std::shared_ptr<const Lesson> LessonOptions::load() const {
  return name.empty() ? nullptr : std::make_shared<const Lesson>(load_lesson(name));
}

}  // namespace ghostforce
