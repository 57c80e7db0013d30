#include "app/state/lesson_progress.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "app/files/kept_file.h"
#include "app/files/xdg_folders.h"

namespace ghostforce {
namespace {

KeptFile progress_file() {
  const std::filesystem::path folder = state_folder();
  return {.path = folder.empty() ? folder : folder / "lessons.toml",
          .contents = "the progress in lessons is",
          .comment = "what has been done of each lesson. Delete this file to begin anew.",
          .without = "no lesson counts as begun"};
}

// Keys of a newer program are left alone.
bool ignore_key(std::string_view, const TomlValue&) {
  return true;
}

LessonRecord read_record(const TomlValue& table) {
  LessonRecord record;
  const auto read_right = [&](const TomlValue& names) {
    const std::size_t count = names.count("give a list of steps").value_or(0);
    for (std::size_t i = 0; i < count; ++i) {
      if (auto name = names[i].text()) record.right.insert(std::move(*name));
    }
  };
  table.read_table(
      std::array{TomlKey{"", "farthest",
                         [&](const TomlValue& value) {
                           const auto number = value.number({.least = 1.0, .greatest = 1e6, .whole = true});
                           if (number) record.farthest = static_cast<std::size_t>(*number) - 1;
                         }},
                 TomlKey{"", "right", read_right}, TomlKey{"", "finished", yes_or_no_into(record.is_finished)}},
      ignore_key);
  return record;
}

}  // namespace

const std::string& progress_key(const Lesson& lesson) noexcept {
  return lesson.path.empty() ? lesson.name : lesson.path;
}

std::string progress_words(const Lesson& lesson, const LessonProgress& progress, const StageLanguage::Picker& words) {
  const auto found = progress.lessons.find(progress_key(lesson));
  if (found == progress.lessons.end()) return filled(words.steps, lesson.steps.size());
  const LessonRecord& record = found->second;
  const auto right =
      std::ranges::count_if(lesson.steps, [&](const LessonStep& step) { return record.right.contains(step.name); });
  if (record.is_finished) {
    const auto asked = std::ranges::count_if(
        lesson.steps, [](const LessonStep& step) { return step.question != LessonQuestion::none; });
    return std::string(words.done) + (right == 0 ? "" : " · " + filled(words.right_of, right, asked));
  }
  // How many there are is not said before the end: those to come are no wrong ones.
  const std::string score = right == 0 ? "" : " · " + filled(words.right, right);
  return filled(words.step, std::min(record.farthest + 1, lesson.steps.size()), lesson.steps.size()) + score;
}

void merge(LessonProgress& into, const LessonProgress& other) {
  for (const auto& [key, record] : other.lessons) {
    LessonRecord& merged = into.lessons[key];
    merged.farthest = std::max(merged.farthest, record.farthest);
    merged.right.insert(record.right.begin(), record.right.end());
    merged.is_finished = merged.is_finished || record.is_finished;
  }
}

LessonProgress load_lesson_progress(std::vector<std::string>& remarks) {
  LessonProgress progress;
  const auto read_lessons = [&](const TomlValue& lessons) {
    lessons.read_table({}, [&](std::string_view name, const TomlValue& table) {
      progress.lessons.emplace(name, read_record(table));
      return true;
    });
  };
  const bool is_usable = load(
      progress_file(),
      [&](TomlReader& reader) {
        reader.whole().read_table(std::array{TomlKey{"", "lesson", read_lessons}}, ignore_key);
      },
      remarks);
  return is_usable ? progress : LessonProgress{};
}

void save(const LessonProgress& progress) {
  std::string text;
  for (const auto& [name, record] : progress.lessons) {
    std::string right;
    for (const std::string& step : record.right) {
      right += right.empty() ? "" : ", ";
      right += toml_string(step);
    }
    text += fmt::format("\n[lesson.{}]\nfarthest = {}\nright = [{}]\nfinished = {}\n", toml_string(name),
                        record.farthest + 1, right, record.is_finished);
  }
  save(progress_file(), text);
}

ProgressKeeper::ProgressKeeper(LessonProgress progress) : kept_(std::move(progress)) {}

void ProgressKeeper::keep(const LessonProgress& progress) {
  if (progress == kept_) return;
  const LessonProgress before = std::exchange(kept_, progress);
  LessonProgress both = progress;
  merge(both, before);
  if (both != progress) {
    forgets_ = true;
    unsaved_ = progress;
  } else {
    for (const auto& [key, record] : progress.lessons) {
      const auto old = before.lessons.find(key);
      if (old == before.lessons.end() || old->second != record) unsaved_.lessons[key] = record;
    }
  }
  std::vector<std::string> problems;
  LessonProgress stored = forgets_ ? LessonProgress{} : load_lesson_progress(problems);
  // A file that has been damaged meanwhile is aside now, and what this window knows of it takes its place.
  merge(stored, problems.empty() ? unsaved_ : kept_);
  save(stored);
  unsaved_ = {};
  forgets_ = false;
}

}  // namespace ghostforce
