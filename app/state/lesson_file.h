// Lessons as files, and those that come with the program. Files are read strictly, like a scene's; docs/lessons.md
// describes the format. Not for the servo thread.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/read_error.h"
#include "app/state/lesson.h"

namespace ghostforce {

// Of the lessons that come with the program, in the order of their numbers.
std::vector<std::string_view> shipped_lesson_names();
// These lessons in the same order, read once. Immutable, any thread.
const std::vector<std::shared_ptr<const Lesson>>& shipped_lessons();
// "3. TITLE" of one of them, in that language.
std::string numbered_title(std::size_t shipped_lesson, std::string_view language);

// A shipped lesson or a file. Throws ReadError: wrong where there is none, or where its text is wrong; unreadable.
Lesson load_lesson(const std::string& name_or_path);

// `shown_path` is what messages call the file; the lesson is named after it. Throws ReadError(wrong), one line per
// problem:
//     FILE:LINE:COLUMN: the key KEY: what is wrong; what to do
Lesson read_lesson(std::string_view text, std::string_view shown_path);

// That language where the lesson has words in it, else English, else whichever comes first; and these words.
std::string_view language_in(const Lesson& lesson, std::string_view wanted);
const LessonWords& words_in(const Lesson& lesson, std::string_view wanted);

// Those that a person can ask for: the stage's own, and others of these lessons, which must outlive the answer.
std::vector<std::string_view> languages_with(std::span<const std::shared_ptr<const Lesson>> lessons);

}  // namespace ghostforce
