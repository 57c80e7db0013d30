#include "app/files/scene_keys.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "app/base/number.h"
#include "app/base/quoted.h"
#include "app/base/typed_text.h"

namespace ghostforce {
namespace {

// "table.name" → table and name.
std::pair<std::string_view, std::string_view> split(std::string_view dotted) noexcept {
  const std::size_t dot = dotted.find('.');
  if (dot == std::string_view::npos) return {{}, dotted};
  return {dotted.substr(0, dot), dotted.substr(dot + 1)};
}

SceneKeys all_keys() {
  SceneKeys all;
  for (const SceneKey& key : scene_keys()) all.push_back(&key);
  return all;
}

std::vector<std::string_view> names_in(std::string_view table, const SceneKeys& keys) {
  std::vector<std::string_view> names;
  for (const SceneKey* const key : keys) {
    if (key->table == table) names.push_back(key->name);
  }
  return names;
}

// Dotted: of the same name in another table first, then of what is near in this one, in all, and but for the table.
std::optional<std::string> nearest_scene_key(std::string_view table, std::string_view name, const SceneKeys& keys) {
  const std::vector<std::string_view> here = names_in(table, keys);
  std::vector<std::string_view> names;
  std::vector<std::string> dotted;
  for (const SceneKey* const key : keys) {
    names.push_back(key->name);
    dotted.push_back(dotted_name(*key));
  }
  const auto whole = [&](std::string_view found) {
    return dotted[static_cast<std::size_t>(std::ranges::find(names, found) - names.begin())];
  };
  if (std::ranges::find(names, name) != names.end()) return whole(name);
  if (const auto near = nearest_name(name, here)) return dotted_name(table, *near);
  const std::vector<std::string_view> all(dotted.begin(), dotted.end());
  if (const auto near = nearest_name(dotted_name(table, name), all)) return std::string(*near);
  if (const auto near = nearest_name(name, names)) return whole(*near);
  return std::nullopt;
}

std::string ask(std::string_view key) {
  return fmt::format("; did you mean '{}'?", key);
}

// A word of format 2 may decide which other keys there are: it is left to TOML.
bool set_word(Scene& scene, const SceneKey& key, std::string_view word) {
  if (const auto* const number = std::get_if<OptionalNumberKey>(&key.value)) {
    if (number->word_for_empty != word) return false;
    number->in(scene) = std::nullopt;
    return true;
  }
  const auto* const choice = std::get_if<ChoiceKey>(&key.value);
  if (choice == nullptr || key.format != 1) return false;
  const auto chosen = std::ranges::find(choice->words, word);
  if (chosen == choice->words.end()) return false;
  choice->set(scene, static_cast<std::size_t>(chosen - choice->words.begin()));
  return true;
}

bool set_number_of(Scene& scene, const SceneKey& key, std::string_view text) {
  const std::optional<NumberLimits> limits = limits_of(key);
  const std::optional<double> number = limits ? read_number(text) : std::nullopt;
  if (!number || !(*number >= limits->least && *number <= limits->greatest)) return false;
  if (limits->whole && *number != std::trunc(*number)) return false;
  set_number(scene, key, *number);
  return true;
}

// "[A, B]"
std::optional<std::array<double, 2>> pair_in(std::string_view text, double least, double greatest) {
  const std::size_t comma = text.find(", ");
  if (comma == std::string_view::npos || !text.starts_with('[') || !text.ends_with(']')) return std::nullopt;
  const std::optional<double> first = read_number(text.substr(1, comma - 1));
  const std::optional<double> second = read_number(text.substr(comma + 2, text.size() - comma - 3));
  const auto is_within = [&](const std::optional<double>& number) {
    return number && *number >= least && *number <= greatest;
  };
  return is_within(first) && is_within(second) ? std::optional(std::array{*first, *second}) : std::nullopt;
}

std::optional<Vector<2>> point_in(std::string_view text) {
  const auto mm = pair_in(text, -farthest_mm, farthest_mm);
  return mm ? std::optional(Vector<2>((*mm)[0] / mm_per_m, (*mm)[1] / mm_per_m)) : std::nullopt;
}

// "[[X, Y], [X, Y]]" into as many points as there are.
bool set_points(std::span<Vector<2>> points, std::string_view text) {
  if (text.size() < 2 || !text.starts_with('[') || !text.ends_with(']')) return false;
  text = text.substr(1, text.size() - 2);
  std::array<Vector<2>, most_motors> read{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && !text.starts_with(", ")) return false;
    if (i > 0) text.remove_prefix(2);
    const std::size_t end = std::min(text.find(']'), text.size() - 1) + 1;
    const std::optional<Vector<2>> point = text.empty() ? std::nullopt : point_in(text.substr(0, end));
    if (!point) return false;
    read[i] = *point;
    text.remove_prefix(end);
  }
  if (!text.empty()) return false;
  std::copy_n(read.begin(), points.size(), points.begin());
  return true;
}

struct BracketsInto {
  Scene& scene;
  std::string_view text;

  bool operator()(const PointKey& key) const {
    const std::optional<Vector<2>> point = point_in(text);
    if (point) key.in(scene) = *point;
    return point.has_value();
  }
  bool operator()(const PairKey& key) const {
    const auto pair = pair_in(text, key.least, key.greatest);
    if (pair) key.in(scene) = {(*pair)[0] / key.per_si, (*pair)[1] / key.per_si};
    return pair.has_value();
  }
  bool operator()(const PointPairKey& key) const { return set_points(key.in(scene), text); }
  bool operator()(const AnchorsKey& key) const {
    Strings& strings = key.in(scene);
    return set_points(std::span(strings.anchors).first(strings.count), text);
  }
  template <typename Other>
  bool operator()(const Other&) const {
    return false;
  }
};

}  // namespace

const SceneKey* find_scene_key(std::string_view table, std::string_view name) noexcept {
  for (const SceneKey& key : scene_keys()) {
    if (key.table == table && key.name == name) return &key;
  }
  return nullptr;
}

const SceneKey* find_scene_key(std::string_view dotted) noexcept {
  const auto [table, name] = split(dotted);
  return find_scene_key(table, name);
}

std::string suggest_scene_key(std::string_view table, std::string_view name, const SceneKeys& among) {
  const SceneKeys keys = among.empty() ? all_keys() : among;
  if (const auto near = nearest_scene_key(table, name, keys)) return ask(*near);
  const std::vector<std::string_view> here = names_in(table, keys);
  if (here.empty()) return "";
  return fmt::format("; {} has {}", table.empty() ? "the file" : fmt::format("[{}]", table), listed(here));
}

std::string suggest_scene_key(std::string_view dotted) {
  const auto [table, name] = split(dotted);
  if (!table.empty()) return suggest_scene_key(table, name);
  if (const auto near = nearest_scene_key(table, name, all_keys())) return ask(*near);
  return fmt::format("; the keys are {}", fmt::join(dotted_names(KeyKind::any), ", "));
}

std::string wrong_kind_text(const SceneKey& key, std::string_view kind) {
  std::string kinds = "'";
  for (const char c : key.kinds) kinds += c == ' ' ? "' or '" : std::string(1, c);
  return fmt::format("belongs to kind {}', and this {} is of kind '{}'", kinds, key.table, kind);
}

std::string dotted_name(const SceneKey& key) {
  return dotted_name(key.table, key.name);
}

std::vector<std::string> dotted_names(KeyKind kind) {
  std::vector<std::string> names;
  for (const SceneKey& key : scene_keys()) {
    if (kind == KeyKind::any || limits_of(key)) names.push_back(dotted_name(key));
  }
  return names;
}

std::string_view unit_of(std::string_view key_name) noexcept {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 10> units{{
      {"_N_s_per_m", "N·s/m"},
      {"_N_per_m", "N/m"},
      {"_mm", "mm"},
      {"_mm_rms", "mm"},
      {"_mm_per_s", "mm/s"},
      {"_deg", "degrees"},
      {"_kg", "kg"},
      {"_hz", "Hz"},
      {"_s", "s"},
      {"_N", "N"},
  }};
  for (const auto& [end, unit] : units) {
    if (key_name.ends_with(end)) return unit;
  }
  return {};
}

std::optional<NumberLimits> limits_of(const SceneKey& key) noexcept {
  const std::string_view unit = unit_of(key.name);
  if (const auto* const number = std::get_if<NumberKey>(&key.value)) {
    return NumberLimits{number->least, number->greatest, unit, number->may_be_infinite, number->whole};
  }
  const auto* const optional = std::get_if<OptionalNumberKey>(&key.value);
  return optional == nullptr ? std::nullopt : std::optional(NumberLimits{optional->least, optional->greatest, unit});
}

bool set_plain_value(Scene& scene, const SceneKey& key, std::string_view text) {
  if (text.starts_with('[')) return std::visit(BracketsInto{scene, text}, key.value);
  const bool is_quoted = text.size() > 2 && text.front() == '"' && text.back() == '"';
  return is_quoted ? set_word(scene, key, text.substr(1, text.size() - 2)) : set_number_of(scene, key, text);
}

}  // namespace ghostforce
