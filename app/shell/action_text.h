// An Action as words: its name and its fields, as docs/sessions.md lists them. Pure; any thread.
#pragma once

#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "app/shell/action_kinds.h"
#include "app/shell/line_text.h"
#include "app/state/action.h"

namespace ghostforce {

// "choose-strategy id=anisotropic slowly=no"
std::string action_text(const Action& action);

// As the value of a field: in quotes where it needs them.
std::string line_value(std::string_view text);

// What kind of value a field of an object has.
template <typename Field, typename Object>
using ValueAt = std::remove_cvref_t<decltype(std::declval<const Field&>().of(std::declval<Object&>()))>;

// Of any object whose fields are listed: the first line of a recorded session is one too.
template <typename Object, typename... Fields>
std::string kind_text(const LineKind<Object, Fields...>& kind, const Object& object) {
  std::string text(kind.name);
  const auto add = [&]<typename Field>(const Field& field) {
    text += fmt::format(" {}={}", field.name, line_value(LineText<ValueAt<Field, Object>>::write(field.of(object))));
  };
  std::apply([&](const auto&... fields) { (add(fields), ...); }, kind.fields);
  return text;
}

}  // namespace ghostforce
