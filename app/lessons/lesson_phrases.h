// The words round a lesson that are the program's own: buttons, how far one has come. One row for each language. Immutable,
// any thread.
#pragma once

#include <string_view>

namespace ghostforce {

struct LessonPhrases {
  std::string_view language;
  std::string_view own_name;  // of the language
  std::string_view of;        // "3 of 8"
  std::string_view back;
  std::string_view next;
  std::string_view show;    // of the answer to a question that is open
  std::string_view answer;  // what a guess is given with
  std::string_view finish;
  std::string_view leave;
};

// English for a language that has no row.
const LessonPhrases& lesson_phrases(std::string_view language) noexcept;

}  // namespace ghostforce
