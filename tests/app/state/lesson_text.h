// A small lesson as a file, for tests that change a part of it.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace ghostforce {

inline constexpr std::string_view small_lesson = R"(format = 1
number = 3.5
hidden = ["slide"]
[[step]]
name     = "press"
set_up   = "ghostforce run wall45 --goal-mm=-10,10 --strategy naive"
controls = ["hand", "strategies"]
slider   = { key = "user.believed_k_u_N_per_m", from = 50, to = 800 }
hidden   = ["numbers", "rest"]
question = "choose"
right    = 2
reveal   = "ghostforce run wall45 --goal-mm=10,-14 --strategy naive"

[[step]]
name     = "cure"
controls = ["hand"]
question = "task"
until    = [{ quantity = "ghost_force_N", at_most = 0.05 }, { quantity = "depth_mm", at_least = 5 }]
with     = "naive"

[[step]]
name      = "guess"
question  = "guess"
within_mm = 4.0

[[step]]
name = "end"

[en]
title = "The ghost"
about = "What a missing motor does to a wall."

[en.press]
text    = "Where does the handle go?"
answers = ["It stays", "It slides"]
right   = "Yes."
wrong   = "No."

[en.cure]
text  = "Cure it."
right = "Done."
wrong = "Like this."

[en.guess]
text  = "Guess."
right = "Near."
wrong = "Far."

[en.end]
text = "The end."

[es]
title = "El fantasma"
about = "Lo que hace un motor que falta."
press = { text = "¿Adónde va?", answers = ["Se queda", "Se desliza"], right = "Sí.", wrong = "No." }
cure  = { text = "Cúralo.", right = "Hecho.", wrong = "Así." }
guess = { text = "Adivina.", right = "Cerca.", wrong = "Lejos." }
end   = { text = "Fin." }
)";

// The lesson with another text in place of one that stands in it.
inline std::string lesson_with(std::string_view in_place_of, std::string_view other) {
  std::string text(small_lesson);
  const std::size_t at = text.find(in_place_of);
  if (at == std::string::npos) throw std::logic_error("not in the lesson: " + std::string(in_place_of));
  return text.replace(at, in_place_of.size(), other);
}

}  // namespace ghostforce
