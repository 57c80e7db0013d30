// A value of a recorded session's line as text, and back: what kinds of values Actions have, and the fields made of
// them. What has a name is written by it, numbers in the shortest form that reads back exactly. Pure; any thread.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/quoted.h"
#include "app/base/shell_word.h"
#include "app/base/typed_text.h"
#include "app/state/action.h"

namespace ghostforce {

inline constexpr std::string_view no_value = "none";

// --- What has names ---

template <typename Id>
struct LineChoice {
  Id id;
  std::string_view name;
};
template <typename Id>
using LineChoices = std::vector<LineChoice<Id>>;

template <typename Id, typename Catalog>
LineChoices<Id> choices_from(const Catalog& catalog) {
  LineChoices<Id> choices;
  for (const auto& entry : catalog) choices.push_back({entry.id, entry.name});
  return choices;
}

inline LineChoices<StrategyId> choices_of(std::type_identity<StrategyId>) {
  return choices_from<StrategyId>(strategy_catalog());
}
inline LineChoices<ScenePart> choices_of(std::type_identity<ScenePart>) {
  return choices_from<ScenePart>(scene_part_catalog);
}
inline LineChoices<MotorsInUse> choices_of(std::type_identity<MotorsInUse>) {
  return choices_from<MotorsInUse>(motors_in_use_catalog);
}
inline LineChoices<Face> choices_of(std::type_identity<Face>) {
  return choices_from<Face>(face_catalog);
}
inline LineChoices<Compare> choices_of(std::type_identity<Compare>) {
  return choices_from<Compare>(compare_catalog());
}
inline LineChoices<StageMode> choices_of(std::type_identity<StageMode>) {
  auto choices = choices_from<StageMode>(stage_mode_catalog());
  choices.push_back({StageMode::none, no_value});
  return choices;
}
inline LineChoices<const Theme*> choices_of(std::type_identity<const Theme*>) {
  LineChoices<const Theme*> choices;
  for (const Theme& theme : theme_catalog()) choices.push_back({&theme, theme.name});
  return choices;
}
inline LineChoices<PlotTab> choices_of(std::type_identity<PlotTab>) {
  LineChoices<PlotTab> choices;
  for (const PlotTab tab : {PlotTab::time, PlotTab::wall_angle, PlotTab::ratio, PlotTab::hand})
    choices.push_back({tab, plot_tab_name(tab)});
  return choices;
}
inline LineChoices<bool> choices_of(std::type_identity<bool>) {
  return {{false, "no"}, {true, "yes"}};
}
inline LineChoices<bool ViewOptions::*> choices_of(std::type_identity<bool ViewOptions::*>) {
  return {{&ViewOptions::ghost_forces, "ghost-forces"},
          {&ViewOptions::predictions, "predictions"},
          {&ViewOptions::trails, "trails"}};
}
constexpr std::string_view dialog_name(Dialog dialog) noexcept {
  switch (dialog) {
    case Dialog::none:
      return no_value;
    case Dialog::help:
      return "help";
    case Dialog::doctor:
      return "doctor";
    case Dialog::lessons:
      return "lessons";
    case Dialog::open_scene:
      return "open-scene";
    case Dialog::save_scene:
      return "save-scene";
    case Dialog::save_picture:
      return "save-picture";
    case Dialog::save_clip:
      return "save-clip";
    case Dialog::save_plots:
      return "save-plots";
    case Dialog::palette:
      return "palette";
    case Dialog::reset_preferences:
      return "reset-preferences";
  }
  return no_value;
}
inline LineChoices<Dialog> choices_of(std::type_identity<Dialog>) {
  LineChoices<Dialog> choices;
  for (int i = 0; i <= static_cast<int>(Dialog::reset_preferences); ++i)
    choices.push_back({static_cast<Dialog>(i), dialog_name(static_cast<Dialog>(i))});
  return choices;
}
inline LineChoices<BeliefSource> choices_of(std::type_identity<BeliefSource>) {
  return {{BeliefSource::typed, "typed"}, {BeliefSource::measured, "measured"}, {BeliefSource::live, "live"}};
}
inline LineChoices<ScreenMotion> choices_of(std::type_identity<ScreenMotion>) {
  return {{ScreenMotion::as_system, "as-system"}, {ScreenMotion::full, "full"}, {ScreenMotion::reduced, "reduced"}};
}
inline LineChoices<SpaceMouseSettings::Mode> choices_of(std::type_identity<SpaceMouseSettings::Mode>) {
  return {{SpaceMouseSettings::Mode::position, "position"}, {SpaceMouseSettings::Mode::rate, "speed"}};
}
inline LineChoices<SpaceMouseSettings::Up> choices_of(std::type_identity<SpaceMouseSettings::Up>) {
  return {{SpaceMouseSettings::Up::lift, "lifting"}, {SpaceMouseSettings::Up::push_away, "pushing-away"}};
}

template <typename T>
concept Named = requires {
  choices_of(std::type_identity<T>{});
};

// --- A value, as text and back; `wanted` says what it has to be ---

template <typename T>
struct LineText;

template <Named T>
struct LineText<T> {
  static std::string wanted() {
    return fmt::format("one of {}", listed(names_of(choices_of(std::type_identity<T>{}))));
  }
  static std::string write(const T& value) {
    const auto choices = choices_of(std::type_identity<T>{});
    return std::string(std::ranges::find(choices, value, &LineChoice<T>::id)->name);
  }
  static std::optional<T> read(std::string_view text) {
    const auto choices = choices_of(std::type_identity<T>{});
    const auto found = std::ranges::find(choices, text, &LineChoice<T>::name);
    return found == choices.end() ? std::nullopt : std::optional(found->id);
  }
};

template <>
struct LineText<double> {
  static std::string wanted() { return "a number"; }
  static std::string write(double value) { return fmt::format("{}", value); }
  static std::optional<double> read(std::string_view text) {
    const std::optional<double> value = number_in<double>(text);
    return value && std::isnan(*value) ? std::nullopt : value;
  }
};

template <std::integral T>
requires(!std::same_as<T, bool>) struct LineText<T> {
  static std::string wanted() { return "a whole number"; }
  static std::string write(T value) { return fmt::format("{}", value); }
  static std::optional<T> read(std::string_view text) { return number_in<T>(text); }
};

template <>
struct LineText<std::string> {
  static std::string wanted() { return "a text"; }
  static std::string write(const std::string& value) { return value; }
  static std::optional<std::string> read(std::string_view text) { return std::string(text); }
};

template <>
struct LineText<Vector<2>> {
  static std::string wanted() { return "two numbers with a comma between them"; }
  static std::string write(const Vector<2>& value) { return fmt::format("{},{}", value.x, value.y); }
  static std::optional<Vector<2>> read(std::string_view text) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const auto x = LineText<double>::read(text.substr(0, comma));
    const auto y = LineText<double>::read(text.substr(std::min(comma + 1, text.size())));
    return x && y ? std::optional(Vector<2>(*x, *y)) : std::nullopt;
  }
};

template <>
struct LineText<ZoomView::Place> {
  static std::string wanted() { return "two numbers and a strategy, with commas between them"; }
  static std::string write(const ZoomView::Place& place) {
    return fmt::format("{},{}", LineText<Vector<2>>::write(place.at), LineText<StrategyId>::write(place.pane));
  }
  static std::optional<ZoomView::Place> read(std::string_view text) {
    const std::size_t comma = std::min(text.rfind(','), text.size());
    const auto at = LineText<Vector<2>>::read(text.substr(0, comma));
    const auto pane = LineText<StrategyId>::read(text.substr(std::min(comma + 1, text.size())));
    return at && pane ? std::optional(ZoomView::Place{*at, *pane}) : std::nullopt;
  }
};

template <>
struct LineText<std::vector<std::string>> {
  static std::string wanted() { return "one or more words, quoted as for a shell"; }
  static std::string write(const std::vector<std::string>& paths) {
    std::vector<std::string> words;
    for (const std::string& path : paths) words.push_back(shell_word(path));
    return fmt::format("{}", fmt::join(words, " "));
  }
  static std::optional<std::vector<std::string>> read(std::string_view text) {
    ShellWords split = split_shell_words(text);
    if (!split.problem.empty() || split.words.empty()) return std::nullopt;
    return std::move(split.words);
  }
};

template <typename T>
struct LineText<std::optional<T>> {
  static std::string wanted() { return fmt::format("{}, or {}", LineText<T>::wanted(), no_value); }
  static std::string write(const std::optional<T>& value) {
    return value ? LineText<T>::write(*value) : std::string(no_value);
  }
  static std::optional<std::optional<T>> read(std::string_view text) {
    using Read = std::optional<std::optional<T>>;
    if (text == no_value) return Read(std::in_place);
    std::optional<T> value = LineText<T>::read(text);
    return value ? Read(std::in_place, std::move(value)) : std::nullopt;
  }
};

// --- An object by its fields ---

// Values of one type, as text and back. `value` points to one of them.
struct LineValue {
  std::string (*wanted)();                           // what the text has to be
  std::string (*text)(const void* value);            // without quotes
  bool (*read)(std::string_view text, void* value);  // false: not that; the value stays as it was
};

// A value inside an object. `object` points to one of the type that the field was made for (line_field_of).
struct LineField {
  std::string_view name{};
  const LineValue* type = nullptr;
  const void* (*value_in)(const void* object) = nullptr;

  std::string text(const void* object) const { return type->text(value_in(object)); }
  // The value is part of the object, which may be changed.
  bool read(std::string_view text, void* object) const { return type->read(text, const_cast<void*>(value_in(object))); }
};

struct LineKind {
  static constexpr std::size_t most_fields = 10;  // the first line of a session

  std::string_view name{};
  std::array<LineField, most_fields> field_places{};
  std::size_t field_count = 0;

  constexpr std::span<const LineField> fields() const { return std::span(field_places).first(field_count); }
};

template <typename T>
inline constexpr LineValue line_value_of{
    .wanted = &LineText<T>::wanted,
    .text = [](const void* value) { return LineText<T>::write(*static_cast<const T*>(value)); },
    .read =
        [](std::string_view text, void* value) {
          auto read = LineText<T>::read(text);
          if (read) *static_cast<T*>(value) = *std::move(read);
          return read.has_value();
        }};

// The members that lead to a value.
template <auto... path>
struct LinePath {
  std::string_view name;
};

template <auto... path>
constexpr LinePath<path...> line_field(std::string_view name) {
  return {name};
}

template <typename Object, auto... path>
constexpr LineField line_field_of(LinePath<path...> field) {
  using Value = std::remove_cvref_t<decltype((std::declval<Object&>().*....*path))>;
  return {field.name, &line_value_of<Value>,
          [](const void* object) -> const void* { return &((*static_cast<const Object*>(object)).*....*path); }};
}

template <typename Object>
constexpr LineKind line_kind(std::string_view name, auto... fields) {
  return {name, {line_field_of<Object>(fields)...}, sizeof...(fields)};
}

}  // namespace ghostforce
