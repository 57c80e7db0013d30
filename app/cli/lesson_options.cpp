#include "app/cli/lesson_options.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "app/console/language.h"
#include "app/lessons/lesson_file.h"
#include "app/view/stage/stage_language.h"

namespace ghostforce {

void LessonOptions::attach(CLI::App& command, FileOptions& files, std::string_view usual_language) {
  files.reads(command.add_option("--lesson", name, "A lesson that comes with the program, or the path of one")
                  ->type_name("NAME|FILE"),
              [](const std::string& word) {
                const std::vector<std::string_view> shipped = shipped_lesson_names();
                const bool is_shipped = std::ranges::find(shipped, word) != shipped.end();
                return is_shipped ? std::vector<std::string>{} : std::vector{word};
              });
  std::vector<std::string_view> codes;
  for (const StageLanguage* const each : stage_language_catalog()) codes.push_back(each->code);
  command
      .add_option("--language", language,
                  fmt::format("The language of the stage and of lessons, as two letters: {}; default: {}",
                              fmt::join(codes, " or "), usual_language))
      ->type_name("CODE");
}

std::shared_ptr<const Lesson> LessonOptions::load() const {
  return name.empty() ? nullptr : std::make_shared<const Lesson>(load_lesson(name));
}

std::string LessonOptions::wanted(const std::string& kept) const {
  return wanted_language(language.empty() ? kept : language, locale_variables());
}

}  // namespace ghostforce
