#include "app/state/lesson_file.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "app/base/quoted.h"
#include "app/files/named_text.h"
#include "app/state/lesson_reader.h"
#include "app/state/stage_language.h"
#include "embedded_lessons.h"

namespace ghostforce {

std::vector<std::string_view> shipped_lesson_names() {
  return names_of_texts(embedded_lessons);
}

Lesson load_lesson(const std::string& name_or_path) {
  Lesson lesson = read_lesson(named_text(name_or_path, "lesson", embedded_lessons), name_or_path);
  if (find_text(embedded_lessons, name_or_path) != nullptr) return lesson;
  lesson.file = name_or_path;
  std::error_code error;  // without a working folder the path is as it was named
  const std::filesystem::path path = std::filesystem::absolute(name_or_path, error);
  lesson.path = quoted_text(error ? name_or_path : path.lexically_normal().string(), longest_path);
  return lesson;
}

Lesson read_lesson(std::string_view text, std::string_view shown_path) {
  LessonReader reader(shown_path);
  Lesson lesson = reader.read(text);
  lesson.name = std::filesystem::path(shown_path).stem().string();
  return lesson;
}

std::string_view language_in(const Lesson& lesson, std::string_view wanted) {
  for (const std::string_view each : {wanted, std::string_view("en")}) {
    if (lesson.words.contains(std::string(each))) return lesson.words.find(std::string(each))->first;
  }
  return lesson.words.begin()->first;
}

const LessonWords& words_in(const Lesson& lesson, std::string_view wanted) {
  return lesson.words.at(std::string(language_in(lesson, wanted)));
}

std::vector<std::string_view> languages_with(std::span<const std::shared_ptr<const Lesson>> lessons) {
  std::vector<std::string_view> codes;
  for (const StageLanguage* const each : stage_languages) codes.push_back(each->code);
  for (const auto& lesson : lessons) {
    for (const auto& [code, words] : lesson->words) {
      if (std::ranges::find(codes, code) == codes.end()) codes.push_back(code);
    }
  }
  return codes;
}

const std::vector<std::shared_ptr<const Lesson>>& shipped_lessons() {
  static const std::vector<std::shared_ptr<const Lesson>> lessons = [] {
    std::vector<std::shared_ptr<const Lesson>> list;
    for (const std::string_view name : shipped_lesson_names()) {
      list.push_back(std::make_shared<const Lesson>(load_lesson(std::string(name))));
    }
    return list;
  }();
  return lessons;
}

std::string numbered_title(std::size_t shipped_lesson, std::string_view language) {
  return fmt::format("{}. {}", shipped_lesson + 1, words_in(*shipped_lessons().at(shipped_lesson), language).title);
}

}  // namespace ghostforce
