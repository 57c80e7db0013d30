#include "app/tools/worksheet/worksheet_phrases.h"

#include <algorithm>
#include <array>

namespace ghostforce {
namespace {

constexpr std::array worksheet_phrase_table{
    WorksheetPhrases{.language = "en",
                     .name = "Name",
                     .date = "Date",
                     .answers = "Answers",
                     .open = "Open this lesson on the screen (F5).",
                     .open_own = "Open this lesson on the screen.",
                     .how = "Answer each question here first, then there, and see what happens.",
                     .because = "Because",
                     .draw = "Draw the handle where you think it will come to rest.",
                     .off_by = "On the screen, I was off by",
                     .done = "Done on the screen",
                     .found = "What I found:",
                     .look = "Look at the screen. What do you see?",
                     .try_out = "Try it on the screen. What do you see?",
                     .in_short = "In your own words: what is this lesson about, and why is it so?"},
    WorksheetPhrases{.language = "es",
                     .name = "Nombre",
                     .date = "Fecha",
                     .answers = "Respuestas",
                     .open = "Abre esta lección en la pantalla (F5).",
                     .open_own = "Abre esta lección en la pantalla.",
                     .how = "Responde cada pregunta primero aquí, luego allí, y mira qué pasa.",
                     .because = "Porque",
                     .draw = "Dibuja el mango donde crees que descansará.",
                     .off_by = "En la pantalla me equivoqué en",
                     .done = "Hecho en la pantalla",
                     .found = "Lo que he encontrado:",
                     .look = "Mira la pantalla. ¿Qué ves?",
                     .try_out = "Pruébalo en la pantalla. ¿Qué ves?",
                     .in_short = "Con tus palabras: ¿de qué trata esta lección, y por qué es así?"},
};

}  // namespace

const WorksheetPhrases& worksheet_phrases(std::string_view language) noexcept {
  const auto* const found = std::ranges::find(worksheet_phrase_table, language, &WorksheetPhrases::language);
  return found == worksheet_phrase_table.end() ? worksheet_phrase_table.front() : *found;
}

}  // namespace ghostforce
