// What a person may do at the moment: the one place that asks for lesson, visitor, measurement and what moves the hand.
// Pure; UI thread.
#pragma once

#include <optional>
#include <string_view>

#include "app/state/action.h"

namespace ghostforce {

// Why not, as a sentence for the person.
struct Refusal {
  std::string_view words;
  bool is_told = false;     // on the screen; else nothing happens, as where a key has no meaning
  bool is_problem = false;  // which stays there until it is dismissed
};

// Empty: it is allowed.
std::optional<Refusal> permit(const Session& session, const Action& action);

}  // namespace ghostforce
