// Every Action by name, with its fields: what a line of a session says (session_file.h), as docs/sessions.md lists them.
// A new Action has its row in action_text.cpp; one that is missing does not compile. Pure; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "app/state/action.h"

namespace ghostforce {

// Values of one type, as text and back. `value` points to one of them.
struct LineValue {
  std::string (*wanted)();                           // what the text has to be
  std::string (*text)(const void* value);            // without quotes
  bool (*read)(std::string_view text, void* value);  // false: not that; the value stays as it was
};

// A value inside an object.
struct LineField {
  std::string_view name{};
  const LineValue* type = nullptr;
  const void* (*in)(const void* object) = nullptr;

  std::string text(const void* object) const { return type->text(in(object)); }
  bool read(std::string_view text, void* object) const { return type->read(text, const_cast<void*>(in(object))); }
};

struct LineKind {
  static constexpr std::size_t most_fields = 10;

  std::string_view name{};
  std::array<LineField, most_fields> field_places{};
  std::size_t field_count = 0;

  constexpr std::span<const LineField> fields() const { return std::span(field_places).first(field_count); }
};

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
