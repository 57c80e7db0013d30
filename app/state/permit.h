// What a person may do at the moment: the one place that asks for lesson, visitor, measurement and what moves the hand.
// Pure; UI thread.
#pragma once

#include <optional>

#include "app/state/action.h"
#include "app/state/stage_language.h"

namespace ghostforce {

// Why not: a sentence for the person, in each language.
using RefusalWords = std::string_view StageLanguage::Refusals::*;
struct Refusal {
  RefusalWords words;
  bool is_told = false;     // on the screen; else nothing happens, as where a key has no meaning
  bool is_problem = false;  // which stays there until it is dismissed
};

// Empty: it is allowed.
std::optional<Refusal> permit(const Session& session, const Action& action);

}  // namespace ghostforce
