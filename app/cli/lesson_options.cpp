#include "app/cli/lesson_options.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "app/console/language.h"
#include "app/lessons/lesson_file.h"
#include "app/view/stage/stage_language.h"

namespace ghostforce {

std::vector<std::string> files_of_lesson(const std::string& word) {
  const std::vector<std::string_view> shipped = shipped_lesson_names();
  const bool is_shipped = std::ranges::find(shipped, word) != shipped.end();
  return is_shipped ? std::vector<std::string>{} : std::vector{word};
}

void attach_language(CLI::App& command, std::string& language, std::string_view usual_language) {
  std::vector<std::string_view> codes;
  for (const StageLanguage* const each : stage_language_catalog()) codes.push_back(each->code);
  command
      .add_option("--language", language,
                  fmt::format("The language of the stage and of lessons, as two letters: {}; default: {}",
                              fmt::join(codes, " or "), usual_language))
      ->type_name("CODE");
}

std::string language_wanted(const std::string& asked_for, const std::string& kept) {
  return wanted_language(asked_for.empty() ? kept : asked_for, locale_variables());
}

void LessonOptions::attach(CLI::App& command, FileOptions& files, std::string_view usual_language) {
  files.reads(command.add_option("--lesson", name, "A lesson that comes with the program, or the path of one")
                  ->type_name("NAME|FILE"),
              files_of_lesson);
  attach_language(command, language, usual_language);
}

std::shared_ptr<const Lesson> LessonOptions::load() const {
  return name.empty() ? nullptr : std::make_shared<const Lesson>(load_lesson(name));
}

}  // namespace ghostforce
