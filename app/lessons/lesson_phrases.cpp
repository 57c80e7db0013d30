#include "app/lessons/lesson_phrases.h"

#include <algorithm>
#include <array>

namespace ghostforce {
namespace {

constexpr std::array phrases{
    LessonPhrases{"en", "English", "of", "Back", "Next", "Show me", "That is my guess", "Finish",
                  "Leave the lesson (Esc)."},
    LessonPhrases{"es", "Español", "de", "Atrás", "Siguiente", "Muéstramelo", "Esa es mi apuesta", "Terminar",
                  "Salir de la lección (Esc)."},
};

}  // namespace

const LessonPhrases& lesson_phrases(std::string_view language) noexcept {
  const auto* const found = std::ranges::find(phrases, language, &LessonPhrases::language);
  return found == phrases.end() ? phrases.front() : *found;
}

}  // namespace ghostforce
