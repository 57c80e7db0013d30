#include "app/cli/lesson_options.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "app/console/language.h"
#include "app/lessons/lesson_file.h"

namespace ghostforce {

std::vector<std::string> files_of_lesson(const std::string& word) {
  const std::vector<std::string_view> shipped = shipped_lesson_names();
  const bool is_shipped = std::ranges::find(shipped, word) != shipped.end();
  return is_shipped ? std::vector<std::string>{} : std::vector{word};
}

void attach_language(CLI::App& command, std::string& language) {
  command
      .add_option("--language", language,
                  "The language of lessons, as two letters: en or es; default: the environment's, or en")
      ->type_name("CODE");
}

std::string wanted_lesson_language(const std::string& asked_for) {
  return wanted_language(asked_for, locale_variables());
}

void LessonOptions::attach(CLI::App& command, FileOptions& files) {
  files.reads(command.add_option("--lesson", name, "A lesson that comes with the program, or the path of one")
                  ->type_name("NAME|FILE"),
              files_of_lesson);
  attach_language(command, language);
}

std::shared_ptr<const Lesson> LessonOptions::load() const {
  return name.empty() ? nullptr : std::make_shared<const Lesson>(load_lesson(name));
}

}  // namespace ghostforce
