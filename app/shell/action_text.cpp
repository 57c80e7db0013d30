#include "app/shell/action_text.h"

#include <cstddef>
#include <variant>

#include "app/files/toml_document.h"

namespace ghostforce {
namespace {

template <typename A, std::size_t i = 0>
constexpr const auto& kind_of() {
  if constexpr (std::is_same_v<A, typename std::tuple_element_t<i, decltype(action_kinds)>::Of>) {
    return std::get<i>(action_kinds);
  } else {
    return kind_of<A, i + 1>();
  }
}

}  // namespace

std::string line_value(std::string_view text) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-._,:/";
  return !text.empty() && text.find_first_not_of(plain) == std::string_view::npos ? std::string(text)
                                                                                  : toml_string(text);
}

std::string action_text(const Action& action) {
  return std::visit([]<typename A>(const A& one) { return kind_text(kind_of<A>(), one); }, action);
}

}  // namespace ghostforce
