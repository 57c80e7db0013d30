#include "app/files/scene_reader.h"

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/files/scene_keys.h"
#include "app/files/toml_document.h"
#include "core/units.h"

namespace ghostforce {
namespace {

// [x, y] in mm -> m.
std::optional<Vector<2>> read_point(const TomlValue& value) {
  const auto mm = value.numbers<2>({-farthest_mm, farthest_mm, "mm"}, "give a position as [x, y]");
  return mm ? std::optional(Vector<2>((*mm)[0] / mm_per_m, (*mm)[1] / mm_per_m)) : std::nullopt;
}

// How many elements an array has: none where it is wrong, which has been told then.
std::size_t read_count(const TomlValue& value, std::string_view of_what) {
  const std::string remedy = fmt::format("give an array of one or more {}", of_what);
  const std::optional<std::size_t> count = value.count(remedy);
  if (count == 0) value.refuse("is empty", remedy);
  return count.value_or(0);
}

// A value into the scene, one function per kind of key.
struct ValueReader {
  Scene& scene;
  const TomlValue& value;
  NumberLimits limits;

  void operator()(const NumberKey& key) const {
    if (const auto number = value.number(limits)) key.in(scene) = *number / key.per_si;
  }

  void operator()(const OptionalNumberKey& key) const {
    const std::string* const word = key.word_for_empty.empty() ? nullptr : value.as_text();
    if (word == nullptr) {
      key.in(scene) = value.number(limits);
    } else if (*word == key.word_for_empty) {
      key.in(scene) = std::nullopt;
    } else {
      value.refuse(fmt::format("is '{}'", quoted_text(*word)),
                   fmt::format("give '{}' or {}", key.word_for_empty, range_words(limits)));
    }
  }

  void operator()(const TextKey& key) const { key.in(scene) = value.text(key.may_have_lines).value_or(""); }

  void operator()(const ChoiceKey& key) const {
    if (const auto word = value.word(key.words)) key.set(scene, *word);
  }

  void operator()(const PointKey& key) const { key.in(scene) = read_point(value).value_or(Vector<2>(0.0)); }

  void operator()(const PointsKey& key) const {
    const std::size_t count = read_count(value, "positions, [[x, y], …]");
    for (std::size_t i = 0; i < count; ++i) key.in(scene).push_back(read_point(value[i]).value_or(Vector<2>(0.0)));
  }

  void operator()(const TimesKey& key) const {
    std::vector<double>& times = key.in(scene);
    const std::size_t count = read_count(value, "times, [0.0, …]");
    for (std::size_t i = 0; i < count; ++i) {
      const auto time = value[i].number(limits);
      if (!time) return;
      if (times.empty() && *time != 0.0) {
        value[i].refuse(fmt::format("the first time is {} s", *time), "it must be 0");
      } else if (!times.empty() && !(*time > times.back())) {
        value[i].refuse(fmt::format("{} s comes after {} s", *time, times.back()), "times must increase");
      }
      times.push_back(*time);
    }
  }

  void operator()(const NumbersKey& key) const {
    const NumberLimits each{key.range.least, key.range.greatest, limits.unit};
    const std::size_t count = read_count(value, "numbers");
    for (std::size_t i = 0; i < count; ++i) key.in(scene).push_back(value[i].number(each).value_or(each.least));
  }

  void operator()(const RangeKey& key) const {
    const auto ends =
        value.numbers<2>({key.range.least, key.range.greatest, limits.unit}, "give a range as [least, greatest]");
    if (!ends) return;
    const auto [least, greatest] = *ends;
    if (least > greatest) {
      value.refuse(fmt::format("{} {} comes before {} {}", least, limits.unit, greatest, limits.unit),
                   "give the smaller number first");
    }
    key.in(scene) = {least, greatest};
  }
};

// KEY=VALUE, blanks around both allowed.
void read_override(TomlReader& reader, std::string_view argument) {
  const std::size_t equals = argument.find('=');
  const std::string_view name = trimmed(argument.substr(0, equals));
  const SceneKey* const key = find_scene_key(name);
  if (equals == std::string_view::npos || name.empty()) {
    reader.refuse_override(argument, "give KEY=VALUE, for example rendering.k_r_N_per_m=800", "");
  } else if (key == nullptr && name != "format") {
    reader.refuse_override(argument, fmt::format("the key {} is unknown", quoted_text(name)), suggest_scene_key(name));
  } else {
    const bool holds_text = key != nullptr && (std::holds_alternative<TextKey>(key->value) ||
                                               std::holds_alternative<ChoiceKey>(key->value));
    reader.override_key(argument, name, trimmed(argument.substr(equals + 1)), holds_text);
  }
}

}  // namespace

Scene read_scene(std::string_view text, std::string_view shown_path, std::span<const std::string> overrides) {
  Scene scene;
  std::vector<TomlKey> keys{{"", "format", nullptr}};
  for (const SceneKey& key : scene_keys()) {
    const auto read = [&](const TomlValue& value) {
      std::visit(ValueReader{scene, value, limits_of(key).value_or(NumberLimits{.unit = unit_of(key.name)})},
                 key.value);
    };
    keys.push_back({key.table, key.name, read, key.required ? std::optional("") : std::nullopt});
  }
  TomlReader reader(shown_path);
  if (!reader.parse(text)) reader.finish();
  if (reader.is_empty()) {
    reader.refuse("the file is empty", "start it with format = 1, or start from a copy of a shipped scene");
    reader.finish();
  }
  for (const std::string& override : overrides) read_override(reader, override);
  if (!reader.has_known_format()) reader.finish();
  reader.read(keys, [](std::string_view table, std::string_view name) { return suggest_scene_key(table, name); });
  reader.finish();
  if (const std::optional<SceneProblem> problem = find_problem(scene)) {
    reader.find(problem->table, problem->name)->refuse(problem->what, problem->remedy);
    reader.finish();
  }
  return scene;
}

}  // namespace ghostforce
