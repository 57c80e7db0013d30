// Every Action by name, with its fields: what a line of a session says (session_file.h), as docs/sessions.md lists them.
// A new Action has its row in action_text.cpp; one that is missing or out of order does not compile. Pure; any thread.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/shell/line_text.h"
#include "app/state/action.h"

namespace ghostforce {

struct ActionKind {
  LineKind line;
  Action (*make)();  // with the usual values
};

// In the order of AnyAction.
std::span<const ActionKind> action_kinds() noexcept;

// The object of its kind, for its LineFields.
const void* object_of(const Action& action);
void* object_of(Action& action);

// "choose-strategy id=anisotropic slowly=no"
std::string action_text(const Action& action);
// Of any object whose fields are listed: the first line of a recorded session is one too.
std::string kind_text(const LineKind& kind, const void* object);

// As the value of a field: in quotes where it needs them.
std::string line_value(std::string_view text);

}  // namespace ghostforce
