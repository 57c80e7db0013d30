#include "app/cli/lesson_options.h"

#include <algorithm>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/console/language.h"
#include "app/lessons/lesson_file.h"

namespace ghostforce {

void LessonOptions::attach(CLI::App& command, FileOptions& files) {
  files.reads(command.add_option("--lesson", name, "A lesson that comes with the program, or the path of one")
                  ->type_name("NAME|FILE"),
              [](const std::string& word) {
                const std::vector<std::string_view> shipped = shipped_lesson_names();
                const bool is_shipped = std::ranges::find(shipped, word) != shipped.end();
                return is_shipped ? std::vector<std::string>{} : std::vector{word};
              });
  command
      .add_option("--language", language,
                  "The language of lessons, as two letters: en or es; default: the environment's, or en")
      ->type_name("CODE");
}

std::shared_ptr<const Lesson> LessonOptions::load() const {
  return name.empty() ? nullptr : std::make_shared<const Lesson>(load_lesson(name));
}

std::string LessonOptions::wanted(const std::string& kept) const {
  return wanted_language(language.empty() ? kept : language, locale_variables());
}

}  // namespace ghostforce
